// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/LessonEditing.h"

#include <utility>

#include <QAction>
#include <QFileInfo>
#include <QSet>

#include "lessons/LessonCatalog.h"
#include "ui/catalog/LessonsPage.h"
#include "ui/kit/Actions.h"
#include "ui/lessoneditor/LessonEditor.h"
#include "ui/window/Navigation.h"
#include "ui/window/Notices.h"

namespace ui::window {

LessonEditing::LessonEditing(const PracticeState& state, catalog::LessonsPage& page, lessoneditor::LessonEditor& editor,
                             kit::Actions& actions, Navigation& navigation, Notices& notices)
    : QObject(&editor), m_state(state), m_page(page), m_editor(editor), m_actions(actions), m_navigation(navigation),
      m_notices(notices)
{
    connect(m_actions.editLesson, &QAction::triggered, this, &LessonEditing::editSelected);
    connect(&m_editor, &lessoneditor::LessonEditor::stepsChanged, this, &LessonEditing::changed);
}

void LessonEditing::setAllowed(bool allowed, const database::Login& user)
{
    m_isAllowed = allowed;
    m_actions.editLesson->setVisible(allowed);
    m_page.setMayEdit(allowed);
    if (allowed && !m_recoveryFolder.isEmpty())
        m_editor.recover(
            lessons::teachersFolder(),
            QStringLiteral("%1/unsaved-lessons-%2.json")
                .arg(m_recoveryFolder, user.isGuest() ? QStringLiteral("guest") : QString::fromStdString(user.uid())));
    showUnsaved();
    emit changed();
}

void LessonEditing::showUnsaved()
{
    m_page.setUnsaved(m_isAllowed ? m_editor.unsavedFiles() : QSet<QString>());
}

void LessonEditing::setKnownAttempts(std::vector<lessoneditor::MeasuredAttempt> attempts)
{
    m_editor.setKnown(std::move(attempts));
}

void LessonEditing::editSelected()
{
    if (m_state.isExamRunning()) {
        m_notices.say(tr("The lesson editor is not available during an exam, because it shows the ideal. Press G to "
                         "finish the exam, or start another lesson."));
        return;
    }
    const lessons::CatalogEntry* const entry = m_page.chosen();
    if (entry == nullptr)  // no lesson matches the search, which the page shows
        return;
    if (!entry->read.lesson)
        m_notices.say(tr("This file is not a valid lesson, so it cannot be edited. Fix the listed errors first."));
    else if (entry->pack.isEmpty())
        edit(entry->read);
    else
        emit unpackRequested(entry->pack, QFileInfo(entry->read.file).fileName());
}

void LessonEditing::edit(const lessons::ReadLesson& lesson)
{
    if (!m_isAllowed) {
        m_notices.say(
            tr("Only teachers can edit lessons: log in as a teacher. To practise the lesson, choose it in the list."));
        return;
    }
    m_editor.edit(lesson, lessons::teachersFolder());
    emit knownAttemptsRequested(*lesson.lesson);
    m_navigation.goTo(m_editor);
}

}  // namespace ui::window
