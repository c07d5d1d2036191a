// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include <memory>

#include "lessons/LessonCatalog.h"
#include "tests/support/OpenGlMain.h"
#include "tests/support/SyntheticMolar.h"
#include "ui/people/Door.h"
#include "ui/shell/Actions.h"
#include "ui/shell/HelpOverlay.h"
#include "ui/shell/MainWindow.h"
#include "ui/shell/Theme.h"
#include "ui/shell/Tour.h"
#include "ui/tooth/ToothView.h"

using database::Role;
using ui::shell::MainWindow;
using ui::shell::Tour;

Q_DECLARE_METATYPE(database::Role)

class TestTour : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { ui::shell::applyTheme(*qApp, ui::shell::ThemeChoice::Light); }
    void init();
    void cleanup() { m_window.reset(); }
    void everyStepLightsAControlAndLeavesItInSight_data();
    void everyStepLightsAControlAndLeavesItInSight();
    void keysLeadThroughIt();
    void otherKeysRest();
    void tabStaysInTheCard();
    void escEndsItWhereItBegan();
    void itIsHadAgainFromTheKeys();
    void theDoorBreaksItOff();

private:
    template <class T>
    T* child(const char* name = nullptr) const
    {
        return m_window->findChild<T*>(name == nullptr ? QString() : QString::fromLatin1(name));
    }
    ui::shell::Actions& actions() const { return *child<ui::shell::Actions>(); }
    Tour& tour() const { return *child<Tour>(); }
    void press(Qt::Key key, Qt::KeyboardModifiers with = {}) const
    {
        QTest::keyClick(m_window->windowHandle(), key, with);
    }

    std::unique_ptr<core::session::UiLinks> m_links;
    std::unique_ptr<MainWindow> m_window;
};

void TestTour::init()
{
    QLocale::setDefault(QLocale("en_GB"));
    m_links = std::make_unique<core::session::UiLinks>();
    m_window = std::make_unique<MainWindow>(*m_links);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_window->setLessons(lessons::readCatalog({}), {});
    m_window->showTooth(support::syntheticMolar(), 1, {});
}

void TestTour::everyStepLightsAControlAndLeavesItInSight_data()
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

void TestTour::everyStepLightsAControlAndLeavesItInSight()
{
    QFETCH(Role, role);
    QFETCH(QSize, size);
    m_window->resize(size);
    actions().attempts->setVisible(role != Role::Guest);
    actions().classes->setVisible(role == Role::Instructor || role == Role::Admin);
    actions().school->setVisible(role == Role::Admin);
    QTest::qWait(50);
    tour().begin(role);
    QVERIFY2(tour().steps() >= 4 && tour().steps() <= 7, qPrintable(QString::number(tour().steps())));
    const auto* card = child<QLabel>("tourTitle")->parentWidget();
    QStringList titles;
    for (int k = 0; k < tour().steps(); ++k) {
        QTest::qWait(50);
        QCOMPARE(tour().step(), k);
        const QWidget* lit = tour().target();
        QVERIFY(lit != nullptr);
        QVERIFY2(lit->isVisible(), qPrintable(child<QLabel>("tourTitle")->text()));
        titles << child<QLabel>("tourTitle")->text();
        QVERIFY(tour().rect().contains(card->geometry()));
        const QRect there(lit->mapTo(m_window.get(), QPoint()), lit->size());
        const QRect own(card->mapTo(m_window.get(), QPoint()), card->size());
        const bool isLarge = there.width() * there.height() > m_window->width() * m_window->height() / 4;
        QVERIFY2(isLarge || !there.intersects(own), qPrintable(titles.back()));
        // All its words have room.
        const auto* words = child<QLabel>("tourWords");
        QVERIFY(words->height() >= words->heightForWidth(words->width()));
        if (const QString folder = qEnvironmentVariable("CUSP_PICTURES"); !folder.isEmpty())
            m_window->grab().save(QString("%1/tour-%2-%3.png")
                                      .arg(folder, QTest::currentDataTag())
                                      .arg(k)
                                      .remove(u',')
                                      .replace(u' ', u'-'));
        tour().next();
    }
    QVERIFY(!tour().isVisible());
    titles.removeDuplicates();
    QCOMPARE(titles.size(), tour().steps());
}

void TestTour::keysLeadThroughIt()
{
    m_window->beginTour();
    press(Qt::Key_Right);
    QCOMPARE(tour().step(), 1);
    press(Qt::Key_Return);
    QCOMPARE(tour().step(), 2);
    press(Qt::Key_Left);
    QCOMPARE(tour().step(), 1);
    press(Qt::Key_Left);
    press(Qt::Key_Left);
    QCOMPARE(tour().step(), 0);
    QVERIFY(!child<QPushButton>("tourBack")->isEnabled());
    QSignalSpy ended(m_window.get(), &MainWindow::tourEnded);
    for (int k = 0; k < tour().steps(); ++k)
        press(Qt::Key_Right);
    QVERIFY(!tour().isVisible());
    QCOMPARE(ended.count(), 1);
}

void TestTour::otherKeysRest()
{
    m_window->beginTour();
    const bool before = actions().section->isChecked();
    press(Qt::Key_X);
    press(Qt::Key_F2);
    QCOMPARE(actions().section->isChecked(), before);
    QVERIFY(tour().isVisible());
    QVERIFY(m_window->view().isVisible());
}

void TestTour::tabStaysInTheCard()
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

void TestTour::escEndsItWhereItBegan()
{
    m_window->openLessons();
    QVERIFY(!m_window->view().isVisible());
    m_window->beginTour();
    QVERIFY(m_window->view().isVisible());  // a guest's first step is the tooth
    QSignalSpy ended(m_window.get(), &MainWindow::tourEnded);
    press(Qt::Key_Escape);
    QVERIFY(!tour().isVisible());
    QVERIFY(!m_window->view().isVisible());
    QCOMPARE(ended.count(), 1);
}

void TestTour::itIsHadAgainFromTheKeys()
{
    actions().help->trigger();
    QPushButton* again = nullptr;
    for (auto* button : child<ui::shell::HelpOverlay>()->findChildren<QPushButton*>())
        if (button->text() == actions().tour->text())
            again = button;
    QVERIFY(again != nullptr && again->isVisible());
    again->click();
    QVERIFY(tour().isVisible());
    QVERIFY(!child<ui::shell::HelpOverlay>()->isVisible());
}

void TestTour::theDoorBreaksItOff()
{
    m_window->beginTour();
    QSignalSpy ended(m_window.get(), &MainWindow::tourEnded);
    m_window->askWho(ui::people::Door::Login);
    QVERIFY(!tour().isVisible());
    QCOMPARE(ended.count(), 0);
    actions().tour->trigger();
    QVERIFY(!tour().isVisible());
}

int main(int argc, char* argv[])
{
    return support::openGlMain<TestTour>(argc, argv);
}

#include "tst_tour.moc"
