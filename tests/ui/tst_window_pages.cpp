// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of the main window: how they are reached, the door and the lock, lessons, teeth, and the score.
#include <QAccessible>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QSlider>

#include "tests/support/Suite.h"
#include "tests/ui/WindowTest.h"
#include "ui/catalog/LessonCards.h"
#include "ui/catalog/LessonsPage.h"
#include "ui/console/Console.h"
#include "ui/console/WatchPanel.h"
#include "ui/people/LoginPage.h"
#include "ui/scoring/ScorePage.h"
#include "ui/scoring/ScorePrediction.h"
#include "ui/scoring/ScorePredictionPage.h"
#include "ui/toothchooser/ArchView.h"
#include "ui/toothchooser/ToothChooser.h"

using namespace core::session;
using namespace ui::kit;
using namespace ui::toothchooser;
using namespace ui::window;
using support::sheet;
using ui::catalog::LessonsPage;
using ui::people::LoginMode;
using ui::people::LoginPage;
using ui::scoring::ScorePage;

class TestWindowPages : public support::WindowTest
{
    Q_OBJECT
private slots:
    void initTestCase() { prepare(); }
    void init() { begin(); }
    void cleanup() { end(); }

    void keysLeadToPagesAndEscapeBack()
    {
        for (const auto& [keys, page] : {std::pair("F2", "ui::catalog::LessonsPage"),
                                         {"T", "ui::toothchooser::ToothChooser"},
                                         {"F", "ui::inside::XrayPage"},
                                         {"F7", "ui::presets::PresetsPage"},
                                         {"Ctrl+,", "ui::settings::SettingsPage"}}) {
            press(QKeySequence(keys));
            QCOMPARE(m_window->page()->metaObject()->className(), page);
            QVERIFY(!isInRoom());
            press(Qt::Key_Escape);
            QVERIFY(isInRoom() && m_window->view().hasFocus());
        }
    }

    void theKeyThatOpenedTheXrayClosesIt()
    {
        for (const char* shown : {"ui::inside::XrayPage", "ui::window::PracticeRoom"}) {
            press(Qt::Key_F);
            QCOMPARE(m_window->page()->metaObject()->className(), shown);
        }
        QVERIFY(m_window->view().hasFocus());
    }

    void escapeClosesWhatLiesOverTheTooth()
    {
        const auto* panel = child<QWidget>("historyPanel");
        const auto* plots = child<ui::console::WatchPanel>();
        child<ui::console::Console>()->execute(QStringLiteral("watch force.stiffness"));
        press(Qt::Key_U);
        QVERIFY(panel->isVisible());
        press(Qt::Key_Escape);
        QVERIFY(!panel->isVisible() && !actions().history->isChecked() && m_window->view().hasFocus());
        QVERIFY2(!plots->names().isEmpty(), "one at a time");
        press(Qt::Key_Escape);
        QVERIFY(plots->names().isEmpty());
    }

    void controlFSearchesThePageOrTheLessons()
    {
        m_window->lessonsPage().setLessons(support::catalog(), {});
        press(Qt::Key_F, Qt::ControlModifier);
        QVERIFY(child<LessonsPage>()->isVisible() && search()->hasFocus());
        QTest::keyClicks(search(), "36");
        child<QListView>("lessonList")->setFocus();
        press(Qt::Key_F, Qt::ControlModifier);
        QVERIFY(search()->hasFocus());
        QCOMPARE(search()->selectedText(), QString("36"));
        press(Qt::CTRL | Qt::Key_Comma);
        press(Qt::Key_F, Qt::ControlModifier);
        QCOMPARE(m_window->page()->metaObject()->className(), "ui::settings::SettingsPage");
        QVERIFY(m_window->page()->isAncestorOf(QApplication::focusWidget()));
        QVERIFY(qobject_cast<QLineEdit*>(QApplication::focusWidget()) != nullptr);
    }

