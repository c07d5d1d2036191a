// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/servo/ServoState.h"

class QCheckBox;
class QLabel;
class QSlider;

namespace ui::kit {
class TabularDigitsLabel;
}

namespace ui::tooth {
class ToothView;
}

namespace ui::practice {

/// Sliders for the hand of a pointer: feed, depth stop and force.
class HandControls : public QWidget
{
    Q_OBJECT
public:
    /// @param view  the sliders show and change its pointer settings; must outlive this
    HandControls(tooth::ToothView& view, QWidget* parent);

    /// Sets the depth stop for a lesson. If it is allowed, switches it on at this depth; otherwise switches it off and
    /// disables it.
    void begin(bool stopIsAllowed, double depthMm);
    /// Returns whether the bur touches the tooth at the lesson's depth.
    [[nodiscard]] bool isDeep(const core::servo::ServoState& servo) const;
    /// Sets the feed, and stores it for the next run of the program.
    void setFeed(double mmPerS);
    /// Restores the default feed and force.
    void reset();
    [[nodiscard]] double pushForce() const;
    /// Replaces the sliders by a sentence while a force device moves the bur.
    /// @param name  of the device; empty: the pointer moves the bur
    void setForceDevice(const QString& name);

private:
    void showHand();

    tooth::ToothView& m_view;
    double m_depthMm = 0.0;  ///< depth that the lesson requires
    QWidget* m_sliders;
    QLabel* m_device;
    QString m_deviceName;
    QSlider* m_feed = nullptr;
    QCheckBox* m_stopOn = nullptr;
    QSlider* m_stop = nullptr;
    QSlider* m_push = nullptr;
    kit::TabularDigitsLabel* m_feedText = nullptr;
    kit::TabularDigitsLabel* m_stopText = nullptr;
    kit::TabularDigitsLabel* m_pushText = nullptr;
};

}  // namespace ui::practice
