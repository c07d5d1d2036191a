// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QObject>
#include <QString>

#include "database/Person.h"
#include "lessons/LessonReader.h"
#include "ui/lessoneditor/ToleranceSweep.h"
#include "ui/window/PracticeState.h"

namespace ui::catalog {
class LessonsPage;
}
namespace ui::kit {
class Actions;
}
namespace ui::lessoneditor {
class LessonEditor;
}

namespace ui::window {

class Navigation;
class Notices;

/// Opens lessons in the lesson editor, if the user may change them.
class LessonEditing final : public QObject
{
    Q_OBJECT
public:
    LessonEditing(const PracticeState& state, catalog::LessonsPage& page, lessoneditor::LessonEditor& editor,
                  kit::Actions& actions, Navigation& navigation, Notices& notices);

    /// Sets whether the user may change lessons, and recovers the user's unsaved lessons.
    void setAllowed(bool allowed, const database::Login& user);
    [[nodiscard]] bool isAllowed() const { return m_isAllowed; }
    /// Sets the folder for the unsaved lessons of each user.
    void setRecoveryFolder(const QString& folder) { m_recoveryFolder = folder; }
    /// Opens a valid lesson in the editor.
    void edit(const lessons::ReadLesson& lesson);
    /// Sets the measures of known attempts at the lesson that is edited.
    void setKnownAttempts(std::vector<lessoneditor::MeasuredAttempt> attempts);
    /// Opens the lesson that is selected on the page of lessons.
    void editSelected();
    /// Marks the lessons with unsaved changes on the page of lessons.
    void showUnsaved();

signals:
    /// Emitted when a lesson is opened. The receiver calls setKnownAttempts().
    void knownAttemptsRequested(const lessons::Lesson& lesson);
    /// Emitted when the user requests to edit a lesson of a pack. The receiver unpacks the pack first.
    void unpackRequested(const QString& pack, const QString& name);
    /// Emitted when actions need an update.
    void changed();

private:
    const PracticeState& m_state;
    catalog::LessonsPage& m_page;
    lessoneditor::LessonEditor& m_editor;
    kit::Actions& m_actions;
    Navigation& m_navigation;
    Notices& m_notices;
    QString m_recoveryFolder;
    bool m_isAllowed = true;
};

}  // namespace ui::window
