// SPDX-License-Identifier: GPL-3.0-or-later
// The real window, its keys pressed and its threads played by hand.
#include <cmath>
#include <numbers>

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAccessible>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QMenu>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QScopeGuard>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSet>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QStackedWidget>
#include <QStyleHints>
#include <QStyleOptionButton>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTranslator>

#include "core/drilling/Bur.h"
#include "core/grading/IdealCavity.h"
#include "core/teeth/Block.h"
#include "lessons/LessonCatalog.h"
#include "lessons/Rubric.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/OpenGlMain.h"
#include "tests/support/SyntheticMolar.h"
#include "ui/admin/AdminPage.h"
#include "ui/admin/AuditPart.h"
#include "ui/admin/PeoplePart.h"
#include "ui/admin/RosterPart.h"
#include "ui/charts/ChartPanel.h"
#include "ui/console/Console.h"
#include "ui/console/WatchPanel.h"
#include "ui/inside/SectionView.h"
#include "ui/inside/XrayPage.h"
#include "ui/people/ClassPage.h"
#include "ui/people/HistoryPage.h"
#include "ui/people/LoginPage.h"
#include "ui/people/TalkPanel.h"
#include "ui/presets/PresetsPage.h"
#include "ui/presets/TrialCard.h"
#include "ui/replay/HistoryPanel.h"
#include "ui/replay/TimeLine.h"
#include "ui/settings/SettingsPage.h"
#include "ui/shell/Actions.h"
#include "ui/shell/ArchView.h"
#include "ui/shell/BusyCard.h"
#include "ui/shell/FoldingBar.h"
#include "ui/shell/HelpOverlay.h"
#include "ui/shell/LineIcon.h"
#include "ui/shell/MainWindow.h"
#include "ui/shell/MaterialLook.h"
#include "ui/shell/MaterialSwatch.h"
#include "ui/shell/Memory.h"
#include "ui/shell/MessageBar.h"
#include "ui/shell/Mouth.h"
#include "ui/shell/PracticeRoom.h"
#include "ui/shell/PutBy.h"
#include "ui/shell/QuestionCard.h"
#include "ui/shell/ScrollPane.h"
#include "ui/shell/SidePanel.h"
#include "ui/shell/StereoCard.h"
#include "ui/shell/TabularLabel.h"
#include "ui/shell/Theme.h"
#include "ui/shell/ToothChooser.h"
#include "ui/study/InfractionCard.h"
#include "ui/study/LessonCards.h"
#include "ui/study/LessonEditor.h"
#include "ui/study/LessonsPage.h"
#include "ui/study/ScorePage.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Language.h"
#include "ui/tooth/ToothView.h"

using namespace core::session;
using namespace ui::shell;
using core::terrain::Material;
using ui::study::ScorePage;
using ui::text::Failed;

namespace {

const QString kSchool = QStringLiteral("school.sqlite");

std::function<QStringList()> noted(const QStringList& notes)
{
    return [notes] { return notes; };
}

database::Person someone(qint64 id, const std::string& given, bool hasPassword,
                         const std::vector<database::ClassId>& classes = {})
{
    return {{id},
            std::to_string(id),
            "s" + std::to_string(id),
            given,
            "Berg",
            database::Role::Student,
            false,
            hasPassword,
            "",
            "",
            classes};
}

}  // namespace

class TestMainWindow : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();

    void eachKeySpeaksToTheSession_data();
    void eachKeySpeaksToTheSession();
    void spaceAndDTurnTheDrillOnAndOff();
    void numbersChooseTheBur();
    void onlyHandpiecesAtHandCanBeTaken();
    void theServoHasTheLastWordOnDrillAndBur();
    void aFullQueueIsToldAndNothingIsPretended();
    void undoRestsWhileThereIsNothingToUndo();
    void gradeIsAskedFor();
    void filesAreAskedFor_data();
    void filesAreAskedFor();
    void eachKindOfFileRemembersItsFolder();
    void droppedFilesAreToldApart();
    void homeIsOfferedWhereAHandCanBeLed();
    void otherHandPanelAndFullScreen();
    void theNextWindowIsLaidOutAsThisOne();
    void rubbishInTheMemoryCountsAsNothing();
    void swatchesFollowTheColoursOfTheTooth();
    void whatIsOnHasACheckMark();
    void theSectionIsShownAndTurned();
    void theStereoPageHasAWayBack();
    void aMessageKeepsToTheView();
    void theXrayPageOpensAndSaves();
    void oneOfTheDepthColoursIsShown();
    void theAidsInUseAreNoted();
    void theBurTellsHowNearItIs();
    void aHandIsHeldOnRequest();
    void aBreachStopsTheBurAndIsExplained();
    void whatALessonLocksRests();
    void whatIsToBeFeltIsNotShown();
    void anExerciseHasNoFiguresOfACut();
    void theCardOfAnExerciseLeavesTheToothItsRoom();
    void anExamTellsNothingByAReplay();
    void anExamEndsOnce();
    void theBurRestsWhileAnotherPageIsRead();
    void aLessonBeginsWithItsOwnColours();
    void aLessonsTimeEndsWithTheLesson();
    void aLessonsClockRestsWhereNobodyWorks();
    void aGuestIsToldThatNothingIsKept();
    void aWarningGoesWithItsReason();
    void enterPressesTheButtonThatHasTheFocus();
    void aBreachWaitsForWhoReadsAnotherPage();
    void helpListsEveryAction();
    void escapeGoesBackStepByStep();
    void escapeClosesAnOpenListOnly();
    void theChartsShareASmallerWindowAsBefore();
    void aRefusedPasswordIsTypedAnew();
    void whatIsWaitedForAtTheDoorIsTold();
    void whoWasLateToCreateTheSchoolLogsIn();
    void whoTypesACommandGoesOnTyping();
    void whatARuleStoppedTurnsAgainInTheNextLesson();
    void draftsWaitForWhoTeaches();
    void whatIsPutByStaysThere();
    void whatSomebodyHasTypedIsPutBy();
    void whatTwoWindowsHadOfOneThingIsTold();
    void aDraftOfALessonThatIsGoneCanBeThrownAway();
    void aGradeThatIsNotKeptIsAskedAboutFirst();
    void anAdminIsToldHowToBeginWithClasses();
    void peoplesColumnsAreMeasuredByAllOfThem();
    void aHalfFilledFormIsPutAside();
    void peoplesColumnsShareTheWidth();
    void whoWasEnteredIsSeenInTheList();
    void whoIsChosenIsInSightAfterASearch();
    void theWidestOfAColumnIsMeasured();
    void aClassListIsChosenWhereTheLastOneLay();
    void presetsAreFoundFromTheSchoolAndFromOnesPlace();
    void theChosenPartOfTheSchoolIsReadWhole();
    void nobodyIsChosenByPassingThroughTheList();
    void aCodeStaysWithItsPerson();
    void aCodeIsNotLostByOneKey();
    void whatIsThereOrMissingIsSaidOfPeople();
    void pagesOfLessonsAreTurned();
    void enterPressesTheWayBack();
    void aDoubleClickOnEnterTakesNoPasswordAway();
    void theQuestionOfAPasswordEndsWithAnythingElse();
    void answersToAQuestionHaveTheirRoom();
    void theOwnClassesComeFirst();
    void manyPeopleAreCountedByTheLocale();
    void aListOfNobodyIsAFault();
    void spaceOnAFocusedButtonPressesIt();
    void theConsoleTakesKeysAndLeavesTheView();
    void presetsAndSettingsHavePages();
    void aComparisonIsEndedBesideTheTooth();

    void figuresComeFromTheLoops();
    void dentinOverThePulpIsTold();
    void depthBesideTheToothShowsADash();
    void aWallThatPressesIsTold();
    void aHandpieceOnTheCrownIsTold();
    void harmIsToldWhenItHappens();
    void noDecayShowsADash();
    void theHintGoesWithTheFirstCut();
    void pushForceGoesBothWays();
    void whyNothingIsDrilledFromBelowIsToldOnce();
    void troubleStaysOutOfTheWayUntilItIsThere();

    void aMessageHasRoomForItsWords();
    void errorsStayAndComeBackAfterNews();
    void whatStaysCoversNoWayToAnotherPage();
    void anErrorGoesWithTheNextGoodTooth();
    void theMessageButtonDoesWhatItSays();
    void anUnfinishedAttemptIsOffered();
    void anExamIsNotDiscardedUnasked();
    void takingItUpAsksAboutTheWorkOnTheTable();
    void notesOfTheImporterAreShown();
    void anotherUnitCanBeChosenBesideTheNote();
    void workIsShownAndHoldsBackTheRest();
    void aReplayRestsTheControls();
    void aReplayMarksItsOwnBurAtOnce();
    void aReplayTellsItsTimeAndPauses();
    void aReplayHasEightSpeeds();
    void keysGoThroughAReplayByStrokes();
    void aReplayIsCalledByItsLesson();
    void pointsAreMarkedAsTheyWereTouched();
    void remarksAreReadWhereTheyWereMeant();
    void theTimeLineIsScrubbedAndTellsWhatWas();
    void anotherAttemptIsShownBeside();
    void theHandIsLedAlongOnRequest();
    void theExpertIsOfferedWhereSomethingIsCut();
    void aLessonOfAPackIsUnpackedToBeEdited();
    void theUndoHistoryIsShownAndGoneThrough();
    void theUndoHistoryTakesALowWindow();
    void escapeEndsAReplayAtOnce();
    void gradingAReplayOffersToStopIt();

    void wholeToothIsLeftWithoutAQuestion();
    void unsavedWorkIsAskedAbout_data();
    void unsavedWorkIsAskedAbout();
    void savedWorkIsLeftWithoutAQuestion();
    void workThatWaitsForAReplayIsAskedAbout();
    void typingSearchesTheLessons();
    void cardsShowTheToothAndTheBestScore();
    void lessonsAreFiltered();
    void aToothOfTheArchIsSearchedFor();
    void datesAndPointsAreNotSearched();
    void usedUpAttemptsAreToldBeforeTheStart();
    void theForecastIsAnsweredWithTheKeys();
    void unsavedLessonsAreAskedAbout_data();
    void unsavedLessonsAreAskedAbout();
    void whatPagesHaveNotKeptIsAskedAbout();
    void atALockedPlaceNobodyDecidesForItsOwner();
    void whatAnAdminHasTypedWaitsForHim();
    void aTouchedFormTakesOverWhatOthersHaveEntered();
    void onesOwnRoleIsNotGivenUpByOneClick();
    void aFaultGoesWithWhatItWasSaidOf();
    void whatIsSaidOfPeopleChangesItsLanguage();
    void anAuditThatCannotBeReadKeepsItsRows();

    void anotherToothIsChosenWithTheMouse();
    void anotherToothIsChosenWithTheKeys();
    void theWholeMouthIsReachedWithM();
    void theScoreAddsUp();
    void aCriticalFaultFailsGoodWork();

    void theFirstWindowFitsTheScreen_data();
    void theFirstWindowFitsTheScreen();
    void everyControlHasAName();
    void aPlaceThatWasLeftIsLocked();
    void nothingStaysOpenOverTheLock();
    void timeAwayFromTheWorkIsNoted();
    void nothingOfWhoLeftStays();
    void aReturnAtTheLockIsNoWrongPassword();
    void everyActionIsFitToBeRead();
    void longTooltipsAreBrokenIntoLines();
    void tabReachesEveryButtonOfTheRoom();
    void nothingIsClipped_data();
    void nothingIsClipped();
    void wordsFoldWhereThereIsNoRoom();
    void whatIsBelowIsPointedAt();
    void coloursCanBeRead();
    void everyDrawingExists();

