// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QObject>
#include <QPointer>

#include "core/terrain/Tooth.h"
#include "ui/kit/ConfirmOverlay.h"
#include "ui/kit/UnsavedChanges.h"
#include "ui/window/PracticeState.h"

namespace ui::kit {
class Actions;
}

namespace ui::window {

class FileDialogs;

/// Asks the user before unsaved data is lost: the student's work on the tooth, changes on pages, and grades.
class UnsavedWork final : public QObject
{
    Q_OBJECT
public:
    using Action = std::function<void()>;

    /// @param window   shows the questions
    /// @param isTrial  returns whether the tooth is a block for the trial of a preset, whose work is never saved
    UnsavedWork(QWidget& window, const PracticeState& state, FileDialogs& files, const kit::Actions& actions,
                std::function<bool()> isTrial);

    /// Returns the unsaved changes of the pages.
    [[nodiscard]] kit::UnsavedChanges& changes() { return m_changes; }
    void setUnsavedGrades(int count) { m_unsavedGrades = count; }

    /// Starts with a new tooth, of which no work is saved.
    void begin() { m_saved = {}; }
    /// Marks the present work as graded.
    void setGraded() { m_graded = m_state.ownWork(); }
    /// Returns whether nothing has been cut since setGraded().
    [[nodiscard]] bool isAsGraded() const { return m_state.ownWork() == m_graded; }
    /// Marks the graded work as saved. Call it when the outbox or the database has the attempt with its recording.
    void setGradedSaved() { m_saved = m_graded; }
    /// Marks the work as saved, and calls the action that waits for that. Call it when the recording of
    /// recordingSaveRequested() has been written.
    void setSaved();

    /// Returns whether leaveWork() would ask.
    [[nodiscard]] bool wouldLoseWork() const;
    /// Returns whether closing the program now would lose unsaved data.
    [[nodiscard]] bool wouldLoseAnything() const;
    /// Calls an action that discards the student's work. If the work is not saved, asks the user first.
    void leaveWork(const Action& what);
    /// Calls an action that discards changes on pages. If there are any, asks the user first.
    /// @param owner  full name of the user who made the changes, if another person may answer; otherwise empty
    void leaveChanges(const Action& what, const QString& owner);
    /// Calls an action after which unsaved grades are not saved any more. If there are any, asks the user first.
    void leaveGrades(const Action& what);
    /// Asks where to save the recording of the student's work.
    void saveRecording();
    /// Forgets the action that waits for the work to be saved.
    void forgetAction() { m_afterSaving = {}; }
    /// Shows a question over the window. Replaces the question before.
    /// @param name  object name, for tests
    void ask(const char* name, const kit::ConfirmOverlay::Question& question);
    [[nodiscard]] bool isAsking() const { return m_question != nullptr && m_question->isVisible(); }

signals:
    /// Emitted when the student answers a question by having the exam graded.
    void gradeRequested();
    void recordingSaveRequested(const QString& path);
    /// Emitted before a person discards changes that another user has made.
    void foreignChangesLeft();

private:
    void askForRecording();

    QWidget& m_window;
    const PracticeState& m_state;
    FileDialogs& m_files;
    const kit::Actions& m_actions;
    std::function<bool()> m_isTrial;
    kit::UnsavedChanges m_changes;
    QPointer<kit::ConfirmOverlay> m_question;
    Action m_afterSaving;
    int m_unsavedGrades = 0;
    // The removed volumes identify the state of the work: when it was saved, when it was graded, and when saving began.
    core::terrain::PerMaterial m_saved{};
    core::terrain::PerMaterial m_graded{};
    core::terrain::PerMaterial m_beingSaved{};
};

}  // namespace ui::window
