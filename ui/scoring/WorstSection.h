// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/inside/SectionPainter.h"
#include "ui/scoring/ScoredWork.h"

namespace ui::scoring {

/// A section through one place of the work, with the original and the ideal surface.
class WorstSection final : public QWidget
{
    Q_OBJECT
public:
    explicit WorstSection(QWidget* parent);

    void setWork(const ScoredWork& work);
    /// @param node  the column marked with a ring; empty: none
    void setMark(std::optional<std::size_t> node, const core::imaging::SectionPlane& plane);
    void setColours(render::Palette colours);
    void setOnPaper(bool onPaper);

    [[nodiscard]] QSize sizeHint() const override { return {320, 140}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 130}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    ScoredWork m_work;
    inside::SectionScene m_scene;
};

/// Returns the vertical plane through a column, along x or y, in which the tooth deviates more from the ideal.
[[nodiscard]] core::imaging::SectionPlane planeThrough(const ScoredWork& work, std::size_t node);

}  // namespace ui::scoring
