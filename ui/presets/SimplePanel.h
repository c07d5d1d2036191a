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

    /// Where all dials stand in the middle.
    void setBase(const core::settings::FeelPreset& base);
    void reset();

signals:
    void changed(const core::settings::FeelPreset& preset);

private:
    void tell();

    core::settings::FeelPreset m_base;
    std::array<QSlider*, kDials> m_sliders{};
};

}  // namespace ui::presets
