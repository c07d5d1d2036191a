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

/// The card with earlier attempts: a chart, the newest attempts, whether this grade is saved, and its rank in the
/// class.
class ScoreHistory final : public QFrame
{
    Q_OBJECT
public:
    explicit ScoreHistory(QWidget* parent);

    /// @param history  newest first, including this attempt
    /// @param sheet    the score of this attempt
    /// @param of       the student and the lesson: the title of an exported chart
    void setHistory(const QList<database::AttemptRecord>& history, const ::lessons::ScoreSheet& sheet,
                    const QString& of);
    /// Sets the rank of the score within a class. Empty: no rank is shown.
    void setClass(const std::optional<::lessons::ClassStanding>& standing);
    /// Whether the shown grade is saved.
    enum class Keeping {
        Nowhere,  ///< there is no database
        Refused,  ///< the disk refused it; the program retries while it runs
        Guest,    ///< no user is logged in, so keepRequested() is offered
        Pending,  ///< it is being saved
        Waiting,  ///< on this computer until the database can be reached
        Kept
    };
    void setKeeping(Keeping keeping);

signals:
    /// Emitted when a guest wants to log in, so that the grade is saved as theirs.
    void keepRequested();
    /// Emitted when the chart has been exported, or the export has failed.
    void told(const QString& sentence);

private:
    [[nodiscard]] charts::Chart chart() const;
    void updateHistory();
    void updateClass();
    void updateKeeping();

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