private:
    void openWindow();
    template <class T>
    T* child(const char* name = "") const
    {
        return m_window->findChild<T*>(QString::fromLatin1(name));
    }
    QString figure(const char* name) const { return child<TabularLabel>(name)->text(); }
    QString message() const { return child<MessageBar>()->sentence(); }
    Actions& actions() const { return *child<Actions>(); }
    /// Presses keys as a person does: the window's shortcuts hear them.
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const
    {
        QTest::keyClick(QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : m_window.get(), key,
                        modifiers);
    }
    /// What the person has asked for since the last call. Which aids are in use is noted unasked, and where he is.
    QList<SessionCommand> sent() const
    {
        QList<SessionCommand> all;
        for (SessionCommand c; m_links->commands.tryPop(c);)
            if (!std::holds_alternative<SetAids>(c) && !isRest(c))
                all << c;
        return all;
    }
    static bool isRest(const SessionCommand& command)
    {
        const auto* note = std::get_if<AddNote>(&command);
        return note != nullptr && (note->code == kRestNote || note->code == kWorkNote);
    }
    /// What was noted of that since the last call.
    QList<quint64> restsNoted() const
    {
        QList<quint64> all;
        for (SessionCommand c; m_links->commands.tryPop(c);)
            if (isRest(c))
                all << std::get<AddNote>(c).code;
        return all;
    }
    /// The aids that were noted last; nothing if none were since the last call.
    std::optional<int> aidsNoted() const
    {
        std::optional<int> last;
        for (SessionCommand c; m_links->commands.tryPop(c);)
            if (const auto* aids = std::get_if<SetAids>(&c))
                last = aids->aids;
        return last;
    }
    /// Until the window has drawn some frames, however long a busy computer takes for them.
    void look(int frames = 10) const
    {
        QSignalSpy drawn(&m_window->view(), &ui::tooth::ToothView::frameAdvanced);
        QTest::qWait(16 * frames);
        static_cast<void>(QTest::qWaitFor([&] { return drawn.count() >= frames; }, 20'000));
    }
    void publish(const ServoState& servo, const SessionState& session) const
    {
        m_links->servo.publish(servo);
        m_links->session.publish(session);
    }
    /// The session says so much enamel of the tooth shown is gone.
    void cutSomething(double enamelMm3) const;
    QuestionCard* question() const;
    ui::admin::PeoplePart& openPeople();
    [[nodiscard]] QString writer() const { return QString::fromStdString(m_admin.uid()); }
    void choosePerson(int row) const;
    static lessons::ReadLesson shipped(const std::string& id);
    static lessons::ReadLesson shippedOf(lessons::Task task);
    static lessons::ScoreSheet sheet(double cariesPercent, double soundMm3, double pulpMm2);

    std::unique_ptr<UiLinks> m_links;
    std::unique_ptr<MainWindow> m_window;
    database::Session m_admin;  ///< who is at the page of the people
};

lessons::ScoreSheet TestMainWindow::sheet(double cariesPercent, double soundMm3, double pulpMm2)
{
    lessons::Rubric rubric;
    rubric.title = {{"en", "Trial"}};
    rubric.version = 2;
    rubric.hash = std::string(64, 'a');
    const auto add = [&](const std::string& id, const std::string& unit, double tolerance, double span, int weight) {
        lessons::CriterionRule rule;
        rule.id = rule.measure = id;
        rule.unit = unit;
        rule.tolerance = tolerance;
        rule.span = span;
        rule.weightTenths = weight;
        rule.critical = weight == 0;
        rubric.criteria.push_back(rule);
    };
    add("caries_left", "percent", 1, 30, 600);
    add("sound_tissue", "mm3", 4, 20, 400);
    add("pulp_exposure", "mm2", 0, 0, 0);
    return lessons::grade(rubric,
                          {{"caries_left", cariesPercent}, {"sound_tissue", soundMm3}, {"pulp_exposure", pulpMm2}});
}

/// Two strokes with different burs, an undo, and a breach.
static ui::replay::Course course()
{
    ui::replay::Course course;
    course.lengthS = course.readyS = 60.0;
    course.strokes = {{5.0, 9.0, 9.01, 0}, {20.0, 21.0, 21.01, 3}};
    using ui::replay::Mark;
    course.marks = {{Mark::Kind::Bur, 15.0, 3},
                    {Mark::Kind::Handpiece, 26.0, 1, "electric"},
                    {Mark::Kind::Undo, 40.0, 9000},
                    {Mark::Kind::Note, 50.0, core::grading::answerNote(1, Material::Dentin)}};
    core::grading::Infraction breach;
    breach.breach = core::grading::Breach::PulpExposed;
    breach.seconds = 20.5;
    course.infractions = {breach};
    return course;
}

lessons::ReadLesson TestMainWindow::shipped(const std::string& id)
{
    for (const lessons::CatalogEntry& entry : lessons::readCatalog({}))
        if (entry.read.lesson && entry.read.lesson->id == id)
            return entry.read;
    qFatal("no such lesson");
    return {};
}

lessons::ReadLesson TestMainWindow::shippedOf(lessons::Task task)
{
    for (const lessons::CatalogEntry& entry : lessons::readCatalog({}))
        if (entry.read.lesson && entry.read.lesson->task == task)
            return entry.read;
    qFatal("no such lesson");
    return {};
}

void TestMainWindow::initTestCase()
{
    QLocale::setDefault(QLocale("en_GB"));
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    applyTheme(*qApp, ThemeChoice::Light);
}

void TestMainWindow::init()
{
    QSettings(QStringLiteral("cusp"), QStringLiteral("cusp")).clear();
    openWindow();
}

void TestMainWindow::openWindow()
{
    m_links = std::make_unique<UiLinks>();
    m_window = std::make_unique<MainWindow>(*m_links);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_window->showTooth(support::syntheticMolar(), 1, {});
    SessionState session;
    session.undoSteps = 3;
    session.redoSteps = 1;
    publish({}, session);
    QTRY_VERIFY(actions().undo->isEnabled());
}

void TestMainWindow::cleanup()
{
    m_window.reset();
    m_links.reset();
}

void TestMainWindow::eachKeySpeaksToTheSession_data()
{
    QTest::addColumn<Qt::Key>("key");
    QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
    QTest::addColumn<int>("command");
    const auto index = [](const SessionCommand& c) { return static_cast<int>(c.index()); };
    QTest::newRow("undo") << Qt::Key_Z << Qt::KeyboardModifiers(Qt::ControlModifier) << index(Undo{});
    QTest::newRow("redo") << Qt::Key_Z << (Qt::ControlModifier | Qt::ShiftModifier) << index(Redo{});
    QTest::newRow("reload") << Qt::Key_R << Qt::KeyboardModifiers() << index(Reload{});
    QTest::newRow("drill") << Qt::Key_D << Qt::KeyboardModifiers() << index(SetDrill{});
    QTest::newRow("drill too") << Qt::Key_Space << Qt::KeyboardModifiers() << index(SetDrill{});
    QTest::newRow("bur") << Qt::Key_3 << Qt::KeyboardModifiers() << index(SetBur{});
}

void TestMainWindow::eachKeySpeaksToTheSession()
{
    QFETCH(Qt::Key, key);
    QFETCH(Qt::KeyboardModifiers, modifiers);
    QFETCH(int, command);
    press(key, modifiers);
    const auto commands = sent();
    QCOMPARE(commands.size(), 1);
    QCOMPARE(static_cast<int>(commands.front().index()), command);
}

void TestMainWindow::spaceAndDTurnTheDrillOnAndOff()
{
    press(Qt::Key_D);
    press(Qt::Key_Space);
    const auto commands = sent();
    QCOMPARE(commands.size(), 2);
    QCOMPARE(std::get<SetDrill>(commands[0]).on, true);
    QCOMPARE(std::get<SetDrill>(commands[1]).on, false);
}

void TestMainWindow::numbersChooseTheBur()
{
    press(Qt::Key_2);
    press(Qt::Key_4);
    const auto commands = sent();
    QCOMPARE(commands.size(), 2);
    QCOMPARE(std::get<SetBur>(commands[0]).index, 1);
    QCOMPARE(std::get<SetBur>(commands[1]).index, 3);
    QVERIFY(actions().burs[3]->isChecked());
    QVERIFY(!actions().burs[0]->isChecked());
    QCOMPARE(actions().burs.size(), static_cast<qsizetype>(core::drilling::burs().size()));
}

void TestMainWindow::onlyHandpiecesAtHandCanBeTaken()
{
    using core::settings::findHandpiece;
    const auto all = core::settings::handpieces();
    m_window->setHandpieces({all.begin(), all.end()});
    press(Qt::Key_9);
    // A lesson's order is its own: the slow one is its first.
    m_window->setHandpieces({findHandpiece("low-speed").value(), findHandpiece("turbine").value()});
    press(Qt::Key_9);
    press(Qt::Key_8);  // electric: not at hand
    press(Qt::Key_7);
    const auto commands = sent();
    QCOMPARE(commands.size(), 3);
    QCOMPARE(int{std::get<SetHandpiece>(commands[0]).index}, 2);
    QCOMPARE(int{std::get<SetHandpiece>(commands[1]).index}, 0);
    QCOMPARE(int{std::get<SetHandpiece>(commands[2]).index}, 1);
}

void TestMainWindow::theServoHasTheLastWordOnDrillAndBur()
{
    ServoState servo;
    servo.tick = 1;
    servo.drillOn = true;
    servo.burIndex = 2;
    publish(servo, {});
    QTRY_VERIFY(actions().drill->isChecked());
    QTRY_VERIFY(actions().burs[2]->isChecked());
    QVERIFY2(sent().isEmpty(), "what the servo says is shown, not sent back");
    // A wish that the servo does not follow is given up.
    press(Qt::Key_D);
    QVERIFY(!actions().drill->isChecked());
    QTRY_VERIFY(actions().drill->isChecked());
}

void TestMainWindow::aFullQueueIsToldAndNothingIsPretended()
{
    while (m_links->commands.tryPush(Undo{})) {
    }
    press(Qt::Key_D);
    QVERIFY(message().contains("busy"));
    QVERIFY(!actions().drill->isChecked());
}

void TestMainWindow::undoRestsWhileThereIsNothingToUndo()
{
    publish({}, {});
    QTRY_VERIFY(!actions().undo->isEnabled());
    QVERIFY(!actions().redo->isEnabled());
    press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(sent().isEmpty());
}

void TestMainWindow::gradeIsAskedFor()
{
    QSignalSpy asked(m_window.get(), &MainWindow::gradeRequested);
    press(Qt::Key_G);
    QCOMPARE(asked.size(), 1);
    // Not twice: the grade is already there.
    m_window->showScore(sheet(0, 0, 0), {});
    press(Qt::Key_G);
    QCOMPARE(asked.size(), 1);
}

void TestMainWindow::filesAreAskedFor_data()
{
    QTest::addColumn<Qt::Key>("key");
    QTest::addColumn<bool>("shift");
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("which");
    QTest::newRow("scan") << Qt::Key_O << false << "scan.stl" << 0;
    QTest::newRow("open recording") << Qt::Key_O << true << "attempt.cusprec" << 1;
    QTest::newRow("save recording") << Qt::Key_S << false << "new.cusprec" << 2;
}

void TestMainWindow::filesAreAskedFor()
{
    QFETCH(Qt::Key, key);
    QFETCH(bool, shift);
    QFETCH(QString, file);
    QFETCH(int, which);
    QTemporaryDir folder;
    const QString path = folder.filePath(file);
    if (which != 2) {
        QFile made(path);
        QVERIFY(made.open(QIODevice::WriteOnly));
    }
    QSignalSpy scan(m_window.get(), &MainWindow::scanChosen);
    QSignalSpy open(m_window.get(), &MainWindow::recordingOpenRequested);
    QSignalSpy save(m_window.get(), &MainWindow::recordingSaveRequested);
    press(key, shift ? Qt::ControlModifier | Qt::ShiftModifier : Qt::KeyboardModifiers(Qt::ControlModifier));
    auto* dialog = m_window->findChild<QFileDialog*>();
    QVERIFY(dialog != nullptr);
    if (which == 2)
        QVERIFY(dialog->selectedFiles().value(0).endsWith(".cusprec"));
    dialog->setDirectory(folder.path());
    dialog->selectFile(path);
    QMetaObject::invokeMethod(dialog, "accept");
    const std::array spies{&scan, &open, &save};
    for (std::size_t k = 0; k < spies.size(); ++k)
        QCOMPARE(spies.at(k)->size(), static_cast<int>(k) == which ? 1 : 0);
    QCOMPARE(spies.at(static_cast<std::size_t>(which))->front().front().toString(), path);
}

void TestMainWindow::eachKindOfFileRemembersItsFolder()
{
    QTemporaryDir scans;
    auto recordings = std::make_unique<QTemporaryDir>();
    const auto choose = [](MainWindow& window, QAction* action, const QString& path) {
        action->trigger();
        auto* dialog = window.findChild<QFileDialog*>();
        const QString folder = dialog->directory().absolutePath();
        dialog->setDirectory(QFileInfo(path).path());
        dialog->selectFile(path);
        QMetaObject::invokeMethod(dialog, "accept");
        QTest::qWait(0);  // the dialog deletes itself
        return folder;
    };
    QFile scan(scans.filePath("molar.stl"));
    QVERIFY(scan.open(QIODevice::WriteOnly));
    choose(*m_window, actions().openScan, scan.fileName());
    choose(*m_window, actions().saveRecording, recordings->filePath("mine.cusprec"));
    // Another window, as of another run.
    MainWindow next(*m_links);
    next.showTooth(support::syntheticMolar(), 1, {});
    const auto* later = next.findChild<Actions*>();
    QCOMPARE(choose(next, later->openScan, scan.fileName()), scans.path());
    QCOMPARE(choose(next, later->saveRecording, recordings->filePath("mine.cusprec")), recordings->path());
    const QString gone = recordings->path();
    recordings.reset();
    QVERIFY2(choose(next, later->saveRecording, scans.filePath("mine.cusprec")) != gone, "the folder is not there");
}

void TestMainWindow::droppedFilesAreToldApart()
{
    QSignalSpy scan(m_window.get(), &MainWindow::scanChosen);
    QSignalSpy open(m_window.get(), &MainWindow::recordingOpenRequested);
    const auto drop = [this](const QString& path) {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent event(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &event);
    };
    drop("/tmp/Molar.STL");
    QCOMPARE(scan.size(), 1);
    drop("/tmp/attempt.cusprec");
    QCOMPARE(open.size(), 1);
    QMimeData words;
    words.setText("not a file");
    QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &words, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(m_window.get(), &enter);
    QVERIFY(!enter.isAccepted());
    drop("/tmp/letter.docx");
    QCOMPARE(scan.size() + open.size(), 2);
    QVERIFY(message().contains("neither a scan"));
}

void TestMainWindow::homeIsOfferedWhereAHandCanBeLed()
{
    const auto rowInHelp = [this] {
        for (const QLabel* label : child<HelpOverlay>()->findChildren<QLabel*>())
            if (label->text() == actions().bringHome->text())
                return label->isVisible();
        return false;
    };
    press(Qt::Key_C);
    QVERIFY(sent().empty());
    press(Qt::Key_F1);
    QVERIFY(!rowInHelp());
    m_window->offerHome();
    QVERIFY(rowInHelp());
    press(Qt::Key_F1);
    press(Qt::Key_C);
    const auto commands = sent();
    QCOMPARE(commands.size(), 1);
    QVERIFY(std::holds_alternative<BringHome>(commands.front()));
    m_window->setReplaying(true);
    press(Qt::Key_C);
    QVERIFY(sent().empty());
}

void TestMainWindow::otherHandPanelAndFullScreen()
{
    press(Qt::Key_H);
    QVERIFY(actions().otherHand->isChecked());
    auto* panel = child<SidePanel>();
    QVERIFY(panel->isVisible());
    press(Qt::Key_F9);
    QVERIFY(!panel->isVisible());
    press(Qt::Key_F9);
    QVERIFY(panel->isVisible());
    press(Qt::Key_F11);
    QVERIFY(m_window->isFullScreen());
    press(Qt::Key_Escape);
    QVERIFY(!m_window->isFullScreen());
    QVERIFY(!actions().fullScreen->isChecked());
}

void TestMainWindow::theNextWindowIsLaidOutAsThisOne()
{
    QVERIFY(!actions().otherHand->isChecked());
    m_window->resize(1011, 707);
    press(Qt::Key_F9);
    press(Qt::Key_X);
    press(Qt::Key_H);
    m_window->close();
    cleanup();
    openWindow();
    QCOMPARE(m_window->size(), QSize(1011, 707));
    QVERIFY(!child<SidePanel>()->isVisible());
    QVERIFY(!actions().panel->isChecked());
    QVERIFY(child<ui::inside::SectionView>()->isVisible());
    QVERIFY(actions().section->isChecked());
    QVERIFY(actions().turnSection->isEnabled());
    QVERIFY(actions().otherHand->isChecked());
    // A lesson's lock is not what the student wanted.
    lessons::Aids none;
    none.section = false;
    m_window->setAids(none);
    QVERIFY(!child<ui::inside::SectionView>()->isVisible());
    cleanup();
    openWindow();
    QVERIFY(child<ui::inside::SectionView>()->isVisible());
}

void TestMainWindow::rubbishInTheMemoryCountsAsNothing()
{
    cleanup();
    for (const char* key : {"window/panel", "window/section", "window/leftHanded", "view/wet"})
        memory().setValue(key, "banana");
    openWindow();
    QVERIFY(child<SidePanel>()->isVisible());
    QVERIFY(!child<ui::inside::SectionView>()->isVisible());
    QVERIFY(!actions().otherHand->isChecked());
    QVERIFY(!actions().wetLook->isChecked());
    cleanup();
    for (const char* key : {"window/panel", "window/section", "window/leftHanded"})
        memory().setValue(key, "1");
    openWindow();
    QVERIFY(child<SidePanel>()->isVisible());
    QVERIFY(!child<ui::inside::SectionView>()->isVisible());
    QVERIFY(!actions().otherHand->isChecked());
}

void TestMainWindow::swatchesFollowTheColoursOfTheTooth()
{
    const auto swatches = child<SidePanel>()->findChildren<MaterialSwatch*>();
    const auto discs = [&] {
        QList<QColor> fills;
        for (MaterialSwatch* swatch : swatches)
            fills << swatch->grab().toImage().pixelColor(swatch->width() / 2, 3);
        return fills;
    };
    // The first shows what is under the bur, and that is nothing; then enamel, dentin and pulp.
    QCOMPARE(swatches.size(), 4);
    using ui::render::Palette;
    for (const Palette colours : {Palette::Natural, Palette::Distinct, Palette::Natural}) {
        QCOMPARE(actions().distinctColours->isChecked(), colours == Palette::Distinct);
        QCOMPARE(discs()[1], materialLook(Material::Enamel, colours).fill);
        QCOMPARE(discs()[2], materialLook(Material::Dentin, colours).fill);
        QCOMPARE(discs()[3], materialLook(Material::Pulp, colours).fill);
        press(Qt::Key_P);
    }
}

void TestMainWindow::whatIsOnHasACheckMark()
{
    auto* menu = child<QToolButton>("viewButton")->menu();
    menu->ensurePolished();
    menu->adjustSize();
    // Light strokes in the column before the words.
    const auto strokes = [&] {
        const QRect row = menu->actionGeometry(actions().wetLook);
        const QImage picture = menu->grab(QRect(row.topLeft(), QSize(22, row.height()))).toImage();
        int light = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                light += picture.pixelColor(x, y).lightness() > 150 ? 1 : 0;
        return light;
    };
    QVERIFY(!actions().wetLook->isChecked());
    QCOMPARE(strokes(), 0);
    press(Qt::Key_W);
    QVERIFY2(strokes() >= 8, qPrintable(QString::number(strokes())));
}

void TestMainWindow::theSectionIsShownAndTurned()
{
    auto* section = child<ui::inside::SectionView>();
    QVERIFY(!section->isVisible());
    QVERIFY(!actions().turnSection->isEnabled());
    const int widthAlone = m_window->view().width();
    press(Qt::Key_X);
    QVERIFY(section->isVisible());
    QTRY_VERIFY(m_window->view().width() < widthAlone);
    QCOMPARE(section->angleDeg(), 90);
    press(Qt::Key_X, Qt::ShiftModifier);
    QCOMPARE(section->angleDeg(), 105);
    press(Qt::Key_X);
    QVERIFY(!section->isVisible());
}

void TestMainWindow::theStereoPageHasAWayBack()
{
    using ui::render::Stereo;
    auto* card = child<StereoCard>();
    auto* mode = card->findChild<QComboBox*>();
    const auto shown = [this] { return m_window->view().settings().presentation; };
    const auto before = shown();
    QCOMPARE(before.stereo, Stereo::Off);
    press(Qt::Key_S, Qt::ShiftModifier);
    QVERIFY(card->isVisible());
    QCOMPARE(shown().stereo, Stereo::RedCyan);
    mode->setCurrentIndex(2);
    QCOMPARE(shown().stereo, Stereo::SideBySide);
    for (QSlider* slider : card->findChildren<QSlider*>())
        slider->setValue(slider->maximum());
    QVERIFY(shown().apart > before.apart);
    // Asked for twice, it does not take its own doing for what was there before.
    actions().stereoPage->trigger();
    press(Qt::Key_Escape);
    QVERIFY(!card->isVisible());
    QVERIFY(shown() == before);
    QVERIFY(!actions().stereo->isChecked());
    press(Qt::Key_S);
    QCOMPARE(shown().stereo, Stereo::RedCyan);
    press(Qt::Key_S);
    press(Qt::Key_S, Qt::ShiftModifier);
    mode->setCurrentIndex(3);
    QTest::mouseClick(card->findChild<QPushButton*>("cancelStereo"), Qt::LeftButton);
    QVERIFY(!card->isVisible());
    QVERIFY(shown() == before);
    press(Qt::Key_S, Qt::ShiftModifier);
    mode->setCurrentIndex(2);
    QTest::mouseClick(card->findChild<QPushButton*>("keepStereo"), Qt::LeftButton);
    QVERIFY(!card->isVisible());
    QCOMPARE(shown().stereo, Stereo::SideBySide);
}

void TestMainWindow::aMessageKeepsToTheView()
{
    m_window->showTooth(support::syntheticMolar(), 2, noted({"A note."}));
    const auto* message = child<MessageBar>();
    const auto isOverTheView = [&] {
        const QWidget& view = m_window->view();
        const QRect area(view.mapTo(m_window.get(), QPoint()), view.size());
        return area.contains(QRect(message->mapTo(m_window.get(), QPoint()), message->size()));
    };
    QTRY_VERIFY(message->isVisible() && isOverTheView());
    const QPoint alone = message->pos();
    press(Qt::Key_X);
    QTRY_VERIFY(isOverTheView() && message->pos() != alone);
    press(Qt::Key_F9);
    QTRY_VERIFY(isOverTheView());
    press(Qt::Key_X);
    QTRY_VERIFY(isOverTheView());
}

void TestMainWindow::theXrayPageOpensAndSaves()
{
    auto* page = child<ui::inside::XrayPage>();
    press(Qt::Key_F);
    QVERIFY(page->isVisible());
    QTRY_VERIFY(page->isReady());
    const QTemporaryDir folder;
    const QString path = folder.filePath("films.png");
    child<QPushButton>("saveFilms")->click();
    auto* dialog = m_window->findChild<QFileDialog*>();
    QVERIFY(dialog != nullptr);
    emit dialog->fileSelected(path);
    dialog->close();
    QVERIFY(QImage(path).size() == page->bothFilms().size());
    QVERIFY(message().contains("films.png"));
    child<QPushButton>("saveFilms")->click();
    dialog = m_window->findChildren<QFileDialog*>().back();
    emit dialog->fileSelected(folder.filePath("nowhere/films.png"));
    dialog->close();
    QVERIFY(message().contains("could not be written"));
    press(Qt::Key_Escape);
    QVERIFY(!page->isVisible());
    QVERIFY(m_window->view().isVisible());
}

void TestMainWindow::oneOfTheDepthColoursIsShown()
{
    using ui::render::DepthColours;
    const auto shown = [this] { return m_window->view().settings().look.depthColours; };
    QCOMPARE(shown(), DepthColours::Off);
    press(Qt::Key_K);
    QCOMPARE(shown(), DepthColours::BelowOriginal);
    press(Qt::Key_K, Qt::ShiftModifier);
    QCOMPARE(shown(), DepthColours::AgainstIdeal);
    QVERIFY(!actions().depthColours->isChecked());
    press(Qt::Key_K);
    QCOMPARE(shown(), DepthColours::BelowOriginal);
    QVERIFY(!actions().idealColours->isChecked());
    press(Qt::Key_K, Qt::ShiftModifier);
    lessons::Aids aids;
    aids.ideal = false;
    m_window->setAids(aids);
    QCOMPARE(shown(), DepthColours::Off);
    QVERIFY(!actions().idealColours->isEnabled());
    QVERIFY(actions().idealColours->toolTip().contains("does not allow"));
    m_window->setAids({});
    QCOMPARE(shown(), DepthColours::AgainstIdeal);
    // A tooth without decay has no ideal.
    auto sound = std::make_shared<core::terrain::ToothAnatomy>(*support::syntheticMolar(64));
    for (core::terrain::ColumnLayers& column : sound->layers)
        column.cariesFloor = column.cariesRoof;
    m_window->showTooth(sound, 77, {});
    QCOMPARE(shown(), DepthColours::Off);
    QVERIFY(!actions().idealColours->isEnabled());
    QVERIFY(actions().idealColours->toolTip().contains("decay"));
    press(Qt::Key_K, Qt::ShiftModifier);
    QCOMPARE(shown(), DepthColours::Off);
}

/// Two blocks whose pads are of other tissues look the same, cut or whole, until the answers have been graded.
void TestMainWindow::whatIsToBeFeltIsNotShown()
{
    std::optional<lessons::Lesson> lesson;
    for (const lessons::CatalogEntry& entry : lessons::readCatalog({}))
        if (entry.read.lesson->task == lessons::Task::TellLayers)
            lesson = entry.read.lesson;
    QVERIFY(lesson.has_value());
    const auto assignedWith = [&](std::uint64_t seed) {
        std::get<lessons::Block>(lesson->tooth).seed = seed;
        return lessons::assign(*lesson).value().assignment;
    };
    ServoState servo;
    servo.tick = 1;
    servo.anchorMm = {core::teeth::kPadX[0], 0.0, 0.0};
    servo.touching = servo.drillOn = true;
    const auto shown = [&](const lessons::Assignment& assignment, std::uint64_t generation, float depthMm) {
        m_window->setAssignment(assignment);
        m_window->showTooth(assignment.anatomy, generation, {});
        servo.materialUnderBur = std::get<core::grading::PadsToName>(*assignment.exercise).madeOf[0];
        publish(servo, {});
        std::vector<float> top = assignment.anatomy->top;
        for (std::size_t k = 0; k < top.size() / 2; ++k)
            if (top[k] > -1.0F)
                top[k] -= depthMm;
        m_window->view().setHeights(top);
        QTest::qWait(100);
        return m_window->grab().toImage();
    };
    const lessons::Assignment first = assignedWith(1);
    lessons::Assignment other = assignedWith(2);
    for (std::uint64_t seed = 3; *other.exercise == *first.exercise; ++seed)
        other = assignedWith(seed);
    static_cast<void>(shown(other, 1, 0.0F));  // where everything finds its place
    const QImage one = shown(first, 4, 0.0F);
    const auto looksThe = [&](const QImage& same, const char* name) {
        if (same == one)
            return true;
        one.save(QStringLiteral(CUSP_BINARY_DIR "/pictures/felt-one.png"));
        same.save(QStringLiteral(CUSP_BINARY_DIR "/pictures/felt-%1.png").arg(name));
        return false;
    };
    QVERIFY(looksThe(shown(other, 5, 0.0F), "other"));
    QVERIFY(looksThe(shown(first, 6, 0.7F), "cut"));
    for (const char* figure : {"materialFigure", "depthFigure", "dentinFigure", "decayFigure", "enamelRemoved"})
        QVERIFY2(!child<TabularLabel>(figure)->isVisible(), figure);
    for (QAction* aid :
         {actions().section, actions().radiograph, actions().depthColours, actions().mirror, actions().history})
        QVERIFY2(!aid->isEnabled(), qPrintable(aid->text()));
    QVERIFY(m_window->view().picture() == m_window->view().picture());

    // A recording of such a block, one's own for one, tells no more.
    m_window->setReplaying(true, 10.0);
    const auto replayed = std::make_shared<core::terrain::ToothAnatomy>(*first.anatomy);
    m_window->showTooth(replayed, 7, {});
    QTest::qWait(100);
    const QImage played = m_window->view().picture();
    m_window->view().setHeights(std::vector<float>(replayed->top.size(), -1.5F));
    QVERIFY(m_window->view().picture() == played);
    QVERIFY(!child<TabularLabel>("materialFigure")->isVisible());
    m_window->setReplaying(false);
    m_window->showTooth(first.anatomy, 6, {});

    // By keys: Tab leads to the choices, the space bar takes one, and the last answer is the one that is sent.
    static_cast<void>(sent());
    auto* enamel = child<QPushButton>("pad01");
    auto* dentin = child<QPushButton>("pad02");
    enamel->setFocus();
    QTest::keyClick(enamel, Qt::Key_Space);
    QTest::mouseClick(dentin, Qt::LeftButton);
    const QList<SessionCommand> answers = sent();
    QCOMPARE(answers.size(), 2);
    QCOMPARE(std::get<AddNote>(answers[0]).code, core::grading::answerNote(0, Material::Enamel));
    QCOMPARE(std::get<AddNote>(answers[1]).code, core::grading::answerNote(0, Material::Dentin));
    QVERIFY(dentin->isChecked() && !enamel->isChecked());
    QVERIFY(!child<QPushButton>("exerciseGrade")->isVisible());
    child<QPushButton>("pad11")->click();
    child<QPushButton>("pad20")->click();
    QVERIFY(child<QPushButton>("exerciseGrade")->isVisible());

    m_window->showScore(sheet(3.2, 40, 0.5), {});
    actions().back->trigger();
    QVERIFY(child<TabularLabel>("materialFigure")->isVisible());
    QVERIFY(!dentin->isEnabled());
    QVERIFY(child<QLabel>("padTruth0")->isVisible());
    QVERIFY(m_window->grab().toImage() != one);
}

void TestMainWindow::anExerciseHasNoFiguresOfACut()
{
    const auto told = [this](const char* figure) { return child<TabularLabel>(figure)->isVisible(); };
    QVERIFY(told("decayFigure") && told("marginFigure") && told("overcut") && told("depthFigure"));
    std::uint64_t generation = 2;
    for (const lessons::Task task : {lessons::Task::TouchPoints, lessons::Task::HoldForce}) {
        const auto exercise = lessons::assign(*shippedOf(task).lesson).value().assignment;
        m_window->setAssignment(exercise);
        m_window->showTooth(exercise.anatomy, generation++, {});
        for (const char* figure : {"decayFigure", "marginFigure", "overcut", "depthFigure", "dentinFigure"})
            QVERIFY2(!told(figure), figure);
        QVERIFY2(told("enamelRemoved") && told("forceFigure"), "a scratch is told all the same");
        // R begins it anew, and no stroke is to be brought back.
        QSignalSpy again(m_window.get(), &MainWindow::attemptAgainWanted);
        static_cast<void>(sent());
        press(Qt::Key_R);
        QCOMPARE(again.size(), 1);
        QVERIFY(sent().isEmpty());
        // The school may have something against it: it is said once it is so.
        QVERIFY2(message().isEmpty(), qPrintable(message()));
        m_window->showBegunAnew();
        QVERIFY2(message().contains("begins anew"), qPrintable(message()));
        child<MessageBar>()->dismiss();
    }
    const auto ideal = lessons::assign(*shipped("class1-36").lesson).value().assignment;
    m_window->setAssignment(ideal);
    m_window->showTooth(ideal.anatomy, generation, {});
    QVERIFY(told("decayFigure") && told("marginFigure") && told("overcut") && told("depthFigure"));
}

void TestMainWindow::theCardOfAnExerciseLeavesTheToothItsRoom()
{
    m_window->resize(853, 533);
    std::uint64_t generation = 2;
    for (const lessons::Task task : {lessons::Task::TouchPoints, lessons::Task::HoldForce, lessons::Task::TellLayers}) {
        const auto exercise = lessons::assign(*shippedOf(task).lesson).value().assignment;
        m_window->setAssignment(exercise);
        m_window->showTooth(exercise.anatomy, generation++, {});
        const auto* card = child<QFrame>("exerciseCard");
        QTRY_VERIFY(card->isVisible() && card->y() >= m_window->view().geometry().bottom());
        QTRY_VERIFY2(m_window->view().height() > card->height(),
                     qPrintable(QString("%1 and %2").arg(m_window->view().height()).arg(card->height())));
    }
    // All of the pads can be seen.
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0}) {
            const glm::dvec3 corner(x * (core::teeth::kPadX[2] + 0.5 * core::teeth::kPadWidthMm),
                                    y * 0.5 * core::teeth::kPadLengthMm, 0.0);
            const glm::dvec2 at = m_window->view().camera().pixelOf(corner);
            QVERIFY2(QRectF(m_window->view().rect()).contains(QPointF(at.x, at.y)),
                     qPrintable(QString("%1 %2").arg(at.x).arg(at.y)));
        }
    m_window->setAssignment(lessons::practiceOn(support::syntheticMolar()).value());
    m_window->showTooth(support::syntheticMolar(), generation, {});
    QVERIFY(!child<QFrame>("exerciseCard")->isVisible());
}

/// One's own attempt, saved and played while the exam goes on, would tell what went wrong.
void TestMainWindow::anExamTellsNothingByAReplay()
{
    lessons::Assignment exam = lessons::assign(*shipped("class1-36").lesson).value().assignment;
    exam.lesson->exam = true;
    const auto* line = child<ui::replay::TimeLine>("timeLine");
    const auto links = std::make_unique<UiLinks>();
    std::uint64_t generation = 2;
    const auto breachesTold = [&] {
        m_window->setReplaying(true, 60.0);
        m_window->setReplayCourse(course());
        m_window->showTooth(support::syntheticMolar(), ++generation, {});
        m_window->showBeside(*links, support::syntheticMolar(), 1, {}, "Before");
        m_window->setBesideCourse(course());
        // The pulp is opened while it is played.
        SessionState session;
        session.toothGeneration = generation;
        publish({}, session);
        look();
        session.removedMm3[static_cast<std::size_t>(Material::Pulp)] = 0.5;
        publish({}, session);
        look();
        QStringList told;
        for (const int y : {12, 12 + 32})
            told << line->saidAt({qRound(line->xOf(20.5)), y});
        told = told.filter("pulp is open");
        if (child<QLabel>("notice")->isVisible())
            told << child<QLabel>("notice")->text();
        if (!line->saidAt({qRound(line->xOf(40.0)), 12}).join(' ').contains("Undone"))
            told << "the rest of the course is missing";
        m_window->hideBeside();
        m_window->setReplaying(false);
        m_window->showTooth(exam.anatomy, 2, {});
        return told;
    };
    m_window->setAssignment(exam);
    m_window->showTooth(exam.anatomy, 2, {});
    QCOMPARE(breachesTold(), QStringList());
    // Nor is a lesson's ideal looked at in the editor.
    m_window->setLessons(lessons::readCatalog({}), {});
    actions().lessons->trigger();
    actions().editLesson->trigger();
    QVERIFY(!child<ui::study::LessonEditor>()->isVisible());
    QVERIFY2(message().contains("exam"), qPrintable(message()));
    actions().back->trigger();
    // Graded, it is over.
    m_window->showScore(sheet(3.2, 40, 0.5), {});
    actions().back->trigger();
    const QStringList all{"0:20  The pulp is open", "0:20  The pulp is open", "Pulp opened"};
    QCOMPARE(breachesTold(), all);
    // In practice nothing is hidden.
    exam.lesson->exam = false;
    m_window->setAssignment(exam);
    m_window->showTooth(exam.anatomy, 2, {});
    QCOMPARE(breachesTold(), all);
}

void TestMainWindow::aLessonsTimeEndsWithTheLesson()
{
    lessons::Assignment assignment;
    assignment.anatomy = support::syntheticMolar();
    assignment.lesson = shippedOf(lessons::Task::TouchPoints).lesson;
    assignment.lesson->minutes = 1.0;
    m_window->setAssignment(assignment);
    m_window->showTooth(assignment.anatomy, 2, {});
    const auto workFor = [this](std::uint64_t generation, double seconds) {
        SessionState session;
        session.toothGeneration = generation;
        session.recordedS = seconds;
        publish({}, session);
        look();
    };
    workFor(2, 30.0);
    // A tooth that is practised on freely has all the time there is.
    m_window->setAssignment(lessons::practiceOn(assignment.anatomy).value());
    m_window->showTooth(assignment.anatomy, 3, {});
    workFor(3, 100.0);
    QVERIFY2(message().isEmpty(), qPrintable(message()));
    m_window->setAssignment(assignment);
    m_window->showTooth(assignment.anatomy, 4, {});
    workFor(4, 100.0);
    QVERIFY2(message().contains("time of this lesson is over"), qPrintable(message()));
    // It is said where the lesson is.
    actions().lessons->trigger();
    QVERIFY2(message().isEmpty(), qPrintable(message()));
}

/// The clock of a lesson is that of the work on it.
void TestMainWindow::aLessonsClockRestsWhereNobodyWorks()
{
    lessons::Assignment assignment = lessons::assign(*shipped("class1-36").lesson).value().assignment;
    assignment.lesson->minutes = 2.0;
    std::uint64_t generation = 1;
    double recordedS = 0.0;
    const auto pass = [&](double seconds) {
        recordedS += seconds;
        SessionState session;
        session.toothGeneration = generation;
        session.recordedS = recordedS;
        publish({}, session);
        QTest::qWait(400);  // until the window has taken it, on a busy computer, too
    };
    const auto clock = [this] { return child<TabularLabel>("lessonTime")->text(); };
    const auto begin = [&] {
        recordedS = 0.0;
        m_window->setAssignment(assignment);
        m_window->showTooth(assignment.anatomy, ++generation, {});
    };
    begin();
    pass(30.0);
    QTRY_COMPARE(clock(), QString("1:30"));
    actions().lessons->trigger();
    pass(300.0);
    QVERIFY2(message().isEmpty(), qPrintable(message()));
    actions().back->trigger();
    pass(10.0);
    QTRY_COMPARE(clock(), QString("1:20"));
    // A tooth that is whole again is still the same attempt, whose time is counted; who has a grade needs none.
    actions().reload->trigger();
    pass(20.0);
    QTRY_COMPARE(clock(), QString("1:00"));
    m_window->showScore(sheet(3.2, 40, 0.5), {});
    pass(300.0);
    actions().back->trigger();
    pass(300.0);
    QTRY_COMPARE(clock(), QString("1:00"));
    QVERIFY2(!message().contains("time of this lesson"), qPrintable(message()));
    // One that is gone on with has rested before as well.
    begin();
    m_window->resumeClock(100.0, 40.0);
    recordedS = 100.0;
    pass(10.0);
    QTRY_COMPARE(clock(), QString("1:10"));
    // An exam's goes on, until there is a grade.
    assignment.lesson->exam = true;
    begin();
    pass(30.0);
    actions().lessons->trigger();
    pass(30.0);
    actions().back->trigger();
    pass(10.0);
    QTRY_COMPARE(clock(), QString("0:50"));
    m_window->showScore(sheet(3.2, 40, 0.5), {});
    QSignalSpy grade(m_window.get(), &MainWindow::gradeRequested);
    pass(300.0);
    actions().back->trigger();
    pass(300.0);
    QTRY_COMPARE(clock(), QString("0:50"));
    QVERIFY(grade.isEmpty());
}

/// On every page and in the practice room, in words.
void TestMainWindow::enterPressesTheButtonThatHasTheFocus()
{
    m_window->askWho(ui::people::Door::Login);
    auto* login = m_window->findChild<ui::people::LoginPage*>();
    auto* guest = m_window->findChild<QPushButton*>("practiseAsGuest");
    QSignalSpy wanted(login, &ui::people::LoginPage::guestWanted);
    guest->setFocus(Qt::TabFocusReason);
    QTRY_VERIFY(guest->hasFocus());
    QTest::keyClick(guest, Qt::Key_Return);
    QCOMPARE(wanted.count(), 1);
}

void TestMainWindow::aGuestIsToldThatNothingIsKept()
{
    const auto isTold = [this] {
        for (const QLabel* sign : m_window->findChildren<QLabel*>(QStringLiteral("guestSign")))
            if (sign->isVisible())
                return sign->text() == "Guest,\nunsaved";
        return false;
    };
    QVERIFY(isTold());
    actions().lessons->trigger();
    QVERIFY(isTold());
    m_window->showScore(sheet(3.2, 40, 0.5), {});
    QVERIFY(isTold());
    support::SchoolRig rig(false);
    rig.populate();
    m_window->setWho(rig.student);
    QVERIFY(!isTold());
    actions().back->trigger();
    QVERIFY(m_window->view().isVisible() && !isTold());
    // Else in whose name one drills.
    const auto* name = child<QLabel>("accountName");
    QVERIFY(name->isVisible());
    QCOMPARE(name->text(), QString::fromStdString(rig.student.username()));
    m_window->setWho({});
    QVERIFY(isTold());
    QVERIFY(!name->isVisible());
}

void TestMainWindow::aWarningGoesWithItsReason()
{
    m_window->showError({core::ErrorCode::FileUnwritable, "no room"}, ui::text::Failed::KeepingAttempt);
    QVERIFY2(message().contains("is not kept on the disk"), qPrintable(message()));
    m_window->showError({core::ErrorCode::FileUnwritable, "no room"}, ui::text::Failed::SavingRecording);
    m_window->forgetAttemptNotKept();
    QVERIFY2(message().contains("was not saved"), qPrintable(message()));
    child<MessageBar>()->dismiss();
    QVERIFY2(message().isEmpty(), qPrintable(message()));
    // Once the school has answered, what was said of its silence is over.
    m_window->showError({core::ErrorCode::ConnectionLost, "away"}, ui::text::Failed::ReadingSchool);
    QVERIFY2(message().contains("cannot be shown now"), qPrintable(message()));
    m_window->showUnanswered();
    QVERIFY2(message().contains("does not answer yet"), qPrintable(message()));
    m_window->forgetUnanswered();
    QVERIFY2(message().isEmpty(), qPrintable(message()));
}

/// A bur that was left running in the air is noticed while somebody reads on.
void TestMainWindow::aBreachWaitsForWhoReadsAnotherPage()
{
    core::grading::Infraction infraction;
    infraction.breach = core::grading::Breach::BurInAir;
    infraction.limit = 10.0;
    m_window->setLessons(lessons::readCatalog({}), {});
    actions().lessons->trigger();
    m_window->tellInfraction(infraction, false);
    QVERIFY(child<ui::study::LessonsPage>()->isVisible());
    actions().back->trigger();
    QVERIFY(child<ui::study::InfractionCard>()->isVisible());
    QVERIFY(child<QPushButton>("goOn")->hasFocus());
    press(Qt::Key_Return);
    QVERIFY(!child<ui::study::InfractionCard>()->isVisible());
}

