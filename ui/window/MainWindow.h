// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QList>
#include <QMainWindow>
#include <QString>
#include <QStringList>

#include "core/base/Result.h"
#include "core/grading/IdealCavity.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "core/settings/FeelPreset.h"
#include "database/AttemptRecord.h"
#include "database/Person.h"
#include "lessons/Assignment.h"
#include "ui/catalog/LessonsPage.h"
#include "ui/kit/MessageBar.h"
#include "ui/lessoneditor/ToleranceSweep.h"
#include "ui/people/LoginMode.h"
#include "ui/practice/HistoryPanel.h"
#include "ui/replay/AttemptTimeline.h"
#include "ui/scoring/ScorePrediction.h"
#include "ui/scoring/ScoredWork.h"
#include "ui/text/Texts.h"
#include "ui/window/AccountController.h"
#include "ui/window/AttemptNotes.h"
#include "ui/window/BurControl.h"
#include "ui/window/CommandSender.h"
#include "ui/window/ConsoleView.h"
#include "ui/window/ExerciseView.h"
#include "ui/window/FileDialogs.h"
#include "ui/window/HardnessController.h"
#include "ui/window/InfractionView.h"
#include "ui/window/LessonController.h"
#include "ui/window/LessonEditing.h"
#include "ui/window/Navigation.h"
#include "ui/window/Notices.h"
#include "ui/window/PracticeController.h"
#include "ui/window/PracticeState.h"
#include "ui/window/ReplayView.h"
#include "ui/window/ResumeOffer.h"
#include "ui/window/UnsavedWork.h"
#include "ui/window/WindowLayout.h"

class QStackedWidget;

namespace ui::admin {
class AdminPage;
}
namespace ui::devices {
class DevicesPage;
}
namespace ui::inside {
class XrayPage;
}
namespace ui::kit {
class Actions;
class BusyOverlay;
}  // namespace ui::kit
namespace ui::lessoneditor {
class LessonEditor;
}
namespace ui::people {
class AssignPage;
class ClassPage;
class HistoryPage;
}  // namespace ui::people
namespace ui::practice {
class StereoCard;
class ViewMenu;
}  // namespace ui::practice
namespace ui::scoring {
class ScorePage;
class ScorePredictionPage;
}  // namespace ui::scoring
namespace ui::settings {
class SettingsPage;
}
namespace ui::tooth {
class ToothView;
}
namespace ui::toothchooser {
class ToothChooser;
}

