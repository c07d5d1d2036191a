// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include <QObject>

#include "app/school/SchoolSession.h"
#include "database/Repositories.h"
#include "lessons/Lesson.h"
#include "ui/window/MainWindow.h"

namespace app {

/// Fills the list of lessons: from the folders of lessons, and from the database with what the user has been assigned
/// and has reached. Opens the folder of the user's own lessons, and unpacks packs into it. Ui thread.
class LessonsController final : public QObject
{
    Q_OBJECT

public:
    /// Both outlive this.
    LessonsController(ui::window::MainWindow& window, const SchoolSession& school);

    /// Returns whether the user has no attempt left at a lesson, by the database's last answer.
    [[nodiscard]] bool isUsedUp(const std::string& lessonId) const;
    /// Forgets the last answer: another user has logged in.
    void forget() { m_fromSchool = {}; }

signals:
    /// Emitted when the list of lessons has been filled.
    void shown();

private:
    void showLessons();
    void fill(bool mayFetch);
    void fetch(const std::vector<std::string>& versions);
    void unpack(const QString& pack, const QString& name);
    void showKnownAttempts(const lessons::Lesson& lesson);
    void openFolder();

    /// What the database says about a user's lessons.
    struct FromSchool
    {
        std::map<std::string, ui::catalog::Standing> standings;
        std::map<std::string, ui::catalog::Given> given;
        std::map<std::string, std::string> versions;  ///< hash of the assigned version, by lesson id
        std::vector<database::Feedback> feedback;
    };
    [[nodiscard]] static FromSchool shownOf(const database::LessonsOfUser& lessons);

    ui::window::MainWindow& m_window;
    const SchoolSession& m_school;
    FromSchool m_fromSchool;  ///< the database's last answer about the user
};

}  // namespace app
