// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/Page.h"
#include "ui/text/PeopleTexts.h"

class QButtonGroup;
class QStackedWidget;

namespace ui::admin {

class AuditPart;
class BackupPart;
class PeoplePart;
class RosterPart;
class StationPart;

/// What an admin keeps: people, class lists, backups, the audit, this computer.
class AdminPage final : public kit::Page
{
    Q_OBJECT
public:
    AdminPage(const kit::Actions& actions, QWidget* parent);

    enum Part { People, Roster, Backups, Audit, Station };
    [[nodiscard]] Part part() const;
    void show(Part part);
    /// Asks for what the part that is shown is about once more: others work at it, too.
    void readAgain() { emit partOpened(part()); }

    [[nodiscard]] PeoplePart& people() { return *m_people; }
    [[nodiscard]] RosterPart& roster() { return *m_roster; }
    [[nodiscard]] BackupPart& backups() { return *m_backups; }
    [[nodiscard]] AuditPart& audit() { return *m_audit; }
    [[nodiscard]] StationPart& station() { return *m_station; }
    /// Lessons are told by title where a check or the audit names them.
    void setLessonTitles(const text::LessonTitles& titles);

signals:
    /// What it shows is to be brought up to date.
    void partOpened(int part);

private:
    QButtonGroup* m_choice;
    QStackedWidget* m_stack;
    PeoplePart* m_people;
    RosterPart* m_roster;
    BackupPart* m_backups;
    AuditPart* m_audit;
    StationPart* m_station;
};

}  // namespace ui::admin
