// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lessons/Rubric.h"
#include "ui/shell/Page.h"

class QButtonGroup;
class QLabel;
class QPushButton;
class QSlider;
class QVBoxLayout;

namespace ui::shell {
class TabularLabel;
}

namespace ui::study {

/// What the student expects, asked before the score is shown: who judges himself learns more than who is told
/// (DentSim, 11 classes: time spent on self-evaluation raises the score in the exam).
class Forecast final : public shell::Page
{
    Q_OBJECT
public:
    Forecast(const shell::Actions& actions, QWidget* parent);

    /// Asks anew.
    void ask(const QString& work, const ::lessons::Rubric& rubric);

signals:
    /// @param worst  id of the criterion that is expected to cost most; empty: none
    void answered(int expectedTenths, const QString& worst);

protected:
    void showEvent(QShowEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QLabel* m_mark = nullptr;
    QSlider* m_slider = nullptr;
    shell::TabularLabel* m_value = nullptr;
    QVBoxLayout* m_criteriaSlot = nullptr;
    QWidget* m_criteria = nullptr;
    QButtonGroup* m_worst = nullptr;
    QPushButton* m_show = nullptr;
};

}  // namespace ui::study
