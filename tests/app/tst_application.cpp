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
#include "core/teeth/Block.h"
#include "database/sql/Database.h"
#include "database/sql/Statement.h"
#include "lessons/LessonReader.h"
#include "tests/app/ProgramWindow.h"
#include "tests/support/OpenGlMain.h"
#include "ui/replay/HistoryPanel.h"
#include "ui/shell/Actions.h"
#include "ui/shell/MessageBar.h"
#include "ui/shell/TabularLabel.h"
#include "ui/study/ScorePage.h"
#include "ui/tooth/ToothView.h"

using support::kPatienceMs;

class TestApplication : public support::ProgramWindow
{
    Q_OBJECT
private slots:
    void init();
    void cleanup() { m_application.reset(); }

    void theFirstMinutesFromBeginningToEnd();
    void theSameWorkIsGradedOnce();
    void aScoreIsExplainedInTheBackground();
    void stoppingAReplayBringsTheOwnWorkBack();
    void aMomentOfTheOwnAttemptIsShownAndLeft();
    void anotherAttemptIsPlayedBeside();
    void theExpertOfWhatIsPlayedIsPutBeside();
    void aHandIsLedAlongARecording();
    void theUndoHistoryLeadsToAnyMoment();
    void stoppingTheReplayOfWhoHasNoWorkGivesAWholeTooth();
    void anUnfinishedAttemptIsOfferedWhenItIsLetGo();
    void anUnfinishedAttemptIsOfferedAndResumed();
    void discardedAttemptsMakeWayForOlderOnes();
    void anExamThatWasGradedIsNotResumed();
    void anExamsTimeGoesOnWhileItsStudentIsAway();

private:
    void start(const QString& recording = {}, bool simulatedDevice = false);
    /// As the admin who creates the school.
    void logIn() const;
    void drillFirst() const { drill(-2.0); }
    void drillSecond() const { drill(2.0); }
    /// Saves what was done as a recording. Returns its path.
    [[nodiscard]] QString save() const;
    /// Writes an exam and reads it as a lesson.
    [[nodiscard]] lessons::Lesson exam() const;
    /// Presses on a place of the tooth until the exercise has this title.
    void touchUntil(glm::dvec2 placeMm, const QString& expectedTitle) const;
    /// Brings the bur over a place of the tooth and presses the button.
    void pressAt(glm::dvec2 placeMm) const;
    /// From above, so that nothing stands before anything.
    void lookFromAbove() const;
    [[nodiscard]] QString title() const { return child<QLabel>("exerciseTitle")->text(); }
    /// Has the exercise graded by the button of its card. Returns the total.
    [[nodiscard]] QString graded() const;
    /// Has the work graded and goes back to it.
    void grade() const;
    /// Starts, drills and is killed. Returns how much enamel was removed.
    QString leaveUnfinished();
    [[nodiscard]] bool isOffered() const { return message().contains("Tooth 36: an attempt of"); }
    void waitForOffer() const { QTRY_VERIFY2_WITH_TIMEOUT(isOffered(), qPrintable(message()), kPatienceMs); }
    void answer(const char* button = "") const
    {
        QTest::mouseClick(child<ui::shell::MessageBar>()->findChild<QPushButton*>(QString::fromLatin1(button)),
                          Qt::LeftButton);
    }
    void waitForReplay() const { QTRY_VERIFY_WITH_TIMEOUT(actions().pauseReplay->isEnabled(), kPatienceMs); }
    [[nodiscard]] QList<ui::tooth::ToothView*> views() const { return window().findChildren<ui::tooth::ToothView*>(); }
};

void TestApplication::init()
{
    QLocale::setDefault(QLocale("en_GB"));
    m_folder = std::make_unique<QTemporaryDir>();
}

void TestApplication::start(const QString& recording, bool simulatedDevice)
{
    app::WindowOptions options;
    options.source = {36};
    options.recording = recording;
    options.simulatedDevice = simulatedDevice;
    begin(options);
    waitForTooth();
}

void TestApplication::logIn() const
{
    window().askLogin();
    emit window().schoolWanted({"admin", "Ada", "Admin", database::Role::Admin}, "correct horse");
    QTRY_COMPARE_WITH_TIMEOUT(actions().account->text(), QString("admin"), kPatienceMs);
    actions().back->trigger();
    waitForTooth();
}

