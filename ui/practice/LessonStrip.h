// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include <QFrame>

#include "core/terrain/Tooth.h"
#include "lessons/Lesson.h"
#include "ui/tooth/ExerciseMarks.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace ui::kit {
class TabularDigitsLabel;
}

namespace ui::practice {

/// The strip above the tooth: the current step of the lesson, a hint on request, and the time.
class LessonStrip final : public QFrame
{
    Q_OBJECT
public:
    explicit LessonStrip(QWidget* parent);

    /// Shows the first step of a lesson.
    void setLesson(const ::lessons::Lesson& lesson);
    /// Shows instructions for practice without a lesson, on a tooth with decay.
    void setPractice();
    /// Adds marks for the places that the current step names, on a tooth with this ideal.
    void markPlaces(tooth::ExerciseMarks& marks, const core::terrain::ToothAnatomy& tooth,
                    const std::vector<float>& ideal) const;
    /// Shows the next step if the current step has just been completed.
    /// @param wholeMm3, removedMm3  volumes of the uncut tooth and of the removed material, by material
    /// @param isDeep  the bur is at the depth that the lesson requires
    void follow(const core::terrain::PerMaterial& wholeMm3, const core::terrain::PerMaterial& removedMm3, bool isDeep);
    /// Shows the working time, or the remaining time of the lesson.
    /// @param workedS  seconds of this attempt so far
    void setTime(double workedS);
    /// Sets whether the student may attempt the exam again after its grade.
    void setMayBeginAgain(bool may);
    enum class Ending {
        WithScore,
        Refused  ///< the attempt does not count
    };
    /// Ends an exam: stops the clock and shows what to do next, until another lesson is set.
    void conclude(Ending ending);

signals:
    /// Emitted when a step is shown, also if it is the same step again.
    void stepShown();

private:
    void goTo(std::size_t step);
    void showStep();
    [[nodiscard]] QString stepWords() const;

    ::lessons::Lesson m_lesson;
    bool m_isPractice = false;
    std::size_t m_step = 0;
    std::array<bool, ::lessons::kReachedCount> m_reached{};  ///< by lessons::Reached
    double m_workedS = 0.0;
    bool m_isConcluded = false;
    Ending m_ending = Ending::WithScore;
    bool m_mayBeginAgain = false;
    QLabel* m_number = nullptr;
    QLabel* m_text = nullptr;
    QPushButton* m_hint = nullptr;
    QToolButton* m_before = nullptr;
    QToolButton* m_next = nullptr;
    kit::TabularDigitsLabel* m_time = nullptr;
};

}  // namespace ui::practice