    void aRefusedPasswordIsTypedAnew()
    {
        m_window->account().ask(LoginMode::NewSchool);
        for (const char* name : {"password", "passwordAgain"})
            child<QLineEdit>(name)->setText("password1");
        m_window->account().refuse({core::ErrorCode::OutOfRange, "everybody tries it first"});
        QCOMPARE(QApplication::focusWidget(), child<QLineEdit>("password"));
        for (const char* name : {"password", "passwordAgain"})
            QVERIFY(child<QLineEdit>(name)->text().isEmpty());
    }

    void aOneTimeCodeLeadsToTheFirstPasswordField()
    {
        spoil();
        QSignalSpy code(&m_window->loginPage(), &ui::people::LoginPage::codeRequested);
        auto* username = child<QLineEdit>("username");
        auto* password = child<QLineEdit>("password");
        auto* again = child<QLineEdit>("passwordAgain");
        for (const LoginMode door : {LoginMode::Login, LoginMode::Locked}) {
            if (door == LoginMode::Locked)
                m_window->setWho(school().student);
            m_window->account().ask(door);
            const QString name =
                door == LoginMode::Locked ? QString::fromStdString(school().student.username()) : "s1001";
            username->setText(door == LoginMode::Login ? name : QString());
            password->setText("K7PM-2QXR");
            click("logIn");
            m_window->account().refuse({core::ErrorCode::NewPassword, "the code is right"});
            QVERIFY(password->hasFocus() && password->text().isEmpty());
            QVERIFY2(!username->isVisible(), "neither name nor code is asked for again");
            QTest::keyClicks(password, "a long password");
            press(Qt::Key_Return);
            QVERIFY(again->hasFocus());
            QTest::keyClicks(again, "a long password");
            press(Qt::Key_Return);
            QCOMPARE(code.size(), 1);
            QCOMPARE(code.takeFirst(), (QList<QVariant>{name, "K7PM-2QXR", "a long password"}));
        }
    }

    /// Of a large file, or one whose disk has much to do; what takes a moment is not.
    void whatIsWaitedForAtTheDoorIsTold()
    {
        m_window->account().ask(LoginMode::Login);
        auto* waiting = child<QLabel>("waiting");
        m_window->account().setOpening(true);
        QVERIFY(!waiting->isVisible());
        QTRY_VERIFY(waiting->isVisible());
        m_window->account().setOpening(false);
        QVERIFY(!waiting->isVisible());
        child<QLineEdit>("username")->setText("ann");
        child<QLineEdit>("password")->setText("something");
        QTest::keyClick(child<QLineEdit>("password"), Qt::Key_Return);
        QVERIFY(!waiting->isVisible());
        QTRY_VERIFY(waiting->isVisible());
        QVERIFY(child<QPushButton>("practiseAsGuest")->isEnabled());
        m_window->account().refuse({core::ErrorCode::WrongLogin, "wrong"});
        QVERIFY(!waiting->isVisible());
    }

    void aGuestIsToldThatNothingIsKept()
    {
        const auto isTold = [this] {
            const auto signs = m_window->findChildren<QLabel*>(QStringLiteral("guestSign"));
            return std::any_of(signs.begin(), signs.end(), [](const QLabel* sign) { return sign->isVisible(); });
        };
        QVERIFY(isTold());
        actions().lessons->trigger();
        QVERIFY(isTold());
        m_window->showScore(sheet(3.2, 40, 0.5), {});
        QVERIFY(isTold());
        m_window->setWho(school().student);
        QVERIFY(!isTold());
        actions().back->trigger();
        QVERIFY(isInRoom() && !isTold());
        // Else in whose name one drills.
        const auto* name = child<QLabel>("accountName");
        QVERIFY(name->isVisible());
        QCOMPARE(name->text(), QString::fromStdString(school().student.username()));
        m_window->setWho({});
        QVERIFY(isTold() && !name->isVisible());
    }

