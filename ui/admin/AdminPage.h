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

/// The pages of the school's admin: people, class lists, backups, the audit log and this computer.
class AdminPage final : public kit::Page
{
    Q_OBJECT
public:
    AdminPage(const kit::Actions& actions, QWidget* parent);

    enum Part { People, Roster, Backups, Audit, Station };
    [[nodiscard]] Part part() const;
    void show(Part part);
    /// Requests the data of the current part again, because other users may have changed them.
    void readAgain() { emit partOpened(part()); }

    [[nodiscard]] PeoplePart& people() { return *m_people; }
    [[nodiscard]] RosterPart& roster() { return *m_roster; }
    [[nodiscard]] BackupPart& backups() { return *m_backups; }
    [[nodiscard]] AuditPart& audit() { return *m_audit; }
    [[nodiscard]] StationPart& station() { return *m_station; }
    /// Sets the lesson titles for integrity checks and the audit log.
    void setLessonTitles(const text::LessonTitles& titles);

signals:
    /// Emitted when the data of a part must be read.
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