QString TestApplication::save() const
{
    const QString path = m_folder->filePath("first.cusprec");
    emit window().recordingSaveRequested(path);
    if (!QTest::qWaitFor([this] { return message().contains("saved"); }, kPatienceMs))
        qFatal("the recording is not saved");
    return path;
}

lessons::Lesson TestApplication::exam() const
{
    QFile file(m_folder->filePath("exam.lesson.json"));
    if (!file.open(QIODevice::WriteOnly))
        qFatal("the exam cannot be written");
    file.write(R"({"format": 1, "based_on": "decay-36-2-moderate.lesson.json", "id": "exam-36", "exam": true,
                   "minutes": 10})");
    file.close();
    return lessons::readLesson(file.fileName()).lesson.value();
}

void TestApplication::grade() const
{
    actions().grade->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::ScorePage>()->isVisible(), kPatienceMs);
    actions().back->trigger();
}

QString TestApplication::leaveUnfinished()
{
    start();
    drillFirst();
    actions().burs[3]->trigger();
    const QString own = removed();
    if (!QFile::rename(killWithJournal(), m_folder->filePath("unfinished/1-1.cuspjournal")))
        qFatal("there is no unfinished attempt");
    return own;
}

/// A program that dies holds what it has locked until it is gone.
void TestApplication::anUnfinishedAttemptIsOfferedWhenItIsLetGo()
{
    static_cast<void>(leaveUnfinished());
    auto held = core::recording::findAttempt(
        std::filesystem::path(m_folder->filePath("unfinished/1-1.cuspjournal").toStdString()));
    QVERIFY(held && *held);
    start();
    QVERIFY(!isOffered());
    held->reset();
    waitForOffer();
}

void TestApplication::anUnfinishedAttemptIsOfferedAndResumed()
{
    const QString own = leaveUnfinished();
    start();
    waitForOffer();
    // It is not opened unasked; put away, it is offered again with the lessons.
    QVERIFY(removed() != own && !actions().undo->isEnabled());
    actions().back->trigger();
    QVERIFY(!isOffered());
    actions().lessons->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("continueWords")->text().contains("Tooth 36"), kPatienceMs);
    waitForNewTooth([this] { click("continue"); });
    QTRY_COMPARE_WITH_TIMEOUT(removed(), own, kPatienceMs);
    QCOMPARE(journals(), QStringList{"1-1.cuspjournal"});
    QTRY_VERIFY_WITH_TIMEOUT(actions().undo->isEnabled(), kPatienceMs);
    QTRY_VERIFY2_WITH_TIMEOUT(actions().burs[3]->isChecked(), "the bur that was in use last", kPatienceMs);
    drillSecond();
    // The same file holds what is done from now on.
    const QString again = removed();
    QVERIFY(killWithJournal().endsWith("1-1.cuspjournal"));
    start();
    waitForOffer();
    waitForNewTooth([this] { answer(); });
    QTRY_COMPARE_WITH_TIMEOUT(removed(), again, kPatienceMs);
    actions().undo->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), own, kPatienceMs);
    // A program that ends in order leaves nothing behind.
    m_application.reset();
    QVERIFY(journals().isEmpty());
}

void TestApplication::discardedAttemptsMakeWayForOlderOnes()
{
    // The second click of a double click is not meant for the next question.
    const int usual = QApplication::doubleClickInterval();
    const auto asItWas = qScopeGuard([usual] { QApplication::setDoubleClickInterval(usual); });
    QApplication::setDoubleClickInterval(0);
    static_cast<void>(leaveUnfinished());
    const QDir folder(m_folder->filePath("unfinished"));
    QVERIFY(QFile::copy(folder.filePath("1-1.cuspjournal"), folder.filePath("2-1.cuspjournal")));
    QFile broken(folder.filePath("3-1.cuspjournal"));
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("This is no journal.");
    broken.close();
    start();
    waitForOffer();
    QCOMPARE(journals("discarded"), QStringList{"3-1.cuspjournal"});
    answer("decline");
    QTRY_COMPARE_WITH_TIMEOUT(journals("discarded").size(), 2, kPatienceMs);
    waitForOffer();
    answer("decline");
    QTRY_COMPARE_WITH_TIMEOUT(journals("discarded").size(), 3, kPatienceMs);
    QVERIFY(journals().isEmpty());
    // That can be undone.
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("kept for seven days"), kPatienceMs);
    answer();
    waitForOffer();
    QCOMPARE(journals().size(), 1);
    answer("decline");
    QTRY_VERIFY_WITH_TIMEOUT(journals("discarded").size() == 3 && journals().isEmpty(), kPatienceMs);
    while (!message().isEmpty() && !message().contains("cannot be taken up again"))
        child<ui::shell::MessageBar>()->dismiss();
    QVERIFY(message().contains("cannot be taken up again"));
}

