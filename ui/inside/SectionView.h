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

/// The live section through the bur beside the tooth. Two buttons choose its plane and a slider turns it; figures show
/// the distances to the pulp.
class SectionView : public QFrame
{
    Q_OBJECT
public:
    explicit SectionView(QWidget* parent);

    /// Updates the section. Call once per frame: it repaints at most every second frame and 30 times a second, and only
    /// when something visible has changed.
    /// @param tooth     borrowed until the next call; null: none
    /// @param revision  changes whenever the tooth has changed
    void follow(const core::terrain::Tooth* tooth, std::uint64_t revision, const core::servo::ServoState& servo,
                const core::imaging::DepthReading& reading);
    void setColours(render::Palette colours);
    /// Sets the ideal over the grid of the tooth; null: none.
    void setIdeal(core::grading::IdealTop ideal);
    /// Shows the section through this place, with the bur there, instead of the bur's current position. Empty: follows
    /// the bur again.
    void setHeld(std::optional<glm::dvec3> tipMm);
    /// Shows or hides the figures.
    void setFiguresShown(bool shown);
    /// Turns the plane to this direction, seen from above, rounded to degrees. 0 is along x and shows the width of a
    /// marginal ridge.
    void showAlong(double angleRad);
    /// Turns the plane about the bur by 15 degrees.
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
    std::shared_ptr<const core::terrain::ToothAnatomy> m_anatomy;  ///< the tooth whose sides are labelled
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
