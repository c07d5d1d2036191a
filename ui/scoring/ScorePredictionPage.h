// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "lessons/Rubric.h"
#include "ui/kit/Page.h"
#include "ui/scoring/ScorePrediction.h"

class QButtonGroup;
class QLabel;
class QPushButton;
class QSlider;
class QVBoxLayout;

namespace ui::kit {
class TabularDigitsLabel;
}

namespace ui::scoring {

/// What the student expects, asked before the score is shown, and nothing is said for him: who judges himself learns
/// more than who is told (DentSim, 11 classes: time spent on self-evaluation raises the score in the exam). The points
/// have to be set. What cost most is a choice of at most three criteria, and may be left open.
class ScorePredictionPage final : public kit::Page
{
    Q_OBJECT
public:
    ScorePredictionPage(const kit::Actions& actions, QWidget* parent);

    /// Asks anew.
    void ask(const QString& work, const ::lessons::Rubric& rubric);
    /// What it is called now: in another language.
    void setWork(const QString& work);

signals:
    void answered(const ScorePrediction& expected);

protected:
    void showEvent(QShowEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void retranslateUi();
    void showMissing();

    QString m_work;
    ::lessons::Rubric m_rubric;
    std::vector<::lessons::CriterionRule> m_offered;  ///< those that weigh most
    QLabel* m_mark = nullptr;
    QSlider* m_slider = nullptr;
    kit::TabularDigitsLabel* m_value = nullptr;
    QVBoxLayout* m_criteriaSlot = nullptr;
    QWidget* m_criteria = nullptr;
    QButtonGroup* m_worst = nullptr;
    QLabel* m_missing = nullptr;
    QPushButton* m_show = nullptr;
    bool m_hasPoints = false;  ///< the student has moved the slider
};

}  // namespace ui::scoring