    void aPlaceThatWasLeftIsLocked()
    {
        spoil();
        auto* door = child<LoginPage>();
        m_window->account().idleLock().setLimit(std::chrono::milliseconds(300));
        QTest::qWait(500);  // time is the subject: a guest has nothing to lock, however long nothing is touched
        QVERIFY(!door->isVisible());
        m_window->setWho(school().student);
        QTRY_VERIFY(door->isVisible());
        QCOMPARE(door->door(), LoginMode::Locked);
        // No key leads past it, and what others want to show waits behind it.
        for (QAction* action : {actions().lessons, actions().attempts, actions().grade, actions().back, actions().help})
            QVERIFY(!action->isEnabled());
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        m_window->showScore(sheet(3.2, 40, 0.5), {});
        QVERIFY(door->isVisible());
        // When the student is back, they find it as it is now.
        m_window->setWho(school().student);
        QVERIFY(!door->isVisible() && child<ScorePage>()->isVisible());
    }

    /// What the one who left had open would go on working for whoever comes by.
    void nothingStaysOpenOverTheLock()
    {
        spoil();
        m_window->setWho(school().student);
        cutSomething(1.0);
        const auto lockAndComeBack = [&] {
            m_window->account().ask(LoginMode::Locked);
            QVERIFY(child<LoginPage>()->isVisible());
            for (const QWidget* window : m_window->findChildren<QWidget*>())
                QVERIFY2(!window->isWindow() || !window->isVisible(), window->metaObject()->className());
            m_window->setWho(school().student);
        };
        QSignalSpy save(&m_window->unsavedWork(), &ui::window::UnsavedWork::recordingSaveRequested);
        actions().saveRecording->trigger();
        QVERIFY(child<QFileDialog>() != nullptr);
        lockAndComeBack();
        QCOMPARE(save.size(), 0);
        QTRY_VERIFY(child<QFileDialog>() == nullptr);
        QMenu menu(m_window.get());
        menu.addAction(QStringLiteral("something"));
        menu.popup(m_window->mapToGlobal(QPoint(10, 10)));
        QTRY_VERIFY(menu.isVisible());
        lockAndComeBack();
        QSignalSpy chosen(m_window.get(), &MainWindow::toothChosen);
        press(Qt::Key_T);
        press(Qt::Key_Return);
        QVERIFY(question() != nullptr && question()->isVisible());
        m_window->account().ask(LoginMode::Locked);
        QTRY_VERIFY(question() == nullptr);
        QCOMPARE(chosen.size(), 0);
    }

    void nothingOfWhoLeftStays()
    {
        spoil();
        auto* console = child<ui::console::Console>();
        actions().console->trigger();
        console->execute(QStringLiteral("get force.stiffness"));
        console->execute(QStringLiteral("watch force.stiffness"));
        auto* line = child<QLineEdit>("consoleLine");
        line->setText(QStringLiteral("list"));
        QTest::keyClick(line, Qt::Key_Return);
        const double usualN = m_window->view().hand().forceN();
        m_window->view().setPushForce(usualN + 1.0);
        m_window->view().setFeed(2.0);
        m_window->leaveAll();
        QCOMPARE(m_window->view().hand().forceN(), usualN);
        QCOMPARE(m_window->view().hand().feedMmPerS(), ui::tooth::PointerControl::kFirstMmPerS);
        QVERIFY(!console->isVisible());
        QVERIFY(child<ui::console::WatchPanel>()->names().isEmpty());
        actions().console->trigger();
        QVERIFY(!child<QPlainTextEdit>("consoleOutput")->toPlainText().contains("force.stiffness"));
        QTest::keyClick(line, Qt::Key_Up);
        QCOMPARE(line->text(), QString());
    }

    /// It may have been meant for what was open before.
    void aReturnAtTheLockIsNoWrongPassword()
    {
        m_window->setWho(school().student);
        m_window->account().ask(LoginMode::Locked);
        QSignalSpy wanted(&m_window->loginPage(), &ui::people::LoginPage::loginRequested);
        auto* password = child<QLineEdit>("password");
        QTest::keyClick(password, Qt::Key_Return);
        QCOMPARE(wanted.size(), 0);
        QVERIFY(password->isEnabled());
        password->setText(QStringLiteral("something"));
        QTest::keyClick(password, Qt::Key_Return);
        QCOMPARE(wanted.size(), 1);
        spoil();
    }

