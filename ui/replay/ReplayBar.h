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

/// At the foot of the practice room while a recording is played: its time line, and beneath it what moves in time.
class ReplayBar final : public QFrame
{
    Q_OBJECT
public:
    ReplayBar(const kit::Actions& actions, practice::ViewMenu& viewMenu, QWidget* parent);

    /// A recording of this length begins, as fast as it was made; more of it is known by and by (setCourse).
    void begin(double lengthS);
    void setCourse(const AttemptTimeline& course);
    /// What is shown beside; without a length nothing is.
    void setBeside(const AttemptTimeline& beside);
    /// The moment that is shown.
    void setPosition(double seconds);

    /// The end of the next stroke, or of the one before.
    void step(bool onward);
    void goToBegin() { seek(0.0); }
    void goToEnd() { seek(m_course.lengthS); }
    /// The next speed up, or down.
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
