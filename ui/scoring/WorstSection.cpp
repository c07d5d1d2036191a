// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoring/WorstSection.h"

#include <cmath>
#include <numbers>

#include <QPainter>
#include <QPainterPath>

#include "core/grading/Columns.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::scoring {

WorstSection::WorstSection(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    text::bindTranslation(this, [this] { setAccessibleName(tr("Section through the worst place")); });
}

void WorstSection::setWork(const ScoredWork& work)
{
    m_work = work;
    m_scene.tooth = m_work.tooth.get();
    m_scene.ideal = m_work.ideal;
    setMark({}, {work.tooth->grid().middleMm(), 0.0});
}

void WorstSection::setMark(std::optional<std::size_t> node, const core::imaging::SectionPlane& plane)
{
    m_scene.plane = plane;
    m_scene.markMm.reset();
    if (node)
        m_scene.markMm = glm::dvec3(m_work.tooth->grid().nodeMm(*node),
                                    static_cast<double>(core::grading::endOf(*m_work.tooth, *node)));
    update();
}

void WorstSection::setColours(render::Palette colours)
{
    m_scene.palette = colours;
    update();
}

void WorstSection::setOnPaper(bool onPaper)
{
    m_scene.onPaper = onPaper;
    update();
}

void WorstSection::paintEvent(QPaintEvent*)
{
    if (!m_work.tooth)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath frame;
    frame.addRoundedRect(rect(), kit::kRadius, kit::kRadius);
    painter.setClipPath(frame);
    inside::paintSection(painter, rect(), m_scene);
}

core::imaging::SectionPlane planeThrough(const ScoredWork& work, std::size_t node)
{
    const core::terrain::Grid& grid = work.tooth->grid();
    const auto side = static_cast<std::size_t>(grid.side);
    const int i = static_cast<int>(node % side);
    const int j = static_cast<int>(node / side);
    double alongX = 0.0;
    double alongY = 0.0;
    for (int n = 0; n < grid.side; ++n) {
        alongX += static_cast<double>(std::abs(aboveIdeal(work, grid.index(n, j))));
        alongY += static_cast<double>(std::abs(aboveIdeal(work, grid.index(i, n))));
    }
    return {grid.nodeMm(i, j), alongX > alongY ? 0.0 : 0.5 * std::numbers::pi};
}

}  // namespace ui::scoring
