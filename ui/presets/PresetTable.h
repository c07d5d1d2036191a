// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

#include "core/settings/FeelPreset.h"

class QDoubleSpinBox;

namespace ui::presets {

/// All numbers of a preset: a row for each material with rate and threshold, and what the force pipeline takes, each
/// with its unit, range and what it does.
class PresetTable : public QWidget
{
    Q_OBJECT
public:
    explicit PresetTable(QWidget* parent);

    /// Says nothing.
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