void TestApplication::anExamThatWasGradedIsNotResumed()
{
    for (const bool isGraded : {false, true}) {
        start();
        openLesson(exam());
        drillFirst();
        if (isGraded) {
            actions().grade->trigger();
            expectScore();
        }
        const QString journal = killWithJournal();
        start();
        if (isGraded) {
            QTRY_COMPARE_WITH_TIMEOUT(journals("discarded").size(), 1, kPatienceMs);
            QVERIFY(!message().contains("an attempt of"));
        } else {
            QTRY_VERIFY_WITH_TIMEOUT(message().contains("an attempt of"), kPatienceMs);
            QVERIFY(QFile::remove(journal));
        }
        m_application.reset();
    }
}

/// Whoever leaves an exam, or has its program killed, could think as long as they like.
void TestApplication::anExamsTimeGoesOnWhileItsStudentIsAway()
{
    start();
    openLesson(exam());
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
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("an attempt of"), kPatienceMs);
    waitForNewTooth([this] { answer(); });
    const auto* left = child<ui::shell::TabularLabel>("lessonTime");
    QTRY_VERIFY2_WITH_TIMEOUT(left->text().startsWith("5:"), qPrintable(left->text()), kPatienceMs);
}

void TestApplication::lookFromAbove() const
{
    ui::tooth::ToothView& view = window().view();
    view.setCamera(0.0, 85.0, view.camera().distanceMm());
}

void TestApplication::pressAt(glm::dvec2 placeMm) const
{
    ui::tooth::ToothView& view = window().view();
    const core::terrain::Tooth& tooth = *view.tooth();
    const glm::dvec2 node = tooth.anatomy->grid.latticeOf(placeMm);
    const std::size_t k = tooth.anatomy->grid.index(qRound(node.x), qRound(node.y));
    const glm::dvec3 point(placeMm, static_cast<double>(tooth.anatomy->top[k]));
    const glm::dvec2 pixel = view.camera().pixelOf(point);
    QTest::mouseMove(&view, QPoint(qRound(pixel.x), qRound(pixel.y)));
    QTRY_VERIFY_WITH_TIMEOUT(glm::distance(glm::dvec2(servo().anchorMm), placeMm) < 0.3, kPatienceMs);
    press(point);
}

void TestApplication::touchUntil(glm::dvec2 placeMm, const QString& expectedTitle) const
{
    // The room may still be laid out when the first point is pressed.
    for (int tries = 0; tries < 5 && title() != expectedTitle; ++tries) {
        pressAt(placeMm);
        static_cast<void>(QTest::qWaitFor([&] { return title() == expectedTitle; }, 3000));
        release();
        QTRY_VERIFY_WITH_TIMEOUT(!servo().touching, kPatienceMs);
    }
    QCOMPARE(title(), expectedTitle);
}

QString TestApplication::graded() const
{
    if (!child<QPushButton>("exerciseGrade")->isVisible())
        return QStringLiteral("is not offered");
    click("exerciseGrade");
    expectScore();
    return child<ui::shell::TabularLabel>("total")->text();
}

