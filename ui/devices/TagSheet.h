// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <QByteArray>
#include <QCoreApplication>
#include <QSizeF>

#include "core/tracking/TagCells.h"

class QPainter;

namespace ui::devices {

/// Printed sheets for head tracking in their exact size: tags to cut out, a headband with a tag, and the board for
/// calibrating a camera. They fit A4 and Letter. Their text is in the current language.
class TagSheet
{
    Q_DECLARE_TR_FUNCTIONS(ui::devices::TagSheet)

public:
    enum class Page { Tags, Headband, Board };
    static constexpr std::array kPages{Page::Tags, Page::Headband, Page::Board};
    static constexpr std::array kEdgesMm{60.0, 50.0, 40.0};  ///< black edges of the tags on the first page
    static constexpr double kBandEdgeMm = 50.0;              ///< black edge of the tag on the headband
    static constexpr double kRulerMm = 100.0;                ///< length of the ruler on each page
    static constexpr double kSquareMm = 25.0;                ///< squares of the board

    TagSheet(int id, const core::tracking::TagCells& cells);

    /// Paints a sheet in the middle of the paper. The painter's origin is the upper left corner of the paper.
    void paint(QPainter& painter, Page page, const QSizeF& paperMm) const;

    /// Returns all sheets as a PDF, A4.
    [[nodiscard]] QByteArray pdf() const;

private:
    class Pen;
    void paintTags(Pen& pen) const;
    void paintHeadband(Pen& pen) const;
    static void paintBoard(Pen& pen);
    /// @param upperLeft  corner of its white border, mm
    void paintTag(Pen& pen, const QPointF& upperLeft, double edgeMm) const;
    static void paintRuler(Pen& pen, const QPointF& leftEnd);

    int m_id;
    core::tracking::TagCells m_cells;
};

}  // namespace ui::devices