void TestMainWindow::theAidsInUseAreNoted()
{
    look(16);
    const auto first = aidsNoted();
    QVERIFY(first.has_value());
    QVERIFY((*first & kDepthGaugeAid) != 0 && (*first & kSectionAid) == 0);
    press(Qt::Key_X);
    look(16);
    QVERIFY((aidsNoted().value_or(0) & kSectionAid) != 0);
    press(Qt::Key_F);
    look(16);
    QVERIFY((aidsNoted().value_or(0) & kRadiographAid) != 0);
    press(Qt::Key_Escape);
    look(16);
    QVERIFY((aidsNoted().value_or(kRadiographAid) & kRadiographAid) == 0);
    look(16);
    QVERIFY2(!aidsNoted().has_value(), "said once");
    // What was out before, and is not seen where the lesson does not allow it, is not in use there.
    actions().mirror->setChecked(true);
    look(16);
    QVERIFY((aidsNoted().value_or(0) & kMirrorAid) != 0);
    lessons::Aids noMirror;
    noMirror.mirror = false;
    m_window->setAids(noMirror);
    look(16);
    QVERIFY((aidsNoted().value_or(kMirrorAid) & kMirrorAid) == 0);
    m_window->setAids({});
    actions().mirror->setChecked(false);
    look(16);
    static_cast<void>(aidsNoted());
    // The console tells no more than the lesson allows, and of what it tells that is noted, too.
    auto* console = child<ui::console::Console>();
    press(Qt::Key_F9);
    look(16);
    QVERIFY((aidsNoted().value_or(kDepthGaugeAid) & kDepthGaugeAid) == 0);
    console->execute(QStringLiteral("watch live.depth"));
    look(16);
    QVERIFY((aidsNoted().value_or(0) & kDepthGaugeAid) != 0);
    m_window->setAids(lessons::Aids::none());
    look(16);
    QVERIFY((aidsNoted().value_or(kDepthGaugeAid) & kDepthGaugeAid) == 0);
    console->execute(QStringLiteral("get live.depth"));
    QVERIFY(child<QPlainTextEdit>("consoleOutput")->toPlainText().endsWith("This lesson does not allow it."));
}

void TestMainWindow::theBurTellsHowNearItIs()
{
    const auto shown = [this] { return child<TabularLabel>("marginFigure")->text(); };
    ServoState servo;
    servo.tick = 1;
    servo.toothGeneration = 1;
    servo.anchorMm = {support::kLesionX, support::kLesionY, 20.0};
    const auto whenAt = [&](double z) {
        servo.anchorMm.z = z;
        publish(servo, {});
        look(16);
        return shown();
    };
    const QString nothing = whenAt(20.0);
    press(Qt::Key_A);
    QCOMPARE(whenAt(20.0), nothing);
    // Deep in what is to be kept beside the decay.
    servo.anchorMm.x += 3.0;
    const QString inside = whenAt(-3.0);
    QVERIFY2(inside.startsWith(QChar(0x2212)), qPrintable(inside));
    QVERIFY((aidsNoted().value_or(0) & kBurColourAid) != 0);
    lessons::Aids aids;
    aids.burColour = false;
    m_window->setAids(aids);
    QCOMPARE(whenAt(-3.0), nothing);
    QVERIFY(!actions().burColour->isEnabled());
    m_window->setAids({});
    press(Qt::Key_A);
    QCOMPARE(whenAt(-3.0), nothing);
}

void TestMainWindow::aHandIsHeldOnRequest()
{
    QSignalSpy wanted(m_window.get(), &MainWindow::fixtureWanted);
    press(Qt::Key_Q);
    press(Qt::Key_Q);
    QCOMPARE(wanted.count(), 2);
    QVERIFY(wanted.front().front().toBool() && !wanted.back().front().toBool());
    lessons::Aids aids;
    aids.fixture = false;
    m_window->setAids(aids);
    press(Qt::Key_Q);
    QCOMPARE(wanted.count(), 2);
}

void TestMainWindow::aBreachStopsTheBurAndIsExplained()
{
    core::grading::Infraction infraction;
    infraction.breach = core::grading::Breach::TooDeep;
    infraction.limit = 2.5;
    infraction.tick = 4321;
    static_cast<void>(sent());
    QSignalSpy back(m_window.get(), &MainWindow::takeBackWanted);
    m_window->tellInfraction(infraction, true);
    QVERIFY(child<ui::study::InfractionCard>()->isVisible());
    QCOMPARE(child<QLabel>("infraction")->text(), QString("Deeper than 2.50 mm"));
    QVERIFY2(child<ui::inside::SectionView>()->isVisible(), "the section shows where");
    const auto stopped = sent();
    QVERIFY(!stopped.isEmpty() && std::holds_alternative<SetDrill>(stopped.front()));
    QVERIFY(!std::get<SetDrill>(stopped.front()).on);
    press(Qt::Key_Return);
    QVERIFY(!child<ui::study::InfractionCard>()->isVisible());
    QCOMPARE(back.count(), 1);
    QCOMPARE(back.front().front().toULongLong(), qulonglong{4321});
    // Undo is the same, or the card would go on telling what is no longer there.
    m_window->tellInfraction(infraction, true);
    press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(!child<ui::study::InfractionCard>()->isVisible());
    QCOMPARE(back.count(), 2);
    // Where there is nothing to go back to, only going on is offered.
    m_window->tellInfraction(infraction, false);
    QVERIFY(!child<QPushButton>("takeBack")->isVisible());
    press(Qt::Key_Escape);
    QVERIFY(!child<ui::study::InfractionCard>()->isVisible());
    QCOMPARE(back.count(), 2);
    press(Qt::Key_X);
    QVERIFY(!child<ui::inside::SectionView>()->isVisible());
    infraction.breach = core::grading::Breach::BurInAir;
    m_window->tellInfraction(infraction, true);
    QVERIFY2(!child<QPushButton>("takeBack")->isVisible(), "in the air nothing was cut");
    QVERIFY2(!child<ui::inside::SectionView>()->isVisible(), "there is nothing to be seen");
    press(Qt::Key_Escape);
    // How wide a marginal ridge is, is seen along the tooth only.
    QVERIFY(child<ui::inside::SectionView>()->angleDeg() != 0);
    infraction.breach = core::grading::Breach::RidgeCut;
    m_window->tellInfraction(infraction, true);
    QCOMPARE(child<ui::inside::SectionView>()->angleDeg(), 0);
    // What was to be cut lies in the plane that shows where it was cut instead.
    const auto molar = support::syntheticMolar();
    const auto ideal = core::grading::idealCavity(*molar);
    const core::terrain::Grid& grid = molar->grid;
    infraction.breach = core::grading::Breach::WrongPlace;
    for (const glm::dvec2 place : {grid.nodeMm(0, grid.side / 2), grid.nodeMm(grid.side / 2, 0), grid.nodeMm(0, 0)}) {
        infraction.placeMm = glm::dvec3(place, 0.0);
        m_window->tellInfraction(infraction, true);
        const double angle = child<ui::inside::SectionView>()->angleDeg() * std::numbers::pi / 180.0;
        bool isThere = false;
        for (double mm = -40.0; mm < 40.0; mm += 0.5 * grid.cellMm) {
            const glm::dvec2 at = grid.latticeOf(place + mm * glm::dvec2(std::cos(angle), std::sin(angle)));
            const auto i = static_cast<int>(std::lround(at.x));
            const auto j = static_cast<int>(std::lround(at.y));
            if (grid.contains(i, j))
                isThere = isThere || (*ideal)[grid.index(i, j)] < molar->top[grid.index(i, j)];
        }
        QVERIFY(isThere);
    }
}

void TestMainWindow::whatALessonLocksRests()
{
    press(Qt::Key_X);
    QVERIFY(child<ui::inside::SectionView>()->isVisible());
    const QString tip = actions().section->toolTip();
    m_window->setAids(lessons::Aids::none());
    QVERIFY(!child<ui::inside::SectionView>()->isVisible());
    for (const QAction* aid : {actions().section, actions().turnSection, actions().radiograph}) {
        QVERIFY(!aid->isEnabled());
        QVERIFY(aid->toolTip().contains("does not allow"));
    }
    QVERIFY(!child<TabularLabel>("depthFigure")->isVisible());
    QVERIFY(!child<TabularLabel>("dentinFigure")->isVisible());
    press(Qt::Key_X);
    press(Qt::Key_F);
    QVERIFY(!child<ui::inside::SectionView>()->isVisible());
    QVERIFY(!child<ui::inside::XrayPage>()->isVisible());
    QVERIFY2(child<TabularLabel>("decayFigure")->isVisible(), "what is no aid stays");
    // A section without the gauge tells no figures.
    lessons::Aids aids;
    aids.depthGauge = false;
    m_window->setAids(aids);
    QCOMPARE(actions().section->toolTip(), tip);
    press(Qt::Key_X);
    QVERIFY(child<ui::inside::SectionView>()->isVisible());
    QVERIFY(!child<TabularLabel>("sectionNearest")->isVisible());
    m_window->setAids({});
    QVERIFY(child<TabularLabel>("sectionNearest")->isVisible());
    QVERIFY(child<TabularLabel>("depthFigure")->isVisible());
    // Locked while it is looked at, the page of films closes.
    press(Qt::Key_F);
    QVERIFY(child<ui::inside::XrayPage>()->isVisible());
    m_window->setAids(lessons::Aids::none());
    QVERIFY(!child<ui::inside::XrayPage>()->isVisible());
}

void TestMainWindow::helpListsEveryAction()
{
    press(Qt::Key_F1);
    auto* help = child<HelpOverlay>();
    QVERIFY(help->isVisible());
    QSet<QString> words;
    for (const QLabel* label : help->findChildren<QLabel*>())
        words << label->text();
    for (const Actions::Group& group : actions().groups()) {
        QVERIFY2(words.contains(group.title()), qPrintable(group.title()));
        QVERIFY(group.actions.front()->isVisible() != (group.actions.front() == actions().pauseReplay));
        for (const QAction* action : group.actions) {
            QVERIFY2(words.contains(action->text()), qPrintable(action->text()));
            for (const QKeySequence& key : action->shortcuts())
                QVERIFY2(words.contains(key.toString(QKeySequence::NativeText)), qPrintable(action->text()));
        }
    }
    for (const char* gesture : {"Shift + arrows", "right or middle drag"})
        QVERIFY2(words.contains(gesture), gesture);
    press(Qt::Key_F1);
    QVERIFY(!help->isVisible());
}

void TestMainWindow::escapeGoesBackStepByStep()
{
    m_window->showError({core::ErrorCode::FileEmpty, "x"}, Failed::OpeningScan);
    press(Qt::Key_T);
    QVERIFY(child<ToothChooser>()->isVisible());
    press(Qt::Key_F1);
    QVERIFY(child<HelpOverlay>()->isVisible());
    press(Qt::Key_Escape);
    QVERIFY(!child<HelpOverlay>()->isVisible());
    QVERIFY(child<ToothChooser>()->isVisible());
    press(Qt::Key_Escape);
    QVERIFY(child<PracticeRoom>()->isVisible());
    QVERIFY(!message().isEmpty());
    press(Qt::Key_Escape);
    QVERIFY(message().isEmpty());
    press(Qt::Key_Escape);
    QVERIFY(m_window->isVisible());
    QVERIFY2(sent().isEmpty(), "going back never touches the work");
}

void TestMainWindow::escapeClosesAnOpenListOnly()
{
    m_window->openHistory();
    auto* lessons = child<ui::people::HistoryPage>()->findChild<QComboBox*>();
    QVERIFY(lessons != nullptr);
    lessons->addItems({"one", "two"});
    lessons->showPopup();
    QTRY_VERIFY(QApplication::activePopupWidget() != nullptr);
    QTest::keyClick(lessons->view(), Qt::Key_Escape);
    QTRY_VERIFY(QApplication::activePopupWidget() == nullptr);
    QVERIFY(child<ui::people::HistoryPage>()->isVisible());
    press(Qt::Key_Escape);
    QVERIFY(child<PracticeRoom>()->isVisible());
}

/// Else one of them keeps the room it had, and the other has none.
void TestMainWindow::theChartsShareASmallerWindowAsBefore()
{
    QList<database::AttemptRecord> attempts;
    for (int k = 40; k-- > 0;) {
        database::AttemptRecord one;
        one.id = k + 1;
        one.lessonId = "lesson" + std::to_string(k % 5);
        one.finishedUtc = QDateTime({2026, 1, 1}, {9, 0}, Qt::UTC).addDays(k).toString(Qt::ISODate).toStdString();
        one.scoreTenths = 600 + 7 * k;
        for (int c = 0; c < 16; ++c)
            one.criteria.push_back({"sound tissue removed beside the decay " + std::to_string(c), 100 - c, 300});
        attempts << one;
    }
    m_window->openHistory();
    m_window->historyPage().setHistory(attempts);
    const auto height = [this](const char* chart) { return child<ui::charts::ChartPanel>(chart)->height(); };
    const auto resize = [this](const QSize& size) {
        m_window->resize(size);
        QTRY_COMPARE(m_window->size(), size);
        QTest::qWait(50);
    };
    resize({1280, 800});
    const int score = height("scoreChart");
    const int other = height("otherChart");
    resize({1900, 1060});
    QVERIFY(height("scoreChart") > score);
    resize({1280, 800});
    QCOMPARE(height("scoreChart"), score);
    QCOMPARE(height("otherChart"), other);
}

void TestMainWindow::aRefusedPasswordIsTypedAnew()
{
    m_window->askWho(ui::people::Door::NewSchool);
    for (const char* name : {"password", "passwordAgain"})
        child<QLineEdit>(name)->setText("password1");
    m_window->refuseLogin({core::ErrorCode::OutOfRange, "everybody tries it first"});
    QCOMPARE(QApplication::focusWidget(), child<QLineEdit>("password"));
    for (const char* name : {"password", "passwordAgain"})
        QVERIFY(child<QLineEdit>(name)->text().isEmpty());
}

/// Of a large file, or one whose disk has much to do; what takes a moment is not.
void TestMainWindow::whatIsWaitedForAtTheDoorIsTold()
{
    m_window->askLogin();
    auto* waiting = child<QLabel>("waiting");
    m_window->setOpening(true);
    QVERIFY(!waiting->isVisible());
    QTRY_VERIFY(waiting->isVisible());
    QVERIFY2(waiting->text().contains("being opened"), qPrintable(waiting->text()));
    m_window->setOpening(false);
    QVERIFY(!waiting->isVisible());

    child<QLineEdit>("username")->setText("ann");
    child<QLineEdit>("password")->setText("something");
    QTest::keyClick(child<QLineEdit>("password"), Qt::Key_Return);
    QVERIFY(!waiting->isVisible());
    QTRY_VERIFY(waiting->isVisible());
    QVERIFY2(waiting->text().contains("Waiting"), qPrintable(waiting->text()));
    QVERIFY(child<QPushButton>("practiseAsGuest")->isEnabled());
    m_window->refuseLogin({core::ErrorCode::WrongLogin, "wrong"});
    QVERIFY(!waiting->isVisible());

    // Why it cannot be opened, and that it is tried again, stands there already.
    m_window->setUnreachable(core::Error{core::ErrorCode::ConnectionLost, "gone"}, "server", {});
    m_window->setOpening(true);
    QTest::qWait(800);
    QVERIFY(!waiting->isVisible());
    m_window->setOpening(false);
    m_window->setUnreachable({}, {}, {});
}

void TestMainWindow::whoWasLateToCreateTheSchoolLogsIn()
{
    m_window->setNewSchool(true);
    m_window->askLogin();
    QCOMPARE(child<ui::people::LoginPage>()->door(), ui::people::Door::NewSchool);
    m_window->setNewSchool(false);
    m_window->askLogin();
    QCOMPARE(child<ui::people::LoginPage>()->door(), ui::people::Door::Login);
    m_window->refuseLogin({core::ErrorCode::NotAllowed, "there are people here already"});
    QCOMPARE(QApplication::focusWidget(), child<QLineEdit>("username"));  // of this form nothing is typed yet
    const auto says = [this](const QString& words) {
        const auto labels = child<ui::people::LoginPage>()->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [&](const QLabel* one) {
            return one->isVisibleTo(m_window.get()) && one->text().contains(words);
        });
    };
    QVERIFY(says("Somebody has been entered here meanwhile"));
}

void TestMainWindow::anAdminIsToldHowToBeginWithClasses()
{
    support::SchoolRig rig(false);
    rig.populate();
    m_window->setWho(rig.admin);
    m_window->openClasses();
    m_window->classPage().setClasses({});
    QVERIFY(child<QLabel>("classEmpty")->text().contains("Make one"));
    QVERIFY(!child<QWidget>("lessonChooser")->isVisible());
    child<QPushButton>("enterPeople")->click();
    QVERIFY(child<ui::admin::AdminPage>()->isVisible());
}

ui::admin::PeoplePart& TestMainWindow::openPeople()
{
    support::SchoolRig rig(false);
    rig.populate();
    m_admin = rig.admin;
    m_window->setWho(m_admin);
    actions().school->trigger();
    return m_window->adminPage().people();
}

void TestMainWindow::choosePerson(int row) const
{
    auto* table = child<QTableView>("people");
    table->setCurrentIndex(table->model()->index(row, 0));
}

/// The table measures no more than its first thousand rows, and of those that are searched for only.
void TestMainWindow::peoplesColumnsAreMeasuredByAllOfThem()
{
    ui::admin::PeoplePart& people = openPeople();
    QList<database::Person> all;
    for (int k = 0; k < 1200; ++k)
        all << someone(k + 1, "Ada", true);
    all.back().role = database::Role::Instructor;
    all.back().familyName = "Zuse";  // and so the last
    const auto* table = child<QTableView>("people");
    const auto fits = [table] {
        const QModelIndex last = table->model()->index(table->model()->rowCount() - 1, 2);
        return last.data().toString() == "instructor" && table->columnWidth(2) >= table->sizeHintForIndex(last).width();
    };
    people.setPeople(all, {});
    QVERIFY(fits());
    auto* search = people.findChild<QLineEdit*>("peopleSearch");
    QVERIFY(search);
    search->setText("s7");
    people.setPeople(all, {});
    search->clear();
    QVERIFY(fits());
}

/// As the column of states is where there is little room: none has to be looked for behind a bar.
void TestMainWindow::peoplesColumnsShareTheWidth()
{
    ui::admin::PeoplePart& people = openPeople();
    database::Person one = someone(1, "Maria Magdalena Hildegard Victoria", false, {{1}, {2}, {3}});
    one.familyName = "von der Heide-Sondershausen";
    one.role = database::Role::Instructor;
    one.lastLoginUtc = "2026-11-20T10:15:00Z";
    people.setPeople({one}, {{{1}, "DEN101-A operative dentistry", 0}, {{2}, "DEN102-B", 0}, {{3}, "DEN103-C", 0}});
    people.showCode(writer(), one, "1234-5678");
    const auto* table = child<QTableView>("people");
    const auto inEnglish = qScopeGuard([] { ui::text::Language::choose("en_GB"); });
    for (const char* language : {"en_GB", "de", "es", "ja"})
        for (const QSize size : {QSize(1280, 800), QSize(1920, 1000), QSize(1280, 800)}) {
            ui::text::Language::choose(language);
            m_window->resize(size);
            QTest::qWait(50);
            QCOMPARE(table->horizontalScrollBar()->maximum(), 0);
            for (const int column : {2, 4, 5})
                QVERIFY2(table->columnWidth(column) >=
                             table->sizeHintForIndex(table->model()->index(0, column)).width(),
                         qPrintable(QString("%1, column %2").arg(QLatin1String(language)).arg(column)));
        }
}

void TestMainWindow::whoWasEnteredIsSeenInTheList()
{
    ui::admin::PeoplePart& people = openPeople();
    QList<database::Person> all;
    for (int k = 1; k <= 200; ++k)
        all << someone(k, "Ada", true);
    people.setPeople(all, {});
    all << someone(999, "Zoe", false);
    all.back().familyName = "Zuse";
    people.confirm({999}, [] { return QString("Zoe was entered."); });
    people.setPeople(all, {});
    const auto* table = child<QTableView>("people");
    const QModelIndexList rows = table->selectionModel()->selectedRows();
    QCOMPARE(rows.size(), 1);
    QVERIFY(rows.front().row() > 100);
    QTRY_VERIFY(table->viewport()->rect().contains(table->visualRect(rows.front()).center()));
}

/// What is searched for is found again when the search ends; what is only read once more moves nothing.
void TestMainWindow::whoIsChosenIsInSightAfterASearch()
{
    ui::admin::PeoplePart& people = openPeople();
    QList<database::Person> all;
    for (int k = 1001; k <= 3000; ++k)
        all << someone(k, "Ada", true);
    people.setPeople(all, {});
    const auto* table = child<QTableView>("people");
    const auto isSeen = [table] {
        const QModelIndexList rows = table->selectionModel()->selectedRows();
        return rows.size() == 1 && table->viewport()->rect().contains(table->visualRect(rows.front()).center());
    };
    auto* search = people.findChild<QLineEdit*>("peopleSearch");
    search->setText("s2500");
    choosePerson(0);
    search->clear();
    QVERIFY(isSeen());
    QScrollBar* bar = table->verticalScrollBar();
    QVERIFY(bar->value() > 100);

    bar->setValue(bar->value() / 2);
    const int scrolled = bar->value();
    QVERIFY(!isSeen());
    people.setPeople(all, {});
    QCOMPARE(bar->value(), scrolled);
    QCOMPARE(table->selectionModel()->selectedRows().size(), 1);
}

/// Of many that have as many letters.
void TestMainWindow::theWidestOfAColumnIsMeasured()
{
    ui::admin::PeoplePart& people = openPeople();
    QList<database::Person> all;
    for (int k = 1; k <= 60; ++k)
        all << someone(k, k < 50 ? "Williwilli Illitilli" : "Wammwamma Mammawammw", true);
    people.setPeople(all, {});
    const auto* table = child<QTableView>("people");
    for (int row = 0; row < table->model()->rowCount(); ++row)
        QVERIFY2(table->columnWidth(0) >= table->sizeHintForIndex(table->model()->index(row, 0)).width(),
                 qPrintable(table->model()->index(row, 0).data().toString()));
}

void TestMainWindow::aClassListIsChosenWhereTheLastOneLay()
{
    openPeople();
    m_window->adminPage().show(ui::admin::AdminPage::Roster);
    const QTemporaryDir folder;
    const auto choose = [this] {
        child<QPushButton>("chooseRoster")->click();
        return child<QFileDialog>("QFileDialog");
    };
    QFileDialog* dialog = choose();
    QVERIFY(dialog != nullptr);
    emit dialog->fileSelected(folder.filePath("class.csv"));
    delete dialog;
    dialog = choose();
    QCOMPARE(QFileInfo(dialog->directory().path()).canonicalFilePath(), QFileInfo(folder.path()).canonicalFilePath());
    dialog->reject();
    // What is short in it is said.
    database::RosterOutcome looked;
    looked.people = {{"eve", "Eve", database::Role::Student, {}, true, "", "", true},
                     {"ada", "Ada Berg", database::Role::Student, {}, false, "", "", false}};
    m_window->adminPage().roster().showOutcome(looked, "class.csv", false);
    const auto* rows = child<QTableView>("roster")->model();
    QCOMPARE(rows->index(0, 4).data().toString(), QString("new; the line has fewer fields than the first"));
    QCOMPARE(rows->index(1, 4).data().toString(), QString("known"));
}

void TestMainWindow::aHalfFilledFormIsPutAside()
{
    ui::admin::PeoplePart& people = openPeople();
    people.setPeople({someone(1, "Ada", true), someone(2, "Bob", true)}, {});
    const auto* given = child<QLineEdit>("personGiven");
    const auto* aside = child<QLabel>("personAside");
    choosePerson(0);
    choosePerson(1);
    QVERIFY(!aside->isVisible());
    choosePerson(0);
    QTest::keyClicks(child<QLineEdit>("personGiven"), "lina");
    choosePerson(1);
    QCOMPARE(given->text(), QString("Bob"));
    QVERIFY2(aside->isVisible() && aside->text().contains("Ada Berg"), qPrintable(aside->text()));
    child<QPushButton>("personAsideBack")->click();
    QCOMPARE(given->text(), QString("Adalina"));
    QCOMPARE(child<QTableView>("people")->currentIndex().row(), 0);
    QVERIFY(!aside->isVisible());
    // Of somebody new as well, and neither drops the other.
    child<QPushButton>("newPerson")->click();
    QTest::keyClicks(child<QLineEdit>("personUsername"), "eve");
    choosePerson(1);
    QVERIFY2(aside->text().contains("new person"), qPrintable(aside->text()));
    child<QPushButton>("personAsideBack")->click();
    QCOMPARE(child<QLineEdit>("personUsername")->text(), QString("eve"));
    QVERIFY2(aside->text().contains("Ada Berg"), qPrintable(aside->text()));
    // What was entered is not offered again.
    child<QPushButton>("savePerson")->click();
    people.confirm({3}, [] { return QString("eve was entered."); });
    people.setPeople({someone(1, "Ada", true), someone(2, "Bob", true), someone(3, "Eve", false)}, {});
    child<QPushButton>("personAsideBack")->click();
    QCOMPARE(given->text(), QString("Adalina"));
    QVERIFY(!aside->isVisible());
}

void TestMainWindow::presetsAreFoundFromTheSchoolAndFromOnesPlace()
{
    openPeople();
    QVERIFY(child<QMenu>("accountMenu")->actions().contains(actions().presets));
    const auto buttons = m_window->adminPage().findChildren<QPushButton*>();
    const auto found = std::find_if(buttons.begin(), buttons.end(), [this](const QPushButton* button) {
        return button->text() == actions().presets->text();
    });
    QVERIFY(found != buttons.end() && (*found)->isVisible());
    (*found)->click();
    QVERIFY(child<ui::presets::PresetsPage>()->isVisible());
}

/// Its word is bold.
void TestMainWindow::theChosenPartOfTheSchoolIsReadWhole()
{
    openPeople();
    for (QPushButton* button : m_window->adminPage().findChildren<QPushButton*>()) {
        if (button->property("kind") != "segment" || !button->isVisible())
            continue;
        button->click();
        QStyleOptionButton look;
        look.initFrom(button);
        look.text = button->text();
        look.state |= QStyle::State_On;
        const int room = button->style()->subElementRect(QStyle::SE_PushButtonContents, &look, button).width();
        const int word = QFontMetrics(typeface(kBody)).horizontalAdvance(button->text());
        QVERIFY2(room >= word, qPrintable(QString("%1: %2 of %3 px").arg(button->text()).arg(room).arg(word)));
    }
}

/// Tab on the way to something else.
void TestMainWindow::nobodyIsChosenByPassingThroughTheList()
{
    ui::admin::PeoplePart& people = openPeople();
    people.setPeople({someone(1, "Ada", true), someone(2, "Bob", true)}, {});
    child<QPushButton>("newPerson")->click();
    const auto* given = child<QLineEdit>("personGiven");
    auto* table = child<QTableView>("people");
    table->setFocus();
    table->selectionModel()->setCurrentIndex(table->model()->index(0, 0), QItemSelectionModel::NoUpdate);
    QVERIFY(given->text().isEmpty());
    QTest::keyClick(table, Qt::Key_Space);
    QCOMPARE(given->text(), QString("Ada"));
    QTest::keyClick(table, Qt::Key_Down);
    QCOMPARE(given->text(), QString("Bob"));
    // Who is searched for meanwhile is not chosen by that.
    child<QLineEdit>("peopleSearch")->setText("Ada");
    QCOMPARE(given->text(), QString("Bob"));
    child<QLineEdit>("peopleSearch")->clear();
    QVERIFY(table->selectionModel()->isRowSelected(1));
}

