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

/// How the pointer holds the handpiece: how fast it goes down, where it stops and how hard it pushes.
class HandControls : public QWidget
{
    Q_OBJECT
public:
    explicit HandControls(QWidget* parent);

    /// Sets the hand of this view from now on, and shows what it is set to elsewhere.
    void control(tooth::ToothView& view);
    /// Without it, there is no depth stop to switch on: an exam.
    void setStopAllowed(bool allowed);
    /// Switches the stop on or off, at this depth.
    void setStop(bool on, double depthMm);
    /// Feed and force as they are for a new user.
    void reset();
    [[nodiscard]] double pushForce() const;

private:
    void showHand();

    tooth::ToothView* m_view = nullptr;
    QWidget* m_stopRow = nullptr;
    QSlider* m_feed = nullptr;
    QCheckBox* m_stopOn = nullptr;
    QSlider* m_stop = nullptr;
    QSlider* m_push = nullptr;
    TabularLabel* m_feedText = nullptr;
    TabularLabel* m_stopText = nullptr;
    TabularLabel* m_pushText = nullptr;
};

}  // namespace ui::shell
