// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

#include "core/settings/FeelPreset.h"

class QDoubleSpinBox;

namespace ui::presets {

/// A form for all numbers of a preset: a row for each material with rate and threshold, and the numbers of the force
/// pipeline, each with unit, range and explanation.
class PresetTable : public QWidget
{
    Q_OBJECT
public:
    explicit PresetTable(QWidget* parent);

    /// Sets the preset without emitting changed().
    void setPreset(const core::settings::FeelPreset& preset);

signals:
    void changed(const core::settings::FeelPreset& preset);

private:
    QDoubleSpinBox* input(std::size_t field);
    void tell();

    core::settings::FeelPreset m_preset;
    std::vector<QDoubleSpinBox*> m_inputs;  ///< in the order of core::settings::feelFields()
    bool m_isQuiet = false;
};

}  // namespace ui::presets