void TestMainWindow::aCodeStaysWithItsPerson()
{
    ui::admin::PeoplePart& people = openPeople();
    people.setPeople({someone(1, "Ada", false), someone(2, "Bob", true)}, {});
    const auto* code = child<QLabel>("oneTimeCode");
    choosePerson(0);
    people.showCode(writer(), someone(1, "Ada", false), "1234-5678");
    QVERIFY(code->isVisible());
    choosePerson(1);
    QVERIFY(!code->isVisible());
    // The list says whose code can still be seen.
    const auto state = [this](int row) {
        return child<QTableView>("people")->model()->index(row, 5).data().toString();
    };
    QVERIFY2(state(0).contains("shown here") && !state(1).contains("shown here"), qPrintable(state(0)));
    m_window->adminPage().show(ui::admin::AdminPage::Roster);
    m_window->adminPage().show(ui::admin::AdminPage::People);
    choosePerson(0);
    QVERIFY(code->isVisible());
    QCOMPARE(code->text(), QString("1234-5678"));
    // It was used.
    people.setPeople({someone(1, "Ada", true), someone(2, "Bob", true)}, {});
    QVERIFY(!code->isVisible());
    // Another admin has made another one, with which this is good for nothing.
    people.showCode(writer(), someone(1, "Ada", false), "1234-5678");
    QVERIFY(code->isVisible());
    database::Person again = someone(1, "Ada", false);
    again.codeUntilUtc = "9999-01-01T00:00:00Z";
    people.setPeople({again, someone(2, "Bob", true)}, {});
    QVERIFY(!code->isVisible());
    QCOMPARE(state(0), QString("has a one-time code"));
    // Nor is one of somebody whom a restored school does not know.
    people.showCode(writer(), again, "1234-5678");
    QVERIFY(!people.unkept().isEmpty());
    people.setPeople({someone(2, "Bob", true)}, {});
    QVERIFY2(people.unkept().isEmpty(), qPrintable(people.unkept()));
    people.setPeople({someone(1, "Ada", false), someone(2, "Bob", true)}, {});
    people.showCode(writer(), someone(1, "Ada", false), "1234-5678");
    actions().lessons->trigger();
    actions().school->trigger();
    QVERIFY(child<QWidget>("people")->isVisible() && !code->isVisible());
    QVERIFY2(!state(0).contains("shown here"), qPrintable(state(0)));
}

void TestMainWindow::aCodeIsNotLostByOneKey()
{
    ui::admin::PeoplePart& people = openPeople();
    people.setPeople({someone(1, "Ada", false)}, {});
    int reset = 0;
    connect(&people, &ui::admin::PeoplePart::resetWanted, this, [&] { ++reset; });
    const auto* code = child<QLabel>("oneTimeCode");
    choosePerson(0);
    people.showCode(writer(), someone(1, "Ada", false), "1234-5678");
    // It may have been told.
    child<QPushButton>("resetPassword")->click();
    child<QPushButton>("resetPassword")->click();
    QCOMPARE(reset, 0);
    QVERIFY2(child<QLabel>("personSaid")->text().contains("make another"),
             qPrintable(child<QLabel>("personSaid")->text()));
    child<QPushButton>("keepAsItIs")->click();
    child<QTableView>("people")->setFocus();
    press(Qt::Key_Escape);
    QVERIFY(code->isVisible());
    QVERIFY(child<QLabel>("personSaid")->text().contains("kept nowhere else"));
    // Who does anything else is warned anew.
    child<QPushButton>("resetPassword")->click();
    child<QPushButton>("keepAsItIs")->click();
    child<QTableView>("people")->setFocus();
    press(Qt::Key_Escape);
    QVERIFY(code->isVisible());
    QVERIFY(child<QLabel>("personSaid")->text().contains("kept nowhere else"));
    press(Qt::Key_Escape);
    QVERIFY(!m_window->adminPage().isVisible());
}

void TestMainWindow::whatIsThereOrMissingIsSaidOfPeople()
{
    ui::admin::PeoplePart& people = openPeople();
    people.setPeople({someone(1, "Ada", true)}, {{{4}, "Year 1", 0}});
    choosePerson(0);
    int wanted = 0;
    connect(&people, &ui::admin::PeoplePart::classWanted, this, [&] { ++wanted; });
    child<QLineEdit>("className")->setText("Year 1");
    child<QPushButton>("addClass")->click();
    QCOMPARE(wanted, 0);
    QCOMPARE(child<QLabel>("personSaid")->text(), QString("There is a class Year 1 already. It is ticked above."));
    QCOMPARE(child<QListWidget>("personClasses")->item(0)->checkState(), Qt::Checked);
    child<QPushButton>("newPerson")->click();
    child<QPushButton>("savePerson")->click();
    QVERIFY(child<QLabel>("personFault")->text().contains("is missing"));
}

void TestMainWindow::pagesOfLessonsAreTurned()
{
    m_window->setLessons(lessons::readCatalog({}), {});
    actions().lessons->trigger();
    auto* list = child<QListView>("lessonList");
    QVERIFY(list->hasFocus());
    const QPixmap with = list->grab();
    const int first = list->currentIndex().row();
    press(Qt::Key_PageDown);
    QVERIFY(list->currentIndex().row() > first + 1);
    press(Qt::Key_PageUp);
    QCOMPARE(list->currentIndex().row(), first);
    // Who has the keyboard is seen.
    child<QPushButton>("startLesson")->setFocus();
    QVERIFY(list->grab().toImage() != with.toImage());
}

void TestMainWindow::enterPressesTheWayBack()
{
    actions().lessons->trigger();
    auto* page = child<ui::study::LessonsPage>();
    auto* arrow = page->findChild<QToolButton*>(QString(), Qt::FindDirectChildrenOnly);
    QVERIFY(arrow != nullptr && page->isVisible());
    arrow->setFocus();
    QTest::keyClick(arrow, Qt::Key_Return);
    QVERIFY(!page->isVisible());
}

void TestMainWindow::aDoubleClickOnEnterTakesNoPasswordAway()
{
    ui::admin::PeoplePart& people = openPeople();
    int entered = 0;
    int reset = 0;
    connect(&people, &ui::admin::PeoplePart::addWanted, this, [&] { ++entered; });
    connect(&people, &ui::admin::PeoplePart::changeWanted, this, [&] { ++entered; });
    connect(&people, &ui::admin::PeoplePart::resetWanted, this, [&] { ++reset; });
    const auto* save = child<QPushButton>("savePerson");
    child<QPushButton>("newPerson")->click();
    child<QLineEdit>("personUsername")->setText("eve");
    QTest::qWait(0);
    const QPoint place = save->mapTo(m_window.get(), QPoint());
    child<QPushButton>("savePerson")->click();
    people.confirm({1}, [] { return QString("eve was entered."); });
    people.showCode(writer(), someone(1, "Eve", false), "1234-5678");
    people.setPeople({someone(1, "Eve", false)}, {});
    child<QPushButton>("savePerson")->click();
    child<QPushButton>("resetPassword")->click();
    QCOMPARE(entered, 1);
    QCOMPARE(reset, 0);
    QTRY_COMPARE(save->mapTo(m_window.get(), QPoint()), place);
    // Later the button does what it says.
    QTRY_VERIFY((child<QPushButton>("resetPassword")->click(), reset > 0));
}

void TestMainWindow::theQuestionOfAPasswordEndsWithAnythingElse()
{
    ui::admin::PeoplePart& people = openPeople();
    people.setPeople({someone(1, "Ada", true)}, {});
    choosePerson(0);
    const auto* keep = child<QPushButton>("keepAsItIs");
    child<QPushButton>("resetPassword")->click();
    QVERIFY(keep->isVisible());
    QTest::keyClicks(child<QLineEdit>("personGiven"), "x");
    QVERIFY(!keep->isVisible());
    QVERIFY(child<QLabel>("personSaid")->text().isEmpty());
    child<QPushButton>("resetPassword")->click();
    QVERIFY(keep->isVisible());
    child<QPushButton>("savePerson")->click();
    QVERIFY(!keep->isVisible());
    QCOMPARE(child<QPushButton>("resetPassword")->text(), QString("Reset password"));
}

/// In the language with the longest words.
void TestMainWindow::answersToAQuestionHaveTheirRoom()
{
    const auto inEnglish = qScopeGuard([] { ui::text::Language::choose("en_GB"); });
    ui::text::Language::choose("de");
    ui::admin::PeoplePart& people = openPeople();
    database::Person own = someone(1, "Ada", true);
    own.uid = writer().toStdString();
    own.role = database::Role::Admin;
    people.setPeople({own}, {});
    choosePerson(0);
    const auto* keep = child<QPushButton>("keepAsItIs");
    const auto isSeenWhole = [](const QPushButton* button) {
        return button->isVisible() && button->width() >= button->sizeHint().width() &&
               button->parentWidget()->rect().contains(button->geometry());
    };
    child<QComboBox>("personRole")->setCurrentIndex(0);
    child<QPushButton>("savePerson")->click();
    QTRY_VERIFY2(isSeenWhole(keep), qPrintable(keep->text()));
    QTRY_VERIFY(isSeenWhole(child<QPushButton>("savePerson")));
    QCOMPARE(keep->x(), child<QPushButton>("savePerson")->x());
    child<QPushButton>("keepAsItIs")->click();
    child<QPushButton>("disablePerson")->click();
    QTRY_VERIFY2(isSeenWhole(keep), qPrintable(keep->text()));
    QTRY_VERIFY2(isSeenWhole(child<QPushButton>("disablePerson")),
                 qPrintable(child<QPushButton>("disablePerson")->text()));
}

void TestMainWindow::theOwnClassesComeFirst()
{
    ui::admin::PeoplePart& people = openPeople();
    QList<database::SchoolClass> classes;
    for (const int number : {0, 1, 10, 11, 2, 3})
        classes.push_back({{number + 1}, "DEN-" + std::to_string(number), 0, 0});
    people.setPeople({someone(1, "Ada", true, {{4}, {11}})}, classes);
    choosePerson(0);
    const auto* list = child<QListWidget>("personClasses");
    QStringList shown;
    for (int row = 0; row < list->count(); ++row)
        shown << list->item(row)->text();
    QCOMPARE(shown, (QStringList{"DEN-3", "DEN-10", "DEN-0", "DEN-1", "DEN-2", "DEN-11"}));
    QCOMPARE(list->item(1)->checkState(), Qt::Checked);
    QCOMPARE(list->item(2)->checkState(), Qt::Unchecked);
}

void TestMainWindow::manyPeopleAreCountedByTheLocale()
{
    constexpr int kMany = 1503;
    ui::admin::PeoplePart& people = openPeople();
    QList<database::Person> all;
    database::RosterOutcome outcome;
    for (int n = 1; n <= kMany; ++n) {
        all << someone(n, "Ada", true);
        outcome.people.push_back({"s", "Ada", database::Role::Student, {}, true, {}, {}});
    }
    people.setPeople(all, {});
    QVERIFY2(child<QLabel>("peopleCount")->text().contains("1,503"), qPrintable(child<QLabel>("peopleCount")->text()));
    for (const bool isDone : {false, true}) {
        m_window->adminPage().roster().showOutcome(outcome, "class.csv", isDone);
        const QString said = child<QLabel>("rosterSaid")->text();
        QVERIFY2(said.contains("1,503"), qPrintable(said));
    }
}

void TestMainWindow::aListOfNobodyIsAFault()
{
    openPeople();
    m_window->adminPage().show(ui::admin::AdminPage::Roster);
    m_window->adminPage().roster().showOutcome({}, "class.csv", false);
    const auto* fault = child<QLabel>("rosterFault");
    QVERIFY2(fault->isVisible() && fault->text().contains("nobody in class.csv"), qPrintable(fault->text()));
    QVERIFY(!child<QLabel>("rosterSaid")->isVisible());
    QVERIFY(!child<QPushButton>("enterRoster")->isVisible());
}

void TestMainWindow::spaceOnAFocusedButtonPressesIt()
{
    QSignalSpy asked(m_window.get(), &MainWindow::gradeRequested);
    QPushButton* grade = nullptr;
    for (QPushButton* button : child<PracticeRoom>()->findChildren<QPushButton*>())
        if (button->text() == actions().grade->text())
            grade = button;
    QVERIFY(grade != nullptr);
    grade->setFocus(Qt::TabFocusReason);
    press(Qt::Key_Space);
    QCOMPARE(asked.size(), 1);
    QVERIFY2(sent().isEmpty(), "the drill did not start");
}

void TestMainWindow::theConsoleTakesKeysAndLeavesTheView()
{
    auto* console = child<ui::console::Console>();
    QVERIFY(!console->isVisible());
    press(Qt::Key_F10);
    QTRY_VERIFY(console->isVisible());
    QCOMPARE(QApplication::focusWidget(), child<QLineEdit>("consoleLine"));
    static_cast<void>(sent());
    QTest::keyClicks(QApplication::focusWidget(), "d1r ");  // which would drill, take a bur and begin again
    QVERIFY(sent().isEmpty());
    QCOMPARE(child<QLineEdit>("consoleLine")->text(), QString("d1r "));
    // The mouse drills beneath it.
    auto& view = m_window->view();
    const QPoint below(view.width() / 2, view.height() * 3 / 4);
    QVERIFY(!console->geometry().contains(view.mapTo(console->parentWidget(), below)));
    press(Qt::Key_QuoteLeft);
    QTRY_VERIFY(!console->isVisible());
    QCOMPARE(child<QLineEdit>("consoleLine")->text(), QString("d1r "));
    press(Qt::Key_QuoteLeft);
    QTRY_VERIFY(console->isVisible());
    press(Qt::Key_Escape);
    QTRY_VERIFY(!console->isVisible());
}

void TestMainWindow::presetsAndSettingsHavePages()
{
    QSignalSpy asked(m_window.get(), &MainWindow::presetsWanted);
    press(Qt::Key_F7);
    QTRY_VERIFY(child<ui::presets::PresetsPage>()->isVisible());
    QCOMPARE(asked.size(), 1);
    QVERIFY(!actions().console->isEnabled());
    press(Qt::Key_Escape);
    press(Qt::Key_Comma, Qt::ControlModifier);
    QTRY_VERIFY(child<ui::settings::SettingsPage>()->isVisible());
    press(Qt::Key_Escape);
    QTRY_VERIFY(child<PracticeRoom>()->isVisible());
}

void TestMainWindow::aComparisonIsEndedBesideTheTooth()
{
    const core::settings::FeelPreset preset = lessons::shippedPresets().front();
    emit child<ui::presets::PresetsPage>()->compareWanted(preset, preset, 2);
    m_window->beginTrial();
    press(Qt::Key_Comma, Qt::ControlModifier);
    QTRY_VERIFY(child<QLabel>("settingsBlind")->isVisible());
    auto* stiffness = child<QDoubleSpinBox>("force.stiffness");
    QVERIFY(!stiffness->isEnabled());
    press(Qt::Key_Escape);
    QTRY_VERIFY(child<ui::presets::TrialCard>()->isVisible());
    // What is cut into such a block is nobody's work, and no grade says anything of it.
    QVERIFY(!actions().grade->isEnabled());
    QTest::mouseClick(child<QPushButton>("trialEnd"), Qt::LeftButton);
    press(Qt::Key_Comma, Qt::ControlModifier);
    QTRY_VERIFY(stiffness->isVisible());
    QVERIFY(!child<QLabel>("settingsBlind")->isVisible() && stiffness->isEnabled());
    QCOMPARE(stiffness->value(), preset.stiffnessNPerMm);
    // The block may be felt otherwise, what was found out stays on the card.
    QSignalSpy felt(m_window.get(), &MainWindow::presetFelt);
    stiffness->setValue(1.5);
    QCOMPARE(felt.size(), 1);
    QVERIFY(!child<QLabel>("settingsFault")->isVisible());
    press(Qt::Key_Escape);
    QTRY_VERIFY(child<ui::presets::TrialCard>()->isVisible());
    QVERIFY(!child<ui::presets::TrialCard>()->tuned());
    QTest::mouseClick(child<QPushButton>("trialBack"), Qt::LeftButton);
    QTRY_VERIFY(child<ui::presets::PresetsPage>()->isVisible());
}

void TestMainWindow::figuresComeFromTheLoops()
{
    ServoState servo;
    servo.tick = 5;
    servo.touching = true;
    servo.materialUnderBur = Material::Dentin;
    servo.forceN = {0.0, 0.6, 0.8};
    servo.depthMm = 1.417;
    servo.hasDepth = true;
    SessionState session;
    session.wholeMm3 = {20.0, 200.0, 250.0, 20.0};
    session.removedMm3 = {5.0, 12.314, 4.0, 0.25};
    session.overcutMm3 = 9.806;
    publish(servo, session);
    QTRY_COMPARE(figure("materialFigure"), QString("Dentin"));
    QTRY_COMPARE(figure("depthFigure"), QString("1.42"));
    QCOMPARE(figure("forceFigure"), QString("1.00"));
    QCOMPARE(figure("decayFigure"), QString("75"));
    QCOMPARE(figure("enamelRemoved"), QString("12.31"));
    QCOMPARE(figure("dentinRemoved"), QString("4.00"));
    QCOMPARE(figure("pulpRemoved"), QString("0.25"));
    QCOMPARE(figure("overcut"), QString("9.81"));
    servo.touching = false;
    session.removedMm3[0] = 19.95;
    publish(servo, session);
    QTRY_COMPARE(figure("materialFigure"), QString("Air"));
    QTRY_COMPARE(figure("depthFigure"), QString("–"));
    QTRY_COMPARE(figure("decayFigure"), QString("< 1"));
}

void TestMainWindow::dentinOverThePulpIsTold()
{
    const core::terrain::Tooth& tooth = *m_window->view().tooth();
    const core::imaging::PulpChamber pulp(*tooth.anatomy);
    ServoState servo;
    servo.tick = 5;
    servo.touching = true;
    servo.hasDepth = true;
    // Over the pulp, behind the lesion.
    servo.anchorMm = {0.3, 1.3, -2.0};
    const auto reading = core::imaging::readDepth(tooth, pulp, servo.anchorMm);
    QVERIFY(reading.dentinOverPulpMm.value() > 0.5);
    publish(servo, {});
    QTRY_COMPARE(figure("dentinFigure"), QLocale().toString(*reading.dentinOverPulpMm, 'f', 2));
    // Beside the pulp there is none over it.
    servo.anchorMm = {4.2, 0.0, -2.0};
    QVERIFY(!core::imaging::readDepth(tooth, pulp, servo.anchorMm).dentinOverPulpMm);
    publish(servo, {});
    QTRY_COMPARE(figure("dentinFigure"), QString("–"));
}

void TestMainWindow::depthBesideTheToothShowsADash()
{
    ServoState servo;
    servo.tick = 5;
    servo.touching = true;
    servo.depthMm = 10.56;
    servo.forceN = {0.0, 0.0, 0.5};
    publish(servo, {});
    QTRY_COMPARE(figure("forceFigure"), QString("0.50"));
    QCOMPARE(figure("depthFigure"), QString("–"));
}

void TestMainWindow::aWallThatPressesIsTold()
{
    ServoState servo;
    servo.tick = 5;
    servo.touching = true;
    servo.forceN = {0.6, 0.0, 0.8};
    publish(servo, {});
    QTRY_COMPARE(figure("forceFigure"), QString("1.00"));
    QCOMPARE(child<TabularLabel>("forceFigure")->unit(), QString("N, 0.6 sideways"));
    servo.forceN = {0.0, 0.0, 0.8};
    publish(servo, {});
    QTRY_COMPARE(child<TabularLabel>("forceFigure")->unit(), QString("N"));
}

void TestMainWindow::aHandpieceOnTheCrownIsTold()
{
    // The force is there and the bur touches nothing: it hangs beside the tooth.
    ServoState servo;
    servo.tick = 5;
    servo.handpieceOnCrown = true;
    servo.forceN = {0.0, 0.0, 0.8};
    publish(servo, {});
    QTRY_COMPARE(figure("materialFigure"), QString("Handpiece"));
    auto* sentence = child<QLabel>("health");
    QTRY_VERIFY(sentence->text().startsWith("The handpiece lies on the crown"));
    servo.touching = true;
    publish(servo, {});
    QTRY_COMPARE(figure("materialFigure"), QString("Enamel"));
    QTRY_VERIFY(!sentence->isVisible());
}

void TestMainWindow::harmIsToldWhenItHappens()
{
    auto* notice = child<QLabel>("notice");
    SessionState session;
    session.toothGeneration = 1;
    session.removedMm3[1] = 3.0;
    publish({}, session);
    QTRY_COMPARE(figure("enamelRemoved"), QString("3.00"));
    QVERIFY(!notice->isVisible());
    session.removedMm3[3] = 0.01;
    publish({}, session);
    QTRY_VERIFY(notice->isVisible());
    QCOMPARE(notice->text(), QString("Pulp opened"));
    session.perforated = true;
    publish({}, session);
    QTRY_COMPARE(notice->text(), QString("Tooth perforated"));
    session.removedMm3[3] = 0.0;
    session.perforated = false;
    publish({}, session);
    QTRY_VERIFY(!notice->isVisible());
    // Another tooth that comes with its harm done: an attempt that waited for a replay.
    session.toothGeneration = 2;
    session.removedMm3[1] = 4.0;
    session.perforated = true;
    publish({}, session);
    QTRY_COMPARE(figure("enamelRemoved"), QString("4.00"));
    QVERIFY(!notice->isVisible());
}

void TestMainWindow::noDecayShowsADash()
{
    SessionState session;
    session.wholeMm3 = {0.0, 200.0, 250.0, 20.0};
    publish({}, session);
    QTRY_COMPARE(figure("decayFigure"), QString("–"));
}

void TestMainWindow::theHintGoesWithTheFirstCut()
{
    auto* hint = child<QLabel>("hint");
    QVERIFY(hint->isVisible());
    ServoState servo;
    servo.tick = 1;
    servo.cutting = true;
    publish(servo, {});
    QTRY_VERIFY(!hint->isVisible());
}

void TestMainWindow::pushForceGoesBothWays()
{
    auto* slider = child<QSlider>("pushForce");
    slider->setValue(20);
    QCOMPARE(m_window->view().pushForce(), 2.0);
    m_window->view().setPushForce(0.5);
    emit m_window->view().pushForceChanged(0.5);
    QCOMPARE(slider->value(), 5);
    QCOMPARE(child<SidePanel>()->pushForce(), 0.5);
}

void TestMainWindow::whyNothingIsDrilledFromBelowIsToldOnce()
{
    emit m_window->view().pushRefused();
    QVERIFY(message().startsWith("From below"));
    press(Qt::Key_Escape);
    emit m_window->view().pushRefused();
    QVERIFY(message().isEmpty());
}

void TestMainWindow::troubleStaysOutOfTheWayUntilItIsThere()
{
    const auto told = [this](const char* part) {
        for (const QLabel* label : child<SidePanel>()->findChildren<QLabel*>())
            if (label->isVisible() && label->text().contains(QLatin1String(part)))
                return true;
        return false;
    };
    QVERIFY(!told("handpiece is gone"));
    ServoState servo;
    servo.tick = 1;
    servo.health = kDeviceLost;
    publish(servo, {});
    QTRY_VERIFY(told("handpiece is gone"));
    servo.health = 0;
    publish(servo, {});
    QTRY_VERIFY(!told("handpiece is gone"));
}

void TestMainWindow::whatStaysCoversNoWayToAnotherPage()
{
    m_window->openHistory();
    const auto* bar = child<MessageBar>();
    const auto top = [this] { return m_window->historyPage().geometry().top(); };
    QCOMPARE(top(), 0);
    m_window->showError({core::ErrorCode::FileEmpty, "x"}, Failed::OpeningScan);
    QTRY_VERIFY(bar->isVisible() && top() > bar->geometry().bottom());
    actions().back->trigger();
    QTRY_COMPARE(child<PracticeRoom>()->geometry().top(), 0);  // there it lies over the tooth
    m_window->openHistory();
    QTRY_VERIFY(top() > bar->geometry().bottom());
    child<MessageBar>()->dismiss();
    QTRY_COMPARE(top(), 0);
}

/// On whatever page: of a word that takes the place of another, too.
void TestMainWindow::aMessageHasRoomForItsWords()
{
    const auto expectRoom = [this] {
        QTest::qWait(50);
        for (const QLabel* words : child<MessageBar>()->findChildren<QLabel*>())
            if (words->isVisible() && words->hasHeightForWidth())
                QVERIFY2(words->height() >= words->heightForWidth(words->width()), qPrintable(words->text()));
    };
    m_window->showMessage("A word.");
    expectRoom();
    m_window->showMessage(QString("This sentence is long, and takes the place of one that was short. ").repeated(4));
    expectRoom();
    m_window->showError({core::ErrorCode::FileUnwritable, {}}, Failed::KeepingExam);
    expectRoom();
    m_window->openHistory();
    expectRoom();
    m_window->showNotKept({core::ErrorCode::FileUnwritable, {}});
    expectRoom();
}

void TestMainWindow::errorsStayAndComeBackAfterNews()
{
    m_window->showError({core::ErrorCode::FileTruncated, "molar.stl: ends after 84 bytes."}, Failed::OpeningScan,
                        "/scans/molar.stl");
    QVERIFY(message().contains("ends too early"));
    bool named = false;
    bool exact = false;
    for (const QLabel* label : child<MessageBar>()->findChildren<QLabel*>()) {
        named = named || (label->isVisible() && label->text() == "molar.stl");
        exact = exact || label->toolTip().contains("molar.stl: ends after 84 bytes.");
    }
    QVERIFY(named);
    QVERIFY(exact);
    m_window->showMessage("Saved.");
    QCOMPARE(message(), QString("Saved."));
    press(Qt::Key_Escape);
    QVERIFY(message().contains("ends too early"));
    press(Qt::Key_Escape);
    QVERIFY(message().isEmpty());
    // A lesson is mended by its teacher, who reads which and where.
    m_window->showError({core::ErrorCode::FileTruncated, "tooth.scan: a.stl is cut short"}, Failed::OpeningLesson,
                        "my-scan");
    named = false;
    for (const QLabel* label : child<MessageBar>()->findChildren<QLabel*>())
        named = named || (label->isVisible() && label->text() == "my-scan: tooth.scan: a.stl is cut short");
    QVERIFY(named);
}

void TestMainWindow::anErrorGoesWithTheNextGoodTooth()
{
    const core::Error error{core::ErrorCode::FileEmpty, "x"};
    m_window->showError(error, Failed::KeepingGrades);
    m_window->showError(error, Failed::OpeningScan);
    m_window->showTooth(support::syntheticMolar(), 2, noted({"A note."}));
    QCOMPARE(message(), QString("A note."));
    m_window->showTooth(support::syntheticMolar(), 3, {});
    QVERIFY(message().startsWith("Grades will not be kept"));
    // What was just tried is answered first, whatever else is still to be read.
    m_window->showError(error, Failed::OpeningScan);
    QVERIFY(!message().startsWith("Grades will not be kept"));
    press(Qt::Key_Escape);
    QVERIFY(message().startsWith("Grades will not be kept"));
    press(Qt::Key_Escape);
    QVERIFY(message().isEmpty());
    // The tooth that stands in for the one refused at the start does not take the reason with it.
    MainWindow fresh(*m_links);
    fresh.showError(error, Failed::OpeningScan);
    fresh.showTooth(support::syntheticMolar(), 1, {});
    QVERIFY(fresh.findChild<MessageBar*>()->sentence().contains("is empty"));
}

void TestMainWindow::theMessageButtonDoesWhatItSays()
{
    press(Qt::Key_R);
    QCOMPARE(sent().size(), 1);
    QVERIFY(message().contains("whole again"));
    auto* button = child<MessageBar>()->findChild<QPushButton*>();
    QVERIFY(button->isVisible());
    QTest::mouseClick(button, Qt::LeftButton);
    const auto commands = sent();
    QCOMPARE(commands.size(), 1);
    QVERIFY(std::holds_alternative<Undo>(commands.front()));
    QVERIFY(message().isEmpty());
}

