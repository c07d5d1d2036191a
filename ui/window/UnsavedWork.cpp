// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/UnsavedWork.h"

#include <utility>

#include <QAction>
#include <QWidget>

#include "ui/kit/Actions.h"
#include "ui/window/FileDialogs.h"

namespace ui::window {

UnsavedWork::UnsavedWork(QWidget& window, const PracticeState& state, FileDialogs& files, const kit::Actions& actions,
                         std::function<bool()> isTrial)
    : QObject(&window), m_window(window), m_state(state), m_files(files), m_actions(actions),
      m_isTrial(std::move(isTrial))
{}

void UnsavedWork::setSaved()
{
    m_saved = m_beingSaved;
    if (const Action what = std::exchange(m_afterSaving, {}))
        what();
}

bool UnsavedWork::wouldLoseWork() const
{
    if (m_state.isExamRefused || (m_isTrial() && !m_state.isReplaying))
        return false;
    const core::terrain::PerMaterial work = m_state.ownWork();
    return work != core::terrain::PerMaterial{} && work != m_saved;
}

bool UnsavedWork::wouldLoseAnything() const
{
    return m_unsavedGrades > 0 || wouldLoseWork() || !m_changes.what().isEmpty();
}

void UnsavedWork::leaveWork(const Action& what)
{
    if (!wouldLoseWork()) {
        what();
        return;
    }
    if (m_state.isExamRunning() && !m_state.isReplaying) {
        ask("workQuestion", {tr("The exam would end without a score."),
                             tr("It still counts as an attempt. Your work cannot be graded later."),
                             tr("&Grade it now"), [this] { emit gradeRequested(); }, what});
        return;
    }
    const auto save = [this, what] {
        m_afterSaving = what;
        askForRecording();
    };
    ask("workQuestion", {tr("Your work would be lost."), tr("Your latest cuts are not saved as a recording."),
                         tr("&Save the recording …"), save, what});
}

void UnsavedWork::leaveChanges(const Action& what, const QString& owner)
{
    const QString unsaved = m_changes.what();
    if (unsaved.isEmpty()) {
        what();
        return;
    }
    // A person who is not the owner must not read what the changes are about.
    const bool isForeign = !owner.isEmpty();
    ask("unsavedQuestion",
        kit::UnsavedChanges::question(isForeign ? QString() : unsaved, owner, [this, what, isForeign] {
            if (isForeign)
                emit foreignChangesLeft();
            m_changes.discard();
            what();
        }));
}

void UnsavedWork::leaveGrades(const Action& what)
{
    if (m_unsavedGrades == 0) {
        what();
        return;
    }
    ask("gradeQuestion", {tr("%n grade(s) are not saved yet and would be lost.", nullptr, m_unsavedGrades),
                          tr("The disk cannot be written to. Cusp tries again every few seconds while it runs. Free "
                             "some disk space, or check the permissions of the folder."),
                          {},
                          {},
                          what});
}

void UnsavedWork::ask(const char* name, const kit::ConfirmOverlay::Question& question)
{
    delete m_question;
    m_question = new kit::ConfirmOverlay(question, &m_window);
    m_question->setObjectName(QLatin1String(name));
}

void UnsavedWork::saveRecording()
{
    forgetAction();
    askForRecording();
}

void UnsavedWork::askForRecording()
{
    m_files.save(m_actions.saveRecording->text(), FileDialogs::Kind::Recording,
                 FileDialogs::newFileName(m_state.tooth->name, FileDialogs::Kind::Recording),
                 [this](const QString& path) {
                     m_beingSaved = m_state.ownWork();
                     emit recordingSaveRequested(path);
                 });
}

}  // namespace ui::window
