// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QObject>
#include <QTest>

#include "tests/ui/Pictures.h"
#include "ui/render/Canvas.h"
#include "ui/render/ToothRenderer.h"
#include "ui/tooth/Viewpoint.h"

namespace support {

/// A base class for tests that draw without a window.
class CanvasTest : public QObject
{
protected:
    static constexpr int kWidth = 800;
    static constexpr int kHeight = 600;

    void makeCanvas()
    {
        auto canvas = ui::render::Canvas::make({kWidth, kHeight});
        QVERIFY2(canvas, "this display offers no OpenGL 3.3 core");
        m_canvas = std::move(*canvas);
        m_renderer = std::make_unique<ui::render::ToothRenderer>();
        QString reason;
        QVERIFY2(m_renderer->initialize(reason), qPrintable(reason));
        m_camera.setViewport({kWidth, kHeight});
    }

    template <class Draw>
    QImage picture(const Draw& draw, int samples = ui::render::Canvas::kSamples)
    {
        const QImage image = m_canvas->picture(draw, samples);
        const QString row = QTest::currentDataTag();
        pictures::keep(image, QStringLiteral("%1_%2_%3").arg(QTest::currentTestFunction(), row).arg(m_pictures++));
        return image;
    }

    /// Shows an uncut tooth.
    void show(const std::shared_ptr<const core::terrain::ToothAnatomy>& tooth)
    {
        m_surface = std::make_unique<ui::render::ToothSurface>(tooth, ui::tooth::operatingLight(false));
        m_renderer->setSurface(*m_surface);
        ui::tooth::showWhole(m_camera, *m_surface);
    }

    void look(double azimuthDeg, double elevationDeg, double distances = 1.0)
    {
        m_camera.set(azimuthDeg, elevationDeg, distances * m_camera.fittingMm());
    }

    [[nodiscard]] ui::render::Scene scene() const
    {
        return ui::tooth::sceneThrough(m_camera, {kWidth, kHeight}, false);
    }

    void update(bool hurried = false) { m_renderer->update(*m_surface, m_surface->refresh(hurried)); }

    /// Lowers a tile of the shown tooth.
    void cut(glm::dvec2 placeMm, float floorMm, bool hurried = false)
    {
        m_surface->write(pictures::cutTile(m_surface->anatomy(), placeMm, floorMm));
        update(hurried);
    }

    [[nodiscard]] glm::dvec3 onTooth(glm::dvec2 placeMm) const { return {placeMm, m_surface->heightMm(placeMm)}; }

    [[nodiscard]] std::size_t nodeAt(glm::dvec2 placeMm) const
    {
        const core::terrain::Grid& grid = m_surface->anatomy().grid;
        const glm::ivec2 node(glm::round(grid.latticeOf(placeMm)));
        return grid.index(node.x, node.y);
    }

    [[nodiscard]] pictures::Colour at(const QImage& image, glm::dvec3 pointMm, int reach = 3) const
    {
        const glm::dvec2 pixel = m_camera.pixelOf(pointMm);
        return pictures::mean(image, pictures::around(pixel.x, pixel.y, reach));
    }

    // The order matters: the renderer is destroyed before the OpenGL context.
    std::unique_ptr<ui::render::Canvas> m_canvas;
    std::unique_ptr<ui::render::ToothRenderer> m_renderer;
    std::unique_ptr<ui::render::ToothSurface> m_surface;
    ui::tooth::Camera m_camera;

private:
    int m_pictures = 0;
};

}  // namespace support