void TestMainWindow::anUnfinishedAttemptIsOffered()
{
    QSignalSpy resumed(m_window.get(), &MainWindow::resumeRequested);
    QSignalSpy discarded(m_window.get(), &MainWindow::discardRequested);
    auto* resume = child<MessageBar>()->findChild<QPushButton*>();
    auto* discard = child<MessageBar>()->findChild<QPushButton*>("decline");
    const QDateTime now = QDateTime::currentDateTime();
    m_window->offerUnfinished([] { return QString("Tooth 36"); }, now, false);
    const QString time = QLocale().toString(now.time(), QLocale::ShortFormat);
    QCOMPARE(message(), QString("Tooth 36: an attempt of %1 was not finished.").arg(time));
    QVERIFY(resume->isVisible() && discard->isVisible());
    QTest::mouseClick(resume, Qt::LeftButton);
    QCOMPARE(resumed.size(), 1);
    QVERIFY(message().isEmpty());
    m_window->offerUnfinished([] { return QString("Tooth 36"); }, QDateTime(QDate(2011, 5, 3), QTime(12, 31)), false);
    QVERIFY2(message().contains("2011") || message().contains("/11"), qPrintable(message()));
    // News does not push it out.
    m_window->showMessage("News.");
    QVERIFY(!discard->isVisible());
    press(Qt::Key_Escape);
    QVERIFY(message().contains("was not finished") && discard->isVisible());
    QTest::mouseClick(discard, Qt::LeftButton);
    QCOMPARE(discarded.size(), 1);
    QCOMPARE(resumed.size(), 1);
    // Another that was waiting takes its place: a double click is not meant for it.
    m_window->offerUnfinished([] { return QString("Tooth 36"); }, now, false);
    QTest::mouseClick(discard, Qt::LeftButton);
    QCOMPARE(discarded.size(), 1);
    QVERIFY(message().contains("was not finished") && discard->isVisible());
    QTest::qWait(3 * QApplication::doubleClickInterval());
    // Discarded at another door, it is no longer offered here.
    m_window->offerUnfinished([] { return QString("Tooth 36"); }, now, false);
    QVERIFY(!message().isEmpty());
    emit child<ui::study::LessonsPage>()->discardWanted();
    QVERIFY(message().isEmpty());
    QCOMPARE(discarded.takeLast().size(), 0);
    // The page of lessons has a card for it, and needs no second offer.
    m_window->offerUnfinished([] { return QString("Tooth 36"); }, now, false);
    actions().lessons->trigger();
    QVERIFY(message().isEmpty() && child<QFrame>("continueCard")->isVisible());
    actions().back->trigger();
    // Closed: neither, and it is offered again another time.
    m_window->offerUnfinished([] { return QString("Tooth 36"); }, now, false);
    press(Qt::Key_Escape);
    QVERIFY(message().isEmpty());
    QCOMPARE(discarded.size() + resumed.size(), 2);
}

/// It costs an attempt, as to leave one does.
void TestMainWindow::anExamIsNotDiscardedUnasked()
{
    QSignalSpy resumed(m_window.get(), &MainWindow::resumeRequested);
    QSignalSpy discarded(m_window.get(), &MainWindow::discardRequested);
    m_window->offerUnfinished([] { return QString("The exam"); }, QDateTime::currentDateTime(), true);
    actions().lessons->trigger();
    const auto answer = [this](const char* button) {
        QTest::mouseClick(child<QPushButton>("discardUnfinished"), Qt::LeftButton);
        QVERIFY(child<QuestionCard>("unfinishedQuestion") != nullptr);
        QVERIFY(child<QLabel>("questionDetail")->text().contains("counts as an attempt"));
        QTest::mouseClick(child<QPushButton>(button), Qt::LeftButton);
    };
    answer("questionStay");
    QVERIFY(discarded.isEmpty() && child<QFrame>("continueCard")->isVisible());
    answer("questionDiscard");
    QCOMPARE(discarded.size(), 1);
    QVERIFY(!child<QFrame>("continueCard")->isVisible());
    QTest::qWait(3 * QApplication::doubleClickInterval());
    m_window->offerUnfinished([] { return QString("The exam"); }, QDateTime::currentDateTime(), true);
    answer("questionSave");
    QCOMPARE(resumed.size(), 1);
    QCOMPARE(discarded.size(), 1);
}

void TestMainWindow::takingItUpAsksAboutTheWorkOnTheTable()
{
    QSignalSpy resumed(m_window.get(), &MainWindow::resumeRequested);
    cutSomething(0.5);
    m_window->offerUnfinished([] { return QString("Tooth 36"); }, QDateTime::currentDateTime(), false);
    QTest::mouseClick(child<MessageBar>()->findChild<QPushButton*>(), Qt::LeftButton);
    QCOMPARE(resumed.size(), 0);
    auto* question = child<QuestionCard>("workQuestion");
    QVERIFY(question != nullptr);
    child<QPushButton>("questionDiscard")->click();
    QCOMPARE(resumed.size(), 1);
}

void TestMainWindow::notesOfTheImporterAreShown()
{
    m_window->showTooth(support::syntheticMolar(), 2, noted({"The unit was guessed: millimetres."}));
    QCOMPARE(message(), QString("The unit was guessed: millimetres."));
    press(Qt::Key_Escape);
    m_window->showTooth(support::syntheticMolar(), 3, noted({"One.", "Two."}));
    QVERIFY(message().startsWith("2 note"));
}

void TestMainWindow::anotherUnitCanBeChosenBesideTheNote()
{
    QSignalSpy chosen(m_window.get(), &MainWindow::scanUnitChosen);
    m_window->showTooth(support::syntheticMolar(), 2, noted({"Centimetres were taken."}), true);
    const auto* button = child<MessageBar>()->findChild<QPushButton*>();
    QVERIFY(button->isVisible());
    QVERIFY(button->menu() != nullptr);
    QCOMPARE(button->menu()->actions().size(), 4);
    button->menu()->actions().front()->trigger();
    QCOMPARE(chosen.size(), 1);
    QCOMPARE(chosen.front().front().toString(), QString("mm"));
    QVERIFY(message().isEmpty());
    m_window->showTooth(support::syntheticMolar(), 3, noted({"Centimetres were taken."}), true);
    button->menu()->actions().back()->trigger();
    QCOMPARE(chosen.size(), 1);
    QVERIFY(message().isEmpty());
    m_window->showTooth(support::syntheticMolar(), 4, noted({"The scan has openings; they were closed."}));
    QVERIFY(!button->isVisible());
}

void TestMainWindow::workIsShownAndHoldsBackTheRest()
{
    auto* card = child<BusyCard>();
    m_window->showBusy("Loading the scan");
    QVERIFY(!card->isVisible());
    QVERIFY(!actions().grade->isEnabled());
    QVERIFY(!actions().openScan->isEnabled());
    QTRY_VERIFY(card->isVisible());
    m_window->showError({core::ErrorCode::NoTriangles, "x"}, Failed::OpeningScan);
    QVERIFY(!card->isVisible());
    QVERIFY(actions().openScan->isEnabled());
    m_window->showBusy("Again");
    m_window->showTooth(support::syntheticMolar(), 2, {});
    QVERIFY(!card->isWorking());
    QVERIFY(actions().grade->isEnabled());
}

void TestMainWindow::aReplayRestsTheControls()
{
    QSignalSpy stop(m_window.get(), &MainWindow::replayStopRequested);
    m_window->setReplaying(true);
    for (const Qt::Key key : {Qt::Key_D, Qt::Key_R, Qt::Key_2})
        press(key);
    press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(sent().isEmpty());
    QVERIFY2(!child<QLabel>("hint")->isVisible(), "there is nothing to begin with");
    press(Qt::Key_Escape);
    QCOMPARE(stop.size(), 1);
    m_window->setReplaying(false);
    QVERIFY(child<QLabel>("hint")->isVisible());
    press(Qt::Key_D);
    QCOMPARE(sent().size(), 1);
}

void TestMainWindow::aReplayMarksItsOwnBurAtOnce()
{
    // With the next frame, and not when the bur that was chosen a moment ago has had its time.
    const auto showsAtOnce = [this](int bur, bool drill) {
        ServoState servo;
        servo.tick = 1;
        servo.burIndex = static_cast<std::uint8_t>(bur);
        servo.drillOn = drill;
        publish(servo, {});
        QSignalSpy frames(&m_window->view(), &ui::tooth::ToothView::frameAdvanced);
        return frames.wait() && actions().burs[bur]->isChecked() && actions().drill->isChecked() == drill;
    };
    press(Qt::Key_4);
    press(Qt::Key_D);
    m_window->setReplaying(true, 10.0);
    QVERIFY(showsAtOnce(1, false));
    QVERIFY(!actions().burs[3]->isChecked());
    m_window->setReplaying(false);
    QVERIFY(showsAtOnce(3, true));
}

void TestMainWindow::aReplayTellsItsTimeAndPauses()
{
    QSignalSpy pause(m_window.get(), &MainWindow::replayPauseRequested);
    m_window->setReplaying(true, 95.0);
    QCOMPARE(figure("replayTime"), QString("0:00 of 1:35"));
    SessionState session;
    session.recordedS = 67.9;
    publish({}, session);
    QTRY_COMPARE(figure("replayTime"), QString("1:07 of 1:35"));
    press(Qt::Key_Space);
    QCOMPARE(actions().pauseReplay->text(), QString("Resume the replay"));
    bool named = false;
    for (const auto* button : child<PracticeRoom>()->findChildren<QAbstractButton*>())
        named = named || button->accessibleName() == "Resume the replay";
    QVERIFY(named);
    press(Qt::Key_Space);
    QCOMPARE(actions().pauseReplay->text(), QString("Pause the replay"));
    QCOMPARE(pause.size(), 2);
    QCOMPARE(pause[0].front().toBool(), true);
    QCOMPARE(pause[1].front().toBool(), false);
    QVERIFY2(sent().isEmpty(), "the drill is not meant");
    press(Qt::Key_Space);
    m_window->setReplaying(false);
    QVERIFY2(actions().pauseReplay->text().startsWith("Pause"), "the next replay begins by running");
    press(Qt::Key_Space);
    QCOMPARE(sent().size(), 1);
}

void TestMainWindow::aReplayHasEightSpeeds()
{
    QSignalSpy speed(m_window.get(), &MainWindow::replaySpeedChosen);
    m_window->setReplaying(true, 95.0);
    for (const char* shown : {"2×", "4×", "8×", "16×", "16×"}) {
        press(Qt::Key_BracketRight);
        QCOMPARE(figure("replaySpeed"), QString::fromUtf8(shown));
    }
    QCOMPARE(speed.size(), 4);
    QCOMPARE(speed[3].front().toDouble(), 16.0);
    for (const char* shown : {"8×", "4×", "2×", "1×", "0.5×", "0.25×", "0.1×", "0.1×"}) {
        press(Qt::Key_BracketLeft);
        QCOMPARE(figure("replaySpeed"), QString::fromUtf8(shown));
    }
    QCOMPARE(speed.back().front().toDouble(), 0.1);
    m_window->setReplaying(false);
    m_window->setReplaying(true, 95.0);
    QCOMPARE(figure("replaySpeed"), QString::fromUtf8("1×"));
}

void TestMainWindow::keysGoThroughAReplayByStrokes()
{
    QSignalSpy seek(m_window.get(), &MainWindow::seekWanted);
    QSignalSpy pause(m_window.get(), &MainWindow::replayPauseRequested);
    for (const Qt::Key key : {Qt::Key_Right, Qt::Key_Home, Qt::Key_End, Qt::Key_Period})
        press(key);
    QVERIFY2(seek.isEmpty(), "while one drills these keys are the tooth's");
    m_window->setReplaying(true, 60.0);
    m_window->setReplayCourse(course());
    const auto goes = [&](Qt::Key key, double to) {
        seek.clear();
        press(key);
        QCOMPARE(seek.size(), 1);
        QCOMPARE(seek.front().front().toDouble(), to);
    };
    goes(Qt::Key_Right, 9.01);
    QCOMPARE(pause.size(), 1);
    QVERIFY(actions().pauseReplay->text().startsWith("Resume"));
    goes(Qt::Key_Period, 21.01);
    goes(Qt::Key_Right, 40.0);
    goes(Qt::Key_Right, 60.0);
    goes(Qt::Key_Comma, 40.0);
    goes(Qt::Key_Left, 21.01);
    goes(Qt::Key_Home, 0.0);
    goes(Qt::Key_Left, 0.0);
    goes(Qt::Key_End, 60.0);
    QCOMPARE(figure("replayTime"), QString("1:00 of 1:00"));
    // The eye stays free.
    const double azimuth = m_window->view().camera().azimuthDeg();
    press(Qt::Key_Left, Qt::ControlModifier);
    QVERIFY(m_window->view().camera().azimuthDeg() != azimuth);
}

void TestMainWindow::aReplayIsCalledByItsLesson()
{
    const auto says = [this](const QString& words) {
        const QList<QLabel*> labels = m_window->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const QLabel* label) { return label->isVisible() && label->text() == words; });
    };
    const lessons::Lesson lesson = *shippedOf(lessons::Task::CutIdeal).lesson;
    const QString title = QString::fromStdString(lesson.title.at("en"));
    m_window->setReplaying(true, 60.0, {}, lesson);
    m_window->showTooth(support::syntheticMolar(), 2, {});
    QVERIFY(m_window->windowTitle().startsWith(title));
    QVERIFY(says("Still to cut") && !says("Decay left"));
    // A teacher sees whose it is.
    const QString whose = QStringLiteral("Ada Lovelace, 20/11/2026 10:15");
    m_window->setReplaying(true, 60.0, {}, lesson, whose);
    m_window->showTooth(support::syntheticMolar(), 2, {});
    QCOMPARE(m_window->windowTitle(), title + " – " + whose + " – Cusp");
    m_window->setReplaying(false);
    m_window->showTooth(support::syntheticMolar(), 3, {});
    QVERIFY(!m_window->windowTitle().contains(title) && !m_window->windowTitle().contains("Ada"));
    QVERIFY(says("Decay left") && !says("Still to cut"));
}

void TestMainWindow::pointsAreMarkedAsTheyWereTouched()
{
    m_window->setReplaying(true, 60.0);
    m_window->showTooth(support::syntheticMolar(), 2, {});
    SessionState session;
    session.toothGeneration = 2;
    const auto pictureAt = [&](double seconds) {
        session.recordedS = seconds;
        publish({}, session);
        const auto* time = child<TabularLabel>("replayTime");
        const QString told = QStringLiteral("0:%1 of").arg(seconds, 2, 'f', 0, u'0');
        if (!QTest::qWaitFor([&] { return time->text().startsWith(told); }))
            qWarning("the time is %s", qPrintable(time->text()));
        return m_window->view().picture();
    };
    ui::replay::Course course;
    course.lengthS = course.readyS = 60.0;
    m_window->setReplayCourse(course);
    const QImage bare = pictureAt(10.0);
    course.points = {{{-1.0, 0.0}, 0.6, 20.0}, {{1.5, 1.0}, 0.6, std::nullopt}};
    course.marks = {{ui::replay::Mark::Kind::Touched, 20.0, 0}};
    m_window->setReplayCourse(course);
    const QImage ringed = pictureAt(10.0);
    QVERIFY(ringed != bare);
    const QImage touched = pictureAt(21.0);
    QVERIFY(touched != ringed);
    QCOMPARE(pictureAt(40.0), touched);
    QCOMPARE(pictureAt(11.0), ringed);
    auto* line = child<ui::replay::TimeLine>("timeLine");
    QVERIFY(line->saidAt(QPoint(qRound(line->xOf(20.0)), 12)).join(' ').contains("Point 1 touched"));
}

void TestMainWindow::remarksAreReadWhereTheyWereMeant()
{
    m_window->setReplaying(true, 60.0);
    m_window->showTooth(support::syntheticMolar(), 2, {});
    SessionState session;
    session.toothGeneration = 2;
    const auto* time = child<TabularLabel>("replayTime");
    const auto goTo = [&](double seconds) {
        session.recordedS = seconds;
        publish({}, session);
        const QString told = QStringLiteral("0:%1 of").arg(seconds, 2, 'f', 0, u'0');
        return QTest::qWaitFor([&] { return time->text().startsWith(told); });
    };
    const auto* remark = child<QLabel>("remark");
    ui::replay::Course course;
    course.lengthS = course.readyS = 60.0;
    m_window->setReplayCourse(course);
    QVERIFY(goTo(20.0));
    const QImage bare = m_window->view().picture();
    m_window->setRemarks({{20.0, glm::dvec3(1.0, 0.5, -0.5), "Ada Teach", "The wall <b>leans</b> in."},
                          {40.0, std::nullopt, "Ada Teach", QString(400, u'x').toStdString()}});
    QCOMPARE(remark->text(), QString("Ada Teach: The wall <b>leans</b> in."));
    QCOMPARE(remark->textFormat(), Qt::PlainText);
    QVERIFY(remark->isVisible());
    QVERIFY(m_window->view().picture() != bare);
    // More of the recording becomes known: what was said of it stays.
    m_window->setReplayCourse(course);
    auto* line = child<ui::replay::TimeLine>("timeLine");
    QTRY_VERIFY(line->width() > 400);
    const auto at = [&](double seconds) { return QPoint(qRound(line->xOf(seconds)), 12); };
    QVERIFY(line->saidAt(at(20.0)).join(' ').contains("leans"));
    QSignalSpy seek(m_window.get(), &MainWindow::seekWanted);
    QTest::mouseClick(line, Qt::LeftButton, {}, at(20.0));
    QCOMPARE(seek.size(), 1);
    QVERIFY(std::abs(seek.back().front().toDouble() - (20.0 - ui::replay::kLeadUpS)) < 0.2);

    QTest::qWait(150);  // the seek is over
    QVERIFY(goTo(30.0));
    QVERIFY(!remark->isVisible());
    QCOMPARE(m_window->view().picture(), bare);
    QVERIFY(goTo(40.0));
    QVERIFY(remark->isVisible());
    QVERIFY(remark->text().endsWith(u'…') && remark->text().size() < 320);
    QVERIFY(m_window->view().geometry().contains(remark->geometry()));
    m_window->setReplaying(false);
    QVERIFY(!remark->isVisible());
    m_window->setReplaying(true, 60.0);
    QVERIFY(!remark->isVisible());
}

void TestMainWindow::theTimeLineIsScrubbedAndTellsWhatWas()
{
    QSignalSpy seek(m_window.get(), &MainWindow::seekWanted);
    m_window->setReplaying(true, 60.0);
    m_window->setReplayCourse(course());
    auto* line = child<ui::replay::TimeLine>("timeLine");
    QTRY_VERIFY(line->width() > 400);
    const auto at = [&](double seconds, int y) { return QPoint(qRound(line->xOf(seconds)), y); };
    const double pixelS = 60.0 / (line->xOf(60.0) - line->xOf(0.0));
    const auto last = [&] { return seek.back().front().toDouble(); };
    QTest::mousePress(line, Qt::LeftButton, {}, at(30.0, 24));
    QVERIFY(std::abs(last() - 30.0) <= pixelS);
    QTest::mouseMove(line, at(10.0, 24));
    QVERIFY(std::abs(last() - 10.0) <= pixelS);
    QTest::mouseMove(line, at(50.0, 24));
    QVERIFY(std::abs(last() - 50.0) <= pixelS);
    QTest::mouseRelease(line, Qt::LeftButton, {}, at(50.0, 24));
    const auto seeks = seek.size();
    QTest::mouseMove(line, at(20.0, 24));
    QCOMPARE(seek.size(), seeks);
    // What led to the breach is seen.
    QTest::mouseClick(line, Qt::LeftButton, {}, at(20.5, 12));
    QVERIFY(std::abs(last() - 19.5) <= pixelS);
    QVERIFY(line->saidAt(at(20.5, 12)).join(' ').contains("pulp is open"));
    QVERIFY(line->saidAt(at(40.0, 12)).join(' ').contains("Undone"));
    QVERIFY(line->saidAt(at(15.0, 12)).join(' ').contains("Bur 4"));
    QVERIFY(line->saidAt(at(26.0, 12)).join(' ').contains("Handpiece: Electric"));
    QVERIFY(line->saidAt(at(50.0, 12)).join(' ').contains("Middle pad: said to be dentin"));
    QVERIFY(line->saidAt(at(7.0, 24)).join(' ').contains("Stroke 1, 4.0 s"));
    QVERIFY(line->saidAt(at(30.0, 24)).isEmpty());
    ui::replay::Course rested = course();
    rested.rests = {{28.0, 34.0}};
    m_window->setReplayCourse(rested);
    QVERIFY(line->saidAt(at(30.0, 24)).join(' ').contains("Elsewhere for 0:06"));
    QVERIFY(line->saidAt(at(36.0, 24)).isEmpty());
}

void TestMainWindow::anotherAttemptIsShownBeside()
{
    using ui::tooth::ToothView;
    const auto links = std::make_unique<UiLinks>();
    const auto views = [this] { return m_window->findChildren<ToothView*>(); };
    m_window->setReplaying(true, 60.0);
    m_window->setReplayCourse(course());
    QCOMPARE(views().size(), 1);
    const int line = child<ui::replay::TimeLine>("timeLine")->sizeHint().height();
    m_window->showBeside(*links, support::syntheticMolar(), 1, {}, "Somebody");
    ui::replay::Course other = course();
    other.lengthS = other.readyS = 30.0;
    m_window->setBesideCourse(other);
    QCOMPARE(views().size(), 2);
    ToothView* beside = views().front() == &m_window->view() ? views().back() : views().front();
    QTRY_VERIFY(beside->isVisible() && beside->x() > m_window->view().geometry().right());
    QTRY_VERIFY(std::abs(beside->width() - m_window->view().width()) <= 1);
    const QList<QLabel*> labels = m_window->findChildren<QLabel*>();
    for (const char* name : {"Somebody", "This attempt"})
        QVERIFY(std::any_of(labels.begin(), labels.end(), [name](const QLabel* label) {
            return label->isVisible() && label->text() == QLatin1String(name);
        }));
    // Whichever is turned, the other follows.
    press(Qt::Key_Right, Qt::ControlModifier);
    const double azimuth = m_window->view().camera().azimuthDeg();
    QTRY_COMPARE(beside->camera().azimuthDeg(), azimuth);
    beside->setCamera(70.0, 30.0, 30.0);
    QTRY_COMPARE(m_window->view().camera().azimuthDeg(), 70.0);
    QTRY_COMPARE(m_window->view().camera().distanceMm(), 30.0);
    // Both are on one time line, each with its own strokes.
    auto* both = child<ui::replay::TimeLine>("timeLine");
    QTRY_VERIFY(both->height() > line);
    QVERIFY(both->saidAt({qRound(both->xOf(41.0)), 12 + 32}).join(' ').contains("pulp is open"));
    QVERIFY(both->saidAt({qRound(both->xOf(40.0)), 12}).join(' ').contains("Undone"));
    QVERIFY2(!actions().section->isEnabled(), "there is no room for it");
    QSignalSpy close(m_window.get(), &MainWindow::besideCloseWanted);
    press(Qt::Key_B, Qt::ControlModifier);
    QCOMPARE(close.size(), 1);
    m_window->hideBeside();
    QCOMPARE(views().size(), 1);
    QVERIFY(!actions().beside->isChecked() && actions().section->isEnabled());
    QTRY_COMPARE(both->height(), line);
}

void TestMainWindow::theHandIsLedAlongOnRequest()
{
    QSignalSpy lead(m_window.get(), &MainWindow::leadWanted);
    m_window->setReplaying(true, 60.0);
    press(Qt::Key_A);
    QCOMPARE(lead.size(), 0);
    QVERIFY2(!actions().along->isVisible(), "a mouse leads nobody");
    m_window->offerHome();
    press(Qt::Key_A);
    QCOMPARE(lead.size(), 1);
    QVERIFY(lead.back().front().toBool());
    m_window->showLeadEnd(true);
    QVERIFY(!actions().along->isChecked());
    QVERIFY(message().contains("your hand is free"));
    press(Qt::Key_A);
    QVERIFY(lead.back().front().toBool());
    press(Qt::Key_A);
    QVERIFY(!lead.back().front().toBool());
    m_window->setReplaying(false);
    QVERIFY(!actions().along->isVisible());
}

void TestMainWindow::theExpertIsOfferedWhereSomethingIsCut()
{
    QSignalSpy expert(m_window.get(), &MainWindow::expertWanted);
    press(Qt::Key_Y);
    QCOMPARE(expert.size(), 0);
    lessons::Assignment assignment;
    assignment.anatomy = support::syntheticMolar();
    assignment.lesson.emplace();
    m_window->setAssignment(assignment);
    press(Qt::Key_Y);
    QCOMPARE(expert.size(), 1);
    assignment.exercise = core::grading::ForceToHold{};
    assignment.lesson->task = lessons::Task::HoldForce;
    m_window->setAssignment(assignment);
    QVERIFY(!actions().expert->isVisible());
    assignment.lesson->expert.emplace();
    m_window->setAssignment(assignment);
    QVERIFY(actions().expert->isVisible());
    assignment.lesson->exam = true;
    m_window->setAssignment(assignment);
    press(Qt::Key_Y);
    QCOMPARE(expert.size(), 1);
    QVERIFY(!actions().expert->isVisible());
    // In a replay it is that of the lesson which is played, whatever lies on the table; but in an exam nothing is told.
    const lessons::Lesson played;
    m_window->setReplaying(true, 10.0, nullptr, played);
    QVERIFY(!actions().expert->isVisible());
    m_window->setReplaying(false);
    assignment.lesson.reset();
    assignment.exercise.reset();
    m_window->setAssignment(assignment);
    QVERIFY(!actions().expert->isVisible());
    m_window->setReplaying(true, 10.0, nullptr, played);
    press(Qt::Key_Y);
    QCOMPARE(expert.size(), 2);
    m_window->setReplaying(false);
    QVERIFY(!actions().expert->isVisible());
}

/// By its time or by its score: then nothing is cut any more, and another attempt is another attempt.
void TestMainWindow::anExamEndsOnce()
{
    lessons::Assignment exam = lessons::assign(*shipped("class1-36").lesson).value().assignment;
    exam.lesson->exam = true;
    QSignalSpy again(m_window.get(), &MainWindow::attemptAgainWanted);
    QSignalSpy grade(m_window.get(), &MainWindow::gradeRequested);
    std::uint64_t generation = 1;
    const auto begin = [&] {
        m_window->setAssignment(exam);
        m_window->showTooth(exam.anatomy, ++generation, {});
    };
    const auto work = [&](double seconds, double enamelMm3 = 0.5) {
        SessionState session;
        session.toothGeneration = generation;
        session.removedMm3[1] = enamelMm3;
        session.undoSteps = 3;
        session.redoSteps = 1;
        session.recordedS = seconds;
        ServoState servo;
        servo.tick = 1;
        servo.drillOn = true;
        publish(servo, session);
        look();
    };
    const auto mayCut = [&] { return actions().drill->isEnabled() && actions().burs[0]->isEnabled(); };
    for (const bool byTime : {true, false}) {
        begin();
        work(30.0);
        QVERIFY(mayCut());
        // As in a clinic, no step is taken back; and nobody looks at the work with other means.
        for (QAction* locked : {actions().undo, actions().redo, actions().history, actions().reload,
                                actions().saveRecording, actions().saveReference})
            QVERIFY2(!locked->isEnabled(), qPrintable(locked->text()));
        if (byTime) {
            work(60.0 * exam.lesson->minutes + 1.0);
            QCOMPARE(grade.count(), 1);
        } else {
            m_window->showScore(sheet(3.2, 40, 0.5), {});
        }
        actions().back->trigger();
        QVERIFY(!mayCut());
        QVERIFY(!actions().undo->isEnabled() && !actions().history->isEnabled());
        if (byTime) {
            QVERIFY(!actions().saveRecording->isEnabled());
            actions().reload->trigger();
            QCOMPARE(again.count(), 0);
            QVERIFY2(message().contains("no grade yet"), qPrintable(message()));
            m_window->showScore(sheet(3.2, 40, 0.5), {});
            actions().back->trigger();
        }
        QVERIFY(!mayCut());
        QVERIFY(actions().saveRecording->isEnabled());
        actions().reload->trigger();
        QCOMPARE(again.count(), byTime ? 1 : 2);
        // It begins as the first did, with the bur turning.
        static_cast<void>(sent());
        begin();
        bool turns = false;
        for (const SessionCommand& command : sent())
            if (const auto* drill = std::get_if<SetDrill>(&command))
                turns = drill->on;
        QVERIFY(turns);
    }
    // Who has cut nothing until his time was over has nothing to be graded, and begins anew.
    begin();
    work(60.0 * exam.lesson->minutes + 1.0, 0.0);
    QVERIFY2(message().contains("time of this exam is over"), qPrintable(message()));
    actions().reload->trigger();
    QCOMPARE(again.count(), 3);
    exam.lesson->exam = false;
    begin();
    work(30.0);
    QVERIFY(mayCut() && actions().undo->isEnabled() && actions().reload->isEnabled());
}