/// All three exercises, by the mouse, as somebody does them who has never held a handpiece.
void TestApplication::theFirstMinutesFromBeginningToEnd()
{
    start();
    QTRY_VERIFY_WITH_TIMEOUT(actions().drill->isChecked(), kPatienceMs);
    const lessons::Lesson touch = openLesson("orientation-1-touch");
    lookFromAbove();
    QTRY_VERIFY_WITH_TIMEOUT(!actions().drill->isChecked(), kPatienceMs);
    QCOMPARE(title(), QString("0 of 6 points touched"));
    actions().grade->trigger();
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("not been begun"), qPrintable(message()), kPatienceMs);
    // With the bur turning nothing counts as touched, which is said.
    const auto* const advice = child<QLabel>("exerciseAdvice");
    for (const bool turns : {true, false}) {
        actions().drill->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(advice->text().contains("space bar"), turns, kPatienceMs);
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
    QTRY_COMPARE_WITH_TIMEOUT(title(), QString("0 of 6 points touched"), kPatienceMs);

    openLesson("orientation-2-hold");
    lookFromAbove();
    QTRY_COMPARE_WITH_TIMEOUT(title(), QString("Hold 1.0 N for 10 s"), kPatienceMs);
    window().view().setPushForce(1.0);
    pressAt({-0.27, 0.64});
    QTRY_COMPARE_WITH_TIMEOUT(title(), QString("Held for 10 s"), kPatienceMs);
    release();
    QCOMPARE(graded(), QString("100.0"));
    actions().back->trigger();

    openLesson("orientation-3-layers");
    lookFromAbove();
    QTRY_VERIFY_WITH_TIMEOUT(actions().drill->isChecked(), kPatienceMs);
    QVERIFY(!child<ui::shell::TabularLabel>("materialFigure")->isVisible());
    pressAt({core::teeth::kPadX[0], 0.0});
    QTRY_VERIFY_WITH_TIMEOUT(hasCut(), kPatienceMs);
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
    QCOMPARE(title(), QString("Every pad has its name"));
    QCOMPARE(graded(), QString("70.0"));  // two of three: 90 * 2 / 3 and 10 for the force
    actions().back->trigger();
    QVERIFY(child<ui::shell::TabularLabel>("materialFigure")->isVisible());
    QVERIFY(child<QLabel>("padTruth0")->text().contains("right"));
    QVERIFY(child<QLabel>("padTruth2")->text().contains("it is"));
}

void TestApplication::theSameWorkIsGradedOnce()
{
    start();
    logIn();
    const auto rows = [this] {
        const auto database = database::sql::Database::open(m_folder->filePath("school.sqlite")).value();
        return database::sql::ask(database->handle(),
                                  "SELECT count(*) FROM attempts WHERE tooth = '36' AND person_id IS NOT NULL", "count")
            ->toInt();
    };
    // A whole tooth is no attempt.
    actions().grade->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("not ready") || message().contains("Nothing has been cut"),
                             kPatienceMs);
    QVERIFY(!child<ui::study::ScorePage>()->isVisible());
    QCOMPARE(rows(), 0);
    for (int attempt = 1; attempt <= 2; ++attempt) {
        drill(attempt == 1 ? -2.0 : 2.0);
        grade();
        QTRY_COMPARE_WITH_TIMEOUT(rows(), attempt, kPatienceMs);
        grade();
        // The school answers in order: what comes after a second attempt shows that there is none.
        actions().attempts->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(child<QTableView>("attempts")->model()->rowCount(), attempt, kPatienceMs);
        goBackTo<ui::tooth::ToothView>();
        QCOMPARE(rows(), attempt);
    }
}

/// Moments and other grids come when they are found; shown again, the same grade has them at once; a click on a moment
/// plays the attempt from there.
void TestApplication::aScoreIsExplainedInTheBackground()
{
    start();
    logIn();
    drillFirst();
    const QString own = removed();
    actions().grade->trigger();
    const auto moments = [this] {
        QList<QPushButton*> found;
        for (QPushButton* button : child<ui::study::ScorePage>()->findChildren<QPushButton*>())
            if (button->text().contains("never removed"))
                found << button;
        return found;
    };
    QTRY_COMPARE_WITH_TIMEOUT(moments().size(), 1, kPatienceMs);
    QVERIFY(child<QLabel>("noise")->isVisible());
    QVERIFY2(child<QLabel>("noise")->text().contains("At half the grid"), qPrintable(child<QLabel>("noise")->text()));
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("class")->isVisible(), kPatienceMs);
    actions().back->trigger();
    actions().grade->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::ScorePage>()->isVisible(), kPatienceMs);
    QCOMPARE(moments().size(), 1);
    QVERIFY(child<QLabel>("noise")->isVisible());
    QTest::mouseClick(moments().front(), Qt::LeftButton);
    waitForReplay();
    QVERIFY(!child<ui::study::ScorePage>()->isVisible());
    QTRY_COMPARE_WITH_TIMEOUT(removed(), own, kPatienceMs);  // how it ended
}

