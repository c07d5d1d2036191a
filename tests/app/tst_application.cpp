// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program behind a real window: its threads run, the mouse drills.
#include <algorithm>
#include <array>

#include <QAction>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QScopeGuard>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <glm/geometric.hpp>

#include "core/recording/JournalFile.h"
#include "core/servo/ServoState.h"
#include "core/teeth/Block.h"
#include "database/sql/Database.h"
#include "database/sql/Statement.h"
#include "tests/app/ProgramWindow.h"
#include "tests/support/Files.h"
#include "tests/support/OpenGlMain.h"
#include "ui/kit/Actions.h"
#include "ui/kit/MessageBar.h"
#include "ui/kit/TabularDigitsLabel.h"
#include "ui/people/LoginPage.h"
#include "ui/practice/HistoryPanel.h"
#include "ui/scoring/ScorePage.h"
#include "ui/scoring/ScorePredictionPage.h"
#include "ui/tooth/ToothView.h"

using support::kPatienceMs;

class TestApplication : public support::ProgramWindow
{
    Q_OBJECT
private slots:
    void init()
    {
        QLocale::setDefault(QLocale("en_GB"));
        m_folder = std::make_unique<QTemporaryDir>();
    }

    void cleanup() { m_application.reset(); }

    /// All three exercises, by the mouse, as somebody does them who has never held a handpiece.
    void theFirstMinutesFromBeginningToEnd()
    {
        start();
        WAIT_FOR(actions().drill->isChecked());
        const lessons::Lesson touch = openLesson("orientation-1-touch");
        lookFromAbove();
        WAIT_FOR(!actions().drill->isChecked());
        QCOMPARE(title(), QString("0 of 6 points touched"));
        actions().grade->trigger();
        waitForMessage("not been started");
        // With the bur turning nothing counts as touched, which is said.
        const auto* const advice = child<QLabel>("exerciseAdvice");
        for (const bool turns : {true, false}) {
            actions().drill->trigger();
            WAIT_FOR_VALUE(advice->text().contains("space bar"), turns);
        }
        const std::array<std::size_t, 6> order{3, 0, 5, 1, 4, 2};
        for (std::size_t n = 0; n < order.size(); ++n)
            touchUntil(touch.touch->pointsMm[order[n]],
                       n < 5 ? QString("%1 of 6 points touched").arg(n + 1) : QString("All 6 points touched"));
        QCOMPARE(graded(), QString("100.0"));
        // The same is not graded twice: the page comes without a question.
        actions().back->trigger();
        grade();
        // Begun anew, nothing is touched.
        waitForNewTooth([this] { actions().reload->trigger(); });
        WAIT_FOR_VALUE(title(), QString("0 of 6 points touched"));

        openMadeLesson(R"({"format": 1, "based_on": "0-orientation-2-hold.lesson.json", "id": "hold",
                                  "hold": {"seconds": 2}})");
        lookFromAbove();
        WAIT_FOR_VALUE(title(), QString("Hold 1.0 N for 2 s"));
        window().view().setPushForce(1.0);
        pressAt({-0.27, 0.64});
        WAIT_FOR_VALUE(title(), QString("Held for 2 s"));
        release();
        QCOMPARE(
            graded(),
            QString("52.0"));  // holding 2 s of 10 s earns 12 of 60 points, the other criteria earn all of their 40
        actions().back->trigger();

