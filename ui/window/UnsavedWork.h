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

/// Asks before something is lost that is not saved: the student's work on the tooth, changes on pages, and grades.
class UnsavedWork final : public QObject
{
    Q_OBJECT
public:
    using Action = std::function<void()>;

    /// @param window   gets the questions
    /// @param isTrial  returns whether a block is shown to try a preset; its work is never saved
    UnsavedWork(QWidget& window, const PracticeState& state, FileDialogs& files, const kit::Actions& actions,
                std::function<bool()> isTrial);

    /// Pages whose changes are asked about.
    [[nodiscard]] kit::UnsavedChanges& changes() { return m_changes; }
    void setUnsavedGrades(int count) { m_unsavedGrades = count; }

    /// A new tooth is shown: nothing of it is saved or lost.
    void begin() { m_saved = {}; }
    /// The work as it is now has a grade.
    void setGraded() { m_graded = m_state.ownWork(); }
    [[nodiscard]] bool isAsGraded() const { return m_state.ownWork() == m_graded; }
    /// The database has the graded attempt with its recording.
    void setGradedSaved() { m_saved = m_graded; }
    /// The recording is written that recordingSaveRequested() asked for. Goes on with the action that waited for it.
    void setSaved();

    /// Returns whether leaveWork() would ask.
    [[nodiscard]] bool wouldLoseWork() const;
    /// Returns whether anything would be lost if the program were closed now.
    [[nodiscard]] bool wouldLoseAnything() const;
    /// Does what discards the student's work. Asks first if the work is not saved.
    void leaveWork(const Action& what);
    /// Does what discards changes on pages. Asks first if there are any.
    /// @param owner  full name of the user who made them, if somebody else may answer; empty: the user's own
    void leaveChanges(const Action& what, const QString& owner);
    /// Does what stops further attempts to save grades. Asks first if there are unsaved grades.
    void leaveGrades(const Action& what);
    /// Asks where to save the recording of the student's work.
    void saveRecording();
    /// Forgets the action that waits for the work to be saved.
    void forgetAction() { m_afterSaving = {}; }
    /// Shows a question over the window, in place of the one before.
    /// @param name  for tests
    void ask(const char* name, const kit::ConfirmOverlay::Question& question);
    [[nodiscard]] bool isAsking() const { return m_question != nullptr && m_question->isVisible(); }

signals:
    /// Emitted when the student would rather have the exam graded.
    void gradeRequested();
    void recordingSaveRequested(const QString& path);
    /// Emitted before changes are discarded by somebody who did not make them.
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
    // Removed volumes stand for the work: as it was when it was saved, graded, and when saving began.
    core::terrain::PerMaterial m_saved{};
    core::terrain::PerMaterial m_graded{};
    core::terrain::PerMaterial m_beingSaved{};
};

}  // namespace ui::window