void TestMainWindow::theBurRestsWhileAnotherPageIsRead()
{
    const auto drills = [&] {
        QList<bool> told;
        for (SessionCommand command; m_links->commands.tryPop(command);)
            if (const auto* drill = std::get_if<SetDrill>(&command))
                told << drill->on;
        return told;
    };
    const auto turns = [&](bool on) {
        ServoState servo;
        servo.tick = 1;
        servo.drillOn = on;
        publish(servo, {});
        QTRY_COMPARE(actions().drill->isChecked(), on);
    };
    m_window->showTooth(support::syntheticMolar(), 2, {});
    turns(true);
    drills();
    actions().lessons->trigger();
    QCOMPARE(drills(), QList<bool>{false});
    turns(false);
    actions().back->trigger();
    QCOMPARE(drills(), QList<bool>{true});
    // Who had stopped it himself finds it so.
    turns(false);
    actions().lessons->trigger();
    actions().back->trigger();
    QCOMPARE(drills(), QList<bool>{});
}

void TestMainWindow::aLessonBeginsWithItsOwnColours()
{
    const auto begin = [&](const char* id) {
        const auto assignment = lessons::assign(*shipped(id).lesson).value().assignment;
        m_window->setAssignment(assignment);
        m_window->showTooth(assignment.anatomy, 2, {});
    };
    begin("block-line");
    QVERIFY(actions().idealColours->isChecked());
    actions().section->trigger();
    QVERIFY(actions().section->isChecked());
    begin("decay-36-moderate");
    QVERIFY(!actions().idealColours->isChecked() && !actions().depthColours->isChecked());
    QVERIFY(!actions().section->isChecked());
}

void TestMainWindow::aLessonOfAPackIsUnpackedToBeEdited()
{
    QSignalSpy unpack(m_window.get(), &MainWindow::unpackWanted);
    auto catalog = lessons::readCatalog({});
    std::erase_if(catalog, [](const lessons::CatalogEntry& entry) { return entry.read.lesson->id != "class1-36"; });
    catalog.front().isShipped = false;
    catalog.front().pack = "/folder/course.cusplessons";
    m_window->setLessons(catalog, {});
    actions().lessons->trigger();
    actions().editLesson->trigger();
    QCOMPARE(unpack.size(), 1);
    QCOMPARE(unpack.front()[0].toString(), QString("/folder/course.cusplessons"));
    QCOMPARE(unpack.front()[1].toString(), QString("ideal-1-class1-1-36.lesson.json"));
    QVERIFY(!m_window->findChild<ui::study::LessonEditor*>()->isVisible());
    m_window->editLesson(catalog.front().read);
    QVERIFY(m_window->findChild<ui::study::LessonEditor*>()->isVisible());
}

void TestMainWindow::theUndoHistoryTakesALowWindow()
{
    QTest::failOnWarning(QRegularExpression("Negative sizes"));
    auto* panel = child<ui::replay::HistoryPanel>("historyPanel");
    panel->placeIn({0, 0, 300, 30});
    QCOMPARE(panel->list().height(), 0);
}

void TestMainWindow::theUndoHistoryIsShownAndGoneThrough()
{
    using core::history::MomentInfo;
    std::vector<MomentInfo> moments{{MomentId{1}, MomentId{}, 0, 0.0, true, {}}};
    int asked = 0;
    m_window->setHistorySource({[&] {
                                    ++asked;
                                    return moments;
                                },
                                [&](MomentId) { return m_window->view().tooth()->top; }});
    auto* panel = child<ui::replay::HistoryPanel>("historyPanel");
    QVERIFY(!panel->isVisible());
    press(Qt::Key_U);
    QVERIFY(panel->isVisible());
    QVERIFY(panel->list().hasFocus());
    press(Qt::Key_U);  // the list leaves the keys of the tooth to the tooth
    QVERIFY(!panel->isVisible());
    press(Qt::Key_U);
    QVERIFY(panel->list().hasFocus());
    QCOMPARE(panel->list().model()->rowCount(), 1);
    QVERIFY2(panel->findChildren<QLabel*>().back()->isVisible(), "it says what will be here");
    // Two strokes, one undone, another instead.
    moments = {{MomentId{1}, MomentId{}, 0, 0.0, false, {}},
               {MomentId{2}, MomentId{1}, 900, 0.9, false, {{0.0, 0.5, 0.0, 0.0}, 0.0, false}},
               {MomentId{3}, MomentId{2}, 1900, 1.9, false, {{0.0, 0.8, 0.0, 0.0}, 0.0, false}},
               {MomentId{4}, MomentId{2}, 67000, 67.0, true, {{0.0, 0.6, 0.0, 0.0}, 0.0, false}}};
    SessionState session;
    session.toothGeneration = 1;
    session.historyVersion = 2;
    publish({}, session);
    QTRY_COMPARE(panel->list().model()->rowCount(), 4);
    QTRY_VERIFY2(panel->list().height() > 4 * 40 && panel->height() > panel->list().height(),
                 qPrintable(QString("%1 in %2").arg(panel->list().height()).arg(panel->height())));
    QCOMPARE(panel->list().model()->index(3, 0).data().toString(), QString("1:07, 0.10 mm³ enamel, present"));
    QTRY_VERIFY(panel->picture(MomentId{3}) != nullptr);
    QVERIFY(panel->picture(MomentId{3})->sizeInBytes() < 8192);
    const int before = asked;
    QTest::qWait(250);
    QCOMPARE(asked, before);  // only when there is something new
    QCOMPARE(panel->list().currentIndex().row(), 3);
    press(Qt::Key_Up);
    press(Qt::Key_Return);
    auto commands = sent();
    QCOMPARE(commands.size(), 1);
    QCOMPARE(std::get<GoTo>(commands.front()).id, MomentId{3});
    QTest::mouseClick(panel->list().viewport(), Qt::LeftButton, {},
                      panel->list().visualRect(panel->list().model()->index(1, 0)).center());
    commands = sent();
    QCOMPARE(commands.size(), 1);
    QCOMPARE(std::get<GoTo>(commands.front()).id, MomentId{2});
    panel->list().setFocus();
    press(Qt::Key_Escape);
    QVERIFY2(m_window->view().hasFocus() && panel->isVisible(), "back to the tooth, and it stays");
    m_window->setReplaying(true, 5.0);
    QVERIFY(!panel->isVisible());
    m_window->setReplaying(false);
    QVERIFY(panel->isVisible());
    press(Qt::Key_U);
    QVERIFY(!panel->isVisible());
}

void TestMainWindow::escapeEndsAReplayAtOnce()
{
    QSignalSpy stop(m_window.get(), &MainWindow::replayStopRequested);
    m_window->setReplaying(true, 10.0);
    m_window->showReplayEnd();
    QVERIFY(!message().isEmpty());
    press(Qt::Key_Escape);
    QCOMPARE(stop.size(), 1);
    m_window->setReplaying(false);
    m_window->showTooth(support::syntheticMolar(), 1, {});
    QVERIFY2(message().isEmpty(), "what was said about the replay went with it");
}

void TestMainWindow::gradingAReplayOffersToStopIt()
{
    QSignalSpy asked(m_window.get(), &MainWindow::gradeRequested);
    QSignalSpy stop(m_window.get(), &MainWindow::replayStopRequested);
    m_window->showTooth(support::syntheticMolar(), 2, noted({"A note that has not been read."}));
    m_window->setReplaying(true, 10.0);
    press(Qt::Key_G);
    QCOMPARE(asked.size(), 0);
    QVERIFY(message().contains("This is a replay"));
    QTest::mouseClick(child<MessageBar>()->findChild<QPushButton*>(), Qt::LeftButton);
    QCOMPARE(stop.size(), 1);
}

void TestMainWindow::cutSomething(double enamelMm3) const
{
    SessionState session;
    session.toothGeneration = 1;
    session.removedMm3[1] = enamelMm3;
    session.undoSteps = static_cast<int>(enamelMm3 * 100.0);
    publish({}, session);
    QTRY_COMPARE(figure("enamelRemoved"), QString::number(enamelMm3, 'f', 2));
}

QuestionCard* TestMainWindow::question() const
{
    return child<QuestionCard>("workQuestion");
}

void TestMainWindow::wholeToothIsLeftWithoutAQuestion()
{
    QSignalSpy chosen(m_window.get(), &MainWindow::toothChosen);
    press(Qt::Key_T);
    press(Qt::Key_Return);
    QCOMPARE(chosen.size(), 1);
    QVERIFY(question() == nullptr);
    m_window->close();
    QVERIFY(!m_window->isVisible());
}

void TestMainWindow::unsavedWorkIsAskedAbout_data()
{
    QTest::addColumn<QString>("leave");
    QTest::addColumn<QString>("answer");
    for (const QString leave : {"tooth", "scan", "window"})
        for (const QString answer : {"save", "discard", "cancel"})
            QTest::newRow(qPrintable(leave + ", " + answer)) << leave << answer;
}

void TestMainWindow::unsavedWorkIsAskedAbout()
{
    QFETCH(QString, leave);
    QFETCH(QString, answer);
    QSignalSpy tooth(m_window.get(), &MainWindow::toothChosen);
    QSignalSpy scan(m_window.get(), &MainWindow::scanChosen);
    QSignalSpy save(m_window.get(), &MainWindow::recordingSaveRequested);
    const auto left = [&] { return tooth.size() + scan.size() + (m_window->isVisible() ? 0 : 1); };
    cutSomething(0.5);
    if (leave == "tooth") {
        press(Qt::Key_T);
        press(Qt::Key_Return);
    } else if (leave == "window") {
        m_window->close();
    } else {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile("/tmp/molar.stl")});
        QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &enter);
        QDropEvent event(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &event);
    }
    QVERIFY(question() != nullptr);
    QCOMPARE(left(), 0);
    if (answer == "cancel") {
        QTest::keyClick(question(), Qt::Key_Escape);
        QTRY_VERIFY(question() == nullptr);
        QCOMPARE(left(), 0);
        QVERIFY(save.isEmpty());
        return;
    }
    if (answer == "discard") {
        for (QPushButton* button : question()->findChildren<QPushButton*>())
            if (button->text() == "&Discard")
                QTest::keyClick(button, Qt::Key_Space);
        QCOMPARE(left(), 1);
        QVERIFY(save.isEmpty());
        return;
    }
    QTest::keyClick(question(), Qt::Key_Return);
    auto* dialog = m_window->findChild<QFileDialog*>();
    QVERIFY(dialog != nullptr);
    QTemporaryDir folder;
    dialog->setDirectory(folder.path());
    dialog->selectFile(folder.filePath("mine.cusprec"));
    QMetaObject::invokeMethod(dialog, "accept");
    QCOMPARE(save.size(), 1);
    QCOMPARE(left(), 0);
    m_window->showSaved(folder.filePath("mine.cusprec"));
    QCOMPARE(left(), 1);
}

void TestMainWindow::savedWorkIsLeftWithoutAQuestion()
{
    QSignalSpy chosen(m_window.get(), &MainWindow::toothChosen);
    const auto save = [this] {
        press(Qt::Key_S, Qt::ControlModifier);
        auto* dialog = m_window->findChild<QFileDialog*>();
        QTemporaryDir folder;
        dialog->setDirectory(folder.path());
        dialog->selectFile(folder.filePath("mine.cusprec"));
        QMetaObject::invokeMethod(dialog, "accept");
        m_window->showSaved(folder.filePath("mine.cusprec"));
    };
    cutSomething(0.5);
    save();
    press(Qt::Key_T);
    press(Qt::Key_Return);
    QCOMPARE(chosen.size(), 1);
    // What was cut since is in no recording.
    cutSomething(0.75);
    press(Qt::Key_T);
    press(Qt::Key_Return);
    QCOMPARE(chosen.size(), 1);
    QVERIFY(question() != nullptr);
}

void TestMainWindow::workThatWaitsForAReplayIsAskedAbout()
{
    QSignalSpy chosen(m_window.get(), &MainWindow::toothChosen);
    cutSomething(0.5);
    m_window->setReplaying(true, 10.0);
    m_window->showTooth(support::syntheticMolar(), 2, {});
    SessionState replayed;
    replayed.toothGeneration = 2;
    publish({}, replayed);
    QTRY_COMPARE(figure("enamelRemoved"), QString("0.00"));
    press(Qt::Key_T);
    press(Qt::Key_Return);
    QVERIFY(question() != nullptr);
    QVERIFY(chosen.isEmpty());
}

void TestMainWindow::unsavedLessonsAreAskedAbout_data()
{
    QTest::addColumn<QString>("answer");
    for (const QString answer : {"save", "discard", "cancel"})
        QTest::newRow(qPrintable(answer)) << answer;
}

void TestMainWindow::unsavedLessonsAreAskedAbout()
{
    QFETCH(QString, answer);
    const QTemporaryDir folder;
    const QString file = folder.filePath("class1-36-own.lesson.json");
    auto* editor = child<ui::study::LessonEditor>();
    const lessons::ReadLesson classOne = shipped("class1-36");
    editor->edit(classOne, folder.path());
    QVERIFY(editor->unsaved().isEmpty());
    auto* title = child<QLineEdit>("draftTitle");
    title->clear();
    QTest::keyClicks(title, "Mine");
    QCOMPARE(editor->unsaved(), QStringList{"Mine"});
    // Neither another lesson nor another page loses it, and the list of lessons says so.
    editor->edit(shipped("class1-37"), folder.path());
    m_window->setLessons(lessons::readCatalog({}), {});
    actions().lessons->trigger();
    const auto* model = child<QListView>("lessonList")->model();
    int marked = 0;
    for (int row = 0; row < model->rowCount(); ++row)
        marked += model->index(row, 0).data(Qt::AccessibleDescriptionRole).toString().contains("not saved") ? 1 : 0;
    QCOMPARE(marked, 1);
    QCOMPARE(editor->unsaved(), QStringList{"Mine"});

    m_window->close();
    auto* question = child<QuestionCard>("draftQuestion");
    QVERIFY(question != nullptr && m_window->isVisible());
    QVERIFY(child<QLabel>("questionDetail")->text().contains("Mine"));
    for (QPushButton* button : question->findChildren<QPushButton*>())
        if (button->text().contains(answer, Qt::CaseInsensitive)) {
            QTest::keyClick(button, Qt::Key_Space);
            break;
        }
    QTRY_VERIFY(child<QuestionCard>("draftQuestion") == nullptr);
    QCOMPARE(m_window->isVisible(), answer == "cancel");
    QCOMPARE(QFile::exists(file), answer == "save");
    QCOMPARE(editor->unsaved().isEmpty(), answer == "save");
}

void TestMainWindow::whatPagesHaveNotKeptIsAskedAbout()
{
    ui::admin::PeoplePart& people = openPeople();
    const core::settings::FeelPreset preset = lessons::shippedPresets().front();
    m_window->setPresets({{{}, preset, {}}}, preset);
    QTest::keyClicks(child<QLineEdit>("presetName"), " two");
    m_window->adminPage().roster().showOutcome(
        {{}, {{"eve", "Eve Berg", database::Role::Student, {}, true, "1234-5678", {}}}, {}}, "class.csv", true);
    people.setPeople({someone(1, "Ada", true), someone(2, "Bob", true)}, {});
    choosePerson(0);
    QTest::keyClicks(child<QLineEdit>("personGiven"), "lina");
    choosePerson(1);
    m_window->close();
    const auto* question = child<QuestionCard>("unkeptQuestion");
    QVERIFY(question != nullptr && m_window->isVisible());
    const QString detail = question->findChild<QLabel*>("questionDetail")->text();
    for (const QString& part : {QString("class.csv"), QString("Ada Berg"), QString::fromStdString(preset.name)})
        QVERIFY2(detail.contains(part), qPrintable(detail));
    // The answer that loses nothing leads to where it can be kept.
    m_window->adminPage().show(ui::admin::AdminPage::Roster);
    question->findChild<QPushButton*>("questionSave")->click();
    QVERIFY(m_window->isVisible() && people.isVisible());
    m_window->close();
    child<QuestionCard>("unkeptQuestion")->findChild<QPushButton*>("questionDiscard")->click();
    QVERIFY(!m_window->isVisible());
}

/// Whoever stands there may be anybody.
void TestMainWindow::atALockedPlaceNobodyDecidesForItsOwner()
{
    ui::admin::PeoplePart& people = openPeople();
    const database::Session owner = m_admin;
    people.setPeople({someone(1, "Ada", false), someone(2, "Bob", true)}, {});
    choosePerson(0);
    people.showCode(writer(), someone(1, "Ada", false), "1234-5678");
    const auto* code = child<QLabel>("oneTimeCode");
    // Who closes the window hears whose they are, and nothing of them.
    const auto asks = [this, name = QString::fromStdString(owner.fullName())] {
        m_window->close();
        auto* card = child<QuestionCard>("codeQuestion");
        if (!m_window->isVisible() || card == nullptr)
            return false;
        const QString words =
            card->findChild<QLabel*>("questionText")->text() + card->findChild<QLabel*>("questionDetail")->text();
        card->findChild<QPushButton*>("questionStay")->click();
        return words.contains(name) && words.contains("another from an admin") && !words.contains("1234") &&
               !words.contains("Berg");
    };
    m_window->askWho(ui::people::Door::Locked);
    QVERIFY(asks());
    // He is back.
    m_window->setWho(owner);
    QVERIFY(code->isVisible());
    QCOMPARE(code->text(), QString("1234-5678"));
    // To another it is not shown, nor is it thrown away by him.
    child<MessageBar>()->dismiss();
    openPeople();
    choosePerson(0);
    QVERIFY(people.isVisible() && !code->isVisible());
    QVERIFY(asks());
    // Nor by that it came when he had gone already.
    people.showCode(QString::fromStdString(owner.uid()), someone(2, "Bob", false), "8765-4321");
    choosePerson(1);
    QVERIFY(!code->isVisible());
    m_window->setWho(owner);
    actions().school->trigger();
    choosePerson(0);
    QVERIFY(code->isVisible());
    m_window->close();
    auto* question = child<QuestionCard>("unkeptQuestion");
    QVERIFY(m_window->isVisible() && question != nullptr);
    const QString detail = question->findChild<QLabel*>("questionDetail")->text();
    QVERIFY2(detail.contains("Ada Berg, Bob Berg") && !detail.contains("1234"), qPrintable(detail));
    question->findChild<QPushButton*>("questionStay")->click();
    // Nobody is kept here by them.
    m_window->setWho({});
    m_window->close();
    question = child<QuestionCard>("codeQuestion");
    QVERIFY(m_window->isVisible() && question != nullptr);
    question->findChild<QPushButton*>("questionDiscard")->click();
    QVERIFY(!m_window->isVisible());
}

/// Another admin finds an empty form, in whose name it would be entered.
void TestMainWindow::whatAnAdminHasTypedWaitsForHim()
{
    const QTemporaryDir folder;
    m_window->setPutByFolder(folder.path(), kSchool);
    ui::admin::PeoplePart* people = &openPeople();
    const database::Session owner = m_admin;
    const QList<database::Person> all{someone(1, "Ada", true), someone(2, "Bob", true)};
    const QList<database::SchoolClass> classes{{{4}, "Year 1", 0}};
    people->setPeople(all, classes);
    people->showCode(writer(), someone(2, "Bob", false), "1234-5678");
    choosePerson(0);
    QTest::keyClicks(child<QLineEdit>("personGiven"), "lina");
    child<QListWidget>("personClasses")->item(0)->setCheckState(Qt::Checked);
    database::RosterOutcome looked;
    looked.people = {{"eve", "Eve Berg", database::Role::Student, {}, true, "", {}}};
    m_window->adminPage().roster().showOutcome(looked, "class.csv", false);
    openPeople();
    QVERIFY(child<QLineEdit>("personGiven")->text().isEmpty() && !child<QLabel>("personAside")->isVisible());
    QVERIFY(people->unkept().isEmpty());
    m_window->adminPage().show(ui::admin::AdminPage::Roster);
    QVERIFY(!child<QPushButton>("enterRoster")->isVisible());  // a list that he has not seen
    // The one-time code, which is put by nowhere, is thrown away by who has made it.
    m_window->setWho(owner);
    people->forgetCodes();
    m_window->setWho({});
    m_window->close();
    QVERIFY(!m_window->isVisible());
    QFile put(folder.filePath("1.json"));
    QVERIFY(put.open(QIODevice::ReadOnly));
    QVERIFY(!put.readAll().contains("1234"));
    // After another start as well, on what others have entered by then.
    openWindow();
    m_window->setPutByFolder(folder.path(), kSchool);
    people = &m_window->adminPage().people();
    m_window->setWho(owner);
    actions().school->trigger();
    database::Person changed = all.front();
    changed.familyName = "Hill";
    changed.role = database::Role::Instructor;
    people->setPeople({changed, all.back()}, classes);
    QVERIFY2(people->unkept().contains("Ada Berg"), qPrintable(people->unkept()));
    child<QPushButton>("personAsideBack")->click();
    QCOMPARE(child<QLineEdit>("personGiven")->text(), QString("Adalina"));
    QCOMPARE(child<QLineEdit>("personFamily")->text(), QString("Hill"));
    QCOMPARE(child<QComboBox>("personRole")->currentIndex(), 1);
    QCOMPARE(child<QListWidget>("personClasses")->item(0)->checkState(), Qt::Checked);
}

/// As he has changed nothing else, he undoes nothing of it.
void TestMainWindow::aTouchedFormTakesOverWhatOthersHaveEntered()
{
    ui::admin::PeoplePart& people = openPeople();
    const QList<database::SchoolClass> classes{{{1}, "Year 1", 0}, {{2}, "Year 2", 0}, {{3}, "Year 3", 0}};
    database::Person hugo = someone(1, "Hugo", true, {{1}, {3}});
    people.setPeople({hugo}, classes);
    choosePerson(0);
    QTest::keyClicks(child<QLineEdit>("personGiven"), "X");
    const auto tick = [this](const QString& name) {
        return child<QListWidget>("personClasses")->findItems(name, Qt::MatchExactly).front();
    };
    tick("Year 3")->setCheckState(Qt::Unchecked);
    hugo.role = database::Role::Instructor;
    hugo.classes = {{2}, {3}};
    people.setPeople({hugo}, classes);
    QCOMPARE(child<QLineEdit>("personGiven")->text(), QString("HugoX"));
    QCOMPARE(child<QComboBox>("personRole")->currentIndex(), 1);
    QCOMPARE(tick("Year 1")->checkState(), Qt::Unchecked);
    QCOMPARE(tick("Year 2")->checkState(), Qt::Checked);
    QCOMPARE(tick("Year 3")->checkState(), Qt::Unchecked);
    database::Person sent;
    QSet<qint64> sentClasses;
    connect(&people, &ui::admin::PeoplePart::changeWanted, this, [&](const database::Person& person, const auto& in) {
        sent = person;
        sentClasses = in;
    });
    child<QPushButton>("savePerson")->click();
    QCOMPARE(sent.givenName, std::string("HugoX"));
    QCOMPARE(sent.role, database::Role::Instructor);
    QCOMPARE(sentClasses, QSet<qint64>{2});
}

/// Nobody undoes it by himself.
void TestMainWindow::onesOwnRoleIsNotGivenUpByOneClick()
{
    ui::admin::PeoplePart& people = openPeople();
    database::Person own = someone(1, "Ada", true);
    own.uid = m_admin.uid();
    own.role = database::Role::Admin;
    people.setPeople({own}, {});
    choosePerson(0);
    std::vector<database::Person> sent;
    connect(&people, &ui::admin::PeoplePart::changeWanted, this,
            [&](const database::Person& person, const auto&) { sent.push_back(person); });
    auto* role = child<QComboBox>("personRole");
    const auto chooseStudent = [role] {
        role->setCurrentIndex(0);
        emit role->activated(0);
    };
    chooseStudent();
    auto* save = child<QPushButton>("savePerson");
    const auto* said = child<QLabel>("personSaid");
    save->click();
    save->click();  // of a double click
    QVERIFY(sent.empty());
    QVERIFY2(said->text().contains("an admin no longer"), qPrintable(said->text()));
    child<QPushButton>("keepAsItIs")->click();
    QCOMPARE(role->currentIndex(), 2);
    QVERIFY(said->text().isEmpty());
    chooseStudent();
    save->click();
    QTest::qWait(2 * QGuiApplication::styleHints()->mouseDoubleClickInterval() + 50);
    save->click();
    QCOMPARE(sent.size(), 1U);
    QCOMPARE(sent.back().role, database::Role::Student);
    people.confirm(own.id, [] { return QString("Ada Berg was changed."); });
    people.setPeople({own}, {});
    // Nor is the account.
    QTest::qWait(QGuiApplication::styleHints()->mouseDoubleClickInterval() + 50);
    auto* disable = child<QPushButton>("disablePerson");
    disable->click();
    QCOMPARE(sent.size(), 1U);
    QVERIFY2(said->text().contains("your own account"), qPrintable(said->text()));
    QTest::qWait(2 * QGuiApplication::styleHints()->mouseDoubleClickInterval() + 50);
    disable->click();
    QCOMPARE(sent.size(), 2U);
    QVERIFY(sent.back().disabled);
}

void TestMainWindow::aFaultGoesWithWhatItWasSaidOf()
{
    ui::admin::PeoplePart& people = openPeople();
    people.setPeople({someone(1, "Ada", true)}, {{{4}, "Year 1", 0}});
    choosePerson(0);
    QStringList wanted;
    connect(&people, &ui::admin::PeoplePart::classWanted, this, [&](const QString& name) { wanted << name; });
    auto* name = child<QLineEdit>("className");
    const auto* fault = child<QLabel>("personFault");
    name->setText("Year|2");
    child<QPushButton>("addClass")->click();
    QTest::keyClick(name, Qt::Key_Return);  // before there is an answer
    QCOMPARE(wanted.size(), 1);
    people.refuseClass([] { return QString("No class can be called that."); });
    QVERIFY(fault->isVisible());
    QCOMPARE(name->text(), QString("Year|2"));
    name->setText("Year 2");
    child<QPushButton>("addClass")->click();
    QCOMPARE(wanted.back(), QString("Year 2"));
    people.confirmClass("Year 2");
    QVERIFY(!fault->isVisible() && name->text().isEmpty());
    people.setPeople({someone(1, "Ada", true)}, {{{4}, "Year 1", 0}, {{5}, "Year 2", 0}});
    for (int row = 0; row < 2; ++row)
        QCOMPARE(child<QListWidget>("personClasses")->item(row)->checkState(),
                 child<QListWidget>("personClasses")->item(row)->text() == "Year 2" ? Qt::Checked : Qt::Unchecked);
    // What one page could not read is no longer said on another, nor when this is read again.
    for (QAction* next : {actions().readAgain, actions().lessons}) {
        actions().school->trigger();
        m_window->showError({core::ErrorCode::FileUnwritable, "full"}, Failed::ReadingSchool);
        QVERIFY2(message().contains("cannot be shown now"), qPrintable(message()));
        next->trigger();
        QVERIFY2(message().isEmpty(), qPrintable(message()));
    }
}

