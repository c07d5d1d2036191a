// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include <QDateTime>
#include <QElapsedTimer>
#include <QList>
#include <QMainWindow>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <glm/mat4x4.hpp>

#include "core/base/Result.h"
#include "core/grading/IdealCavity.h"
#include "core/imaging/Section.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "core/settings/Parameters.h"
#include "database/AttemptRecord.h"
#include "database/Person.h"
#include "lessons/Assignment.h"
#include "ui/catalog/LessonsPage.h"
#include "ui/console/Registration.h"
#include "ui/kit/ConfirmOverlay.h"
#include "ui/kit/MessageBar.h"
#include "ui/kit/UnsavedChanges.h"
#include "ui/lessoneditor/ToleranceSweep.h"
#include "ui/people/LoginMode.h"
#include "ui/practice/HistoryPanel.h"
#include "ui/presets/BlindTrial.h"
#include "ui/replay/AttemptTimeline.h"
#include "ui/scoring/ScorePrediction.h"
#include "ui/scoring/ScoredWork.h"
#include "ui/text/Texts.h"
#include "ui/tooth/ExerciseMarks.h"
#include "ui/tooth/SightNotes.h"
#include "ui/window/ExamClock.h"
#include "ui/window/FileDialogs.h"
#include "ui/window/Tour.h"

class QStackedWidget;

namespace ui::kit {
class Actions;
class BusyOverlay;
}  // namespace ui::kit
namespace ui::lessoneditor {
class LessonEditor;
}
namespace ui::practice {
class ExerciseCard;
class InfractionCard;
class StereoCard;
class ViewMenu;
}  // namespace ui::practice
namespace ui::scoring {
class ScorePredictionPage;
class ScorePage;
}  // namespace ui::scoring
namespace ui::toothchooser {
class ToothChooser;
}

namespace ui::admin {
class AdminPage;
}

namespace ui::devices {
class DevicesPage;
}

namespace ui::people {
class AssignPage;
class ClassPage;
class HistoryPage;
class LoginPage;
}  // namespace ui::people

namespace ui::tooth {
class ToothView;
}

namespace ui::inside {
class XrayPage;
}

namespace ui::console {
class Console;
class WatchPanel;
}  // namespace ui::console

namespace ui::settings {
class SettingsPage;
}

namespace ui::presets {
class PresetsPage;
class TrialCard;
}  // namespace ui::presets

namespace ui::window {

class HelpOverlay;
class IdleLock;
class PracticeRoom;
class AccountMenu;

/// The window: the practice room, and over it the choice of a tooth, the grade, the keys, messages and progress.
///
/// It reads links.session and writes links.commands (Undo, Redo, Reload, SetBur, SetDrill, BringHome); the rest of the
/// links belong to the tooth view. What needs files, the database or another tooth it asks for by its signals.
class MainWindow : public QMainWindow
{
    Q_OBJECT
public:
    /// Sends a command to the session loop. If its queue is full, shows that nothing was done, and returns false.
    bool send(core::session::SessionCommand command);
    /// Whether send() will succeed so many times in a row. Otherwise shows that nothing was done.
    [[nodiscard]] bool canSend(std::size_t commands);