    void aCourseIsListedUnderItsHeading()
    {
        m_window->lessonsPage().setLessons(support::catalog(), {});
        actions().lessons->trigger();
        const auto* model = child<QListView>("lessonList")->model();
        QStringList headings;
        QStringList course;
        for (int row = 0; row < model->rowCount(); ++row) {
            const QModelIndex index = model->index(row, 0);
            if (!index.data(ui::catalog::CardEntry).isValid())
                headings << index.data().toString();
            else if (headings.last() == "First year")
                course << index.data().toString();
        }
        QCOMPARE(headings.count("First year"), 1);
        QVERIFY(headings.indexOf("Practice block") < headings.indexOf("First year"));
        QVERIFY(headings.indexOf("First year") < headings.indexOf("Removing decay"));
        QVERIFY(course.indexOf("Buccal pit on 36") < course.indexOf("Class V on 33"));
    }

    void typingSearchesTheLessons()
    {
        m_window->lessonsPage().setLessons(support::catalog(), {});
        QSignalSpy begun(child<LessonsPage>(), &LessonsPage::lessonChosen);
        actions().lessons->trigger();
        auto* list = child<QListView>("lessonList");
        QVERIFY(list->hasFocus());
        // Pages are turned with the keys.
        const int first = list->currentIndex().row();
        press(Qt::Key_PageDown);
        QVERIFY(list->currentIndex().row() > first + 1);
        press(Qt::Key_PageUp);
        QCOMPARE(list->currentIndex().row(), first);
        // Wherever one is; the letters are no shortcuts here.
        for (const Qt::Key key : {Qt::Key_T, Qt::Key_E, Qt::Key_M, Qt::Key_X})
            press(key);
        QCOMPARE(search()->text().toLower(), QString("temx"));
        QVERIFY(child<LessonsPage>()->isVisible() && search()->hasFocus());
        QVERIFY2(!child<QPushButton>("startLesson")->isEnabled(), "nothing fits");
        // The first that fits is chosen, also where another one that fits was chosen before.
        search()->setText("class1-36");
        QCOMPARE(lessonTitle(), QString("Class I on 36"));
        search()->setText("36");
        QCOMPARE(lessonTitle(), QString("Touch the points"));
        search()->setText("class1-37");
        search()->clear();
        QCOMPARE(lessonTitle(), QString("Class I on 37"));
        // Typed from the list, a new search begins.
        search()->setText("37");
        press(Qt::Key_Down);
        QVERIFY(list->hasFocus());
        press(Qt::Key_2);
        QCOMPARE(search()->text(), QString("2"));
        search()->setText("class1-27");
        press(Qt::Key_Return);
        QCOMPARE(begun.size(), 1);
        QCOMPARE(QString::fromStdString(begun.front().front().value<lessons::Lesson>().id), QString("class1-27"));
    }

    void cardsAreAsHighAsTheirWords()
    {
        const auto* list = child<QListView>("lessonList");
        actions().lessons->trigger();
        m_window->lessonsPage().setLessons(support::catalog(), {},
                                           {{"class1-36", {"Year 1", {}, {}}},
                                            {"class1-37", {"Year 1", QDateTime::currentDateTime().addDays(3), {}}}});
        const auto high = [&](const char* lesson) {
            search()->setText(QString::fromLatin1(lesson));
            return list->sizeHintForIndex(list->currentIndex()).height();
        };
        QCOMPARE(high("class1-26"), high("class1-27"));
        QVERIFY(high("class1-36") > high("class1-26"));  // it names the class
        QCOMPARE(high("class1-36"), high("class1-37"));
        QVERIFY(high("exam-36-class2") > high("exam-36-class1"));  // the title takes two lines
    }

    void cardsTellTheBestScore()
    {
        auto* list = child<QListView>("lessonList");
        actions().lessons->trigger();
        m_window->lessonsPage().setLessons(support::catalog(), {{"class1-34", {2, 603, false, "2026-11-20T10:00:00Z"}},
                                                                {"class1-36", {3, 917, true, "2026-11-20T11:00:00Z"}}});
        for (const auto& [lesson, score, passed] :
             {std::tuple("class1-34", "60.3", false), {"class1-36", "✓ 91.7", true}, {"class1-37", "", false}}) {
            search()->setText(lesson);
            QCOMPARE(cards().size(), 1);
            const QModelIndex card = list->currentIndex();
            QCOMPARE(card.data(ui::catalog::CardScore).toString(), QString::fromUtf8(score));
            QCOMPARE(card.data(ui::catalog::CardPassed).toBool(), passed);
        }
    }

