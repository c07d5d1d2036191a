// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QFrame>

#include "ui/replay/AttemptTimeline.h"

class QLabel;

namespace ui::kit {
class Actions;
class TabularDigitsLabel;
}  // namespace ui::kit
namespace ui::practice {
class ViewMenu;
}

namespace ui::replay {

class TimeLine;

/// The bar at the bottom of the practice room during a replay: the time line and the controls.
class ReplayBar final : public QFrame
{
    Q_OBJECT
public:
    ReplayBar(const kit::Actions& actions, practice::ViewMenu& viewMenu, QWidget* parent);

    /// Starts a recording of this length at normal speed. Call setCourse() again as more of it becomes known.
    void begin(double lengthS);
    void setCourse(const AttemptTimeline& course);
    /// Sets the attempt shown for comparison. Length 0: none.
    void setBeside(const AttemptTimeline& beside);
    /// Sets the current moment.
    void setPosition(double seconds);

    /// Seeks to the end of the next or the previous stroke.
    void step(bool onward);
    void goToBegin() { seek(0.0); }
    void goToEnd() { seek(m_course.lengthS); }
    /// Selects the next higher or lower speed.
    void changeSpeed(bool faster);

signals:
    void seekRequested(double seconds);
    void speedChosen(double times);
    void stopRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void seek(double seconds);
    void showTime();
    void showSpeed();

    AttemptTimeline m_course;
    double m_positionS = 0.0;
    QElapsedTimer m_sinceSeek;
    std::size_t m_speed = 0;
    TimeLine* m_line = nullptr;
    QLabel* m_words = nullptr;
    kit::TabularDigitsLabel* m_time = nullptr;
    kit::TabularDigitsLabel* m_speedLabel = nullptr;
};

}  // namespace ui::replay
