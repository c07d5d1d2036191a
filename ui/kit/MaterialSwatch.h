// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QWidget>

#include "core/terrain/Tooth.h"
#include "ui/render/Look.h"

namespace ui::kit {

/// A small disc in the colour of a material with its letter, so that colour is not the only sign. It has no pattern,
/// because there is no room for one behind the letter.
class MaterialSwatch : public QWidget
{
    Q_OBJECT
public:
    explicit MaterialSwatch(int sidePx, QWidget* parent);

    /// @param material  empty: an empty ring
    void setMaterial(std::optional<core::terrain::Material> material);
    void setColours(render::Palette colours);
    [[nodiscard]] QSize sizeHint() const override { return {m_sidePx, m_sidePx}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int m_sidePx;
    std::optional<core::terrain::Material> m_material;
    render::Palette m_colours = render::Palette::Natural;
};

}  // namespace ui::kit
