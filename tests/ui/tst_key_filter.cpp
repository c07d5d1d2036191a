// SPDX-License-Identifier: GPL-3.0-or-later
// A key goes to the focused widget if a shortcut of the window would otherwise take it.
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QStackedWidget>
#include <QTest>

#include "tests/support/Suite.h"
#include "ui/window/KeyFilter.h"

class TestKeyFilter : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase()
    {
        for (QWidget* page : {&m_room, &m_office, &m_lessons})
            m_pages.addWidget(page);
    }

    void lettersAreShortcutsInTheRoomOnly()
    {
        QListWidget list;
        QWidget plain;
        m_pages.setCurrentWidget(&m_room);
        QVERIFY(isShortcut(plain, Qt::Key_G, "g") && isShortcut(list, Qt::Key_G, "g"));
        m_pages.setCurrentWidget(&m_lessons);
        QVERIFY(isShortcut(plain, Qt::Key_G, "g") && !isShortcut(list, Qt::Key_G, "g"));
        m_pages.setCurrentWidget(&m_office);
        QVERIFY(!isShortcut(plain, Qt::Key_G, "g"));
        QVERIFY(isShortcut(plain, Qt::Key_G, "\x07", Qt::ControlModifier) && isShortcut(plain, Qt::Key_F5, ""));
    }

    void spacePressesTheButtonWithTheFocus()
    {
        m_pages.setCurrentWidget(&m_room);
        QPushButton button;
        QWidget plain;
        QVERIFY(!isShortcut(button, Qt::Key_Space, " ") && isShortcut(plain, Qt::Key_Space, " "));
    }

    void escapeClearsASearchFieldFirst()
    {
        m_pages.setCurrentWidget(&m_room);
        QLineEdit search;
        search.setClearButtonEnabled(true);
        search.setText("class");
        QVERIFY(!isShortcut(search, Qt::Key_Escape, "\x1b"));
        QTest::keyClick(&search, Qt::Key_Escape);
        QCOMPARE(search.text(), QString());
        QVERIFY(isShortcut(search, Qt::Key_Escape, "\x1b"));
    }

    void enterPressesAButtonThatHadTheFocus()
    {
        QPushButton button;
        QVERIFY(!button.autoDefault());
        QFocusEvent focus(QEvent::FocusIn);
        QCoreApplication::sendEvent(&button, &focus);
        QVERIFY(button.autoDefault());
    }

private:
    /// Returns whether the focused widget leaves a key to the shortcuts.
    static bool isShortcut(QWidget& focused, Qt::Key key, const char* text, Qt::KeyboardModifiers modifiers = {})
    {
        QKeyEvent event(QEvent::ShortcutOverride, key, modifiers, QString::fromLatin1(text));
        event.ignore();
        QCoreApplication::sendEvent(&focused, &event);
        // A line edit accepts every key that it would type.
        return !event.isAccepted();
    }

    QStackedWidget m_pages;
    QWidget m_room;
    QWidget m_office;
    QWidget m_lessons;
    ui::window::KeyFilter m_filter{m_pages, m_room, {&m_office}, nullptr};
};

CUSP_TEST(TestKeyFilter)
#include "tst_key_filter.moc"