    void lessonsAreFiltered()
    {
        auto* page = child<LessonsPage>();
        std::vector<lessons::CatalogEntry> entries = support::catalog();
        for (lessons::CatalogEntry& entry : entries)
            if (entry.read.lesson->id == "class1-24")
                entry.read.lesson->exam = true;
        const auto all = static_cast<qsizetype>(entries.size());
        const std::map<std::string, ui::catalog::Standing> standings{
            {"class1-36", {2, 603, false, "2026-11-20T10:00:00Z"}},
            {"class1-37", {1, 917, true, "2026-11-20T11:00:00Z"}}};
        const ui::catalog::Given given{"Year 1", {}, {}};
        page->setLessons(entries, standings, {{"class1-36", given}, {"class1-37", given}, {"class1-26", given}});
        actions().lessons->trigger();
        const auto filter = [page](const char* words) {
            const auto buttons = page->findChildren<QPushButton*>();
            return *std::find_if(buttons.begin(), buttons.end(), [words](const QPushButton* button) {
                return button->isCheckable() && button->text() == QLatin1String(words);
            });
        };
        const auto shown = [&](const char* words) {
            QTest::mouseClick(filter(words), Qt::LeftButton);
            return cards();
        };
        QVERIFY(filter("All")->isChecked());
        QCOMPARE(cards().size(), all);
        QCOMPARE(shown("To do"), (QStringList{"Class I on 36", "Class I on 26"}));
        QCOMPARE(shown("Passed"), QStringList{"Class I on 37"});
        const QStringList exams{"Exam: decay on 36", "Exam: decay on 26", "Exam: Class I on 36",
                                "Exam: Class II box on 36, mesial", "Class I on 24"};
        QCOMPARE(shown("Exams"), exams);
        // They are the last group of the list.
        QCOMPARE(shown("All").mid(all - exams.size()), exams);
        QCOMPARE(shown("Exams"), exams);
        QVERIFY(filter("Exams")->isChecked() && !filter("All")->isChecked());
        // Beside what is searched for.
        search()->setText("class1-36");
        QCOMPARE(shown("Passed"), QStringList());
        QCOMPARE(lessonTitle(), QString("No matching lessons"));
        QCOMPARE(shown("All"), QStringList{"Class I on 36"});
        // For a student to whom nothing was given, everything that is not passed is to do.
        search()->clear();
        page->setLessons(entries, standings);
        QCOMPARE(shown("To do").size(), all - 1);
        // The next person begins with all.
        page->forget();
        QVERIFY(filter("All")->isChecked());
        QCOMPARE(cards().size(), all);
    }

    void anExamBeginsWithOneCard()
    {
        std::vector<lessons::CatalogEntry> entries = support::catalog();
        for (lessons::CatalogEntry& entry : entries)
            if (entry.read.lesson->id == "class1-24") {
                entry.read.lesson->exam = true;
                entry.read.lesson->minutes = 8.0;
                entry.read.lesson->aids = {};
                entry.read.lesson->aids.section = false;
            }
        m_window->lessonsPage().setLessons(entries, {{"class1-24", {1, 603, false, "2026-11-20T10:00:00Z"}}},
                                           {{"class1-24", {"Year 1", {}, 2}}});
        actions().lessons->trigger();
        search()->setText("class1-24");
        QSignalSpy chosen(m_window.get(), &MainWindow::lessonChosen);
        click("startLesson");
        QVERIFY(question("examQuestion") != nullptr);
        const QString said = child<QLabel>("questionDetail")->text();
        for (const char* words : {"8 min", "2 attempt(s) left, 1 graded so far", "undo", "section"})
            QVERIFY2(said.contains(words), words);
        QVERIFY2(!said.contains("X-ray") && child<QPushButton>("questionDiscard") == nullptr, "nothing else is locked");
        press(Qt::Key_Escape);
        QVERIFY(chosen.isEmpty() && question("examQuestion") == nullptr && child<LessonsPage>()->isVisible());
        click("startLesson");
        press(Qt::Key_Return);
        QCOMPARE(chosen.size(), 1);
        QVERIFY(isInRoom());
    }