        openLesson("orientation-3-layers");
        lookFromAbove();
        WAIT_FOR(actions().drill->isChecked());
        QVERIFY(!child<ui::kit::TabularDigitsLabel>("materialFigure")->isVisible());
        pressAt({core::teeth::kPadX[0], 0.0});
        WAIT_FOR(hasCut());
        release();
        waitForStrokeEnd();
        const auto made = core::teeth::padMaterials(window().view().tooth()->anatomy->seed);
        const auto choose = [&](std::size_t pad, core::terrain::Material said) {
            click(qPrintable(QStringLiteral("pad%1%2").arg(pad).arg(static_cast<int>(said))));
        };
        choose(0, made[0]);
        choose(1, made[2]);
        choose(1, made[1]);  // thought better of it
        choose(2, made[0]);
        QCOMPARE(title(), QString("Every pad has an answer"));
        QCOMPARE(graded(), QString("70.0"));  // two of three: 90 * 2 / 3 and 10 for the force
        actions().back->trigger();
        QVERIFY(child<ui::kit::TabularDigitsLabel>("materialFigure")->isVisible());
        QVERIFY(child<QLabel>("padTruth0")->text().contains("right"));
        QVERIFY(child<QLabel>("padTruth2")->text().contains("it is"));
    }

    void theSameWorkIsGradedOnceAndExplained()
    {
        start();
        logIn();
        const auto rows = [this] {
            const auto database = database::sql::Database::open(m_folder->filePath("school.sqlite")).value();
            return database::sql::ask(database->handle(),
                                      "SELECT count(*) FROM attempts WHERE tooth = '36' AND person_id IS NOT NULL",
                                      "count")
                ->toInt();
        };
        // A whole tooth is no attempt.
        actions().grade->trigger();
        WAIT_FOR(message().contains("not ready") || message().contains("Nothing has been cut"));
        QVERIFY(!child<ui::scoring::ScorePage>()->isVisible());
        QCOMPARE(rows(), 0);
        for (int attempt = 1; attempt <= 2; ++attempt) {
            drill(attempt == 1 ? -2.0 : 2.0);
            grade();
            WAIT_FOR_VALUE(rows(), attempt);
            grade();
            // The school answers in order: what comes after a second attempt shows that there is none.
            actions().attempts->trigger();
            WAIT_FOR_VALUE(child<QTableView>("attempts")->model()->rowCount(), attempt);
            goBackTo<ui::tooth::ToothView>();
            QCOMPARE(rows(), attempt);
        }
        // Moments and other grids come when they are found; shown again, the same grade has them at once. A moment
        // is asked for as a click does, and the attempt is played from there.
        window().view().setCamera(40.0, 62.0, 35.0);
        drill({0.0, -2.0, -1.0});
        const QString own = removed();
        actions().grade->trigger();
        const auto areMomentsKnown = [this] {
            const auto words = child<ui::scoring::ScorePage>()->findChildren<QLabel*>();
            return std::any_of(words.begin(), words.end(),
                               [](const QLabel* label) { return label->text().contains("not removed"); });
        };
        WAIT_FOR(areMomentsKnown());
        child<QToolButton>("scoreDetails")->setChecked(true);
        WAIT_FOR(child<QLabel>("noise")->isVisible());
        QVERIFY2(child<QLabel>("noise")->text().contains("pass mark"), qPrintable(child<QLabel>("noise")->text()));
        WAIT_FOR(child<QLabel>("class")->isVisible());
        actions().back->trigger();
        actions().grade->trigger();
        waitForPage<ui::scoring::ScorePage>();
        QVERIFY(areMomentsKnown());
        QVERIFY(child<QLabel>("noise")->isVisible());
        window().view().setCamera(-140.0, 20.0, 35.0);
        emit child<ui::scoring::ScorePage>()->momentRequested(1000.0);
        waitForReplay();
        QVERIFY(!child<ui::scoring::ScorePage>()->isVisible());
        WAIT_FOR_VALUE(removed(), own);  // how it ended
        // The eye is where the student had it while they drilled.
        WAIT_FOR(std::abs(window().view().camera().elevationDeg() - 62.0) < 0.1);
        QVERIFY(std::abs(window().view().camera().azimuthDeg() - 40.0) < 0.1);
    }

    /// After another bur, another view, a zoom and a jump of the pointer. Deeper down the bur leaves the ray: it goes
    /// straight down while the pointer rests.
    void whatIsCutIsUnderThePointer()
    {
        start();
        auto& view = window().view();
        QPoint at;
        double mostMm = 0.0;
        bool hasCut = false;
        const auto compare = [&](const core::servo::ServoState& state) {
            if (!state.cutting || std::exchange(hasCut, true))
                return;
            const ui::render::Ray ray = view.camera().rayThrough({at.x() + 0.5, at.y() + 0.5});
            mostMm = std::max(mostMm, glm::length(glm::cross(state.anchorMm - ray.originMm, ray.direction)));
        };
        connect(&view, &ui::tooth::ToothView::frameAdvanced, this, compare);
        struct Jump
        {
            int bur;
            double azimuthDeg;
            double elevationDeg;
            double distanceMm;
            glm::dvec3 placeMm;
        };
        for (const Jump& jump : {Jump{0, 0.0, 88.0, 40.0, {-2.5, 1.0, -1.0}},
                                 {1, 40.0, 60.0, 30.0, {2.0, -1.0, -1.0}},
                                 {3, -60.0, 50.0, 45.0, {-1.5, -2.0, -1.0}},
                                 {0, 0.0, 75.0, 25.0, {1.5, 1.5, -1.0}}}) {
            actions().burs[jump.bur]->trigger();
            view.setCamera(jump.azimuthDeg, jump.elevationDeg, jump.distanceMm);
            const QString before = removed();
            hasCut = false;
            at = press(jump.placeMm);
            WAIT_FOR(removed() != before && hasCut);
            QTest::mouseRelease(&view, Qt::LeftButton, {}, at);
            waitForStrokeEnd();
        }
        disconnect(&view, &ui::tooth::ToothView::frameAdvanced, this, nullptr);
        QVERIFY2(mostMm > 0.0 && mostMm < 0.15, qPrintable(QString("%1 mm").arg(mostMm)));
    }

    void stoppingAReplayBringsTheOwnWorkBack()
    {
        start();
        drillFirst();
        const QString recording = save();
        const QString first = removed();
        drillSecond();
        const QString own = removed();
        const QImage tooth = window().view().toothPicture();
        emit window().recordingOpenRequested(recording);
        waitForReplay();
        WAIT_FOR(removed() != own);
        actions().back->trigger();
        QVERIFY(message().contains("your own work"));
        WAIT_FOR_VALUE(removed(), own);
        QCOMPARE(window().view().toothPicture(), tooth);
        // And it goes on from there.
        QVERIFY(actions().undo->isEnabled());
        drill({0.0, -2.0, -1.0});
        // After two replays it is still asked about.
        for (int n = 0; n < 2; ++n) {
            emit window().recordingOpenRequested(recording);
            QVERIFY(!actions().openRecording->isEnabled());
            WAIT_FOR(actions().openRecording->isEnabled());
            waitForReplay();
            WAIT_FOR_VALUE(removed(), first);
        }
        window().close();
        QVERIFY(window().isVisible());
        QVERIFY(child<QWidget>("workQuestion") != nullptr);
    }

    void aMomentOfTheOwnAttemptIsShownAlsoBesideAnother()
    {
        start();
        drillFirst();
        const QString own = removed();
        QVERIFY(own != "0.00");
        const QString recording = save();
        waitForTicks(1500);  // an attempt of more than a second
        grade();
        m_application->showMoment(1.0e6);
        // It plays the last seconds and rests at the end.
        WAIT_FOR(actions().pauseReplay->text().startsWith("Resume"));
        const auto time = [this] { return child<ui::kit::TabularDigitsLabel>("replayTime")->text(); };
        // To a second, for the words are rounded.
        const auto seconds = [&](int part) {
            const QStringList words = time().section(" of ", part, part).split(u':');
            return 60 * words.front().toInt() + words.back().toInt();
        };
        QTRY_VERIFY2_WITH_TIMEOUT(seconds(1) > 0 && seconds(1) - seconds(0) <= 1, qPrintable(time()), kPatienceMs);
        WAIT_FOR_VALUE(removed(), own);
        const QImage cut = window().view().toothPicture();
        // What is said at the end is not said elsewhere.
        window().replayView().showEnd();
        QVERIFY(message().contains("recording has ended"));
        actions().stepBack->trigger();
        QVERIFY2(!message().contains("recording has ended"), qPrintable(message()));
        // Back to before it was cut, and forth to what the stroke has left.
        actions().replayBegin->trigger();
        WAIT_FOR_VALUE(removed(), QString("0.00"));
        QVERIFY(window().view().toothPicture() != cut);
        actions().stepOn->trigger();
        WAIT_FOR_VALUE(removed(), own);
        QCOMPARE(window().view().toothPicture(), cut);
        actions().stepBack->trigger();
        WAIT_FOR_VALUE(removed(), QString("0.00"));
        // To the card, where the other moments are, and from there to the tooth.
        actions().back->trigger();
        QVERIFY(child<ui::scoring::ScorePage>()->isVisible());
        actions().back->trigger();
        WAIT_FOR_VALUE(removed(), own);

        // Opens the recording of the first stroke, to compare it with the attempt that has both strokes.
        drillSecond();
        const QString both = removed();
        grade();
        m_application->showMoment(1.0e6);
        for (int n = 0; n < 2; ++n) {  // another one takes its place
            emit window().replayView().besideRequested(recording);
            WAIT_FOR(actions().beside->isEnabled() && views().size() == 2);
        }
        const auto* beside = views().front() == &window().view() ? views().back() : views().front();
        // Both at their ends: what the first stroke has left, and what both have.
        actions().replayEnd->trigger();
        // Sent to the beginning while it plays, it would play on.
        WAIT_FOR(actions().pauseReplay->text().startsWith("Resume"));
        const auto cutIn = [](const ui::tooth::ToothView& view) {
            double sum = 0.0;
            for (std::size_t k = 0; k < view.tooth()->top.size(); ++k)
                sum += static_cast<double>(view.tooth()->anatomy->top[k] - view.tooth()->top[k]);
            return sum;
        };
        WAIT_FOR(cutIn(*beside) > 0.0 && cutIn(window().view()) > cutIn(*beside));
        actions().replayBegin->trigger();
        WAIT_FOR(cutIn(*beside) == 0.0 && cutIn(window().view()) == 0.0);
        actions().beside->trigger();
        QCOMPARE(views().size(), 1);
        emit window().replayView().besideRequested(recording);
        WAIT_FOR_VALUE(views().size(), 2);
        actions().back->trigger();
        QCOMPARE(views().size(), 1);
        goBackTo<ui::tooth::ToothView>();
        WAIT_FOR_VALUE(removed(), both);
    }

    /// A recording is played by someone without work of their own: an expert can be put beside it, and it leaves a
    /// whole tooth.
    void aRecordingIsPlayedBesideItsExpert()
    {
        start();
        static_cast<void>(openLesson("decay-36-small"));
        drillFirst();
        const QString recording = save();
        m_application.reset();
        start(recording);
        waitForReplay();
        WAIT_FOR(actions().expert->isVisible() && actions().expert->isEnabled());
        actions().expert->trigger();
        // The end of what is played may be told over the sentence about it: the view itself says whose hand it is.
        const auto isShown = [this] {
            const auto all = views();
            return all.size() == 2 && std::any_of(all.begin(), all.end(), [](const ui::tooth::ToothView* view) {
                       return view->accessibleName() == "The simulated hand";
                   });
        };
        WAIT_FOR(isShown());
        actions().back->trigger();
        QVERIFY(message().contains("intact"));
        WAIT_FOR_VALUE(removed(), QString("0.00"));
        drillFirst();
    }

    void aHandIsLedAlongARecording()
    {
        start({}, ui::devices::kSimulated);
        QVERIFY(labelWith("The simulated handpiece is active") != nullptr);
        const QString before = removed();
        WAIT_FOR(removed() != before);
        waitForTicks(1500);
        grade();
        m_application->showMoment(1.0e6);
        WAIT_FOR(actions().along->isEnabled());
        const auto apartMm = [this] { return glm::length(servo().deviceMm - servo().anchorMm); };
        // Where the machine stands still for a moment the hand seems to hold against it, and is let go.
        for (int tries = 0; tries < 5 && !actions().along->isChecked(); ++tries) {
            actions().replayBegin->trigger();
            actions().along->trigger();
            WAIT_FOR(apartMm() < 3.0);
            if (actions().pauseReplay->text().startsWith("Resume"))
                actions().pauseReplay->trigger();
            const auto isOneSecondOn = [this] {
                return child<ui::kit::TabularDigitsLabel>("replayTime")->text().startsWith("0:01");
            };
            WAIT_FOR(isOneSecondOn() || !actions().along->isChecked());
        }
        QVERIFY2(actions().along->isChecked(), qPrintable("a hand that goes along is not let go: " + message()));
        QVERIFY2(apartMm() < 3.0, qPrintable(QString("%1 mm").arg(apartMm())));
        actions().along->trigger();
        actions().back->trigger();
        WAIT_FOR(!actions().along->isVisible());
    }

    void theUndoHistoryLeadsToAnyMoment()
    {
        start();
        actions().history->trigger();
        const auto* list = &child<ui::practice::HistoryPanel>("historyPanel")->list();
        drillFirst();
        const QString first = removed();
        WAIT_FOR_VALUE(list->model()->rowCount(), 2);
        actions().undo->trigger();
        WAIT_FOR_VALUE(removed(), QString("0.00"));
        drillSecond();
        const QString second = removed();
        WAIT_FOR_VALUE(list->model()->rowCount(), 3);
        const auto goTo = [&](int row) {
            QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                              list->visualRect(list->model()->index(row, 0)).center());
        };
        goTo(1);  // what was undone
        WAIT_FOR_VALUE(removed(), first);
        goTo(2);
        WAIT_FOR_VALUE(removed(), second);
        goTo(0);
        WAIT_FOR_VALUE(removed(), QString("0.00"));
        QVERIFY(list->model()->index(0, 0).data().toString().contains("present"));
    }

    void anUnfinishedAttemptIsOfferedAndResumed()
    {
        const QString own = leaveUnfinished();
        // A killed program keeps its locks until its process has ended.
        auto held = core::recording::findAttempt(
            std::filesystem::path(m_folder->filePath("unfinished/1-1.cuspjournal").toStdString()));
        QVERIFY(held && *held);
        start();
        QVERIFY(!isOffered());
        held->reset();
        waitForOffer();
        // It is not opened unasked; put away, it is offered again with the lessons.
        QVERIFY(removed() != own && !actions().undo->isEnabled());
        actions().back->trigger();
        QVERIFY(!isOffered());
        actions().lessons->trigger();
        WAIT_FOR(child<QLabel>("continueWords")->text().contains("Tooth 36"));
        waitForNewTooth([this] { click("continue"); });
        WAIT_FOR_VALUE(removed(), own);
        QCOMPARE(journals(), QStringList{"1-1.cuspjournal"});
        WAIT_FOR(actions().undo->isEnabled());
        WAIT_FOR(actions().burs[3]->isChecked());  // the bur that was in use last
        drillSecond();
        // The same file holds what is done from now on.
        const QString again = removed();
        QVERIFY(killWithJournal().endsWith("1-1.cuspjournal"));
        start();
        waitForOffer();
        waitForNewTooth([this] { answer(); });
        WAIT_FOR_VALUE(removed(), again);
        actions().undo->trigger();
        WAIT_FOR_VALUE(removed(), own);
        // A program that ends in order leaves nothing behind.
        m_application.reset();
        QVERIFY(journals().isEmpty());
    }

    void discardedAttemptsMakeWayForOlderOnes()
    {
        // The second click of a double click is not meant for the next question.
        const int usual = QApplication::doubleClickInterval();
        const auto asItWas = qScopeGuard([usual] { QApplication::setDoubleClickInterval(usual); });
        QApplication::setDoubleClickInterval(0);
        static_cast<void>(leaveUnfinished());
        const QDir folder(m_folder->filePath("unfinished"));
        QVERIFY(QFile::copy(folder.filePath("1-1.cuspjournal"), folder.filePath("2-1.cuspjournal")));
        support::write(folder.filePath("3-1.cuspjournal"), "This is no journal.");
        start();
        waitForOffer();
        QCOMPARE(journals("discarded"), QStringList{"3-1.cuspjournal"});
        answer("decline");
        WAIT_FOR_VALUE(journals("discarded").size(), 2);
        waitForOffer();
        answer("decline");
        WAIT_FOR_VALUE(journals("discarded").size(), 3);
        QVERIFY(journals().isEmpty());
        // That can be undone.
        waitForMessage("kept for seven days");
        answer();
        waitForOffer();
        QCOMPARE(journals().size(), 1);
        answer("decline");
        WAIT_FOR(journals("discarded").size() == 3 && journals().isEmpty());
        while (!message().isEmpty() && !message().contains("cannot be resumed"))
            child<ui::kit::MessageBar>()->dismiss();
        QVERIFY(message().contains("cannot be resumed"));
    }

    /// The time of an exam runs on while the student is away or the program does not run. A graded exam is not
    /// resumed.
    void anExamsTimeGoesOnWhileItsStudentIsAway()
    {
        start();
        openMadeLesson(R"({"format": 1, "based_on": "decay-36-2-moderate.lesson.json", "id": "exam-36",
                                  "exam": true, "minutes": 10})");
        drillFirst();
        const QString kept = m_folder->filePath("kept.cuspjournal");
        QVERIFY(QFile::rename(killWithJournal(), kept));
        // It was begun four minutes ago.
        const auto found = core::recording::findAttempt(kept.toStdString());
        QVERIFY(found && *found);
        const std::int64_t begunUtcMs = QDateTime::currentMSecsSinceEpoch() - 240'000;
        auto made = core::recording::JournalFile::create(m_folder->filePath("unfinished/1-1.cuspjournal").toStdString(),
                                                         (*found)->recording, begunUtcMs);
        QVERIFY(made && (*made)->sync());
        made->reset();
        start();
        waitForMessage("an attempt of");
        waitForNewTooth([this] { answer(); });
        const auto* left = child<ui::kit::TabularDigitsLabel>("lessonTime");
        QTRY_VERIFY2_WITH_TIMEOUT(left->text().startsWith("5:"), qPrintable(left->text()), kPatienceMs);
        gradeUntil<ui::scoring::ScorePredictionPage>();
        expectScore();
        static_cast<void>(killWithJournal());
        start();
        WAIT_FOR_VALUE(journals("discarded").size(), 1);
        QVERIFY(!message().contains("an attempt of"));
    }

