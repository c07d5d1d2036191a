// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/Gizmo.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/vec3.hpp>

#include <QColor>
#include <QFont>
#include <QPainter>
#include <QPen>

namespace ui::render {
namespace {

constexpr QRgb kDisc = 0xFF16191A;
constexpr QRgb kInk = 0xFFECEEEE;
constexpr QRgb kOcclusal = 0xFF56C7C9;
constexpr double kArm = 0.74;      ///< distance of the letters from the centre, as a share of the radius
constexpr double kKnob = 0.21;     ///< radius of a letter's knob, at the depth of the centre
constexpr double kHitKnobs = 1.8;  ///< a click within so many radii counts as a click on the letter

struct End
{
    glm::dvec3 way;
    std::size_t letter;
};

/// Returns the axis ends to draw, sorted from far to near. The eye looks along -z.
std::vector<End> endsOf(const glm::dmat3& eyeFromTooth, const GizmoLetters& letters)
{
    std::vector<End> ends;
    for (std::size_t k = 0; k < letters.size(); ++k) {
        const auto axis = static_cast<glm::length_t>(k / 2);
        if (!letters.at(k).isEmpty())
            ends.push_back({(k % 2 == 0 ? -1.0 : 1.0) * eyeFromTooth[axis], k});
    }
    std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.way.z < b.way.z; });
    return ends;
}

QPointF placeOf(const End& end, QPointF centre, double radiusPx)
{
    return centre + kArm * radiusPx * QPointF(end.way.x, -end.way.y);
}

double knobOf(const End& end, double radiusPx)
{
    return kKnob * radiusPx * (1.0 + 0.1 * end.way.z);
}

}  // namespace

std::optional<std::size_t> gizmoEndAt(QPointF point, QPointF centre, double radiusPx, const glm::dmat3& eyeFromTooth,
                                      const GizmoLetters& letters)
{
    std::optional<std::size_t> found;
    for (const End& end : endsOf(eyeFromTooth, letters)) {
        const QPointF off = point - placeOf(end, centre, radiusPx);
        if (std::hypot(off.x(), off.y()) <= kHitKnobs * knobOf(end, radiusPx))
            found = end.letter;
    }
    return found;
}

void paintGizmo(QPainter& painter, QPointF centre, double radiusPx, const glm::dmat3& eyeFromTooth,
                const GizmoLetters& letters)
{
    const std::vector<End> ends = endsOf(eyeFromTooth, letters);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QColor disc(kDisc);
    disc.setAlpha(150);
    painter.setPen(Qt::NoPen);
    painter.setBrush(disc);
    painter.drawEllipse(centre, radiusPx, radiusPx);
    for (const End& end : ends) {
        const double near = 0.5 + 0.5 * end.way.z;
        const QPointF at = placeOf(end, centre, radiusPx);
        QColor ink(end.letter == 5 ? kOcclusal : kInk);
        ink.setAlphaF(static_cast<float>(0.45 + 0.55 * near));
        painter.setPen(QPen(ink, 2.0, Qt::SolidLine, Qt::RoundCap));
        const double knob = knobOf(end, radiusPx);
        // The line ends where the knob begins.
        if (const double length = std::hypot(at.x() - centre.x(), at.y() - centre.y()); length > knob)
            painter.drawLine(centre, at - (at - centre) * (knob / length));
        // Ends that point towards the eye are filled, the others hollow.
        const bool filled = end.way.z > -0.05;
        painter.setPen(QPen(ink, 1.5));
        painter.setBrush(filled ? ink : QColor(kDisc));
        painter.drawEllipse(at, knob, knob);
        QFont font = painter.font();
        font.setPixelSize(std::max(9, static_cast<int>(1.15 * knob)));
        font.setBold(true);
        painter.setFont(font);
        painter.setPen(filled ? QColor(kDisc) : ink);
        painter.drawText(QRectF(at.x() - knob, at.y() - knob, 2.0 * knob, 2.0 * knob), Qt::AlignCenter,
                         letters.at(end.letter));
    }
    painter.restore();
}

}  // namespace ui::render
