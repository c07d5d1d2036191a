// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include <QElapsedTimer>
#include <QFrame>

#include "core/grading/IdealCavity.h"
#include "core/imaging/Section.h"
#include "core/servo/ServoState.h"
#include "ui/kit/MaterialLook.h"

class QLayout;
class QPushButton;
class QSlider;

namespace ui::kit {
class TabularDigitsLabel;
}

namespace ui::inside {

class SectionCanvas;

/// Beside the tooth: the live cut through the bur, the plane chosen with two buttons or turned with a slider, and what
/// is left to the pulp in figures.
class SectionView : public QFrame
{
    Q_OBJECT
public:
    explicit SectionView(QWidget* parent);

    /// The tooth as the view has it now. Call as often as frames come: it paints every second of them at
    /// most, 30 times a second, and only when something that shows has changed.
    /// @param tooth     borrowed until the next call; null: none
    /// @param revision  another number whenever the tooth has changed
    void follow(const core::terrain::Tooth* tooth, std::uint64_t revision, const core::servo::ServoState& servo,
                const core::imaging::DepthReading& reading);
    void setColours(render::Palette colours);
    /// What the lesson asks for, over the grid of the tooth followed next; null: nothing.
    void setIdeal(core::grading::IdealTop ideal);
    /// Shows the cut through this place, with the bur as it stood there, and not where the bur is now; nothing: goes
    /// with the bur again.
    void setHeld(std::optional<glm::dvec3> tipMm);
    /// Without them the picture alone is there.
    void setFiguresShown(bool shown);
    /// Turns the plane to run along this direction, seen from above; 0 is along x, in which the width of a marginal
    /// ridge is seen. To the nearest degree.
    void showAlong(double angleRad);
    /// Turns the plane about the bur, +15 degrees.
    void turn();
    [[nodiscard]] int angleDeg() const;

private:
    QLayout* makeAngle();
    void makeFigures();
    void setAngle(int degrees);
    void nameSides();
    void showFigures(const core::servo::ServoState& servo, const core::imaging::DepthReading& reading);

    SectionCanvas* m_canvas;
    QWidget* m_figures;
    QPushButton* m_alongX;
    QPushButton* m_alongY;
    QSlider* m_angle;
    kit::TabularDigitsLabel* m_angleText;
    kit::TabularDigitsLabel* m_depth;
    kit::TabularDigitsLabel* m_dentin;
    kit::TabularDigitsLabel* m_down;
    kit::TabularDigitsLabel* m_nearest;
    std::shared_ptr<const core::terrain::ToothAnatomy> m_anatomy;  ///< whose sides are named
    std::uint64_t m_revision = 0;
    std::optional<glm::dvec3> m_held;
    glm::dvec3 m_tipMm{0.0};
    std::uint8_t m_bur = 0;
    bool m_hasBur = false;
    QElapsedTimer m_sincePaint;
    int m_framesSince = 0;
    QElapsedTimer m_sinceFigures;
};

}  // namespace ui::inside