    void usedUpAttemptsAreToldBeforeTheStart()
    {
        QSignalSpy begun(child<LessonsPage>(), &LessonsPage::lessonChosen);
        actions().lessons->trigger();
        for (const int left : {1, 0}) {
            m_window->lessonsPage().setLessons(support::catalog(), {}, {{"class1-37", {"Year 1", {}, left}}});
            search()->setText("class1-37");
            QCOMPARE(child<QPushButton>("startLesson")->isEnabled(), left > 0);
            QCOMPARE(child<QLabel>("whyNotStart")->isVisible(), left == 0);
            const QModelIndex card = child<QListView>("lessonList")->currentIndex();
            QCOMPARE(card.data(ui::catalog::CardIsUsedUp).toBool(), left == 0);
        }
        search()->setFocus();
        press(Qt::Key_Return);
        QCOMPARE(begun.size(), 0);
    }

    void theForecastIsAnsweredWithTheKeys()
    {
        m_window->setAssignment(support::assigned("class1-36"));
        QSignalSpy given(&m_window->predictionPage(), &ui::scoring::ScorePredictionPage::answered);
        const auto* show = child<QPushButton>("showScore");
        const auto worst = [&] { return given.takeLast().front().value<ui::scoring::ScorePrediction>().worst; };
        m_window->askPrediction();
        QVERIFY(!show->isEnabled());
        press(Qt::Key_Right);
        QVERIFY(show->isEnabled());
        press(Qt::Key_Tab);
        press(Qt::Key_Down);
        press(Qt::Key_Return);
        QVERIFY2(given.isEmpty(), "the answer is chosen first");
        press(Qt::Key_Return);
        QCOMPARE(given.size(), 1);
        QCOMPARE(worst(), std::string("gouge"));
        // What cost most may be left open.
        actions().back->trigger();
        m_window->askPrediction();
        press(Qt::Key_Right);
        press(Qt::Key_Return);
        QCOMPARE(given.size(), 1);
        QCOMPARE(worst(), std::string());
    }

    void theForecastOffersThreeCriteriaAndItsButtonIsInSight()
    {
        m_window->resize(1280, 800);
        m_window->setAssignment(support::assigned("class2-36-distal"));
        m_window->askPrediction();
        QCOMPARE(m_window->page()->findChildren<QRadioButton*>().size(), 3);
        const auto* show = child<QPushButton>("showScore");
        QTRY_COMPARE(show->visibleRegion().boundingRect(), show->rect());
    }

    void anotherToothIsChosen()
    {
        QSignalSpy chosen(m_window.get(), &MainWindow::toothChosen);
        press(Qt::Key_T);
        auto* arches = child<ToothChooser>()->findChild<ArchView*>();
        QCOMPARE(arches->selected(), 36);
        const auto teeth = arches->findChildren<ArchTooth*>();
        QCOMPARE(teeth.size(), 16);
        for (ArchTooth* tooth : teeth) {
            // The rectangles of neighbours overlap, their middles do not.
            QTest::mouseClick(arches, Qt::LeftButton, {}, tooth->geometry().center());
            QCOMPARE(arches->selected(), tooth->fdi());
        }
        arches->setSelected(24);
        click("takeTooth");
        QCOMPARE(chosen.takeFirst().front().toInt(), 24);
        QVERIFY(isInRoom());
        press(Qt::Key_T);
        arches->setSelected(36);
        for (const auto& [key, fdi] :
             {std::pair(Qt::Key_Right, 37), {Qt::Key_Up, 27}, {Qt::Key_Left, 26}, {Qt::Key_Down, 36}}) {
            press(key);
            QCOMPARE(arches->selected(), fdi);
        }
        press(Qt::Key_Return);
        QCOMPARE(chosen.takeFirst().front().toInt(), 36);
    }

