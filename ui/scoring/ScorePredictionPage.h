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

/// Asks the student for the expected score before the score is shown. There is no default, because self-assessment
/// improves learning (DentSim, 11 classes: time spent on self-evaluation raises the score in the exam). The points are
/// required. The criterion expected to cost most is optional and chosen from at most three.
class ScorePredictionPage final : public kit::Page
{
    Q_OBJECT
public:
    ScorePredictionPage(const kit::Actions& actions, QWidget* parent);

    /// Starts with an empty form.
    void ask(const QString& work, const ::lessons::Rubric& rubric);
    /// Sets the name of the work, in the current language.
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
    std::vector<::lessons::CriterionRule> m_offered;  ///< the criteria with the highest weights
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
