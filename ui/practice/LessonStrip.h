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
    /// Shows what to do in practice without a lesson, which is on a tooth with decay.
    void setPractice();
    /// Adds marks for the place that the current step names, on a tooth with this ideal.
    void markPlaces(tooth::ExerciseMarks& marks, const core::terrain::ToothAnatomy& tooth,
                    const std::vector<float>& ideal) const;
    /// Shows the next step if the bur has just reached what the current step asks for.
    /// @param wholeMm3, removedMm3  volumes of the uncut tooth, and of what was removed, by material
    /// @param isDeep  the bur is as deep as the lesson asks
    void follow(const core::terrain::PerMaterial& wholeMm3, const core::terrain::PerMaterial& removedMm3, bool isDeep);
    /// Shows the working time, or what is left of the time of the lesson.
    /// @param workedS  seconds of this attempt so far
    void setTime(double workedS);
    /// Sets whether another attempt at the exam is left after its grade.
    void setMayBeginAgain(bool may);
    enum class Ending {
        WithScore,
        Refused  ///< the attempt does not count
    };
    /// Ends an exam: stops the clock and shows what to do next, until another lesson is set.
    void conclude(Ending ending);

signals:
    /// Emitted when a step is shown: another one, or the same again.
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