    void theScoreAddsUp()
    {
        const lessons::ScoreSheet s = sheet(3.2, 9.81, 0);
        database::AttemptRecord now;
        now.scoreTenths = s.totalTenths;
        now.finishedUtc = "2026-11-20T10:15:00Z";
        database::AttemptRecord before = now;
        before.scoreTenths = 610;
        m_window->showScore(s, {now, before});
        QVERIFY(child<ScorePage>()->isVisible());
        QCOMPARE(figure("total"), QString("84.0"));
        QCOMPARE(child<QLabel>("verdict")->text(), QString("Passed"));
        QCOMPARE(child<QLabel>("sum")->text(), QString("100.0 − 4.4 − 11.6 − 0.0 = 84.0"));
        QCOMPARE(figure("lost_caries_left"), QString("−4.4"));
        QCOMPARE(figure("lost_sound_tissue"), QString("−11.6"));
        QCOMPARE(figure("lost_pulp_exposure"), QString("0"));
        const auto listed = child<ScorePage>()->findChildren<TabularDigitsLabel*>();
        QVERIFY(std::any_of(listed.begin(), listed.end(), [](const auto* label) { return label->text() == "61.0"; }));
        QVERIFY(!child<QLabel>("historyRemark")->isVisible());
        // A second grade replaces the first.
        m_window->showScore(sheet(40, 30, 0), {});
        QCOMPARE(child<QLabel>("verdict")->text(), QString("Not passed yet"));
        QCOMPARE(child<QLabel>("sum")->text(), QString("100.0 − 60.0 − 40.0 − 0.0 = 0.0"));
        QCOMPARE(child<ScorePage>()->findChildren<TabularDigitsLabel*>("lost_caries_left").size(), 1);
        QVERIFY(child<QLabel>("historyRemark")->isVisible());
        // A critical fault fails good work.
        m_window->showScore(sheet(0, 0, 0.1), {});
        QCOMPARE(figure("total"), QString("0.0"));
        QVERIFY(child<QLabel>("verdict")->text().startsWith("Not passed"));
        press(Qt::Key_Return);
        QVERIFY2(isInRoom(), "the next step is one key away");
    }

    void afterAPassTheNextLessonIsOffered()
    {
        QSignalSpy chosen(m_window.get(), &MainWindow::lessonChosen);
        auto* next = child<QPushButton>("nextLesson");
        const auto nextAfter = [&](const std::string& lesson, const lessons::ScoreSheet& score) {
            beginLesson(support::assigned(lesson));
            m_window->showScore(score, {});
            if (!next->isVisible())
                return QString();
            press(Qt::Key_Return);
            return chosen.isEmpty() ? QString("none")
                                    : QString::fromStdString(chosen.takeLast().front().value<lessons::Lesson>().id);
        };
        const lessons::ScoreSheet pass = sheet(0, 0, 0);
        m_window->lessonsPage().setLessons(support::catalog(), {});
        QCOMPARE(nextAfter("class1-36", sheet(40, 30, 0)), QString());
        QCOMPARE(nextAfter("class1-36", pass), QString("class1-37"));
        QVERIFY(isInRoom());
        // Assigned lessons that are not passed come first, each once.
        const ui::catalog::Given given{"Year 1", {}, {}};
        const ui::catalog::Given usedUp{"Year 1", {}, 0};
        m_window->lessonsPage().setLessons(support::catalog(), {},
                                           {{"class1-36", given}, {"class1-34", usedUp}, {"class1-27", given}});
        QCOMPARE(nextAfter("class1-36", pass), QString("class1-27"));
        QCOMPARE(nextAfter("class1-27", pass), QString("class1-35"));
        // A grade without a lesson, and one that is looked at again, offer none.
        beginLesson(lessons::practiceOn(support::syntheticMolar()).value());
        m_window->showScore(pass, {});
        QVERIFY(!next->isVisible());
        m_window->showOldScore([] { return QString("Class I on 36"); }, pass, {}, {}, {});
        QVERIFY(!next->isVisible());
    }

