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

/// A card below the tooth during an introductory exercise. It shows the progress, the force in relation to its band, or
/// the choice of a tissue for each pad. When the exercise is complete, it offers grading. The card is low and wide, so
/// that it does not cover the tooth.
class ExerciseCard final : public QFrame
{
    Q_OBJECT
public:
    /// @param grade  the action of its button
    ExerciseCard(QAction* grade, QWidget* parent);

    /// Starts an exercise with no progress.
    void begin(const core::grading::Exercise& exercise);
    /// Shows the progress as measured by the examiner.
    void setPractised(const core::grading::Practised& practised);
    [[nodiscard]] const core::grading::Practised& practised() const { return m_practised; }
    /// Updates the force and the drill. Call once per frame.
    void setServo(const core::servo::ServoState& servo);
    /// Ends the exercise after grading: disables the choices and shows the correct ones.
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
    bool m_hasChosen = false;  ///< the user has answered here, so setPractised() no longer changes the choices
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

/// Returns "Left", "Middle" or "Right".
[[nodiscard]] QString padName(std::size_t pad);

}  // namespace ui::practice
