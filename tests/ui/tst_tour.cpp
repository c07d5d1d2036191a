// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
#include <QPushButton>

#include "tests/support/Suite.h"
#include "tests/ui/WindowTest.h"
#include "ui/people/LoginMode.h"
#include "ui/window/HelpOverlay.h"
#include "ui/window/Tour.h"

using database::Role;
using ui::window::MainWindow;
using ui::window::Tour;

Q_DECLARE_METATYPE(database::Role)

class TestTour : public support::WindowTest
{
    Q_OBJECT
private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        begin();
        m_window->lessonsPage().setLessons(support::catalog(), {});
    }
    void cleanup()
    {
        spoil();
        end();
    }
    void everyStepLightsAControlAndLeavesItInSight_data()
    {
        QTest::addColumn<Role>("role");
        QTest::addColumn<QSize>("size");
        for (const auto& [name, role] : {std::pair("guest", Role::Guest),
                                         {"student", Role::Student},
                                         {"instructor", Role::Instructor},
                                         {"admin", Role::Admin}})
            for (const QSize size : {QSize(1280, 760), QSize(853, 493)})
                QTest::addRow("%s, %d", name, size.width()) << role << size;
    }

    void everyStepLightsAControlAndLeavesItInSight()
    {
        QFETCH(Role, role);
        QFETCH(QSize, size);
        m_window->resize(size);
        actions().attempts->setVisible(role != Role::Guest);
        actions().classes->setVisible(role == Role::Instructor || role == Role::Admin);
        actions().school->setVisible(role == Role::Admin);
        QTRY_COMPARE(m_window->size(), size);
        tour().begin(role);
        QVERIFY2(tour().steps() >= 4 && tour().steps() <= 7, qPrintable(QString::number(tour().steps())));
        QStringList titles;
        for (int k = 0; k < tour().steps(); ++k) {
            QCOMPARE(tour().step(), k);
            titles << child<QLabel>("tourTitle")->text();
            QTRY_VERIFY2(isInOrder(), qPrintable(titles.back()));
            tour().next();
        }
        QVERIFY(!tour().isVisible());
        titles.removeDuplicates();
        QCOMPARE(titles.size(), tour().steps());
    }

    void keysLeadThroughIt()
    {
        m_window->beginTour();
        // The shortcuts of the window are disabled during the tour.
        for (const auto& [key, step] : {std::pair(Qt::Key_Right, 1),
                                        {Qt::Key_Return, 2},
                                        {Qt::Key_X, 2},
                                        {Qt::Key_F2, 2},
                                        {Qt::Key_Left, 1},
                                        {Qt::Key_Left, 0},
                                        {Qt::Key_Left, 0}}) {
            press(key);
            QCOMPARE(tour().step(), step);
        }
        QVERIFY(!actions().section->isChecked() && m_window->view().isVisible());
        QVERIFY(!child<QPushButton>("tourBack")->isEnabled());
        QSignalSpy ended(&m_window->navigation(), &ui::window::Navigation::tourEnded);
        for (int k = 0; k < tour().steps(); ++k)
            press(Qt::Key_Right);
        QVERIFY(!tour().isVisible());
        QCOMPARE(ended.count(), 1);
    }

    void tabStaysInTheCard()
    {
        m_window->beginTour();
        press(Qt::Key_Right);
        for (const char* expected : {"tourSkip", "tourBack", "tourNext", "tourSkip"}) {
            press(Qt::Key_Tab);
            QCOMPARE(QApplication::focusWidget(), child<QPushButton>(expected));
        }
        press(Qt::Key_Tab, Qt::ShiftModifier);
        QCOMPARE(QApplication::focusWidget(), child<QPushButton>("tourNext"));
    }

    void escEndsItWhereItBegan()
    {
        m_window->navigation().openLessons();
        QVERIFY(!m_window->view().isVisible());
        m_window->beginTour();
        QVERIFY(m_window->view().isVisible());  // a guest's tour begins at the tooth
        QSignalSpy ended(&m_window->navigation(), &ui::window::Navigation::tourEnded);
        press(Qt::Key_Escape);
        QVERIFY(!tour().isVisible());
        QVERIFY(!m_window->view().isVisible());
        QCOMPARE(ended.count(), 1);
    }

    void itIsHadAgainFromTheKeys()
    {
        actions().help->trigger();
        QPushButton* again = nullptr;
        for (auto* button : child<ui::window::HelpOverlay>()->findChildren<QPushButton*>())
            if (button->text() == actions().tour->text())
                again = button;
        QVERIFY(again != nullptr && again->isVisible());
        again->click();
        QVERIFY(tour().isVisible());
        QVERIFY(!child<ui::window::HelpOverlay>()->isVisible());
    }

    void theDoorBreaksItOff()
    {
        m_window->beginTour();
        QSignalSpy ended(&m_window->navigation(), &ui::window::Navigation::tourEnded);
        m_window->account().ask(ui::people::LoginMode::Login);
        QVERIFY(!tour().isVisible());
        QCOMPARE(ended.count(), 0);
        actions().tour->trigger();
        QVERIFY(!tour().isVisible());
    }

private:
    Tour& tour() const { return *child<Tour>(); }
    void press(Qt::Key key, Qt::KeyboardModifiers with = {}) const
    {
        QTest::keyClick(m_window->windowHandle(), key, with);
    }
    /// Returns whether the control of this step is visible beside the card, and the card has room for its text.
    [[nodiscard]] bool isInOrder() const
    {
        const QWidget* lit = tour().target();
        const auto* card = child<QLabel>("tourTitle")->parentWidget();
        const auto* words = child<QLabel>("tourWords");
        if (lit == nullptr || !lit->isVisible() || !tour().rect().contains(card->geometry()) ||
            words->height() < words->heightForWidth(words->width()))
            return false;
        const QRect there(lit->mapTo(m_window.get(), QPoint()), lit->size());
        const QRect own(card->mapTo(m_window.get(), QPoint()), card->size());
        const bool isLarge = there.width() * there.height() > m_window->width() * m_window->height() / 4;
        return isLarge || !there.intersects(own);
    }
};

CUSP_TEST(TestTour)
#include "tst_tour.moc"