    /// Nothing is left to do at the tooth of an exam that is graded.
    void afterAnExamTheLessonsFollow()
    {
        QSignalSpy wanted(m_window.get(), &MainWindow::lessonsRequested);
        m_window->lessonsPage().setLessons(support::catalog(), {});
        beginLesson(support::exam());
        m_window->showScore(sheet(40, 30, 0), {});
        QVERIFY(!child<QPushButton>("nextLesson")->isVisible());
        press(Qt::Key_Return);
        QVERIFY(child<LessonsPage>()->isVisible());
        QCOMPARE(wanted.count(), 1);  // with the score and the attempts that are left
    }

    void theFirstWindowFitsTheScreen()
    {
        for (const auto& [screen, size] : {std::pair(QSize(1024, 560), QSize(1016, 520)),
                                           {QSize(1366, 768), QSize(1280, 728)},
                                           {QSize(1920, 1080), QSize(1280, 800)},
                                           {QSize(640, 480), QSize(800, 460)}}) {
            QCOMPARE(MainWindow::firstSize(screen), size);
            m_window->resize(size);
            QTRY_COMPARE(m_window->size(), size);
        }
    }

    void everyControlHasAName()
    {
        int controls = 0;
        for (QWidget* widget : m_window->findChildren<QWidget*>()) {
            const bool control =
                qobject_cast<QAbstractButton*>(widget) != nullptr || qobject_cast<QSlider*>(widget) != nullptr ||
                qobject_cast<QProgressBar*>(widget) != nullptr || (widget->focusPolicy() & Qt::TabFocus) != 0;
            if (!control || widget->objectName().startsWith("qt_"))
                continue;
            QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(widget);
            QVERIFY(spoken != nullptr);
            const bool silent = spoken->text(QAccessible::Name).trimmed().isEmpty();
            // A button of the message bar without words is not there for anyone.
            if (silent && qobject_cast<MessageBar*>(widget->parentWidget()) != nullptr && !widget->isVisible())
                continue;
            QVERIFY2(!silent, qPrintable(QString("%1 in %2")
                                             .arg(widget->metaObject()->className(),
                                                  widget->parentWidget()->metaObject()->className())));
            ++controls;
        }
        QVERIFY(controls > 40);
    }

    void coloursCanBeRead()
    {
        for (const QPalette& p : {pagePalette(false), pagePalette(true), roomPalette()}) {
            for (const auto ground : {QPalette::Window, QPalette::Base, QPalette::Button}) {
                for (const auto words : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
                                         QPalette::PlaceholderText, QPalette::Link})
                    QVERIFY2(contrast(p.color(words), p.color(ground)) >= 4.5,
                             qPrintable(p.color(words).name() + " on " + p.color(ground).name()));
                const Tones tone = tones(p);
                for (const QColor& words : {tone.attentionText, tone.harmText})
                    QVERIFY(contrast(words, p.color(ground)) >= 4.5);
                for (const QColor& shape : {tone.accent, tone.attention, tone.harm})
                    QVERIFY2(contrast(shape, p.color(ground)) >= 3.0, qPrintable(shape.name()));
            }
            QVERIFY(contrast(p.color(QPalette::HighlightedText), p.color(QPalette::Highlight)) >= 4.5);
            QVERIFY(contrast(p.color(QPalette::WindowText), p.color(QPalette::Midlight)) >= 4.5);
        }
        QVERIFY(qAbs(contrast(Qt::black, Qt::white) - 21.0) < 1e-6);
    }

private:
    /// The titles of the lessons that are listed, without the headings.
    [[nodiscard]] QStringList cards() const
    {
        QStringList titles;
        const auto* model = child<QListView>("lessonList")->model();
        for (int row = 0; row < model->rowCount(); ++row)
            if (const QModelIndex card = model->index(row, 0); card.data(ui::catalog::CardEntry).isValid())
                titles << card.data().toString();
        return titles;
    }
    [[nodiscard]] QLineEdit* search() const { return child<LessonsPage>()->findChild<QLineEdit*>(); }
    [[nodiscard]] QString lessonTitle() const { return child<QLabel>("lessonTitle")->text(); }
};

CUSP_TEST(TestWindowPages)
#include "tst_window_pages.moc"
