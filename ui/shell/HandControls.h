// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QCheckBox;
class QSlider;

namespace ui::tooth {
class ToothView;
}

namespace ui::shell {

class TabularLabel;

/// Sliders for the hand of a pointer: feed, depth stop and force.
class HandControls : public QWidget
{
    Q_OBJECT
public:
    explicit HandControls(QWidget* parent);

    /// Connects the sliders with the hand of a view, both ways. Call this once.
    void control(tooth::ToothView& view);
    /// Switches the depth stop on at this depth. If it is not allowed, as in an exam, switches it off for good.
    void begin(bool stopIsAllowed, double depthMm);
    /// Sets the feed, and remembers it from run to run.
    void setFeed(double mmPerS);
    /// Restores the default feed and force.
    void reset();
    [[nodiscard]] double pushForce() const;

private:
    void setStop(bool on, double depthMm);
    void showHand();

    tooth::ToothView* m_view = nullptr;
    QSlider* m_feed = nullptr;
    QCheckBox* m_stopOn = nullptr;
    QSlider* m_stop = nullptr;
    QSlider* m_push = nullptr;
    TabularLabel* m_feedText = nullptr;
    TabularLabel* m_stopText = nullptr;
    TabularLabel* m_pushText = nullptr;
};

}  // namespace ui::shell
