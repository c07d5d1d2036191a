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
    [[nodiscard]] LessonEditing& lessonEditing() { return *m_editing; }
    [[nodiscard]] ExerciseView& exerciseView() { return *m_exercise; }
    [[nodiscard]] BurControl& burControl() { return m_bur; }

    /// Returns the user's page: the one that is shown, or opens after the login or the tour.
    [[nodiscard]] const QWidget* page() const { return m_navigation->userPage(); }
    [[nodiscard]] bool isInRoom() const;
    /// Returns whether the operation announced by showBusy() is running.
    [[nodiscard]] bool isBusy() const;
    [[nodiscard]] bool isExamRunning() const { return m_state.isExamRunning(); }
    [[nodiscard]] bool isExamOver() const { return m_state.isExam() && m_state.isOver; }
    [[nodiscard]] bool isReplaying() const { return m_state.isReplaying; }
    /// Shows the states of other channels: those of a replay, or the own ones again. Commands still go to the own ones.
    /// @param channels  must outlive the window
    void showChannels(core::session::UiChannels& channels);
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
    void setHandpieces(const std::vector<core::settings::Handpiece>& atHand);
    /// Asks which score the student expects.
    void askPrediction();
    /// Shows the score of the current attempt.
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
    void showOverLimit();
    void setHistorySource(practice::HistorySource source);
    /// Tells whether a simulated hand drills every tooth from now on.
    void setSelfDrilling(bool isOn) { m_isSelfDrilling = isOn; }
    /// Tells whether the device can lead the hand.
    void offerHome(bool canLead);
    void beginTrial();

    // The replay; see ReplayView.

    void setReplaying(bool replaying, double lengthS = 0.0, core::grading::IdealTop ideal = {},
                      std::optional<lessons::Lesson> lesson = {}, const QString& whose = {});
    void showBeside(core::session::UiChannels& links, const std::shared_ptr<const core::terrain::ToothAnatomy>& tooth,
                    std::uint64_t generation, const core::grading::IdealTop& ideal, const QString& name);

    // Messages and questions.

    /// Announces an operation. showTooth(), showBeside(), askPrediction(), showScore(), showOldScore(), showError() and
    /// stopBusy() end it.
    void showBusy(const QString& what);
    void stopBusy();
    /// Shows an error, and ends the operation announced by showBusy().
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
    /// Shows that a grade could not be saved, until hideGradeNotSaved(). An operation announced by showBusy() goes on.
    void showGradeNotSaved(const core::Error& error) { m_notices.showGradeNotSaved(error); }
    void hideGradeNotSaved() { m_messages->withdraw(kit::MessageBar::Topic::Keeping); }
    /// The school's database does not answer.
    void showDatabaseSilent();
    /// It answers again.
    void hideDatabaseSilent() { m_messages->withdraw(kit::MessageBar::Topic::School); }
    /// Reads again what the page shows of the database.
    void readAgain();
    /// The same if the page shows attempts.
    void readAttemptsAgain();
    /// What could not be read for the page has been read.
    void hideReadError() { m_messages->withdraw(kit::MessageBar::Topic::Page); }
    /// Shows that the attempt cannot be written to the disk while the student works. An announced operation goes on.
    void showJournalError(const core::Error& error, text::FailedOperation failed)
    {
        m_notices.showError(error, failed, {});
    }
    /// The attempt is written to the disk again, or is over.
    void hideJournalError() { m_messages->withdraw(kit::MessageBar::Topic::Journal); }

    // The user; see AccountController.

    /// Tells whether the user may change lessons.
    void setMayEdit(bool may) { m_editing->setAllowed(may, m_account->user()); }
    /// Opens the user's first page: a student's lessons, a teacher's classes, an admin's school.
    void openHome();
    void setWho(const database::Login& who);
    /// Another user comes: forgets pages and messages of the one before.
    void leaveAll();
    void beginTour();

signals:
    void toothChosen(int fdi);
    void lessonChosen(const lessons::Lesson& lesson);
    void scanChosen(const QString& path);
    /// Emitted when the scan shall be read again in this unit: "mm", "cm" or "m".
    void scanUnitChosen(const QString& unit);
    void recordingOpenRequested(const QString& path);
    void replayStopRequested();
    void gradeRequested();
    /// Emitted when the tooth shall be saved as a captured ideal.
    void referenceSaveRequested(const QString& path);
    /// Emitted when the page of lessons has to be filled; LessonsPage::setLessons() answers.
    void lessonsRequested();

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
