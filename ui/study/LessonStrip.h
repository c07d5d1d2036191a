// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>

#include <QFrame>

#include "core/terrain/Tooth.h"
#include "lessons/Lesson.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace ui::shell {
class TabularLabel;
}

namespace ui::study {

/// Above the tooth while a lesson is worked on: the step to do, a hint for who asks, and the time.
class LessonStrip final : public QFrame
{
    Q_OBJECT
public:
    explicit LessonStrip(QWidget* parent);

    /// Begins with the first step.
    void setLesson(const ::lessons::Lesson& lesson);
    /// Says what to do on a tooth with decay that is practised on without a lesson.
    void setPractice();
    /// Returns the place that the shown step names.
    [[nodiscard]] std::optional<core::guidance::Landmark> mark() const;
    /// Goes on by itself when what the step asks for has been reached.
    void follow(const std::set<::lessons::Reached>& reached);
    /// @param workedS  seconds of this attempt so far
    void setTime(double workedS);
    /// This one has its grade, and there is another attempt left.
    void setMayBeginAgain(bool may);
    /// The exam is over: the clock stops, and the strip says how to go on, until another lesson is set.
    enum class Ending {
        WithScore,
        Refused  ///< it counts as nothing
    };
    void conclude(Ending ending);

signals:
    void stepShown();
    /// The lesson's time is over; said once.
    void timeOver();

private:
    void goTo(std::size_t step);
    void showStep();
    [[nodiscard]] QString stepWords() const;

    ::lessons::Lesson m_lesson;
    bool m_isPractice = false;
    std::size_t m_step = 0;
    std::set<::lessons::Reached> m_reached;
    double m_workedS = 0.0;
    bool m_overSaid = false;
    bool m_isConcluded = false;
    Ending m_ending = Ending::WithScore;
    bool m_mayBeginAgain = false;
    QLabel* m_number = nullptr;
    QLabel* m_text = nullptr;
    QPushButton* m_hint = nullptr;
    QToolButton* m_before = nullptr;
    QToolButton* m_next = nullptr;
    shell::TabularLabel* m_time = nullptr;
};

/// Returns what has been reached on a tooth.
/// @param wholeMm3, removedMm3  volumes of the uncut tooth, and of what was removed, by material
[[nodiscard]] std::set<::lessons::Reached> reachedBy(const core::terrain::PerMaterial& wholeMm3,
                                                     const core::terrain::PerMaterial& removedMm3);

}  // namespace ui::study
