// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QImage>
#include <QList>

#include "database/records.h"
#include "lessons/ScoreSheet.h"
#include "ui/shell/Page.h"

class QBoxLayout;
class QGridLayout;
class QPushButton;

namespace ui::shell {

class HistoryChart;
class PictureFrame;
class ScoreBar;
class TabularLabel;

/// A grade that explains itself: the total, whether it passes, every criterion with its formula worked in numbers, the
/// sum, and the grades before it.
class ScorePage : public Page
{
    Q_OBJECT
public:
    ScorePage(const Actions& actions, QWidget* parent);

    /// @param history  newest first, this attempt included; empty: grades are not kept
    /// @param work     the lesson, or the tooth
    /// @param picture  the tooth as it looks now; may be null
    /// @param expectedTenths  what the student had expected, where that was asked
    void setScore(const QString& work, const lessons::ScoreSheet& sheet, const QList<database::AttemptRecord>& history,
                  const QImage& picture, std::optional<int> expectedTenths);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makeResult();
    QWidget* makeCriteria();
    QWidget* makeHistory();
    /// The result beside what explains it; where there is no room for that, above.
    void arrange(bool beside);
    void fillCriteria(const lessons::ScoreSheet& sheet);
    void fillHistory(const QList<database::AttemptRecord>& history, int total, int passMark);

    QGridLayout* m_cards = nullptr;
    QWidget* m_resultCard = nullptr;
    QBoxLayout* m_result = nullptr;
    QWidget* m_criteriaCard = nullptr;
    QWidget* m_historyCard = nullptr;
    TabularLabel* m_total = nullptr;
    QLabel* m_verdictIcon = nullptr;
    QLabel* m_verdict = nullptr;
    QLabel* m_expected = nullptr;
    QLabel* m_rubric = nullptr;
    ScoreBar* m_bar = nullptr;
    PictureFrame* m_picture = nullptr;
    QWidget* m_criteria = nullptr;
    QVBoxLayout* m_criteriaSlot = nullptr;
    QLabel* m_sum = nullptr;
    QPushButton* m_back = nullptr;
    QLabel* m_remark = nullptr;
    HistoryChart* m_chart = nullptr;
    QWidget* m_list = nullptr;
    QVBoxLayout* m_listSlot = nullptr;
};

}  // namespace ui::shell
