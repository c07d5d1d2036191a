// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QObject>
#include <QString>

#include "app/SchoolDesk.h"
#include "core/recording/Recording.h"
#include "database/overview.h"
#include "database/records.h"
#include "ui/people/PeopleWords.h"
#include "ui/report/Report.h"
#include "ui/shell/MainWindow.h"

namespace app {

/// Fills the pages of attempts and classes from the school's data, and opens what is chosen there. Ui thread.
class PeopleDesk final : public QObject
{
    Q_OBJECT

public:
    /// @param who  works here now
    PeopleDesk(ui::shell::MainWindow& window, SchoolDesk& desk, std::function<database::Session()> who);

    /// An attempt that is kept has been opened: what people say of it is shown, and asked for. Nothing: another one is
    /// on the page.
    void talkAbout(const std::optional<database::AttemptRecord>& attempt);

signals:
    /// This recording is to be played.
    void replayWanted(const core::recording::Recording& recording);
    /// This attempt's score card is to be shown.
    void scoreWanted(const database::AttemptRecord& attempt, const core::recording::Recording& recording);

private:
    void openHistory(database::PersonId person, const QString& fullName, const std::optional<std::string>& lesson);
    void tellClassAt(const QString& lesson);
    void openClasses();
    void tellOverview(database::ClassId ofClass);
    void tellResults(const QString& lesson);
    void fetch(qint64 attempt,
               const std::function<void(const database::AttemptRecord&, const core::recording::Recording&)>& use);
    void refuse(const core::Error& error);
    void connectTalk();
    void tellTalk();
    template <class Work>
    void sayInTalk(Work work);
    void connectReport();
    void withReport(const std::function<void(const ui::report::ClassReport&)>& use);

    ui::shell::MainWindow& m_window;
    SchoolDesk& m_desk;
    std::function<database::Session()> m_who;
    database::PersonId m_person;  ///< whose attempts are shown
    database::ClassOverview m_overview;
    database::LessonResults m_results;
    std::optional<database::AttemptRecord> m_talkedAbout;
    struct Known
    {
        int passMarkTenths = 0;
        std::map<std::string, QString> criteria;
    };
    std::map<std::string, Known> m_lessons;  ///< by id
    ui::people::LessonTitles m_titles;
};

}  // namespace app