    /// @param links  must outlive the window
    explicit MainWindow(core::session::UiChannels& links, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// The size to begin with on a screen that has so much room for windows.
    [[nodiscard]] static QSize firstSize(const QSize& available);

    /// Whether who works here may change lessons.
    void setMayEdit(bool may);
    [[nodiscard]] tooth::ToothView& view() { return *m_view; }
    [[nodiscard]] catalog::LessonsPage& lessonsPage() { return *m_lessonsPage; }
    [[nodiscard]] scoring::ScorePage& scorePage() { return *m_scorePage; }
    /// Where somebody is, or comes to when the door opens or the tour has ended.
    [[nodiscard]] const QWidget* page() const;
    [[nodiscard]] people::HistoryPage& historyPage() { return *m_history; }
    [[nodiscard]] people::ClassPage& classPage() { return *m_classes; }
    [[nodiscard]] admin::AdminPage& adminPage() { return *m_admin; }
    [[nodiscard]] devices::DevicesPage& devicesPage() { return *m_devicesPage; }
    [[nodiscard]] kit::Actions& actions() { return *m_actions; }
    [[nodiscard]] kit::MessageBar& messages() { return *m_messages; }
    [[nodiscard]] PracticeRoom& room() { return *m_room; }
    [[nodiscard]] bool isInRoom() const;
    /// A question waits for an answer: nothing behind it is done.
    [[nodiscard]] bool isAsking() const { return m_question != nullptr && m_question->isVisible(); }
    [[nodiscard]] people::AssignPage& assignPage() { return *m_assign; }
    /// What showBusy() told of goes on.
    [[nodiscard]] bool isBusy() const;

public slots:
    /// The tooth that is now on the table.
    /// @param notes  what the importer guessed or warned, one sentence each; nothing: it had no doubt
    /// @param unitInDoubt  a unit can be chosen beside the notes
    void showTooth(std::shared_ptr<const core::terrain::ToothAnatomy> tooth, std::uint64_t generation,
                   const std::function<QStringList()>& notes, bool unitInDoubt = false);
    /// Work is going on. It ends with showTooth, showScore or showError.
    void showBusy(const QString& what);
    /// @param file  its path, where there is one
    void showError(const core::Error& error, text::FailedOperation failed, const QString& file = {});
    /// A grade could not be kept. That stands until forgetNotKept(), or until somebody closes it.
    void showNotKept(const core::Error& error);
    /// So many grades, of whomever, are not in the outbox yet: the disk refuses them.
    void setUnkeptGrades(int count);
    void forgetNotKept();
    /// What the school keeps has been asked for, and does not come.
    void showUnanswered();
    /// It answers again: what was said of its silence, and of what could not be read, is over.
    void forgetUnanswered();
    /// What the page that is open shows of the school is asked for once more, and what was said against it forgotten.
    void readAgain();
    /// The same where it shows attempts.
    void readAttemptsAgain();
    /// What could not be read for the page that is shown is there now.
    void forgetUnread();
    /// An attempt is kept on the disk again while it is made, or is over.
    void forgetAttemptNotKept();
    /// What showBusy() told of came to nothing.
    void stopBusy();
    /// The time that a share of the last servo periods stays under, µs; NaN before there are any.
    [[nodiscard]] double periodUs(double share) const { return m_periods.percentileUs(share); }
    void showMessage(const QString& sentence);
    /// As showMessage(), until it is closed.
    void showWarning(const QString& sentence);
    /// With a button that takes back what it tells of.
    void showUndoable(const QString& sentence, const std::function<void()>& undo);
    /// The recording that recordingSaveRequested() asked for is in this file.
    void showSaved(const QString& path);
    /// An attempt was not finished: says so, with a button that takes it up and one that discards it. It stays until
    /// one of them is pressed, or it is closed.
    /// @param tooth  its title
    void offerUnfinished(const std::function<QString()>& tooth, const QDateTime& begun, bool isExam);
    /// It is offered no longer.
    void forgetUnfinished();
    /// It was discarded; a button takes that back.
    void offerToBringBack(const std::function<void()>& bringBack);
    /// @param history  grades of this tooth, newest first, this one included; empty: grades are not kept
    /// @param expected  what the student had said when asked
    /// @param scored  what was marked, for the pictures of it
    void showScore(const lessons::ScoreSheet& sheet, const QList<database::AttemptRecord>& history,
                   const std::optional<scoring::ScorePrediction>& expected = {},
                   const std::optional<scoring::ScoredWork>& scored = {});
    /// The attempt that showScore() was about is kept with its recording: as it was graded, nothing of it can be lost.
    void showWorkKept();
    /// It is not kept: who has logged in for it had no attempt left.
    void showOverLimit();
    /// A rule of the lesson has been broken, in practice: the bur stops, and the student chooses.
    void tellInfraction(const core::grading::Infraction& infraction, bool canTakeBack);
    /// How the exercise of the student's lesson has gone so far.
    void showPractised(const core::grading::Practised& practised);
    /// Asks what the student expects; forecastGiven() answers.
    void askForecast();
    /// The lesson that the tooth shown next is for; none: practised freely.
    void setAssignment(const lessons::Assignment& assignment);
    /// The attempt at it is one that is gone on with: so long it was recorded, and the clock stands there, s.
    void resumeClock(double recordedS, double workedS);
    /// The student's lesson is an exam, and has not been graded yet.
    [[nodiscard]] bool isExamRunning() const;
    [[nodiscard]] bool isReplaying() const { return m_replaying; }
    /// Shows the states of other channels: those of a replay, or the own ones again. Commands still go to the own ones.
    /// @param channels  must outlive the window
    void showChannels(core::session::UiChannels& channels);
    /// Nothing is cut any more in the exam on the table; in practice nothing.
    void endExam();
    [[nodiscard]] bool isExamOver() const { return m_examIsOver; }
    /// It counts as nothing: the student's last attempt at it was begun elsewhere.
    void refuseExam();
    /// The handpieces of the attempt that is shown next, in the order of its settings.
    void setHandpieces(const std::vector<core::settings::Handpiece>& atHand);
    /// Bur and handpiece (an index, as of SetHandpiece) that an attempt was left with.
    void takeInHand(std::optional<std::uint8_t> bur, std::optional<std::uint8_t> handpiece);
    /// The page where a lesson is chosen.
    void openLessons();
    /// Where the day of who is logged in begins: a student's lessons, a teacher's classes, an admin's school.
    void openHome();
    void setLessons(std::vector<lessons::CatalogEntry> entries, std::map<std::string, catalog::Standing> standings,
                    std::map<std::string, catalog::Given> given = {});
    /// What teachers have said of the attempts of who works here, newest first.
    void setFeedback(const std::vector<database::Feedback>& feedback);
    /// What is on the shelf of hardness presets, and which of it teeth feel like.
    void setPresets(std::vector<lessons::ReadPreset> all, const core::settings::FeelPreset& inUse);
    /// Sets who works here, and whether they may save presets and choose which is in use. Otherwise they can only view
    /// and try them.
    void setMayKeepPresets(const database::Login& who, bool may);
    /// presetSaveRequested(), or a file that was imported, has become this version: shown on the page, and said.
    /// @param note  what deserves a look all the same; may be empty
    void showPresetKept(const core::settings::FeelPreset& preset, const QString& note = {});
    /// What could not be done, on the page of presets.
    void showPresetFault(const QString& sentence);
    /// The block that presetTrialRequested() asked for is on the table.
    void beginTrial();
    /// What the tooth on the table feels like, and what it would if nobody had turned anything.
    void showFeel(const core::settings::FeelPreset& now, const core::settings::FeelPreset& usual);
    /// Opens the editor on a sound lesson.
    void editLesson(const lessons::ReadLesson& lesson);
    /// The folder in which the unsaved lessons of each user survive a crash.
    void setRecoveryFolder(const QString& folder) { m_recoveryFolder = folder; }
    /// What was measured of attempts at the lesson that is edited, as it is.
    void setKnownAttempts(std::vector<lessoneditor::MeasuredAttempt> attempts);
    /// A recording of this length drives the bur: the student's own controls rest, the student's own work waits. Call
    /// it before the tooth is shown that goes with it.
    /// @param ideal  what was to be cut; null: nothing
    /// @param lesson  that it was made for; nothing: practised freely
    /// @param whose   who made it, and when; empty: that is not known
    void setReplaying(bool replaying, double lengthS = 0.0, core::grading::IdealTop ideal = {},
                      std::optional<lessons::Lesson> lesson = {}, const QString& whose = {});
    /// How the attempt went that is played, as far as it is known; again when more of it is.
    void setReplayCourse(const replay::AttemptTimeline& course);
    /// What people have remarked of its moments; again when that is another. A replay begins without.
    void setRemarks(std::vector<replay::Remark> remarks);
    /// Another attempt is shown beside the one that is played, from the same side: the tooth of `links`.
    /// @param links  must outlive it: until hideBeside()
    void showBeside(core::session::UiChannels& links, const std::shared_ptr<const core::terrain::ToothAnatomy>& tooth,
                    std::uint64_t generation, const core::grading::IdealTop& ideal, const QString& name);
    /// Answers besidesRequested(): attempts to choose from, beside a file; none: a file is asked for at once.
    void offerBeside(const QList<kit::MessageBar::Choice>& attempts);
    void setBesideCourse(const replay::AttemptTimeline& course);
    void hideBeside();
    /// The hand is led no longer: it has pushed, or the device is lost.
    void showLeadEnd(bool pushed);
    /// The replay is held, or goes on, without having been asked to here.
    void showReplayPaused(bool paused);
    /// The recording has come to its end, where it is held.
    void showReplayEnd();
    /// Where the undo history is asked for.
    void setHistorySource(practice::HistorySource source);
    /// Somebody is to log in, to create the school, or to come back. Nothing else can be done meanwhile but practising
    /// without a login where the door offers that.
    void askWho(people::LoginMode door);
    /// Somebody is to log in; where nobody is entered yet, to create the school.
    void askLogin() { askWho(m_isNewSchool ? people::LoginMode::Welcome : people::LoginMode::Login); }
    /// Asks for a login to keep a guest's grade. The person may also say that the grade is not theirs.
    void askLoginToKeep();
    [[nodiscard]] bool keepsOnLogin() const;
    void setNewSchool(bool isNew) { m_isNewSchool = isNew; }
    [[nodiscard]] bool isNewSchool() const { return m_isNewSchool; }
    /// Opens the page of attempts, or that of classes.
    void openHistory();
    void openClasses();
    /// The page where lessons are given to a class.
    void openAssign();
    /// Another attempt than the one on the table, with its score card.
    /// @param work  its lesson, or its tooth
    void showOldScore(std::function<QString()> work, const lessons::ScoreSheet& sheet,
                      const QList<database::AttemptRecord>& history,
                      const std::optional<scoring::ScorePrediction>& expected,
                      const std::optional<scoring::ScoredWork>& scored);
    /// The score card again that was left for its replay.
    void backToScore();
    /// To the list of attempts, as it was left.
    void backToHistory();
    /// Who works here now.
    void setWho(const database::Login& who);
    /// Who is logged in and touches nothing for so long finds the place locked; the drill at work counts as a touch.
    void setIdleLimit(std::chrono::milliseconds limit);
    /// Somebody else will work here: nothing that was said to the one before stays to be read.
    void leaveAll();
    /// Beside what is typed there, until somebody is asked anew.
    /// @param sentence  in the language of the moment
    void sayAtDoor(std::function<QString()> sentence);
    /// Shows who works here round; tourEnded() follows.
    void beginTour();
    /// Is somebody asked to log in?
    [[nodiscard]] bool isAtDoor() const;
    /// What was typed at the door is wrong.
    void refuseLogin(const core::Error& error);
    /// The database is being opened: nobody can be let in meanwhile.
    void setOpening(bool isOpening);
    /// The database cannot be used, and why; nothing: it can.
    /// @param where       its file, or its server
    /// @param backupMade  when the backup was that can be put in its place; invalid: there is none
    void setUnreachable(const std::optional<core::Error>& error, const QString& where, const QDateTime& backupMade);
    /// Whether the simulated handpiece drills every tooth that is shown from now on. The window says so beside its
    /// name.
    void setSelfDrilling(bool isOn) { m_selfDrilling = isOn; }
    /// Whether the device has a work area and a force, so that the user can ask to be led home over the tooth.
    void offerHome(bool canLead);
    /// Does `what`, which puts the student's work away for good. If that is not saved as it stands, asks first.
    void leaveWork(const std::function<void()>& what);
    /// What the lesson allows; all of it to begin with. What it does not is put away and rests.
    void setAids(const lessons::Aids& aids);
    /// No attempt at the lesson on the table is left after the one that was graded: it is not begun again.
    void setUsedUp(bool usedUp);
    /// attemptAgainRequested() was followed.
    void showBegunAnew();

signals:
    /// The tour was seen, or skipped.
    void tourEnded();
    void loginRequested(const QString& username, const QString& password);
    void codeRequested(const QString& username, const QString& code, const QString& newPassword);
    void schoolRequested(const database::NewPerson& admin, const QString& password);
    /// One's own attempts are to be seen.
    void attemptsRequested();
    void classesRequested();
    /// Who is logged in wants another password; setWho() or refuseLogin() answers.
    void passwordChangeRequested(const QString& old, const QString& newPassword);
    /// Practice without an account.
    void guestRequested();
    /// The database that cannot be used is to be tried again, or its backup to be put in its place.
    void openAgainRequested();
    void restoreRequested();
    /// The grade that is shown shall be kept as that of whoever logs in now.
    void keepRequested();
    /// What was said of this attempt is to be read; 0: there are several.
    void feedbackRequested(qint64 attempt);
    /// The user leaves for somebody else; they have been asked about what would be lost.
    void logoutRequested();
    void toothChosen(int fdi);
    void lessonChosen(const lessons::Lesson& lesson);
    /// The lesson on the table is to begin anew, as another attempt.
    void attemptAgainRequested();
    /// The tooth is to be put back to before this tick of the attempt.
    void takeBackRequested(std::uint64_t tick);
    /// The page of lessons opens: what it shows is to be brought up to date.
    void lessonsRequested();
    void lessonFolderRequested();
    /// The page of hardness presets opens: setPresets() is wanted.
    void presetsRequested();
    /// To be kept as another version of its name.
    void presetSaveRequested(const core::settings::FeelPreset& preset);
    void presetUseRequested(const core::settings::FeelPreset& preset);
    void presetImportRequested(const QString& path);
    void presetRetireRequested(const QString& name, bool isRetired);
    void presetExportRequested(const core::settings::FeelPreset& preset, const QString& path);
    /// A block to try this preset on is to be laid on the table; beginTrial() answers.
    void presetTrialRequested(const core::settings::FeelPreset& preset);
    /// What the block on which a preset is tried is made of from now on; presetFelt() follows.
    void trialBlockChosen(const core::settings::ToothKind& kind);
    /// What is on the table is to feel like this from now on, in the middle of whatever is done.
    void presetFelt(const core::settings::FeelPreset& preset);
    /// The same by hand, in the console or the settings: this tooth and those after it, but exams.
    void feelRequested(const core::settings::FeelPreset& preset);
    /// A lesson of a pack is to be edited: the pack is to be unpacked into the teacher's folder, and the lesson of that
    /// name there given to editLesson().
    void unpackRequested(const QString& pack, const QString& name);
    /// A lesson is edited: what is known of attempts at it is wanted, for setKnownAttempts().
    void knownAttemptsRequested(const lessons::Lesson& lesson);
    /// The attempt that was graded last is to be seen from this moment on, s since its beginning.
    void momentRequested(double seconds);
    /// @param worst  the criterion expected to cost most, by id; empty: none
    void forecastGiven(const ui::scoring::ScorePrediction& expected);
    void scanChosen(const QString& path);
    /// The scan on the table is to be read again in this unit: "mm", "cm" or "m".
    void scanUnitChosen(const QString& unit);
    void recordingSaveRequested(const QString& path);
    /// The tooth as it is cut is to be kept as a captured ideal; showMessage() or showError() answers.
    void referenceSaveRequested(const QString& path);
    void recordingOpenRequested(const QString& path);
    void gradeRequested();
    /// What offerUnfinished() has offered; work that would be lost has been asked about.
    void resumeRequested();
    void discardRequested();
    void replayStopRequested();
    /// This moment of what is played is seen in the practice room, s since its beginning.
    void replayShown(double seconds);
    /// Whether a force shall hold the hand within what is to be cut. Off with every new tooth.
    void fixtureRequested(bool wanted);
    void replayPauseRequested(bool paused);
    /// So many times as fast as the recording was made, 0.1 to 16. Every replay begins with 1.
    void replaySpeedChosen(double times);
    /// The replay is to show this moment of the recording.
    void seekRequested(double seconds);
    /// Another attempt is to be put beside what is played: which there are.
    /// @param lesson  that it was made for; empty: practised freely
    void besidesRequested(const std::string& lesson, const std::string& tooth);
    void besideRequested(const QString& path);
    void besideCloseRequested();
    /// The recording that the lesson names: to be played, or to be put beside what is played.
    void expertRequested();
    /// The device is to lead the hand along what is played, or to let it go.
    void leadRequested(bool on);

protected:
    void closeEvent(QCloseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    /// What was asked of the servo and is believed until it answers, or until it has had time to.
    struct Wish
    {
        int value = 0;
        QElapsedTimer since;
    };

    void retranslateUi();
    void sayTooth();
    void tellError(const core::Error& error, text::FailedOperation failed, const QString& file,
                   kit::MessageBar::Topic topic);
    kit::MessageBar::Message noteOfScan(const QStringList& notes, bool unitInDoubt);
    void recallLayout();
    void connectActions();
    void connectView();
    void takeFrame(const core::servo::ServoState& servo);
    void takeSession();
    void tellAids();
    void tellRest();
    void guide(const core::servo::ServoState& servo);
    void tellHarm(const core::session::SessionState& now);
    void wishDrill(bool on);
    void wishBur(int index);
    void wishHandpiece(int shipped);
    void goTo(QWidget* page);
    void focusRoom();
    void goBack();
    void leavePage();
    [[nodiscard]] QWidget* pageBehind() const;
    void sayWayBack();
    /// What the student has cut off the present tooth; all zero on a whole one.
    [[nodiscard]] core::terrain::PerMaterial ownWork() const;
    [[nodiscard]] bool wouldLoseWork() const;
    void leaveGrades(const std::function<void()>& what);
    /// Asks whether to discard unsaved changes before `what` is done, if there are any.
    void leaveUnsaved(const std::function<void()>& what);
    [[nodiscard]] bool isAtLockedDoor() const;
    void connectDoor();
    void connectTour();
    [[nodiscard]] QWidget* tourPage(Tour::Where where) const;
    void showAccount();
    void changePassword();
    void changeAccount();
    void tellUnreachable();
    void resumeUnfinished();
    void discardUnfinished();
    void tellUnfinished();
    void lockIfIdle();
    void closeAllOver();
    /// Whether something is saved or discarded; cancelled, nothing happens.
    /// @param name  for tests
    void ask(const char* name, const kit::ConfirmOverlay::Question& question);
    void askToSave();
    void connectReplay();
    void lookAlike();
    /// Says a sentence about the replay, with a button that stops it.
    void offerToStop(const QString& sentence);
    void enableActions();
    void placeOverlays();
    [[nodiscard]] const lessons::Lesson* lessonShown() const;
    [[nodiscard]] QString workTitle() const;
    void editChosenLesson();
    void showIdeal();
    void layExercise();
    void markExercise();
    void showRemarks();
    [[nodiscard]] bool isBlindfolded() const;
    void showHistory();
    void restBur();
    void startAgain();
    void runClock();
    void endTime();
    [[nodiscard]] bool isExam() const;
    [[nodiscard]] replay::AttemptTimeline asMayBeTold(replay::AttemptTimeline course) const;
    [[nodiscard]] std::pair<std::vector<tooth::PointMark>, std::vector<tooth::PointMark>> replayedPoints() const;
    void setDrillFor(lessons::Task task);
    void toggleXray();
    void connectPresets();
    void connectConsole();
    void registerParameters();
    [[nodiscard]] std::string feelByHand(const core::settings::FeelPreset& wanted);
    [[nodiscard]] QString newFileName(FileDialogs::Kind kind) const;
    void openFile(const QString& path);

    core::session::UiChannels& m_links;
    core::session::UiChannels* m_shown;  ///< m_links, or the channels of a replay
    tooth::SightNotes m_sights{m_links};
    kit::Actions* m_actions;
    bool m_mayEdit = true;
    practice::ViewMenu* m_viewMenu;
    AccountMenu* m_accountMenu;
    tooth::ToothView* m_view;
    QStackedWidget* m_pages;
    PracticeRoom* m_room;
    toothchooser::ToothChooser* m_chooser;
    scoring::ScorePage* m_scorePage;
    catalog::LessonsPage* m_lessonsPage;
    QPointer<kit::ConfirmOverlay> m_question;
    people::LoginPage* m_login;
    people::HistoryPage* m_history;
    people::ClassPage* m_classes;
    people::AssignPage* m_assign;
    admin::AdminPage* m_admin;
    database::Login m_who;
    std::optional<core::Error> m_unreachable;  ///< why the database cannot be used
    QString m_where;                           ///< the database
    lessoneditor::LessonEditor* m_editor;
    scoring::ScorePredictionPage* m_forecast;
    presets::PresetsPage* m_presets;
    presets::TrialCard* m_trialCard;
    core::settings::Parameters m_parameters;
    console::PeriodMeter m_periods;
    console::WatchPanel* m_watch;
    console::Console* m_console;
    settings::SettingsPage* m_settingsPage = nullptr;
    devices::DevicesPage* m_devicesPage;
    core::settings::FeelPreset m_feel;       ///< of what lies on the table
    core::settings::FeelPreset m_usualFeel;  ///< of it, if nobody had turned anything
    core::servo::ServoState m_servo;         ///< of the last frame
    inside::XrayPage* m_xray;
    kit::MessageBar* m_messages;
    kit::BusyOverlay* m_busy;
    kit::UnsavedChanges m_unsaved;
    QString m_recoveryFolder;
    HelpOverlay* m_help;
    Tour* m_tour;
    QWidget* m_beforeTour = nullptr;  ///< the page where it began
    practice::StereoCard* m_stereoCard;
    practice::InfractionCard* m_infractionCard;
    practice::ExerciseCard* m_exerciseCard;
    FileDialogs* m_files;
    IdleLock* m_idle;
    ExamClock m_clock;  ///< of the student's attempt

    std::shared_ptr<const core::terrain::ToothAnatomy> m_tooth;
    std::uint64_t m_ownGeneration = 0;              ///< of the student's tooth
    core::terrain::PerMaterial m_workAtRest{};      ///< while a recording is played: what waits
    core::terrain::PerMaterial m_workBeingSaved{};  ///< what had been cut when saving was asked for
    core::terrain::PerMaterial m_workGraded{};      ///< what had been cut when it was graded
    core::terrain::PerMaterial m_savedWork{};       ///< what had been cut when it was last saved
    std::function<void()> m_afterSaving;            ///< what waits for the work to be saved
    core::session::SessionState m_session;
    std::optional<core::imaging::PulpChamber> m_pulp;  ///< of m_tooth
    core::grading::IdealTop m_ideal;                   ///< what the lesson asks for of it; null: nothing
    core::grading::IdealTop m_replayIdeal;             ///< the same of the recording that is played
    std::optional<lessons::Lesson> m_replayLesson;     ///< that it was made for
    QString m_replayWhose;                             ///< who made it, and when
    replay::AttemptTimeline m_replayCourse;
    std::vector<replay::Remark> m_remarked;  ///< of the moment that is shown
    replay::AttemptTimeline m_besideCourse;  ///< of the one beside it
    /// The version, and what is made of it, for which a block has been asked.
    std::optional<std::pair<core::settings::FeelPreset, core::settings::FeelPreset>> m_triedPreset;
    std::optional<presets::BlindTrial> m_blindTrial;  ///< in place of it
    lessons::Aids m_aids;
    std::optional<lessons::Assignment> m_assignment;      ///< of the student's tooth
    std::pair<std::uint64_t, std::uint8_t> m_aidsTold{};  ///< of which tooth
    std::pair<std::uint64_t, bool> m_restTold{};          ///< the same
    Wish m_drillWish;
    Wish m_burWish;
    Wish m_handpieceWish;
    std::vector<int> m_handpieces;  ///< at hand, as indices into core::settings::handpieces(); -1: not one of those
    QElapsedTimer m_sinceGuide;
    std::uint64_t m_exerciseGeneration = 0;  ///< of the tooth that m_exerciseCard is about
    std::optional<core::grading::Touched> m_touched;
    bool m_drillWasOn = false;           ///< before what it rests for: an exercise, an exam that is over
    bool m_infractionStopped = false;    ///< the bur turned when it was told
    std::uint64_t m_infractionTick = 0;  ///< of the one that is told
    bool m_isGraded = false;             ///< the student's work has been, as it stood
    bool m_examIsOver = false;           ///< nothing can be cut any more
    bool m_examIsRefused = false;        ///< and what was cut counts as nothing
    bool m_isUsedUp = false;             ///< no other attempt can begin
    QElapsedTimer m_sinceDiscard;        ///< of an unfinished attempt
    bool m_isUnfinishedExam = false;     ///< that offerUnfinished() has offered
    std::function<kit::MessageBar::Message()> m_offerUnfinished;
    bool m_burRests = false;               ///< while another page is read
    const QWidget* m_askedFrom = nullptr;  ///< the page on which work was begun that is waited for
    bool m_standsIn = false;               ///< the next tooth is not the one that was wanted
    bool m_replaying = false;
    bool m_replayPaused = false;
    bool m_canLead = false;                ///< the device can lead a hand
    tooth::ToothView* m_beside = nullptr;  ///< while there is another attempt beside
    glm::dmat4 m_sharedLook{1.0};          ///< from where both looked last
    bool m_selfDrilling = false;
    QWidget* m_behindScore = nullptr;    ///< the page from which the score card was opened
    QWidget* m_behindHistory = nullptr;  ///< the same of the attempts
    QWidget* m_behindDoor = nullptr;     ///< the page to go on with
    bool m_isNewSchool = false;
    bool m_mayLeaveDoor = false;  ///< who practises as a guest, and has only looked at it
    bool m_mayClose = false;
    int m_unkeptGrades = 0;
    bool m_isGuestGone = false;  ///< nobody has touched anything for long since the guest's work was graded
    bool m_hasCut = false;
    bool m_knowsTheFarSide = false;  ///< has been told why nothing is drilled from below
};

}  // namespace ui::window