void TestApplication::stoppingAReplayBringsTheOwnWorkBack()
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
    QTRY_VERIFY_WITH_TIMEOUT(removed() != own, kPatienceMs);
    actions().back->trigger();
    QVERIFY(message().contains("your own work"));
    QTRY_COMPARE_WITH_TIMEOUT(removed(), own, kPatienceMs);
    QCOMPARE(window().view().toothPicture(), tooth);
    // And it goes on from there.
    QVERIFY(actions().undo->isEnabled());
    drill({0.0, -2.0, -1.0});
    // After two replays it is still asked about.
    for (int n = 0; n < 2; ++n) {
        emit window().recordingOpenRequested(recording);
        QVERIFY(!actions().openRecording->isEnabled());
        QTRY_VERIFY_WITH_TIMEOUT(actions().openRecording->isEnabled(), kPatienceMs);
        waitForReplay();
        QTRY_COMPARE_WITH_TIMEOUT(removed(), first, kPatienceMs);
    }
    window().close();
    QVERIFY(window().isVisible());
    QVERIFY(child<QWidget>("workQuestion") != nullptr);
}

void TestApplication::aMomentOfTheOwnAttemptIsShownAndLeft()
{
    start();
    drillFirst();
    const QString own = removed();
    QVERIFY(own != "0.00");
    waitForTicks(1500);  // an attempt of more than a second
    grade();
    m_application->showMoment(1.0e6);
    // Held, a moment before its end.
    QVERIFY(actions().pauseReplay->text().startsWith("Resume"));
    const auto time = [this] { return child<ui::shell::TabularLabel>("replayTime")->text(); };
    // To a second, for the words are rounded.
    const auto seconds = [&](int part) {
        const QStringList words = time().section(" of ", part, part).split(u':');
        return 60 * words.front().toInt() + words.back().toInt();
    };
    QTRY_VERIFY2_WITH_TIMEOUT(seconds(1) > 0 && seconds(1) - seconds(0) <= 1, qPrintable(time()), kPatienceMs);
    QTRY_COMPARE_WITH_TIMEOUT(removed(), own, kPatienceMs);
    const QImage cut = window().view().toothPicture();
    // What is said at the end is not said elsewhere.
    window().showReplayEnd();
    QVERIFY(message().contains("come to its end"));
    actions().stepBack->trigger();
    QVERIFY2(!message().contains("come to its end"), qPrintable(message()));
    // Back to before it was cut, and forth to what the stroke has left.
    actions().replayBegin->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
    QVERIFY(window().view().toothPicture() != cut);
    actions().stepOn->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), own, kPatienceMs);
    QCOMPARE(window().view().toothPicture(), cut);
    actions().stepBack->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
    // To the card, where the other moments are, and from there to the tooth.
    actions().back->trigger();
    QVERIFY(child<ui::study::ScorePage>()->isVisible());
    actions().back->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), own, kPatienceMs);
    drillSecond();
}

void TestApplication::anotherAttemptIsPlayedBeside()
{
    start();
    drillFirst();
    const QString recording = save();
    drillSecond();
    const QString own = removed();
    grade();
    m_application->showMoment(1.0e6);
    for (int n = 0; n < 2; ++n) {  // another one takes its place
        emit window().besideWanted(recording);
        QTRY_VERIFY_WITH_TIMEOUT(actions().beside->isEnabled() && views().size() == 2, kPatienceMs);
    }
    const auto* beside = views().front() == &window().view() ? views().back() : views().front();
    // Both at their ends: what the first stroke has left, and what both have.
    actions().replayEnd->trigger();
    const auto cut = [](const ui::tooth::ToothView& view) {
        double sum = 0.0;
        for (std::size_t k = 0; k < view.tooth()->top.size(); ++k)
            sum += static_cast<double>(view.tooth()->anatomy->top[k] - view.tooth()->top[k]);
        return sum;
    };
    QTRY_VERIFY_WITH_TIMEOUT(cut(*beside) > 0.0 && cut(window().view()) > cut(*beside), kPatienceMs);
    actions().replayBegin->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(cut(*beside) == 0.0 && cut(window().view()) == 0.0, kPatienceMs);
    actions().beside->trigger();
    QCOMPARE(views().size(), 1);
    emit window().besideWanted(recording);
    QTRY_COMPARE_WITH_TIMEOUT(views().size(), 2, kPatienceMs);
    actions().back->trigger();
    QCOMPARE(views().size(), 1);
    QTRY_COMPARE_WITH_TIMEOUT(removed(), own, kPatienceMs);
}