namespace ui::window {

class HelpOverlay;
class PracticeRoom;

/// The window: its pages, menus and messages, and the parts that control them.
///
/// The parts read links.session and write links.commands. The rest of the links belongs to the tooth view. What needs
/// files, the database or another tooth is requested by signals.
class MainWindow : public QMainWindow
{
    Q_OBJECT
public:
    /// @param links  must outlive the window
    explicit MainWindow(core::session::UiChannels& links, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Returns the size to begin with on a screen with so much room for windows.
    [[nodiscard]] static QSize firstSize(const QSize& available);

    // The parts, and the pages that others fill.
    [[nodiscard]] tooth::ToothView& view() { return *m_view; }
    [[nodiscard]] PracticeRoom& room() { return *m_room; }
    [[nodiscard]] kit::Actions& actions() { return *m_actions; }
    [[nodiscard]] kit::MessageBar& messages() { return *m_messages; }
    [[nodiscard]] catalog::LessonsPage& lessonsPage() { return *m_lessonsPage; }
    [[nodiscard]] scoring::ScorePage& scorePage() { return *m_scorePage; }
    [[nodiscard]] scoring::ScorePredictionPage& predictionPage() { return *m_prediction; }
    [[nodiscard]] people::HistoryPage& historyPage() { return *m_history; }
    [[nodiscard]] people::ClassPage& classPage() { return *m_classes; }
    [[nodiscard]] people::AssignPage& assignPage() { return *m_assign; }
    [[nodiscard]] people::LoginPage& loginPage() { return *m_login; }
    [[nodiscard]] admin::AdminPage& adminPage() { return *m_admin; }
    [[nodiscard]] devices::DevicesPage& devicesPage() { return *m_devicesPage; }
    [[nodiscard]] Navigation& navigation() { return *m_navigation; }
    [[nodiscard]] ReplayView& replayView() { return *m_replay; }
    [[nodiscard]] HardnessController& hardness() { return *m_hardness; }
    [[nodiscard]] InfractionView& infractionView() { return *m_infraction; }
    [[nodiscard]] LessonController& lessonController() { return *m_lesson; }
    [[nodiscard]] AccountController& account() { return *m_account; }
    [[nodiscard]] UnsavedWork& unsavedWork() { return *m_unsaved; }
    [[nodiscard]] ResumeOffer& resumeOffer() { return *m_resume; }

    /// Returns the user's page: the one that is shown, or opens after the login or the tour.
    [[nodiscard]] const QWidget* page() const { return m_navigation->userPage(); }
    [[nodiscard]] bool isInRoom() const;
    /// Returns whether a question waits for an answer. Nothing behind it can be used.
    [[nodiscard]] bool isAsking() const { return m_unsaved->isAsking(); }
    /// Returns whether the operation announced by showBusy() is running.
    [[nodiscard]] bool isBusy() const;
    [[nodiscard]] bool isExamRunning() const { return m_state.isExamRunning(); }
    [[nodiscard]] bool isExamOver() const { return m_state.isExamOver; }
    [[nodiscard]] bool isReplaying() const { return m_state.isReplaying; }
    /// Shows the states of other channels: those of a replay, or the own ones again. Commands still go to the own ones.
    /// @param channels  must outlive the window
    void showChannels(core::session::UiChannels& channels);
    [[nodiscard]] bool isAtDoor() const { return m_navigation->isAtLogin(); }
    [[nodiscard]] bool isNewSchool() const { return m_account->isNewSchool(); }
    [[nodiscard]] bool keepsOnLogin() const { return m_account->keepsOnLogin(); }
    /// Returns the time that a share of the last servo periods stays under, µs; NaN before there are any.
    [[nodiscard]] double periodUs(double share) const { return m_console->periods().percentileUs(share); }
    /// See CommandSender.
    bool send(core::session::SessionCommand command) { return m_commands.send(std::move(command)); }
    [[nodiscard]] bool canSend(std::size_t commands) { return m_commands.canSend(commands); }

public slots:
    // The tooth and the attempt.

    /// Shows a tooth in the room.
    /// @param notes        what the importer guessed or warned of, one sentence each; null: nothing
    /// @param unitInDoubt  the user may choose another unit
    void showTooth(std::shared_ptr<const core::terrain::ToothAnatomy> tooth, std::uint64_t generation,
                   const std::function<QStringList()>& notes, bool unitInDoubt = false);
    /// Begins an attempt at a lesson, or free practice. Its tooth is shown next.
    void setAssignment(const lessons::Assignment& assignment);
    /// The attempt that was begun continues one that was interrupted. Times in seconds.
    void resumeClock(double recordedS, double workedS) { m_lesson->resumeClock(recordedS, workedS); }
    void takeInHand(std::optional<std::uint8_t> bur, std::optional<std::uint8_t> handpiece)
    {
        m_bur.resume(bur, handpiece);
    }
    void setHandpieces(const std::vector<core::settings::Handpiece>& atHand);
    /// Sets the aids that the lesson allows.
    void setAids(const lessons::Aids& aids) { m_lesson->setAids(aids); }
    void setUsedUp(bool usedUp) { m_lesson->setUsedUp(usedUp); }
    void endExam() { m_lesson->endExam(); }
    void refuseExam() { m_lesson->refuseExam(); }
    void showBegunAnew() { m_lesson->showBegunAgain(); }
    void tellInfraction(const core::grading::Infraction& infraction, bool canTakeBack)
    {
        m_infraction->show(infraction, canTakeBack);
    }
    void showPractised(const core::grading::Practised& practised) { m_exercise->setPractised(practised); }
    /// Asks which score the student expects.
    void askForecast();
    /// @param history   scores of this tooth, newest first, including this one; empty: none are stored
    /// @param expected  the student's prediction
    /// @param scored    the work, for its pictures
    void showScore(const lessons::ScoreSheet& sheet, const QList<database::AttemptRecord>& history,
                   const std::optional<scoring::ScorePrediction>& expected = {},
                   const std::optional<scoring::ScoredWork>& scored = {});
    /// Shows the score of an earlier attempt.
    /// @param work  title of its lesson or tooth
    void showOldScore(std::function<QString()> work, const lessons::ScoreSheet& sheet,
                      const QList<database::AttemptRecord>& history,
                      const std::optional<scoring::ScorePrediction>& expected,
                      const std::optional<scoring::ScoredWork>& scored);
    /// The database has the graded attempt with its recording.
    void showWorkKept() { m_unsaved->setGradedSaved(); }
    void showOverLimit();
    void setHistorySource(practice::HistorySource source);
    /// Tells whether a simulated hand drills every tooth from now on.
    void setSelfDrilling(bool isOn) { m_isSelfDrilling = isOn; }
    /// Tells whether the device can lead the hand.
    void offerHome(bool canLead);
    void showFeel(const core::settings::FeelPreset& now, const core::settings::FeelPreset& usual)
    {
        m_hardness->setFeel(now, usual);
    }
    void beginTrial();

    // The replay; see ReplayView.

    void setReplaying(bool replaying, double lengthS = 0.0, core::grading::IdealTop ideal = {},
                      std::optional<lessons::Lesson> lesson = {}, const QString& whose = {});
    void setReplayCourse(const replay::AttemptTimeline& course) { m_replay->setCourse(course); }
    void setRemarks(std::vector<replay::Remark> remarks) { m_replay->setRemarks(std::move(remarks)); }
    void showBeside(core::session::UiChannels& links, const std::shared_ptr<const core::terrain::ToothAnatomy>& tooth,
                    std::uint64_t generation, const core::grading::IdealTop& ideal, const QString& name);
    void offerBeside(const QList<kit::MessageBar::Choice>& attempts) { m_replay->offerBeside(attempts); }
    void setBesideCourse(const replay::AttemptTimeline& course) { m_replay->setBesideCourse(course); }
    void hideBeside() { m_replay->hideBeside(); }
    void showLeadEnd(bool pushed) { m_replay->showLeadEnd(pushed); }
    void showReplayEnd() { m_replay->showEnd(); }

    // Messages and questions.

    /// Announces an operation. showTooth(), showScore(), showError() and stopBusy() end it.
    void showBusy(const QString& what);
    void stopBusy();
    /// @param file  path of the file that failed; empty: none
    void showError(const core::Error& error, text::FailedOperation failed, const QString& file = {});
    void showMessage(const QString& sentence) { m_notices.say(sentence); }
    void showWarning(const QString& sentence) { m_notices.warn(sentence); }
    void showUndoable(const QString& sentence, const std::function<void()>& undo)
    {
        m_notices.sayUndoable(sentence, undo);
    }
    /// The recording that recordingSaveRequested() asked for is in this file.
    void showSaved(const QString& path);
    /// A grade could not be saved. The message stays until forgetNotKept().
    void showNotKept(const core::Error& error);
    void forgetNotKept() { m_messages->withdraw(kit::MessageBar::Topic::Keeping); }
    /// Sets the number of grades, of all users, that the disk refuses.
    void setUnkeptGrades(int count) { m_unsaved->setUnsavedGrades(count); }
    /// The school's database does not answer.
    void showUnanswered();
    /// It answers again.
    void forgetUnanswered() { m_messages->withdraw(kit::MessageBar::Topic::School); }
    /// Reads again what the page shows of the database.
    void readAgain();
    /// The same if the page shows attempts.
    void readAttemptsAgain();
    /// What could not be read for the page has been read.
    void forgetUnread() { m_messages->withdraw(kit::MessageBar::Topic::Page); }
    /// The attempt is written to the disk again, or is over.
    void forgetAttemptNotKept() { m_messages->withdraw(kit::MessageBar::Topic::Journal); }
    /// See ResumeOffer.
    void offerUnfinished(const std::function<QString()>& title, const QDateTime& begun, bool isExam)
    {
        m_resume->offer(title, begun, isExam);
    }
    void forgetUnfinished() { m_resume->forget(); }
    void offerToBringBack(const std::function<void()>& restore) { m_resume->offerToRestore(restore); }
    /// Does what discards the student's work. Asks first if the work is not saved.
    void leaveWork(const std::function<void()>& what) { m_unsaved->leaveWork(what); }

    // Lessons and presets.

    void openLessons() { m_navigation->openLessons(); }
    void setLessons(std::vector<lessons::CatalogEntry> entries, std::map<std::string, catalog::Standing> standings,
                    std::map<std::string, catalog::Given> given = {})
    {
        m_lessonsPage->setLessons(std::move(entries), std::move(standings), std::move(given));
    }
    /// Sets what teachers have said of the user's attempts, newest first.
    void setFeedback(const std::vector<database::Feedback>& feedback) { m_lessonsPage->setFeedback(feedback); }
    /// Tells whether the user may change lessons.
    void setMayEdit(bool may) { m_editing->setAllowed(may, m_account->user()); }
    /// Sets the folder for the unsaved lessons of each user.
    void setRecoveryFolder(const QString& folder) { m_editing->setRecoveryFolder(folder); }
    /// Opens the editor on a valid lesson.
    void editLesson(const lessons::ReadLesson& lesson) { m_editing->edit(lesson); }
    /// Sets the measures of known attempts at the lesson in the editor.
    void setKnownAttempts(std::vector<lessoneditor::MeasuredAttempt> attempts)
    {
        m_editing->setKnownAttempts(std::move(attempts));
    }
    /// See HardnessController.
    void setPresets(std::vector<lessons::ReadPreset> all, const core::settings::FeelPreset& inUse)
    {
        m_hardness->setPresets(std::move(all), inUse);
    }
    void setMayKeepPresets(const database::Login& who, bool may) { m_hardness->setMayKeep(who, may); }
    void showPresetKept(const core::settings::FeelPreset& preset, const QString& note = {})
    {
        m_hardness->showSaved(preset, note);
    }
    void showPresetFault(const QString& sentence) { m_hardness->showFault(sentence); }

    // The user; see AccountController.

    /// Opens the user's first page: a student's lessons, a teacher's classes, an admin's school.
    void openHome();
    void openHistory() { m_navigation->openHistory(); }
    void openClasses() { m_navigation->openClasses(); }
    void openAssign() { m_navigation->openAssign(); }
    void backToScore() { m_navigation->openScore(); }
    void backToHistory() { m_navigation->goBackToHistory(); }
    void setWho(const database::Login& who);
    /// Another user comes: forgets pages and messages of the one before.
    void leaveAll();
    void askWho(people::LoginMode mode) { m_account->ask(mode); }
    void askLogin() { m_account->askLogin(); }
    void askLoginToKeep() { m_account->askLoginToKeep(); }
    void setNewSchool(bool isNew) { m_account->setNewSchool(isNew); }
    void refuseLogin(const core::Error& error) { m_account->refuse(error); }
    void setOpening(bool isOpening) { m_account->setOpening(isOpening); }
    void setUnreachable(const std::optional<core::Error>& error, const QString& where, const QDateTime& backupMade)
    {
        m_account->setUnreachable(error, where, backupMade);
    }
    void sayAtDoor(std::function<QString()> sentence) { m_account->say(std::move(sentence)); }
    void setIdleLimit(std::chrono::milliseconds limit) { m_account->idleLock().setLimit(limit); }
    void beginTour();

signals:
    // The user and the database.
    void loginRequested(const QString& username, const QString& password);
    void codeRequested(const QString& username, const QString& code, const QString& newPassword);
    /// Emitted when the first user of a school shall be created.
    void schoolRequested(const database::NewPerson& admin, const QString& password);
    /// setWho() or refuseLogin() answers.
    void passwordChangeRequested(const QString& old, const QString& newPassword);
    void guestRequested();
    /// Emitted when the user lets somebody else log in, and has answered for what would be lost.
    void logoutRequested();
    /// Emitted when the database that cannot be used shall be opened again.
    void openAgainRequested();
    /// Emitted when the backup shall replace that database.
    void restoreRequested();
    /// Emitted when the score that is shown shall be saved for whoever logs in next.
    void keepRequested();

    // The next tooth.
    void toothChosen(int fdi);
    void lessonChosen(const lessons::Lesson& lesson);
    void scanChosen(const QString& path);
    /// Emitted when the scan shall be read again in this unit: "mm", "cm" or "m".
    void scanUnitChosen(const QString& unit);
    void recordingOpenRequested(const QString& path);
    /// Emitted when the recording of the lesson's author shall be played, or shown beside.
    void expertRequested();
    /// Emitted when another attempt shall be shown beside the replay.
    void besideRequested(const QString& path);
    void replayStopRequested();
    /// Emitted when the attempt with the score that is shown shall be replayed from a moment, s since its beginning.
    void momentRequested(double seconds);
    /// Emitted when the attempt shall begin again as another one.
    void attemptAgainRequested();
    void resumeRequested();
    void discardRequested();

    // The attempt.
    /// Emitted when the tooth shall be restored to the time before a tick of the attempt.
    void takeBackRequested(std::uint64_t tick);
    /// Emitted when a force shall hold the hand within the ideal, or no longer. Off with each new tooth.
    void fixtureRequested(bool wanted);
    void gradeRequested();
    void forecastGiven(const ui::scoring::ScorePrediction& expected);
    void recordingSaveRequested(const QString& path);
    /// Emitted when the tooth shall be saved as a captured ideal.
    void referenceSaveRequested(const QString& path);

    // Lessons and presets.
    /// Emitted when the page of lessons opens; setLessons() answers.
    void lessonsRequested();
    void lessonFolderRequested();
    /// See LessonEditing.
    void unpackRequested(const QString& pack, const QString& name);
    void knownAttemptsRequested(const lessons::Lesson& lesson);
    /// See HardnessController.
    void presetTrialRequested(const core::settings::FeelPreset& preset);
    void trialBlockChosen(const core::settings::ToothKind& kind);
    void presetFelt(const core::settings::FeelPreset& preset);
    void feelRequested(const core::settings::FeelPreset& preset);

protected:
    void closeEvent(QCloseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void addPages();
    void makeParts();
    void connectActions();
    void connectFileActions();
    void connectPageActions();
    void connectPages();
    void connectParts();
    void connectView();
    void retranslateUi();
    void refresh();
    void placeOverlays();
    void showPage();
    void focusRoom();
    void goBack();
    void goBackInRoom();
    void step(bool undo);
    void search();
    void toggleXray();
    void showTitle();
    void openFile(const QString& path);
    [[nodiscard]] QString newFileName(FileDialogs::Kind kind) const;

    core::session::UiChannels& m_links;
    PracticeState m_state;
    kit::Actions* m_actions;
    practice::ViewMenu* m_viewMenu;
    tooth::ToothView* m_view;
    QStackedWidget* m_pages;
    PracticeRoom* m_room;
    toothchooser::ToothChooser* m_chooser;
    scoring::ScorePage* m_scorePage;
    catalog::LessonsPage* m_lessonsPage;
    people::LoginPage* m_login;
    people::HistoryPage* m_history;
    people::ClassPage* m_classes;
    people::AssignPage* m_assign;
    admin::AdminPage* m_admin;
    lessoneditor::LessonEditor* m_editor;
    scoring::ScorePredictionPage* m_prediction;
    presets::PresetsPage* m_presets;
    settings::SettingsPage* m_settingsPage = nullptr;
    devices::DevicesPage* m_devicesPage;
    inside::XrayPage* m_xray;
    kit::MessageBar* m_messages;
    kit::BusyOverlay* m_busy;
    HelpOverlay* m_help;
    Tour* m_tour;
    practice::StereoCard* m_stereoCard;

    // The parts go before the widgets that they control.
    Notices m_notices;
    CommandSender m_commands;
    BurControl m_bur;
    std::unique_ptr<WindowLayout> m_layout;
    std::unique_ptr<ConsoleView> m_console;
    std::unique_ptr<FileDialogs> m_files;
    std::unique_ptr<Navigation> m_navigation;
    std::unique_ptr<UnsavedWork> m_unsaved;
    std::unique_ptr<AccountController> m_account;
    std::unique_ptr<ResumeOffer> m_resume;
    std::unique_ptr<ReplayView> m_replay;
    std::unique_ptr<ExerciseView> m_exercise;
    std::unique_ptr<InfractionView> m_infraction;
    std::unique_ptr<LessonController> m_lesson;
    std::unique_ptr<AttemptNotes> m_notes;
    std::unique_ptr<PracticeController> m_practice;
    std::unique_ptr<HardnessController> m_hardness;
    std::unique_ptr<LessonEditing> m_editing;

    const QWidget* m_askedFrom = nullptr;  ///< the page on which the running operation was begun
    bool m_canLead = false;
    bool m_isSelfDrilling = false;
    bool m_isStandIn = false;     ///< the next tooth is shown in place of one that failed
    bool m_knowsFarSide = false;  ///< the user was told why nothing is drilled from below
    bool m_mayClose = false;
};

}  // namespace ui::window