private:
    void start(const QString& recording = {}, const QString& device = {})
    {
        app::WindowOptions options;
        options.source = {36};
        options.recording = recording;
        options.device = device;
        begin(options);
        waitForTooth();
    }

    /// As the admin who creates the school.
    void logIn() const
    {
        window().account().askLogin();
        emit window().loginPage().schoolRequested({"admin", "Ada", "Admin", database::Role::Admin}, "correct horse");
        WAIT_FOR_VALUE(actions().account->text(), QString("admin"));
        actions().back->trigger();
        waitForTooth();
    }

    void drillFirst() const { drill(-2.0); }
    void drillSecond() const { drill(2.0); }
    /// Saves what was done as a recording. Returns its path.
    [[nodiscard]] QString save() const
    {
        const QString path = m_folder->filePath("first.cusprec");
        emit window().unsavedWork().recordingSaveRequested(path);
        if (!QTest::qWaitFor([this] { return message().contains("saved"); }, kPatienceMs))
            qFatal("the recording is not saved");
        return path;
    }

    /// Presses on a place of the tooth until the exercise has this title.
    void touchUntil(glm::dvec2 placeMm, const QString& expectedTitle) const
    {
        // The room may still be laid out when the first point is pressed.
        for (int tries = 0; tries < 5 && title() != expectedTitle; ++tries) {
            pressAt(placeMm);
            static_cast<void>(QTest::qWaitFor([&] { return title() == expectedTitle; }, 3000));
            release();
            WAIT_FOR(!servo().touching);
        }
        QCOMPARE(title(), expectedTitle);
    }

    /// Brings the bur over a place of the tooth and presses the button.
    void pressAt(glm::dvec2 placeMm) const
    {
        ui::tooth::ToothView& view = window().view();
        const core::terrain::Tooth& tooth = *view.tooth();
        const glm::dvec2 node = tooth.anatomy->grid.latticeOf(placeMm);
        const std::size_t k = tooth.anatomy->grid.index(qRound(node.x), qRound(node.y));
        const glm::dvec3 point(placeMm, static_cast<double>(tooth.anatomy->top[k]));
        const glm::dvec2 pixel = view.camera().pixelOf(point);
        QTest::mouseMove(&view, QPoint(qRound(pixel.x), qRound(pixel.y)));
        WAIT_FOR(glm::distance(glm::dvec2(servo().anchorMm), placeMm) < 0.3);
        press(point);
    }

    /// From above, so that nothing stands before anything.
    void lookFromAbove() const
    {
        ui::tooth::ToothView& view = window().view();
        view.setCamera(0.0, 85.0, view.camera().distanceMm());
    }

    [[nodiscard]] QString title() const { return child<QLabel>("exerciseTitle")->text(); }
    /// Has the exercise graded by the button of its card. Returns the total.
    [[nodiscard]] QString graded() const
    {
        if (!child<QPushButton>("exerciseGrade")->isVisible())
            return QStringLiteral("is not offered");
        click("exerciseGrade");
        if (!QTest::qWaitFor([this] { return child<ui::scoring::ScorePredictionPage>()->isVisible(); },
                             support::kSecondTryMs))
            gradeUntil<ui::scoring::ScorePredictionPage>();
        expectScore();
        return child<ui::kit::TabularDigitsLabel>("total")->text();
    }

    /// Has the work graded and goes back to it.
    void grade() const
    {
        gradeUntil<ui::scoring::ScorePage>();
        actions().back->trigger();
    }

    /// Starts, drills and is killed. Returns how much enamel was removed.
    QString leaveUnfinished()
    {
        start();
        drillFirst();
        actions().burs[3]->trigger();
        const QString own = removed();
        if (!QFile::rename(killWithJournal(), m_folder->filePath("unfinished/1-1.cuspjournal")))
            qFatal("there is no unfinished attempt");
        return own;
    }

    [[nodiscard]] bool isOffered() const { return message().contains("Tooth 36: an attempt of"); }
    void waitForOffer() const { WAIT_FOR(isOffered()); }
    void answer(const char* button = "") const
    {
        QTest::mouseClick(child<ui::kit::MessageBar>()->findChild<QPushButton*>(QString::fromLatin1(button)),
                          Qt::LeftButton);
    }
    void waitForReplay() const { WAIT_FOR(actions().pauseReplay->isEnabled()); }
    [[nodiscard]] QList<ui::tooth::ToothView*> views() const { return window().findChildren<ui::tooth::ToothView*>(); }
};

int main(int argc, char** argv)
{
    return support::openGlMain<TestApplication>(argc, argv);
}

#include "tst_application.moc"
