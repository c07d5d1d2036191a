// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include <QFrame>

#include "core/grading/Exercise.h"
#include "core/servo/ServoState.h"

class QAction;
class QButtonGroup;
class QLabel;
class QPushButton;

namespace ui::kit {
class TabularDigitsLabel;
}

namespace ui::practice {

class HoldGauge;

/// Beneath the tooth while an exercise of the first minutes goes on: how far it has come, the force against its band,
/// or the choice of a tissue for each pad. When all is done it says so and offers the grade. Low and wide, so that the
/// tooth keeps its room.
class ExerciseCard final : public QFrame
{
    Q_OBJECT
public:
    /// @param grade  what its button does
    ExerciseCard(QAction* grade, QWidget* parent);

    /// Begins with nothing done.
    void begin(const core::grading::Exercise& exercise);
    /// What the examiner has seen so far.
    void setPractised(const core::grading::Practised& practised);
    [[nodiscard]] const core::grading::Practised& practised() const { return m_practised; }
    /// Once a frame.
    void setServo(const core::servo::ServoState& servo);
    /// It has been graded: choices rest, and the right ones are told.
    void conclude();
    [[nodiscard]] bool isConcluded() const { return m_isConcluded; }

signals:
    void answered(std::size_t pad, core::terrain::Material said);

private:
    QWidget* makeHold();
    QWidget* makeChoices();
    void sayTruth();
    void showProgress();
    void showAdvice();

    core::grading::Exercise m_exercise;
    core::grading::Practised m_practised;
    bool m_drillIsOn = false;
    bool m_isConcluded = false;
    bool m_hasChosen = false;  ///< in this window; then what it shows is not to be put right
    QLabel* m_title = nullptr;
    QLabel* m_advice = nullptr;
    QWidget* m_hold = nullptr;
    HoldGauge* m_gauge = nullptr;
    kit::TabularDigitsLabel* m_force = nullptr;
    kit::TabularDigitsLabel* m_time = nullptr;
    QWidget* m_choices = nullptr;
    std::array<QButtonGroup*, core::grading::kPads> m_pads{};
    std::array<QLabel*, core::grading::kPads> m_truth{};
    QPushButton* m_grade = nullptr;
};

/// "Left", "Middle", "Right".
[[nodiscard]] QString padName(std::size_t pad);

}  // namespace ui::practice
