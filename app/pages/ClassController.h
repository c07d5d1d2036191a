// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include <QByteArray>
#include <QList>
#include <QObject>
#include <QString>
#include <QTimer>

#include "app/pages/LessonNames.h"
#include "app/school/UserQueries.h"
#include "core/base/Result.h"
#include "database/ClassOverview.h"
#include "database/Person.h"
#include "ui/people/AssignPage.h"
#include "ui/report/Report.h"
#include "ui/window/MainWindow.h"

namespace app {

/// Fills the pages of classes and of their assignments, changes assignments, and prints class reports. Ui thread.
class ClassController final : public QObject
{
    Q_OBJECT

public:
    /// @param lessons  outlives this
    ClassController(ui::window::MainWindow& window, UserQueries queries, LessonNames& lessons);

    /// Another user logs in: nothing that was read for the one before is shown or printed.
    void forget();

signals:
    /// Emitted when the attempts of a student are to be shown: of one lesson or, if it is empty, of all.
    void attemptsRequested(database::PersonId person, const QString& fullName,
                           const std::optional<std::string>& lesson);
    /// Emitted when something cannot be read, and the page keeps what it showed before.
    void readFailed(const core::Error& error);

private:
    void connectPages();
    void connectReports();
    void showLessons();
    void open();
    /// @param then  once they are shown
    void readClasses(const std::function<void()>& then = {});
    void showUnlisted(const core::Error& error);
    void openAssignments();
    using Packs = std::map<std::string, QByteArray>;  ///< of versions, by hash
    void changeAssignments(const QList<ui::people::AssignmentChange>& changes);
    void makeChanges(const QList<ui::people::AssignmentChange>& changes, const Packs& packs);
    void readOverview(database::ClassId ofClass);
    void showUnread(database::ClassId ofClass, const core::Error& error);
    void readResults(const QString& lesson);
    void showResults();
    [[nodiscard]] QString nameOf(qint64 student) const;
    [[nodiscard]] ui::report::ClassReport report() const;
    void withReport(const std::function<void(const ui::report::ClassReport&)>& use);
    void savePdf();
    void print();

    ui::window::MainWindow& m_window;
    UserQueries m_queries;
    LessonNames& m_lessons;
    database::ClassOverview m_overview;
    QList<database::ClassAssignment> m_given;  ///< to that class
    database::LessonResults m_results;
    QTimer m_retry;  ///< until a class that could not be read is read again
};

}  // namespace app
