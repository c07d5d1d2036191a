// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include <QObject>
#include <QString>

#include "app/school/SchoolService.h"
#include "database/AttemptRecord.h"
#include "ui/report/Report.h"
#include "ui/window/MainWindow.h"

namespace app {

/// Puts the score card that is shown into a PDF or on paper, with what the database knows of its attempt. Ui thread.
class ReportController final : public QObject
{
    Q_OBJECT

public:
    /// What the card on the score page is about.
    struct Subject
    {
        database::AttemptRecord attempt;
        QString person;       ///< full name; empty: a guest
        database::Login by;   ///< who wants it
        SchoolService* desk;  ///< whose database has the attempt; null: none has
    };
    /// @param subject  nothing: no card is shown
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
