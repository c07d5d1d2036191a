// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include <QObject>
#include <QString>

#include "app/school/SchoolAccess.h"
#include "database/AttemptRecord.h"
#include "ui/report/Report.h"
#include "ui/window/MainWindow.h"

namespace app {

/// Saves the score card that is shown as a PDF or prints it, with the history and comments from the database. Ui
/// thread.
class ReportController final : public QObject
{
    Q_OBJECT

public:
    /// The attempt of the card on the score page.
    struct Subject
    {
        database::AttemptRecord attempt;
        QString person;        ///< full name; empty: a guest
        database::Login by;    ///< who prints or saves it
        SchoolAccess* school;  ///< whose database holds the attempt; null: none does
    };
    /// @param subject  returns the attempt; empty: no card is shown
    ReportController(ui::window::MainWindow& window, std::function<std::optional<Subject>()> subject);

private:
    void save();
    void print();
    void withCard(const std::function<void(const ui::scoring::ScoreCard&)>& use);
    [[nodiscard]] QString titleOf(const ui::scoring::ScoreCard& card) const;

    ui::window::MainWindow& m_window;
    std::function<std::optional<Subject>()> m_subject;
};

}  // namespace app
