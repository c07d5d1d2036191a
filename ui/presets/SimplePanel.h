// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include <QWidget>

#include "ui/presets/SimpleFeel.h"

class QLabel;
class QSlider;

namespace ui::presets {

/// A slider for each dial of a preset, with a label at each end: "softer", "harder".
class SimplePanel : public QWidget
{
    Q_OBJECT
public:
    explicit SimplePanel(QWidget* parent);

    /// Sets the sliders to the dials that turn one of `bases` into `preset`, and shows the name of that base. Uses the
    /// first base that is possible. If none is, `preset` itself becomes the middle of the sliders.
    void setPreset(const std::vector<core::settings::FeelPreset>& bases, const core::settings::FeelPreset& preset);

signals:
    void changed(const core::settings::FeelPreset& preset);

private:
    void tell();
    void say();

    core::settings::FeelPreset m_base;
    bool m_isTyped = false;  ///< the base is not a version, but numbers that the user typed
    std::array<QSlider*, kDials> m_sliders{};
    QLabel* m_middle;
};

}  // namespace ui::presets