/// Whatever lies on the table meanwhile.
void TestApplication::theExpertOfWhatIsPlayedIsPutBeside()
{
    start();
    static_cast<void>(openLesson("decay-36-small"));
    drillFirst();
    const QString recording = save();
    m_application.reset();
    start(recording);
    QTRY_VERIFY_WITH_TIMEOUT(actions().expert->isVisible() && actions().expert->isEnabled(), kPatienceMs);
    actions().expert->trigger();
    // The end of what is played may be told over the sentence about it: the view itself says whose hand it is.
    const auto isShown = [this] {
        const auto all = views();
        return all.size() == 2 && std::any_of(all.begin(), all.end(), [](const ui::tooth::ToothView* view) {
                   return view->accessibleName() == "The simulated hand";
               });
    };
    QTRY_VERIFY2_WITH_TIMEOUT(isShown(), qPrintable(message()), kPatienceMs);
}

void TestApplication::aHandIsLedAlongARecording()
{
    start({}, true);
    QVERIFY(labelWith("The simulated handpiece is at work") != nullptr);
    const QString before = removed();
    QTRY_VERIFY_WITH_TIMEOUT(removed() != before, kPatienceMs);
    waitForTicks(1500);
    grade();
    m_application->showMoment(1.0e6);
    QTRY_VERIFY_WITH_TIMEOUT(actions().along->isEnabled(), kPatienceMs);
    const auto apartMm = [this] { return glm::length(servo().deviceMm - servo().anchorMm); };
    // Where the machine stands still for a moment the hand seems to hold against it, and is let go.
    for (int tries = 0; tries < 5 && !actions().along->isChecked(); ++tries) {
        actions().replayBegin->trigger();
        actions().along->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(apartMm() < 3.0, kPatienceMs);
        if (tries == 0)
            actions().pauseReplay->trigger();  // it goes on
        const auto isOneSecondOn = [this] {
            return child<ui::shell::TabularLabel>("replayTime")->text().startsWith("0:01");
        };
        QTRY_VERIFY_WITH_TIMEOUT(isOneSecondOn() || !actions().along->isChecked(), kPatienceMs);
    }
    QVERIFY2(actions().along->isChecked(), qPrintable("a hand that goes along is not let go: " + message()));
    QVERIFY2(apartMm() < 3.0, qPrintable(QString("%1 mm").arg(apartMm())));
    actions().along->trigger();
    actions().back->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!actions().along->isVisible(), kPatienceMs);
}

void TestApplication::theUndoHistoryLeadsToAnyMoment()
{
    start();
    actions().history->trigger();
    const auto* list = &child<ui::replay::HistoryPanel>("historyPanel")->list();
    drillFirst();
    const QString first = removed();
    QTRY_COMPARE_WITH_TIMEOUT(list->model()->rowCount(), 2, kPatienceMs);
    actions().undo->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
    drillSecond();
    const QString second = removed();
    QTRY_COMPARE_WITH_TIMEOUT(list->model()->rowCount(), 3, kPatienceMs);
    const auto goTo = [&](int row) {
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                          list->visualRect(list->model()->index(row, 0)).center());
    };
    goTo(1);  // what was undone
    QTRY_COMPARE_WITH_TIMEOUT(removed(), first, kPatienceMs);
    goTo(2);
    QTRY_COMPARE_WITH_TIMEOUT(removed(), second, kPatienceMs);
    goTo(0);
    QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
    QVERIFY(list->model()->index(0, 0).data().toString().contains("present"));
}

void TestApplication::stoppingTheReplayOfWhoHasNoWorkGivesAWholeTooth()
{
    start();
    drillFirst();
    const QString recording = save();
    m_application.reset();
    start(recording);
    QVERIFY(actions().pauseReplay->isEnabled());
    actions().back->trigger();
    QVERIFY(message().contains("whole"));
    QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
    drillFirst();
}

int main(int argc, char** argv)
{
    return support::openGlMain<TestApplication>(argc, argv);
}

#include "tst_application.moc"
