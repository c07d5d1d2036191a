// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QWidget>

#include "core/terrain/Tooth.h"

namespace ui::shell {

/// A small disc in the natural colour of a material with its letter, so that it is told by more than its colour.
class MaterialSwatch : public QWidget
{
    Q_OBJECT
public:
    explicit MaterialSwatch(int sidePx, QWidget* parent);

    /// Nothing: an empty ring.
    void setMaterial(std::optional<core::terrain::Material> material);
    [[nodiscard]] QSize sizeHint() const override { return {m_sidePx, m_sidePx}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int m_sidePx;
    std::optional<core::terrain::Material> m_material;
};

}  // namespace ui::shell
