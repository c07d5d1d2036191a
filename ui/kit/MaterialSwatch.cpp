// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/MaterialSwatch.h"

#include <QPainter>

#include "ui/kit/MaterialLook.h"
#include "ui/kit/Theme.h"
#include "ui/text/Texts.h"

namespace ui::kit {

MaterialSwatch::MaterialSwatch(int sidePx, QWidget* parent) : QWidget(parent), m_sidePx(sidePx)
{
    setFixedSize(sidePx, sidePx);
}

void MaterialSwatch::setMaterial(std::optional<core::terrain::Material> material)
{
    if (material == m_material)
        return;
    m_material = material;
    update();
}

void MaterialSwatch::setColours(render::Palette colours)
{
    m_colours = colours;
    update();
}

void MaterialSwatch::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF disc = QRectF(rect()).adjusted(1, 1, -1, -1);
    painter.setPen(QPen(palette().color(QPalette::Mid), 1));
    if (!m_material) {
        painter.drawEllipse(disc);
        return;
    }
    const MaterialLook look = materialLook(*m_material, m_colours);
    painter.setBrush(look.fill);
    painter.drawEllipse(disc);
    painter.setPen(look.letter);
    painter.setFont(typeface(m_sidePx * 5 / 9, QFont::DemiBold));
    painter.drawText(disc, Qt::AlignCenter, text::materialLetter(*m_material));
}

}  // namespace ui::kit
