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
/// material is left. It has a legend in millimetres. The colour-blind palette adds a pattern to each colour. A tooltip
/// shows the depth under the pointer. Dark in both themes.
class HeatMap final : public QWidget
{
    Q_OBJECT
public:
    explicit HeatMap(QWidget* parent);

    void setWork(const ScoredWork& work);
    /// Marks a column with a ring and the section through it with a line.
    /// @param node  empty: no mark
    void setMark(std::optional<std::size_t> node, const core::imaging::SectionPlane& plane);
    void setColours(render::Palette colours);
    /// Sets the pin: a place that a comment is about, in the tooth frame, mm; empty: none.
    void setPin(const std::optional<std::array<double, 3>>& placeMm);
    /// Lets the user set the pin by a click or with the arrow keys, and remove it with Delete.
    void setPinnable(bool pinnable);
    /// Switches to dark text on white, for print.
    void setOnPaper(bool onPaper);

    [[nodiscard]] std::optional<std::size_t> marked() const { return m_mark; }
    [[nodiscard]] const std::optional<std::array<double, 3>>& pin() const { return m_pin; }
    /// Returns the position of a place of the tooth in the widget. Requires a work that has been set.
    [[nodiscard]] QPointF pointOf(const std::array<double, 3>& placeMm) const;
    [[nodiscard]] QSize sizeHint() const override { return {320, 140}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 130}; }

signals:
    /// Emitted when the user has set the pin on the final surface, or has removed it.
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
    /// The rectangle of the picture, and the part of the grid that it shows.
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
    int m_i0 = 0;  ///< bounds of the part of the grid with tooth, inclusive
    int m_i1 = 0;
    int m_j0 = 0;
    int m_j1 = 0;
    std::optional<std::size_t> m_mark;
    core::imaging::SectionPlane m_plane;
    std::optional<std::array<double, 3>> m_pin;
    bool m_isPinnable = false;
    render::Palette m_colours = render::Palette::Natural;
    bool m_onPaper = false;
    QImage m_picture;  ///< the plot, in screen pixels
    std::optional<std::size_t> m_probed;
};

/// Returns the colour of a deviation from the ideal, mm, negative if too deep, on the scale render::kIdealScaleMm.
[[nodiscard]] QRgb heatColour(double aboveMm);

}  // namespace ui::scoring
