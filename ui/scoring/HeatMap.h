// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include <QImage>
#include <QWidget>

#include "core/imaging/Section.h"
#include "ui/render/Look.h"
#include "ui/scoring/ScoredWork.h"

namespace ui::scoring {

/// The tooth from above, coloured by its deviation from the ideal: vermilion where it was cut too deep, blue where
/// something is still to go, with a legend in millimetres; in the palette for every eye with a pattern on each. The
/// pointer reads the depth under it. Dark in either theme, like the room with the tooth.
class HeatMap final : public QWidget
{
    Q_OBJECT
public:
    explicit HeatMap(QWidget* parent);

    void setWork(const ScoredWork& work);
    /// Rings a column, and draws the line of the section through it; nothing: neither.
    void setMark(std::optional<std::size_t> node, const core::imaging::SectionPlane& plane);
    void setColours(render::Palette colours);
    /// A place of the tooth that somebody speaks of, in its frame, mm; nothing: none.
    void setPin(const std::optional<std::array<double, 3>>& placeMm);
    /// The pin can be set, by a click, or with the keys: the arrows move it, Delete takes it away.
    void setPinnable(bool pinnable);
    /// Dark words on white.
    void setOnPaper(bool onPaper);

    [[nodiscard]] std::optional<std::size_t> marked() const { return m_mark; }
    [[nodiscard]] const std::optional<std::array<double, 3>>& pin() const { return m_pin; }
    /// Where a place of the tooth is in the picture; a work is shown.
    [[nodiscard]] QPointF pointOf(const std::array<double, 3>& placeMm) const;
    [[nodiscard]] QSize sizeHint() const override { return {320, 140}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 130}; }

signals:
    /// Somebody has set the pin on the surface as it ended, or taken it away.
    void pinned(const std::optional<std::array<double, 3>>& placeMm);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    /// Where the picture lies, and which part of the grid it shows.
    struct Frame
    {
        QRectF plot;
        double pxPerCell = 1.0;
        [[nodiscard]] QPointF at(double i, double j) const;
        double firstI = 0.0;
        double lastJ = 0.0;
    };
    [[nodiscard]] Frame frame() const;
    [[nodiscard]] std::optional<std::size_t> nodeAt(const Frame& frame, const QPointF& at) const;
    void draw();
    void paintEnds(QPainter& painter, const Frame& frame) const;
    void paintMark(QPainter& painter, const Frame& frame) const;
    void paintPin(QPainter& painter) const;
    [[nodiscard]] std::array<double, 3> placeOf(std::size_t node) const;
    void choosePin(const std::optional<std::array<double, 3>>& placeMm);
    void retranslateUi();
    void paintLegend(QPainter& painter, const QRectF& area) const;
    [[nodiscard]] QColor wordColour() const;

    ScoredWork m_work;
    int m_i0 = 0;  ///< the part of the grid with tooth, both ends included
    int m_i1 = 0;
    int m_j0 = 0;
    int m_j1 = 0;
    std::optional<std::size_t> m_mark;
    core::imaging::SectionPlane m_plane;
    std::optional<std::array<double, 3>> m_pin;
    bool m_isPinnable = false;
    render::Palette m_colours = render::Palette::Natural;
    bool m_onPaper = false;
    QImage m_picture;  ///< of the plot, in the pixels of the screen
    std::optional<std::size_t> m_probed;
};

/// The colour of a deviation from the ideal in millimetres, negative if too deep, on either end's scale of
/// render::kIdealScaleMm.
[[nodiscard]] QRgb heatColour(double aboveMm);

}  // namespace ui::scoring
