// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include <QWidget>

#include "ui/presets/SimpleFeel.h"

class QLabel;
class QSlider;

namespace ui::presets {

/// A slider for each dial, with a word at either end: "softer", "harder".
class SimplePanel : public QWidget
{
    Q_OBJECT
public:
    explicit SimplePanel(QWidget* parent);

    /// The dials stand as they turn the first of `bases` that they can turn so into `preset`, and it is said which that
    /// is. One that they do not come to is their middle from now on.
    void setPreset(const std::vector<core::settings::FeelPreset>& bases, const core::settings::FeelPreset& preset);

signals:
    void changed(const core::settings::FeelPreset& preset);

private:
    void tell();
    void say();

    core::settings::FeelPreset m_base;
    bool m_isTyped = false;  ///< the middle is no version, but numbers that were typed
    std::array<QSlider*, kDials> m_sliders{};
    QLabel* m_middle;
};

}  // namespace ui::presets
