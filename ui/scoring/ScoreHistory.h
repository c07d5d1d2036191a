// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QFrame>
#include <QList>
#include <QString>

#include "database/AttemptRecord.h"
#include "lessons/ClassStanding.h"
#include "lessons/ScoreSheet.h"

class QLabel;
class QPushButton;

namespace ui::charts {
class SaveButton;
struct Chart;
}  // namespace ui::charts

namespace ui::scoring {

class RecentScoresChart;

/// The card with the attempts before this one: a chart, the newest of them, what becomes of this grade, and where it
/// stands in the class.
class ScoreHistory final : public QFrame
{
    Q_OBJECT
public:
    explicit ScoreHistory(QWidget* parent);

    /// @param history  newest first, this attempt included
    /// @param sheet    the score of this attempt
    /// @param of       whose attempts, at what: the title of the chart in a file
    void setHistory(const QList<database::AttemptRecord>& history, const ::lessons::ScoreSheet& sheet,
                    const QString& of);
    /// Sets where the score stands among those of a class. Empty: nothing is shown about it.
    void setClass(const std::optional<::lessons::ClassStanding>& standing);
    /// What becomes of the grade that is shown.
    enum class Keeping {
        Nowhere,  ///< there is no database
        Refused,  ///< by the disk: it is tried again as long as the program runs
        Guest,    ///< nobody is logged in: keepRequested() is offered
        Pending,  ///< it is being kept
        Waiting,  ///< on this computer, until the database can be reached
        Kept
    };
    void setKeeping(Keeping keeping);

signals:
    /// Emitted when a guest wants to log in, so that the grade is saved as theirs.
    void keepRequested();
    /// Emitted when the chart has been saved or could not be saved.
    void told(const QString& sentence);

private:
    [[nodiscard]] charts::Chart chart() const;
    void tellHistory();
    void tellClass();
    void tellKeeping();

    QList<database::AttemptRecord> m_history;
    ::lessons::ScoreSheet m_sheet;
    QString m_of;
    std::optional<::lessons::ClassStanding> m_standing;
    Keeping m_keeping = Keeping::Nowhere;
    QLabel* m_remark = nullptr;
    QPushButton* m_keep = nullptr;
    RecentScoresChart* m_chart = nullptr;
    charts::SaveButton* m_saveChart = nullptr;
    QWidget* m_list = nullptr;
    QWidget* m_listHolder = nullptr;
    QLabel* m_class = nullptr;
};

}  // namespace ui::scoring
