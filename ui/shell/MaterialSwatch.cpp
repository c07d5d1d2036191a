// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/MaterialSwatch.h"

#include <array>

#include <QPainter>

#include "ui/shell/Theme.h"
#include "ui/text/Texts.h"

namespace ui::shell {
namespace {

struct Look
{
    QRgb fill;
    QRgb letter;
};

/// In the order of core::terrain::Material: decay, enamel, dentin, pulp.
constexpr std::array<Look, core::terrain::kMaterialCount> kLooks{
    {{0xFF5B3A1E, 0xFFFFFFFF}, {0xFFF2ECDF, 0xFF1A2223}, {0xFFE2B964, 0xFF1A2223}, {0xFFC75A62, 0xFFFFFFFF}}};

}  // namespace

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
    const Look& look = kLooks.at(static_cast<std::size_t>(*m_material));
    painter.setBrush(QColor(look.fill));
    painter.drawEllipse(disc);
    painter.setPen(QColor(look.letter));
    painter.setFont(typeface(m_sidePx * 5 / 9, QFont::DemiBold));
    painter.drawText(disc, Qt::AlignCenter, text::materialLetter(*m_material));
}

}  // namespace ui::shell