/// Also of what was said before it was chosen.
void TestMainWindow::whatIsSaidOfPeopleChangesItsLanguage()
{
    ui::admin::PeoplePart& people = openPeople();
    people.confirm({1}, [] { return ui::admin::PeoplePart::tr("Save the changes"); });
    people.setPeople({someone(1, "Ada", true)}, {});
    const auto* said = child<QLabel>("personSaid");
    QCOMPARE(said->text(), QString("Save the changes"));
    const auto inEnglish = qScopeGuard([] { ui::text::Language::choose("en_GB"); });
    ui::text::Language::choose("de");
    QTRY_COMPARE(said->text(), QString("Änderungen speichern"));
}

/// As it was chosen.
void TestMainWindow::anAuditThatCannotBeReadKeepsItsRows()
{
    ui::admin::AuditPart& audit = m_window->adminPage().audit();
    auto* without = child<QCheckBox>("auditNoAttempts");
    const auto* rows = child<QTableView>("audit")->model();
    const auto* counted = child<QLabel>("auditCount");
    audit.keepRows();
    QVERIFY(counted->text().isEmpty());  // whether there are any nobody knows
    database::AuditRow row;
    row.seq = 7;
    audit.setRows({row}, "1234", true);
    QSignalSpy wanted(&audit, &ui::admin::AuditPart::newestWanted);
    without->click();
    QCOMPARE(wanted.size(), 1);
    QVERIFY(!child<QPushButton>("olderAudit")->isEnabled());
    audit.keepRows();
    QVERIFY(!without->isChecked() && rows->rowCount() == 1 && counted->text().startsWith('1'));
    QVERIFY(child<QPushButton>("olderAudit")->isEnabled());
    QCOMPARE(wanted.size(), 1);
}

/// The rest of the command would be taken for keys of the tooth.
void TestMainWindow::whoTypesACommandGoesOnTyping()
{
    press(Qt::Key_F10);
    const auto* const line = child<QLineEdit>("consoleLine");
    QTRY_COMPARE(QApplication::focusWidget(), line);
    core::grading::Infraction infraction;
    infraction.breach = core::grading::Breach::BurInAir;
    infraction.limit = 20.0;
    m_window->tellInfraction(infraction, false);
    QVERIFY(child<ui::study::InfractionCard>()->isVisible());
    QCOMPARE(QApplication::focusWidget(), line);
    // It is there for who has closed the console.
    press(Qt::Key_Escape);
    QVERIFY(child<ui::study::InfractionCard>()->isVisible());
    QCOMPARE(QApplication::focusWidget(), child<QPushButton>("goOn"));
    press(Qt::Key_F10);
    QTRY_COMPARE(QApplication::focusWidget(), line);
    // The work is laid anew, as by a preset that is loaded.
    const auto practice = lessons::practiceOn(support::syntheticMolar()).value();
    m_window->setAssignment(practice);
    m_window->showTooth(practice.anatomy, 2, {});
    QCOMPARE(QApplication::focusWidget(), line);
    press(Qt::Key_Escape);
    QTRY_COMPARE(QApplication::focusWidget(), &m_window->view());
}

void TestMainWindow::whatARuleStoppedTurnsAgainInTheNextLesson()
{
    const auto drillWish = [this] {
        std::optional<bool> last;
        for (const auto& command : sent())
            if (const auto* drill = std::get_if<SetDrill>(&command))
                last = drill->on;
        return last;
    };
    const auto practice = lessons::practiceOn(support::syntheticMolar()).value();
    std::uint64_t generation = 2;
    const auto begin = [&] {
        m_window->setAssignment(practice);
        m_window->showTooth(practice.anatomy, generation++, {});
    };
    actions().drill->setChecked(true);
    core::grading::Infraction infraction;
    infraction.breach = core::grading::Breach::BurInAir;
    m_window->tellInfraction(infraction, false);
    QCOMPARE(drillWish(), std::optional(false));
    begin();
    QCOMPARE(drillWish(), std::optional(true));
    // Who has stopped it himself finds it as he left it.
    actions().drill->setChecked(true);
    m_window->tellInfraction(infraction, false);
    QCOMPARE(drillWish(), std::optional(false));
    press(Qt::Key_Escape);
    QCOMPARE(drillWish(), std::optional(true));
    actions().drill->setChecked(false);
    begin();
    QCOMPARE(drillWish(), std::nullopt);
}

/// Nobody else is asked about them, or sees them.
void TestMainWindow::draftsWaitForWhoTeaches()
{
    const QTemporaryDir folder;
    auto* editor = child<ui::study::LessonEditor>();
    editor->edit(shipped("class1-36"), folder.path());
    auto* title = child<QLineEdit>("draftTitle");
    title->clear();
    QTest::keyClicks(title, "Mine");
    m_window->setLessons(lessons::readCatalog({}), {});
    const auto isMarked = [this] {
        const auto* model = child<QListView>("lessonList")->model();
        for (int row = 0; row < model->rowCount(); ++row)
            if (model->index(row, 0).data(Qt::AccessibleDescriptionRole).toString().contains("not saved"))
                return true;
        return false;
    };
    actions().lessons->trigger();
    QVERIFY(isMarked());
    m_window->setMayEdit(false);
    QVERIFY(!isMarked());
    m_window->close();
    QVERIFY(m_window->isVisible());
    QVERIFY(child<QuestionCard>("draftQuestion") == nullptr);
    const QString said = child<MessageBar>()->sentence();
    QVERIFY2(said.contains("cannot be put by") && !said.contains("Mine"), qPrintable(said));
    QCOMPARE(editor->unsaved(), QStringList{"Mine"});
    // Where there is a place for it, it waits there, for nobody else to read, and the window closes.
    const QString putBy = folder.filePath("put-by");
    const QString file = folder.filePath("put-by/1.json");
    m_window->setPutByFolder(putBy, kSchool);
    m_window->close();
    QVERIFY(!m_window->isVisible());
    QCOMPARE(QFile::permissions(file) & (QFile::ReadGroup | QFile::ReadOther), QFile::Permissions());
    // The next start finds it again.
    openWindow();
    editor = child<ui::study::LessonEditor>();
    QVERIFY(editor->unsaved().isEmpty());
    m_window->setPutByFolder(putBy, kSchool);
    QCOMPARE(editor->unsaved(), QStringList{"Mine"});
    m_window->setMayEdit(true);
    m_window->setLessons(lessons::readCatalog({}), {});
    actions().lessons->trigger();
    QVERIFY(isMarked());
    m_window->close();
    QVERIFY(m_window->isVisible() && child<QuestionCard>("draftQuestion") != nullptr);
    child<QPushButton>("questionDiscard")->click();
    QVERIFY(!m_window->isVisible());
    // Who may has thrown it away.
    QVERIFY(!QFile::exists(file));
}

/// Until it is decided on, whoever works there by then, and however the program ends.
void TestMainWindow::whatIsPutByStaysThere()
{
    support::SchoolRig rig(false);
    rig.populate();
    const QTemporaryDir folder;
    const QString file = folder.filePath("1.json");
    const auto held = [&file] {
        QFile read(file);
        return read.open(QIODevice::ReadOnly) ? read.readAll() : QByteArray();
    };
    m_window->setPutByFolder(folder.path(), kSchool);
    m_window->setWho(rig.instructor);
    m_window->setMayEdit(true);
    auto* editor = child<ui::study::LessonEditor>();
    editor->edit(shipped("class1-36"), folder.path());
    auto* title = child<QLineEdit>("draftTitle");
    title->clear();
    QTest::keyClicks(title, "Mine");
    auto& talk = child<ui::study::ScorePage>()->talk();
    talk.setAttempt(5);
    talk.findChild<QPlainTextEdit*>("commentWords")->setPlainText("Half a sentence");
    // Nobody has left yet: who types is not asked whether the power may go.
    QTRY_VERIFY_WITH_TIMEOUT(held().contains("Mine") && held().contains("Half a sentence"), 20000);
    talk.findChild<QPlainTextEdit*>("commentWords")->setPlainText("Half a sentence more");
    m_window->askWho(ui::people::Door::Locked);
    QVERIFY(held().contains("Half a sentence more"));
    talk.findChild<QPlainTextEdit*>("commentWords")->setPlainText("Half a sentence");
    // Rights come after the change of user, and so does the power cut.
    m_window->setWho({});
    m_window->setMayEdit(false);
    QVERIFY(held().contains("Mine") && held().contains("Half a sentence"));
    m_window->setWho(rig.instructor);
    m_window->setMayEdit(true);
    QVERIFY(held().contains("Mine") && held().contains("Half a sentence"));
    // What is saved is no draft any more.
    QVERIFY(editor->saveAll());
    QVERIFY(!held().contains("Mine") && held().contains("Half a sentence"));
}

/// Neither a passer-by nor who works here next decides on it, and the window closes all the same.
void TestMainWindow::whatSomebodyHasTypedIsPutBy()
{
    support::SchoolRig rig(false);
    rig.populate();
    const QTemporaryDir folder;
    const auto typed = [&folder] { return ui::shell::PutBy(folder.path(), kSchool).found(); };
    m_window->setPutByFolder(folder.path(), kSchool);
    m_window->setWho(rig.instructor);
    auto& talk = child<ui::study::ScorePage>()->talk();
    talk.setAttempt(5);
    talk.findChild<QPlainTextEdit*>("commentWords")->setPlainText("Half a sentence");
    m_window->setWho(rig.student);
    QVERIFY(QFile::exists(folder.filePath("1.json")));  // also where the program is killed now
    m_window->close();
    QVERIFY(!m_window->isVisible());
    openWindow();
    QCOMPARE(typed().size(), 1);
    QCOMPARE(typed()[0].toObject()["comment"].toString(), QString("Half a sentence"));
    // The same of who has locked the place.
    m_window->setPutByFolder(folder.path(), kSchool);
    m_window->setWho(rig.instructor);
    QCOMPARE(child<ui::study::ScorePage>()->talk().unkeptComments(), QList<qint64>{5});
    m_window->askWho(ui::people::Door::Locked);
    m_window->close();
    QVERIFY(!m_window->isVisible());
    openWindow();
    QCOMPARE(typed().size(), 1);
    // Who has typed it is asked, and throws it away.
    m_window->setPutByFolder(folder.path(), kSchool);
    m_window->setWho(rig.instructor);
    m_window->close();
    QVERIFY(m_window->isVisible() && child<QuestionCard>("unkeptQuestion") != nullptr);
    child<QPushButton>("questionDiscard")->click();
    QVERIFY(!m_window->isVisible());
    openWindow();
    QVERIFY(typed().isEmpty());
}

/// To who has typed it, and to nobody else.
void TestMainWindow::whatTwoWindowsHadOfOneThingIsTold()
{
    support::SchoolRig rig(false);
    rig.populate();
    const QTemporaryDir folder;
    const QString person = QString::fromStdString(rig.instructor.uid());
    const auto draft = [&person](qint64 attempt, const QString& comment, const QString& reason, double points) {
        QJsonObject typed{{"person", person}, {"attempt", attempt}, {"comment", comment}, {"reason", reason}};
        if (!reason.isEmpty()) {
            typed["points"] = points;
            typed["arePointsTyped"] = true;
        }
        return typed;
    };
    const auto put = [&folder] { return ui::shell::PutBy(folder.path(), kSchool).found(); };
    {
        ui::shell::PutBy first(folder.path(), kSchool);
        ui::shell::PutBy second(folder.path(), kSchool);
        QVERIFY(first.keep({draft(5, "One half", {}, 0.0), draft(6, {}, "Steady", 40.0)}));
        QVERIFY(second.keep({draft(5, "the other", {}, 0.0), draft(6, {}, "Shaky", 30.0)}));
    }
    m_window->setPutByFolder(folder.path(), kSchool);
    m_window->setWho(rig.student);
    m_window->setMayEdit(false);
    QVERIFY2(message().isEmpty(), qPrintable(message()));
    m_window->setWho(rig.instructor);
    m_window->setMayEdit(true);
    auto& talk = child<ui::study::ScorePage>()->talk();
    // Comments stand together.
    talk.setAttempt(5);
    QCOMPARE(talk.findChild<QPlainTextEdit*>("commentWords")->toPlainText(), QString("One half\n\nthe other"));
    QVERIFY(talk.findChild<QLabel*>("commentSaid")->text().contains("another window"));
    // Of two scores one is given: the other takes its place, and back.
    talk.setAttempt(6);
    const auto* reason = talk.findChild<QLineEdit*>("reason");
    QCOMPARE(reason->text(), QString("Steady"));
    QVERIFY2(message().contains("30") && message().contains("Shaky"), qPrintable(message()));
    const auto press = [this](const QString& words) {
        for (auto* button : child<MessageBar>()->findChildren<QPushButton*>())
            if (button->isVisible() && button->text() == words) {
                button->click();
                return true;
            }
        return false;
    };
    // A passer-by does not see it.
    m_window->askWho(ui::people::Door::Locked);
    QVERIFY2(message().isEmpty(), qPrintable(message()));
    m_window->setWho(rig.instructor);
    talk.setAttempt(6);
    QVERIFY(press("Take it instead"));
    QCOMPARE(reason->text(), QString("Shaky"));
    QVERIFY2(message().contains("40") && message().contains("Steady"), qPrintable(message()));
    QVERIFY(press("Take it instead"));
    QCOMPARE(reason->text(), QString("Steady"));
    QVERIFY(press("Throw it away"));
    QVERIFY2(message().isEmpty(), qPrintable(message()));
    m_window->askWho(ui::people::Door::Locked);
    m_window->close();
    QVERIFY(!m_window->isVisible());
    openWindow();
    QCOMPARE(put().size(), 2);
    QVERIFY(!QJsonDocument(put()).toJson().contains("Shaky"));
}

/// Else it would lie there for ever, and nobody would know.
void TestMainWindow::aDraftOfALessonThatIsGoneCanBeThrownAway()
{
    const QTemporaryDir folder;
    const auto put = [&folder] { return ui::shell::PutBy(folder.path(), kSchool).found(); };
    QVERIFY(ui::shell::PutBy(folder.path(), kSchool)
                .keep({QJsonObject{{"from", folder.filePath("gone.lesson.json")},
                                   {"lesson", QJsonObject{{"title", "Gone"}}}},
                       QJsonObject{{"later", "program"}}}));
    m_window->setPutByFolder(folder.path(), kSchool);
    m_window->setMayEdit(false);
    QVERIFY2(message().isEmpty(), qPrintable(message()));
    m_window->setMayEdit(true);
    QStringList told;
    for (int k = 0; k < 2; ++k) {
        told << message();
        child<QPushButton>("decline")->click();
    }
    told.sort();
    QVERIFY2(told[0].contains("cannot read it") && told[1].contains("gone.lesson.json"), qPrintable(told.join('|')));
    QVERIFY2(message().isEmpty(), qPrintable(message()));
    m_window.reset();
    QVERIFY(put().isEmpty());
    openWindow();
}

/// Whoever made it, and whatever else would be lost.
void TestMainWindow::aGradeThatIsNotKeptIsAskedAboutFirst()
{
    SessionState cut;
    cut.toothGeneration = 1;
    cut.removedMm3[0] = 1.0;
    publish({}, cut);
    m_window->showScore(sheet(40, 30, 0), {});
    child<ui::study::ScorePage>()->setKeeping(ui::study::ScorePage::Keeping::Refused);
    QVERIFY(child<QLabel>("historyRemark")->text().contains("tried again"));
    m_window->setUnkeptGrades(1);
    m_window->close();
    auto* card = child<QuestionCard>("gradeQuestion");
    QVERIFY(m_window->isVisible() && card != nullptr);
    QVERIFY(card->findChild<QLabel*>("questionText")->text().contains("1 grade"));
    card->findChild<QPushButton*>("questionStay")->click();
    QVERIFY(m_window->isVisible());
    m_window->setUnkeptGrades(0);
    m_window->close();
    QVERIFY(child<QuestionCard>("gradeQuestion") == nullptr);
}

void TestMainWindow::typingSearchesTheLessons()
{
    m_window->setLessons(lessons::readCatalog({}), {});
    QSignalSpy begun(child<ui::study::LessonsPage>(), &ui::study::LessonsPage::lessonChosen);
    actions().lessons->trigger();
    auto* list = child<QListView>("lessonList");
    QVERIFY(list->hasFocus());
    auto* search = child<ui::study::LessonsPage>()->findChild<QLineEdit*>();
    // Wherever one is; the letters are no shortcuts here.
    for (const Qt::Key key : {Qt::Key_T, Qt::Key_E, Qt::Key_M})
        press(key);
    QCOMPARE(search->text().toLower(), QString("tem"));
    QVERIFY(child<ui::study::LessonsPage>()->isVisible());
    QVERIFY(search->hasFocus());
    QVERIFY2(!child<QPushButton>("startLesson")->isEnabled(), "nothing fits");
    const auto edits = child<ui::study::LessonsPage>()->findChildren<QPushButton*>();
    QVERIFY(std::none_of(edits.begin(), edits.end(), [](const QPushButton* button) {
        return button->isVisible() && button->text().contains("Edit");
    }));
    // The first that fits is chosen, also where another one that fits was chosen before.
    search->setText("class1-36");
    QCOMPARE(child<QLabel>("lessonTitle")->text(), QString("Class I on 36"));
    search->setText("36");
    QCOMPARE(child<QLabel>("lessonTitle")->text(), QString("Touch the points"));
    search->setText("class1-37");
    search->clear();
    QCOMPARE(child<QLabel>("lessonTitle")->text(), QString("Class I on 37"));
    // Typed from the list, a new search begins.
    search->setText("37");
    press(Qt::Key_Down);
    QVERIFY(list->hasFocus());
    press(Qt::Key_2);
    QCOMPARE(search->text(), QString("2"));
    search->setText("class1-26");
    press(Qt::Key_Return);
    QCOMPARE(begun.size(), 1);
    QCOMPARE(QString::fromStdString(begun.front().front().value<lessons::Lesson>().id), QString("class1-26"));
}

/// By title, in the order of the list; headings left out.
static QStringList cardsOf(const QListView& list)
{
    QStringList titles;
    for (int row = 0; row < list.model()->rowCount(); ++row)
        if (const QModelIndex card = list.model()->index(row, 0); card.data(ui::study::CardEntry).isValid())
            titles << card.data().toString();
    return titles;
}

/// What is drawn on a card, in shares of it.
static QImage drawnOn(const QListView& list, const QModelIndex& card, const QRectF& part)
{
    const QRectF whole = list.visualRect(card);
    return list.viewport()
        ->grab(QRectF(whole.left() + part.left() * whole.width(), whole.top() + part.top() * whole.height(),
                      part.width() * whole.width(), part.height() * whole.height())
                   .toRect())
        .toImage();
}

static qsizetype coloursOf(const QImage& image)
{
    QSet<QRgb> colours;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            colours << image.pixel(x, y);
    return colours.size();
}

void TestMainWindow::cardsShowTheToothAndTheBestScore()
{
    constexpr QRectF kPicture(0.15, 0.05, 0.7, 0.4);
    constexpr QRectF kScore(0.6, 0.85, 0.35, 0.12);
    auto* page = child<ui::study::LessonsPage>();
    auto* list = child<QListView>("lessonList");
    auto* search = page->findChild<QLineEdit*>();
    actions().lessons->trigger();
    page->setLessons(lessons::readCatalog({}), {});
    // The tooth, when it is ready: many shades, and another tooth another picture.
    QImage before;
    for (const char* lesson : {"class1-36", "class1-34"}) {
        search->setText(lesson);
        QCOMPARE(cardsOf(*list).size(), 1);
        const QModelIndex card = list->currentIndex();
        QTRY_VERIFY_WITH_TIMEOUT(coloursOf(drawnOn(*list, card, kPicture)) > 50, 30000);
        const QImage picture = drawnOn(*list, card, kPicture);
        QVERIFY(picture != before);
        before = picture;
        // Not tried yet.
        QCOMPARE(card.data(ui::study::CardScore).toString(), QString());
    }
    const QImage untried = drawnOn(*list, list->currentIndex(), kScore);
    page->setLessons(lessons::readCatalog({}), {{"class1-34", {2, 603, false, "2026-11-20T10:00:00Z"}},
                                                {"class1-36", {3, 917, true, "2026-11-20T11:00:00Z"}}});
    QModelIndex card = list->currentIndex();
    QCOMPARE(card.data(ui::study::CardScore).toString(), QString("60.3"));
    QVERIFY(!card.data(ui::study::CardPassed).toBool());
    QVERIFY(card.data(Qt::AccessibleDescriptionRole).toString().contains("best 60.3, not passed"));
    QVERIFY(drawnOn(*list, card, kScore) != untried);
    search->setText("class1-36");
    card = list->currentIndex();
    QCOMPARE(card.data(ui::study::CardScore).toString(), QString("✓ 91.7"));
    QVERIFY(card.data(ui::study::CardPassed).toBool());
    QVERIFY(card.data(Qt::AccessibleDescriptionRole).toString().contains("best 91.7, passed"));
}

void TestMainWindow::lessonsAreFiltered()
{
    auto* page = child<ui::study::LessonsPage>();
    const auto* list = child<QListView>("lessonList");
    std::vector<lessons::CatalogEntry> entries = lessons::readCatalog({});
    for (lessons::CatalogEntry& entry : entries)
        if (entry.read.lesson->id == "class1-24")
            entry.read.lesson->exam = true;
    const auto all = static_cast<qsizetype>(entries.size());
    const std::map<std::string, ui::study::Standing> standings{{"class1-36", {2, 603, false, "2026-11-20T10:00:00Z"}},
                                                               {"class1-37", {1, 917, true, "2026-11-20T11:00:00Z"}}};
    const ui::study::Given given{"Year 1", {}, {}};
    page->setLessons(entries, standings, {{"class1-36", given}, {"class1-37", given}, {"class1-26", given}});
    actions().lessons->trigger();
    const auto filter = [page](const char* words) {
        for (auto* button : page->findChildren<QPushButton*>())
            if (button->isCheckable() && button->text() == QLatin1String(words))
                return button;
        return static_cast<QPushButton*>(nullptr);
    };
    const auto shown = [&](const char* words) {
        QTest::mouseClick(filter(words), Qt::LeftButton);
        return cardsOf(*list);
    };
    for (const char* words : {"All", "To do", "Passed", "Exams"})
        QVERIFY2(filter(words) != nullptr && filter(words)->isVisible(), words);
    QVERIFY(filter("All")->isChecked());
    QCOMPARE(cardsOf(*list).size(), all);
    QCOMPARE(shown("To do"), (QStringList{"Class I on 36", "Class I on 26"}));
    QCOMPARE(shown("Passed"), QStringList{"Class I on 37"});
    QCOMPARE(shown("Exams"), QStringList{"Class I on 24"});
    QVERIFY(filter("Exams")->isChecked() && !filter("All")->isChecked());
    // Beside what is searched for.
    page->findChild<QLineEdit*>()->setText("class1-36");
    QCOMPARE(shown("Passed"), QStringList());
    QCOMPARE(child<QLabel>("lessonTitle")->text(), QString("No lesson fits"));
    QCOMPARE(shown("All"), QStringList{"Class I on 36"});
    // To whom nothing was given all that he has not passed is to do.
    page->findChild<QLineEdit*>()->clear();
    page->setLessons(entries, standings);
    QCOMPARE(shown("To do").size(), all - 1);
    // The next person begins with all.
    page->forget();
    QVERIFY(filter("All")->isChecked());
    QCOMPARE(cardsOf(*list).size(), all);
}

void TestMainWindow::aToothOfTheArchIsSearchedFor()
{
    m_window->setLessons(lessons::readCatalog({}), {});
    auto* page = child<ui::study::LessonsPage>();
    const auto* list = child<QListView>("lessonList");
    const auto* search = page->findChild<QLineEdit*>();
    actions().lessons->trigger();
    const auto all = cardsOf(*list).size();
    const auto tooth = [page](int fdi) {
        const auto teeth = page->findChildren<ArchTooth*>();
        const auto found = std::find_if(teeth.begin(), teeth.end(), [fdi](auto* one) { return one->fdi() == fdi; });
        return found == teeth.end() ? nullptr : *found;
    };
    const auto open = [&] {
        QTest::mouseClick(child<QPushButton>("pickTooth"), Qt::LeftButton);
        const auto* popup = page->findChild<QFrame*>("archPopup");
        return popup != nullptr && popup->isVisible();
    };
    // With the pointer.
    QVERIFY(open());
    auto* arch = page->findChild<ArchView*>();
    QTest::mouseDClick(arch, Qt::LeftButton, {}, tooth(26)->geometry().center());
    QTRY_VERIFY(page->findChild<QFrame*>("archPopup") == nullptr);
    QCOMPARE(search->text(), QString("26"));
    QTRY_VERIFY(list->hasFocus());
    QStringList cards = cardsOf(*list);
    QVERIFY(cards.size() < all);
    QCOMPARE(cards.first(4).filter("26").size(), 4);
    QVERIFY(child<QLabel>("lessonTitle")->text().contains("26"));
    // With the keys: from the first tooth down, one further back, and that one.
    QVERIFY(open());
    QTest::keyClick(tooth(21), Qt::Key_Down);
    QTest::keyClick(tooth(31), Qt::Key_Right);
    QCOMPARE(search->text(), QString("26"));
    QTest::keyClick(tooth(32), Qt::Key_Return);
    QTRY_VERIFY(page->findChild<QFrame*>("archPopup") == nullptr);
    QCOMPARE(search->text(), QString("32"));
    cards = cardsOf(*list);
    QCOMPARE(cards.first(3).filter("on 32").size(), 3);
    // Escape leaves all as it was.
    QVERIFY(open());
    QTest::keyClick(tooth(21), Qt::Key_Escape);
    QTRY_VERIFY(page->findChild<QFrame*>("archPopup") == nullptr);
    QCOMPARE(search->text(), QString("32"));
}

void TestMainWindow::datesAndPointsAreNotSearched()
{
    auto* page = child<ui::study::LessonsPage>();
    const ui::study::Given given{"Year 26", QDateTime(QDate(2093, 12, 24), QTime(12, 0)), {}};
    page->setLessons(lessons::readCatalog({}), {{"class1-36", {2, 917, true, "2026-11-20T10:00:00Z"}}},
                     {{"class1-37", given}});
    actions().lessons->trigger();
    auto* search = page->findChild<QLineEdit*>();
    for (const char* word : {"2093", "91.7", "24/12"}) {
        search->setText(word);
        QVERIFY2(child<QListView>("lessonList")->model()->rowCount() == 0, word);
    }
    search->setText("year");
    QCOMPARE(child<QLabel>("lessonTitle")->text(), QString("Class I on 37"));
    QTRY_VERIFY(!child<QListView>("lessonList")->verticalScrollBar()->isEnabled());  // and nothing is drawn of it
    search->clear();
    QTRY_VERIFY(child<QListView>("lessonList")->verticalScrollBar()->isEnabled());
    // The number of a tooth is that first, though what is due comes first otherwise.
    search->setText("26");
    const QString first = child<QLabel>("lessonTitle")->text();
    QVERIFY2(first.contains("26"), qPrintable(first));
}

void TestMainWindow::usedUpAttemptsAreToldBeforeTheStart()
{
    auto* page = child<ui::study::LessonsPage>();
    QSignalSpy begun(page, &ui::study::LessonsPage::lessonChosen);
    actions().lessons->trigger();
    for (const int left : {1, 0}) {
        page->setLessons(lessons::readCatalog({}), {}, {{"class1-37", {"Year 1", {}, left}}});
        page->findChild<QLineEdit*>()->setText("class1-37");
        QCOMPARE(child<QPushButton>("startLesson")->isEnabled(), left > 0);
        QCOMPARE(child<QLabel>("whyNotStart")->isVisible(), left == 0);
        const QModelIndex card = child<QListView>("lessonList")->currentIndex();
        QCOMPARE(card.data(ui::study::CardDue).toString(), QString("Year 1"));
        QCOMPARE(card.data(ui::study::CardIsUsedUp).toBool(), left == 0);
    }
    page->findChild<QLineEdit*>()->setFocus();
    press(Qt::Key_Return);
    QCOMPARE(begun.size(), 0);
}

