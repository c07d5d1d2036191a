// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <QWidget>

#include "ui/presets/SimpleFeel.h"

class QSlider;

namespace ui::presets {

/// A slider for each dial, with a word at either end: "softer", "harder".
class SimplePanel : public QWidget
{
    Q_OBJECT
public:
    explicit SimplePanel(QWidget* parent);

    /// The dials stand as they turn `base` into `preset`. One that they do not come to is their middle from now on.
    void setPreset(const core::settings::FeelPreset& base, const core::settings::FeelPreset& preset);

signals:
    void changed(const core::settings::FeelPreset& preset);

private:
    void tell();

    core::settings::FeelPreset m_base;
    std::array<QSlider*, kDials> m_sliders{};
};

}  // namespace ui::presets