void TestMainWindow::theForecastIsAnsweredWithTheKeys()
{
    const auto assignment = lessons::assign(*shipped("class1-36").lesson).value().assignment;
    m_window->setAssignment(assignment);
    m_window->askForecast();
    QSignalSpy given(m_window.get(), &MainWindow::forecastGiven);
    press(Qt::Key_Right);
    press(Qt::Key_Tab);
    auto* show = child<QPushButton>("showScore");
    QVERIFY(!show->isEnabled());
    press(Qt::Key_Down);
    press(Qt::Key_Return);
    QVERIFY2(show->isEnabled(), "the answer is chosen");
    QCOMPARE(given.size(), 0);
    press(Qt::Key_Return);
    QCOMPARE(given.size(), 1);
}

void TestMainWindow::anotherToothIsChosenWithTheMouse()
{
    QSignalSpy chosen(m_window.get(), &MainWindow::toothChosen);
    press(Qt::Key_T);
    auto* arches = child<ArchView>();
    QCOMPARE(arches->selected(), 36);
    for (ArchTooth* tooth : arches->findChildren<ArchTooth*>()) {
        // The rectangles of neighbours overlap, their middles do not.
        QTest::mouseClick(arches, Qt::LeftButton, {}, tooth->geometry().center());
        QCOMPARE(arches->selected(), tooth->fdi());
    }
    arches->setSelected(24);
    QTest::mouseClick(child<QPushButton>("takeTooth"), Qt::LeftButton);
    QCOMPARE(chosen.size(), 1);
    QCOMPARE(chosen.front().front().toInt(), 24);
    QVERIFY(child<PracticeRoom>()->isVisible());
}

void TestMainWindow::anotherToothIsChosenWithTheKeys()
{
    QSignalSpy chosen(m_window.get(), &MainWindow::toothChosen);
    press(Qt::Key_T);
    auto* arches = child<ArchView>();
    QCOMPARE(arches->findChildren<ArchTooth*>().size(), 16);
    press(Qt::Key_Right);
    QCOMPARE(arches->selected(), 37);
    press(Qt::Key_Up);
    QCOMPARE(arches->selected(), 27);
    press(Qt::Key_Left);
    QCOMPARE(arches->selected(), 26);
    press(Qt::Key_Down);
    QCOMPARE(arches->selected(), 36);
    press(Qt::Key_Return);
    QCOMPARE(chosen.size(), 1);
    QCOMPARE(chosen.front().front().toInt(), 36);
}

void TestMainWindow::theWholeMouthIsReachedWithM()
{
    press(Qt::Key_M);
    auto* mouth = child<Mouth>();
    QVERIFY(mouth != nullptr && mouth->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(mouth->isReady(), 20000);
    QTRY_VERIFY(mouth->hasFocus());
    QSignalSpy chosen(m_window.get(), &MainWindow::toothChosen);
    mouth->setSelected(35);
    press(Qt::Key_Right);
    QCOMPARE(child<ArchView>()->selected(), 36);
    // The flat arches know what was chosen, and back again.
    press(Qt::Key_M);
    QVERIFY(child<ArchView>()->isVisible() && !mouth->isVisible());
    press(Qt::Key_M);
    QVERIFY(mouth->isVisible());
    press(Qt::Key_Left);
    press(Qt::Key_Return);
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(chosen.front().front().toInt(), 35);
}

void TestMainWindow::theScoreAddsUp()
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
    QCOMPARE(child<QLabel>("worked_caries_left")->text(), QString("(3.20 − 1.00 free) / 30.00 % × 60.0 points = 4.4"));
    bool listed = false;
    for (const TabularLabel* label : child<ScorePage>()->findChildren<TabularLabel*>())
        listed = listed || label->text() == "61.0";
    QVERIFY(listed);
    // A second grade replaces the first.
    m_window->showScore(sheet(40, 30, 0), {});
    QCOMPARE(child<QLabel>("verdict")->text(), QString("Not passed yet"));
    QCOMPARE(child<QLabel>("sum")->text(), QString("100.0 − 60.0 − 40.0 − 0.0 = 0.0"));
    QCOMPARE(child<ScorePage>()->findChildren<TabularLabel*>("lost_caries_left").size(), 1);
    QVERIFY(child<QLabel>("historyRemark")->text().contains("will not be here next time"));
    m_window->showScore(s, {now});
    QVERIFY(child<QLabel>("historyRemark")->text().contains("first grade"));
    m_window->showScore(s, {now, before});
    QVERIFY(!child<QLabel>("historyRemark")->isVisible());
    press(Qt::Key_Return);
    QVERIFY2(child<PracticeRoom>()->isVisible(), "the next step is one key away");
}

void TestMainWindow::aCriticalFaultFailsGoodWork()
{
    m_window->showScore(sheet(0, 0, 0.1), {});
    QCOMPARE(figure("total"), QString("0.0"));
    QVERIFY(child<QLabel>("verdict")->text().startsWith("Not passed"));
}

void TestMainWindow::theFirstWindowFitsTheScreen_data()
{
    QTest::addColumn<QSize>("screen");
    QTest::addColumn<QSize>("size");
    QTest::newRow("small, with a task bar") << QSize(1024, 560) << QSize(1016, 520);
    QTest::newRow("laptop") << QSize(1366, 768) << QSize(1280, 728);
    QTest::newRow("large") << QSize(1920, 1080) << QSize(1280, 800);
    QTest::newRow("less than any page needs") << QSize(640, 480) << QSize(800, 460);
}

void TestMainWindow::theFirstWindowFitsTheScreen()
{
    QFETCH(QSize, screen);
    QFETCH(QSize, size);
    QCOMPARE(MainWindow::firstSize(screen), size);
    QCOMPARE(m_window->size(), MainWindow::firstSize(m_window->screen()->availableSize()));
    m_window->resize(size);
    QTRY_COMPARE(m_window->size(), size);
}

void TestMainWindow::aPlaceThatWasLeftIsLocked()
{
    support::SchoolRig rig(false);
    rig.populate();
    m_window->setIdleLimit(std::chrono::milliseconds(300));
    QTest::qWait(500);
    QVERIFY(!child<ui::people::LoginPage>()->isVisible());  // a guest has nothing to lock
    m_window->setWho(rig.student);
    QTRY_VERIFY(child<ui::people::LoginPage>()->isVisible());
    QCOMPARE(child<ui::people::LoginPage>()->door(), ui::people::Door::Locked);
    // No key leads past it, and what others want to show waits behind it.
    for (QAction* action : {actions().lessons, actions().attempts, actions().grade, actions().back, actions().help})
        QVERIFY(!action->isEnabled());
    QTest::keyClick(m_window.get(), Qt::Key_Escape);
    m_window->showScore(sheet(3.2, 40, 0.5), {});
    QVERIFY(child<ui::people::LoginPage>()->isVisible());
    // Back again he finds it as it is now.
    m_window->setWho(rig.student);
    QVERIFY(!child<ui::people::LoginPage>()->isVisible());
    QVERIFY(child<ui::study::ScorePage>()->isVisible());
}

/// What the one who left had open would go on working for whoever comes by.
void TestMainWindow::nothingStaysOpenOverTheLock()
{
    support::SchoolRig rig(false);
    rig.populate();
    m_window->setWho(rig.student);
    cutSomething(1.0);
    const auto* const door = child<ui::people::LoginPage>();
    const auto lockAndComeBack = [&] {
        m_window->askWho(ui::people::Door::Locked);
        QVERIFY(door->isVisible());
        for (const QWidget* window : m_window->findChildren<QWidget*>())
            QVERIFY2(!window->isWindow() || !window->isVisible(), window->metaObject()->className());
        m_window->setWho(rig.student);
    };
    QSignalSpy save(m_window.get(), &MainWindow::recordingSaveRequested);
    actions().saveRecording->trigger();
    QVERIFY(child<QFileDialog>("QFileDialog") != nullptr);
    lockAndComeBack();
    QCOMPARE(save.size(), 0);
    QTRY_VERIFY(child<QFileDialog>("QFileDialog") == nullptr);
    QMenu menu(m_window.get());
    menu.addAction(QStringLiteral("something"));
    menu.popup(m_window->mapToGlobal(QPoint(10, 10)));
    QTRY_VERIFY(menu.isVisible());
    lockAndComeBack();
    QSignalSpy chosen(m_window.get(), &MainWindow::toothChosen);
    press(Qt::Key_T);
    press(Qt::Key_Return);
    QVERIFY(question() != nullptr && question()->isVisible());
    m_window->askWho(ui::people::Door::Locked);
    QTRY_VERIFY(question() == nullptr);
    QCOMPARE(chosen.size(), 0);
}

/// So that it counts nowhere as time of the attempt. In an exam it does.
void TestMainWindow::timeAwayFromTheWorkIsNoted()
{
    QList<quint64> noted;
    const auto have = [&] { return noted += restsNoted(); };  // each is asked for once
    QTest::qWait(100);
    QCOMPARE(have(), QList<quint64>());
    m_window->askWho(ui::people::Door::Locked);
    QTRY_COMPARE(have(), QList<quint64>{kRestNote});
    m_window->setWho({});
    QTRY_COMPARE(have(), (QList<quint64>{kRestNote, kWorkNote}));
    lessons::Assignment exam;
    exam.anatomy = support::syntheticMolar();
    exam.lesson.emplace();
    exam.lesson->exam = true;
    m_window->setAssignment(exam);
    m_window->showTooth(exam.anatomy, 2, {});
    m_window->askWho(ui::people::Door::Locked);
    QTest::qWait(100);
    QCOMPARE(restsNoted(), QList<quint64>());
}

void TestMainWindow::nothingOfWhoLeftStays()
{
    auto* console = child<ui::console::Console>();
    actions().console->trigger();
    console->execute(QStringLiteral("get force.stiffness"));
    console->execute(QStringLiteral("watch force.stiffness"));
    auto* line = child<QLineEdit>("consoleLine");
    line->setText(QStringLiteral("list"));
    QTest::keyClick(line, Qt::Key_Return);
    const double usualN = m_window->view().pushForce();
    m_window->view().setPushForce(usualN + 1.0);
    m_window->leaveAll();
    QCOMPARE(m_window->view().pushForce(), usualN);
    QVERIFY(!console->isVisible());
    QVERIFY(child<ui::console::WatchPanel>()->names().isEmpty());
    actions().console->trigger();
    QVERIFY(!child<QPlainTextEdit>("consoleOutput")->toPlainText().contains("force.stiffness"));
    QTest::keyClick(line, Qt::Key_Up);
    QCOMPARE(line->text(), QString());
    actions().console->trigger();
}

/// It may have been meant for what was open before.
void TestMainWindow::aReturnAtTheLockIsNoWrongPassword()
{
    support::SchoolRig rig(false);
    rig.populate();
    m_window->setWho(rig.student);
    m_window->askWho(ui::people::Door::Locked);
    QSignalSpy wanted(m_window.get(), &MainWindow::loginWanted);
    QTest::keyClick(child<QLineEdit>("password"), Qt::Key_Return);
    QCOMPARE(wanted.size(), 0);
    QVERIFY(child<QLineEdit>("password")->isEnabled());
    child<QLineEdit>("password")->setText(QStringLiteral("something"));
    QTest::keyClick(child<QLineEdit>("password"), Qt::Key_Return);
    QCOMPARE(wanted.size(), 1);
}

void TestMainWindow::everyControlHasAName()
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

void TestMainWindow::everyActionIsFitToBeRead()
{
    QSet<QString> keys;
    for (const Actions::Group& group : actions().groups())
        for (const QAction* action : group.actions) {
            QVERIFY(!action->text().isEmpty());
            QVERIFY2(!action->statusTip().isEmpty(), qPrintable(action->text()));
            QVERIFY2(action->toolTip().contains(action->shortcut().toString(QKeySequence::NativeText)),
                     qPrintable(action->toolTip()));
            QVERIFY2(!action->icon().isNull() || actions().burs.contains(action), qPrintable(action->text()));
            if (action == actions().pauseReplay || action == actions().along)
                continue;  // rest while drill and bur colour, which have the same keys, do not
            for (const QKeySequence& key : action->shortcuts()) {
                QVERIFY2(!keys.contains(key.toString()), qPrintable(key.toString() + " is taken twice"));
                keys << key.toString();
            }
        }
}

void TestMainWindow::longTooltipsAreBrokenIntoLines()
{
    m_window->showScore(sheet(3.2, 9.81, 0.5), {});
    int longOnes = 0;
    for (const QWidget* widget : m_window->findChildren<QWidget*>()) {
        if (widget->toolTip().size() < 80)
            continue;
        QVERIFY2(Qt::mightBeRichText(widget->toolTip()), qPrintable(widget->toolTip()));
        ++longOnes;
    }
    QVERIFY(longOnes >= 3);
}

void TestMainWindow::tabReachesEveryButtonOfTheRoom()
{
    m_window->view().setFocus();
    QSet<QWidget*> reached;
    for (int k = 0; k < 200; ++k) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        reached << QApplication::focusWidget();
    }
    for (QAbstractButton* button : child<PracticeRoom>()->findChildren<QAbstractButton*>())
        if (button->isVisible() && button->isEnabled())
            QVERIFY2(reached.contains(button), qPrintable(button->accessibleName()));
    QVERIFY(reached.contains(child<QSlider>("pushForce")));
    QVERIFY(reached.contains(&m_window->view()));
}

void TestMainWindow::nothingIsClipped_data()
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<QSize>("size");
    for (const QString language : {"en", "de", "es", "ja"})
        for (const QSize size :
             {QSize(800, 460), QSize(853, 533), QSize(960, 600), QSize(1016, 552), QSize(1280, 760), QSize(1920, 1080)})
            QTest::newRow(qPrintable(language + QString::number(size.width()))) << language << size;
}

void TestMainWindow::nothingIsClipped()
{
    QFETCH(QString, language);
    QFETCH(QSize, size);
    QTranslator words;
    QVERIFY(words.load(":/i18n/cusp_" + language + ".qm"));
    QCoreApplication::installTranslator(&words);
    MainWindow window(*m_links);
    window.resize(size);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    window.showTooth(support::syntheticMolar(), 1, {});
    // The first that has less room than it wants; pages are laid out in passes, so a check waits for the last one.
    const auto clipped = [&](const char* page) {
        for (QWidget* widget : window.findChildren<QWidget*>()) {
            const auto* label = qobject_cast<QLabel*>(widget);
            if (!widget->isVisible() || (label == nullptr && qobject_cast<QAbstractButton*>(widget) == nullptr &&
                                         qobject_cast<TabularLabel*>(widget) == nullptr))
                continue;
            if (qobject_cast<ArchTooth*>(widget) != nullptr)
                continue;
            bool scrolls = false;
            for (const QWidget* holder = widget; holder != nullptr; holder = holder->parentWidget())
                scrolls = scrolls || qobject_cast<const ScrollPane*>(holder) != nullptr;
            if (!scrolls && !window.rect().contains(QRect(widget->mapTo(&window, QPoint()), widget->size())))
                return QString("%1: %2 '%3' lies outside")
                    .arg(page, widget->metaObject()->className(), widget->accessibleName());
            const QSize wanted =
                widget->hasHeightForWidth() ? QSize(0, widget->heightForWidth(widget->width())) : widget->sizeHint();
            if (widget->width() < wanted.width() || widget->height() < wanted.height())
                return QString("%1: %2 '%3' is %4x%5, wants %6x%7")
                    .arg(page, widget->metaObject()->className(),
                         label != nullptr ? label->text() : widget->accessibleName())
                    .arg(widget->width())
                    .arg(widget->height())
                    .arg(wanted.width())
                    .arg(wanted.height());
        }
        return QString();
    };
    const QString folder = QStringLiteral(CUSP_BINARY_DIR "/pictures");
    QVERIFY(QDir().mkpath(folder));
    const auto check = [&](const char* page) {
        QTest::qWait(50);
        // For looking at; a usual size and the smallest are enough. Packing them well would take a fifth of the time.
        constexpr int kHardlyPacked = 85;
        if (size.width() == 1280 || size.width() == 853)
            window.grab().save(QString("%1/%2-%3-%4.png").arg(folder, page, language).arg(size.width()), nullptr,
                               kHardlyPacked);
        QTRY_VERIFY2(clipped(page).isEmpty(), qPrintable(clipped(page)));
    };
    auto* a = window.findChild<Actions*>();
    SessionState session;
    session.removedMm3 = {0.0, 188.88, 188.88, 18.88};
    session.overcutMm3 = 188.88;
    publish({}, session);
    QTRY_COMPARE(window.findChild<TabularLabel*>("overcut")->text(), QLocale().toString(188.88, 'f', 2));
    check("practice");
    a->section->trigger();
    check("section");
    QVERIFY2(window.view().width() >= 220, qPrintable(QString::number(window.view().width())));
    a->section->trigger();
    a->stereoPage->trigger();
    check("stereo");
    a->back->trigger();
    const auto* figures = window.findChild<SidePanel*>()->findChild<QScrollArea*>();
    QVERIFY2(figures->widget()->width() <= figures->viewport()->width(),
             qPrintable(QString::number(figures->widget()->width())));
    window.showError({core::ErrorCode::WrongKind, {}}, Failed::KeepingGrades,
                     "a_file_with_a_name_as_long_as_names_can_be_which_has_to_go_to_a_second_line.sqlite");
    check("error");
    a->back->trigger();
    a->history->trigger();
    check("history");
    a->history->trigger();
    window.setReplaying(true, 60.0);
    window.setReplayCourse(course());
    check("replay");
    const auto beside = std::make_unique<UiLinks>();
    window.showBeside(*beside, support::syntheticMolar(), 1, {}, "A recording with a long name");
    window.setBesideCourse(course());
    check("beside");
    window.hideBeside();
    window.setReplaying(false);
    a->help->trigger();
    check("help");
    a->back->trigger();
    a->console->trigger();
    window.findChild<ui::console::Console*>()->execute("list");
    check("console");
    a->console->trigger();
    const core::settings::FeelPreset preset = lessons::shippedPresets().front();
    emit window.findChild<ui::presets::PresetsPage*>()->tryWanted(preset, preset);
    window.beginTrial();
    check("trial");
    emit window.findChild<ui::presets::PresetsPage*>()->compareWanted(preset, preset, 2);
    window.beginTrial();
    check("blind");
    auto* trial = window.findChild<ui::presets::TrialCard*>();
    for (int answers = 0; answers < 2; ++answers) {
        for (const char* letter : {"trialA", "trialB"}) {
            trial->findChild<QPushButton*>(letter)->click();
            trial->follow(1, 0, 0.0);
            trial->follow(1, 0, 0.1);
        }
        trial->findChild<QPushButton*>("trialSaysA")->click();
    }
    check("compared");
    trial->hide();
    window.setPresets({{{}, preset, {}}}, preset);
    a->presets->trigger();
    check("presets");
    window.findChild<QPushButton*>("presetExpert")->click();
    window.showPresetFault("Not imported: a.cusppreset: enamel.rate_mm3_per_ns: is -1, it must lie between 0 and 100");
    check("numbers");
    a->back->trigger();
    a->settings->trigger();
    check("settings");
    a->back->trigger();
    a->chooseTooth->trigger();
    check("teeth");
    a->back->trigger();
    a->radiograph->trigger();
    check("xray");
    a->back->trigger();
    window.setLessons(lessons::readCatalog({}), {{"decay-21-small", {3, 872, true, {}}}});
    a->lessons->trigger();
    check("lessons");
    {
        auto* editor = window.findChild<ui::study::LessonEditor*>();
        const auto catalog = lessons::readCatalog({});
        const auto classOne = std::find_if(catalog.begin(), catalog.end(), [](const lessons::CatalogEntry& entry) {
            return entry.read.lesson->id == "class1-36";
        });
        editor->edit(classOne->read, QDir::temp().filePath(QStringLiteral("no such folder")));
        qobject_cast<QStackedWidget*>(editor->parentWidget())->setCurrentWidget(editor);
        QTRY_VERIFY_WITH_TIMEOUT(editor->findChild<QLabel*>("selfCheck")->text().startsWith(QChar(0x2713)), 60000);
        check("editor");
        for (auto* choice : editor->findChildren<QPushButton*>())
            if (choice->property("kind") == "segment") {
                choice->click();
                check("editor-parts");
            }
        a->lessons->trigger();
    }
    a->back->trigger();
    std::uint64_t generation = 2;
    for (const lessons::CatalogEntry& entry : lessons::readCatalog({})) {
        if (!lessons::isExercise(entry.read.lesson->task))
            continue;
        const lessons::Assignment exercise = lessons::assign(*entry.read.lesson).value().assignment;
        window.setAssignment(exercise);
        window.showTooth(exercise.anatomy, generation++, {});
        check(entry.read.lesson->id.c_str());
        for (const char* choice : {"pad01", "pad12", "pad20"})
            if (auto* button = window.findChild<QPushButton*>(choice); button->isVisible())
                button->click();
        ServoState turning;
        turning.tick = 1;
        turning.drillOn = true;
        publish(turning, session);
        QTest::qWait(50);
        check(qPrintable(QString::fromStdString(entry.read.lesson->id) + "-on"));
        window.showScore(sheet(3.2, 40, 0.5), {});
        a->back->trigger();
        check(qPrintable(QString::fromStdString(entry.read.lesson->id) + "-graded"));
    }
    lessons::Assignment assignment;
    assignment.anatomy = support::syntheticMolar();
    for (const lessons::CatalogEntry& entry : lessons::readCatalog({}))
        if (entry.read.lesson->id == "decay-36-moderate")
            assignment.lesson = entry.read.lesson;
    QVERIFY(assignment.lesson.has_value());
    assignment.rubric = assignment.lesson->rubric;
    window.setAssignment(assignment);
    window.showTooth(assignment.anatomy, generation, {});
    check("lesson");
    window.askForecast();
    check("forecast");
    a->back->trigger();
    ui::study::ScoredWork scored;
    scored.tooth = std::make_shared<const core::terrain::Tooth>(assignment.anatomy);
    scored.ideal = assignment.shownIdeal();
    scored.measured.measures = core::grading::measure(*scored.tooth);
    window.showScore(sheet(3.2, 40, 0.5), {}, ui::study::Expectation{900, "caries_left"}, scored);
    const lessons::Moment moment{lessons::Moment::Kind::Stroke, 100, 754000, 754.0, 128};
    const lessons::Moment never{lessons::Moment::Kind::Never, 340, 754000, 754.0, 0};
    window.scorePage().setMoments({{never, moment}, {moment}, {moment}});
    check("score");
    for (const QScrollArea* area : window.findChildren<QScrollArea*>())
        if (area->isVisible())
            QVERIFY2(
                area->widget()->width() <= area->viewport()->width(),
                qPrintable(
                    QString("the score is %1 wide in %2").arg(area->widget()->width()).arg(area->viewport()->width())));
}

void TestMainWindow::wordsFoldWhereThereIsNoRoom()
{
    const auto* undo = child<PracticeRoom>()->findChild<FoldingBar*>("workBar")->findChildren<QToolButton*>().front();
    QCOMPARE(undo->defaultAction(), actions().undo);
    m_window->resize(1280, 760);
    QTRY_COMPARE(undo->toolButtonStyle(), Qt::ToolButtonTextBesideIcon);
    // One button more than there is room for.
    QWidget room;
    FoldingBar bar(&room);
    QList<QToolButton*> buttons;
    for (int k = 0; k < 3; ++k) {
        buttons << barButton(actions().reload, true, &bar);
        bar.row().addWidget(buttons.back());
        bar.mayFold(buttons.back());
    }
    buttons.back()->hide();
    room.resize(1000, 60);
    room.show();
    bar.resize(900, 52);
    const int two = bar.row().minimumSize().width();
    bar.resize(two, 52);
    QCOMPARE(buttons.front()->toolButtonStyle(), Qt::ToolButtonTextBesideIcon);
    buttons.back()->show();
    QCOMPARE(buttons.front()->toolButtonStyle(), Qt::ToolButtonIconOnly);
    QVERIFY(bar.row().minimumSize().width() <= two);
    QVERIFY(!buttons.front()->toolTip().isEmpty());
    bar.resize(2 * two, 52);
    QCOMPARE(buttons.front()->toolButtonStyle(), Qt::ToolButtonTextBesideIcon);
    // What may go goes before any word folds, and comes back.
    auto* name = new QLabel(QStringLiteral("lower left first molar"), &bar);
    bar.row().addWidget(name);
    bar.mayGo(name);
    bar.fold();
    QVERIFY(name->isVisibleTo(&bar));
    bar.resize(bar.row().minimumSize().width() - 1, 52);
    QVERIFY(!name->isVisibleTo(&bar));
    QCOMPARE(buttons.front()->toolButtonStyle(), Qt::ToolButtonTextBesideIcon);
    bar.resize(4 * two, 52);
    QVERIFY(name->isVisibleTo(&bar));
    name->setText(QStringLiteral("lower left first molar ").repeated(20));
    bar.fold();
    QVERIFY(!name->isVisibleTo(&bar));
    // Words of another language need another width.
    ui::text::inEveryLanguage(name, [name] { name->setText(QStringLiteral("36")); });
    QEvent chosen(QEvent::LanguageChange);
    QApplication::sendEvent(&bar, &chosen);
    QVERIFY(name->isVisibleTo(&bar));
}

void TestMainWindow::whatIsBelowIsPointedAt()
{
    const auto* figures = child<SidePanel>()->findChild<ScrollPane*>();
    const auto* push = child<QSlider>("pushForce");
    // As it opens on a screen of 1280 x 800 all of the panel is there.
    m_window->resize(1272, 760);
    QTRY_VERIFY(!figures->hasMoreBelow());
    QTRY_COMPARE(push->visibleRegion().boundingRect().size(), push->size());
    m_window->resize(853, 533);
    QTRY_VERIFY(figures->hasMoreBelow());
    const QRect room(figures->viewport()->mapTo(m_window.get(), QPoint()), figures->viewport()->size());
    const QRect edge(room.left(), room.bottom() - 12, room.width(), 12);
    const auto tones = [&] {
        const QImage picture = m_window->grab(edge).toImage();
        QSet<QRgb> all;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                all << picture.pixel(x, y);
        return all.size();
    };
    QVERIFY2(tones() > 3, "an arrow on a plain ground");
    figures->verticalScrollBar()->setValue(figures->verticalScrollBar()->maximum());
    QVERIFY(!figures->hasMoreBelow());
    m_window->resize(1272, 760);
    press(Qt::Key_F1);
    const auto* keys = child<HelpOverlay>()->findChild<ScrollPane*>();
    QTRY_VERIFY(!keys->hasMoreBelow());
    m_window->resize(853, 533);
    QTRY_VERIFY(keys->hasMoreBelow());
}

void TestMainWindow::coloursCanBeRead()
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

void TestMainWindow::everyDrawingExists()
{
    for (const char* name :
         {"undo", "redo",  "reload",     "drill", "hand", "tooth", "open", "save",    "play",  "pause", "grade",
          "help", "panel", "fullscreen", "view",  "back", "close", "info", "warning", "error", "check", "cross"}) {
        const QIcon icon = lineIcon(name, roomPalette());
        QVERIFY2(!icon.isNull(), name);
        const QImage picture = icon.pixmap(32).toImage();
        bool drawn = false;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                drawn = drawn || qAlpha(picture.pixel(x, y)) > 200;
        QVERIFY2(drawn, name);
    }
    QVERIFY(lineIcon("no such drawing", roomPalette()).isNull());
}

int main(int argc, char** argv)
{
    return support::openGlMain<TestMainWindow>(argc, argv);
}

#include "tst_main_window.moc"
