// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/StabilityScenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "lab/Block.h"

namespace lab {
namespace {

using Height = std::function<double(glm::dvec2)>;

constexpr double kPi = std::numbers::pi;
constexpr double kCellMm = kBlockExtentMm / core::terrain::kDefaultGridSide;
constexpr double kBallMm = 0.5;  ///< radius of the bur
constexpr double kSlope = 0.5;
const double kSlope30 = std::tan(kPi / 6.0);

double flat(glm::dvec2)
{
    return 0.0;
}
/// Depth of a cone of 20 degrees to each side of its axis, 1 mm deep: narrower than the bur.
double pit(glm::dvec2 at)
{
    return -std::max(0.0, 1.0 - std::sqrt(glm::dot(at, at)) / std::tan(kPi / 9.0));
}
double groove(glm::dvec2 at)
{
    return kSlope30 * std::abs(at.x);
}
double wall(glm::dvec2 at)
{
    return at.x > 0.0 ? 1.0 : 0.0;
}
Height ridge(int cells)
{
    // Columns are half a cell to either side of x = 0.
    return [cells](glm::dvec2 at) { return at.x > 0.0 && at.x < cells * kCellMm ? 3.0 : 0.0; };
}
Height step(double mm)
{
    return [mm](glm::dvec2 at) { return at.x > 0.0 ? mm : 0.0; };
}

/// Returns a value that rises evenly from 0 to 1 between the seconds `from` and `to`.
double rise(double seconds, double from, double to)
{
    return std::clamp((seconds - from) / (to - from), 0.0, 1.0);
}

/// Returns the height of a hand that comes down on the tooth and presses on it with some newtons from `byS` on.
double leaning(double seconds, double byS, double mmPerN, double newtons)
{
    return 0.5 - rise(seconds, 0.0, byS) * (0.5 + newtons * mmPerN);
}

/// Returns the additional distance that a hand aims ahead, mm, to overcome friction on a path from `from` to `to`.
/// Otherwise a light hand would not move.
double urge(double seconds, double from, double to, double mmPerN, double newtons)
{
    return newtons * mmPerN * (rise(seconds, from, from + 0.05) - rise(seconds, to, to + 0.05));
}

class Scenes
{
public:
    Scenes()
    {
        pushAndImpact();
        pitAndGrooves();
        wallRidgeStep();
        vanishingGround();
        device();
        drilling();
        loops();
    }
    std::vector<StabilityScene> list;

private:
    StabilityScene& add(int number, std::string name, std::shared_ptr<const core::terrain::ToothAnatomy> on,
                        std::function<glm::dvec3(double, double)> wanted)
    {
        StabilityScene& scene = list.emplace_back();
        scene.number = number;
        scene.name = std::move(name);
        scene.anatomy = std::move(on);
        scene.wanted = std::move(wanted);
        return scene;
    }

    void pushAndImpact()
    {
        StabilityScene& push = add(1, "push", m_plate, [](double t, double mmPerN) {
            return glm::dvec3(0.0, 0.0, 0.5 - rise(t, 0.0, 1.0) * (0.5 + 8.0 * mmPerN));
        });
        push.seconds = 2.2;
        push.steadyS = {{0.4, 1.0}};
        push.bars.swingMm = 0.1;
        push.exact = [](const glm::dvec3& at) { return glm::dvec3(at.x, at.y, 0.0); };
        for (const int mmPerS : {50, 100, 200, 400}) {
            StabilityScene& impact = add(2, "impact " + std::to_string(mmPerS), m_plate,
                                         [](double, double mmPerN) { return glm::dvec3(0.0, 0.0, -2.0 * mmPerN); });
            impact.throwMmPerS = {0.0, 0.0, -mmPerS};
            impact.startMm = {0.0, 0.0, 2.0};
            impact.jumpsFromS = kNever;
            impact.bars.settleS = 0.2;
            impact.bars.bounces = 2.0;
        }
    }

    void pitAndGrooves()
    {
        StabilityScene& scene = add(3, "pit", m_pit, [](double t, double mmPerN) {
            const double turn = 2.0 * kPi * rise(t, 0.5, 1.4);
            return glm::dvec3(0.4 * mmPerN * std::sin(turn), 0.4 * mmPerN * (1.0 - std::cos(turn)),
                              leaning(t, 0.4, mmPerN, 3.0));
        });
        scene.steadyS = {{0.7, 1.4}};
        scene.exact = [](const glm::dvec3&) {  // on the rim all around, whatever the hand does
            const double rim = std::tan(kPi / 9.0);
            return glm::dvec3(0.0, 0.0, std::sqrt(kBallMm * kBallMm - rim * rim) - kBallMm);
        };
        scene.bars.jumpN = 0.3;
        for (const auto& [name, shift] :
             {std::pair("groove", 0), std::pair("groove, a quarter", 1), std::pair("groove, a half", 2)}) {
            StabilityScene& slid = add(4, name, m_groove[static_cast<std::size_t>(shift)], [](double t, double mmPerN) {
                return glm::dvec3(0.0, -2.0 + 4.0 * rise(t, 0.4, 1.4) + urge(t, 0.4, 1.4, mmPerN, 0.45),
                                  leaning(t, 0.3, mmPerN, 2.0));
            });
            slid.along = {0.0, 1.0, 0.0};
            slid.steadyS = {{0.7, 1.4}};
            slid.jumpsFromS = 0.7;
            slid.exact = [](const glm::dvec3& at) {
                return glm::dvec3(0.0, at.y, kBallMm * (std::sqrt(1.0 + kSlope30 * kSlope30) - 1.0));
            };
            slid.bars.rippleN = 0.02;
            slid.bars.errorMm = 0.04;
        }
        // The hand moves up and down a plane of 27 degrees and presses along the plane's normal.
        StabilityScene& slope = add(0, "slope", m_slope, [](double t, double mmPerN) {
            const double x = -1.5 + 3.0 * rise(t, 0.4, 0.9) - 3.0 * rise(t, 0.9, 1.4);
            const double press = rise(t, 0.1, 0.3) * 1.2 * mmPerN;
            const double along = x + urge(t, 0.4, 0.9, mmPerN, 0.35) - urge(t, 0.9, 1.4, mmPerN, 0.35);
            return glm::dvec3(along + 0.5 * press, 0.0, kSlope * along + 0.6 - 0.5 * rise(t, 0.0, 0.3) - press);
        });
        slope.along = glm::normalize(glm::dvec3(1.0, 0.0, kSlope));
        slope.steadyS = {{0.6, 0.9}, {1.1, 1.4}};
        slope.jumpsFromS = 0.6;
        slope.bars.lagMm = 0.02;
    }

    void wallRidgeStep()
    {
        StabilityScene& beside = add(5, "wall", m_wall, [](double t, double mmPerN) {
            return glm::dvec3(-1.0 + rise(t, 0.2, 0.5) * (0.5 + 1.5 * mmPerN),
                              -1.0 + 2.0 * rise(t, 0.6, 1.4) + urge(t, 0.6, 1.4, mmPerN, 0.4),
                              leaning(t, 0.2, mmPerN, 0.5));
        });
        beside.along = {0.0, 1.0, 0.0};
        beside.steadyS = {{0.9, 1.4}};
        beside.jumpsFromS = 0.9;
        beside.exact = [](const glm::dvec3& at) { return glm::dvec3(-kBallMm, at.y, 0.0); };
        beside.bars.errorMm = 0.5 * kCellMm + 0.001;
        for (const std::size_t cells : {std::size_t{1}, std::size_t{2}}) {
            StabilityScene& scene = add(
                6, cells == 1 ? "ridge, 1 cell" : "ridge, 2 cells", m_ridge[cells - 1], [](double t, double mmPerN) {
                    return glm::dvec3(-0.7 + rise(t, 0.6, 1.2) * (0.2 + 3.9 * mmPerN), 0.0, 0.3);
                });
            scene.throwMmPerS = {200.0, 0.0, 0.0};
            scene.startMm = {-3.0, 0.0, 0.3};
            scene.mustStayLeft = true;
            scene.jumpsFromS = 0.6;
        }
        for (const auto& [name, at] : {std::pair("step 0.07", 0), std::pair("step 0.2", 1), std::pair("step 0.5", 2)}) {
            StabilityScene& scene = add(7, name, m_step[static_cast<std::size_t>(at)], [](double t, double mmPerN) {
                return glm::dvec3(-1.5 + 3.0 * rise(t, 0.3, 0.9) - 3.0 * rise(t, 0.9, 1.5) +
                                      urge(t, 0.3, 0.9, mmPerN, 0.35) - urge(t, 0.9, 1.5, mmPerN, 0.35),
                                  0.0, leaning(t, 0.3, mmPerN, 1.0));
            });
            scene.seconds = 2.2;
            scene.along = {1.0, 0.0, 0.0};
            scene.bars.jumpN = 0.5;
        }
    }

    void vanishingGround()
    {
        // The hand presses on a column, which is removed in one tick, as by undo or by thin fins that break off.
        StabilityScene& column =
            add(8, "column", enamelBlock([](glm::dvec2 at) {
                    return at.x > 0.0 && at.x < kCellMm && at.y > 0.0 && at.y < kCellMm ? 1.0 : 0.0;
                }),
                [](double t, double mmPerN) {
                    return glm::dvec3(0.5 * kCellMm, 0.5 * kCellMm, 1.5 - rise(t, 0.0, 0.4) * (0.5 + 2.0 * mmPerN));
                });
        column.swapAtS = 0.8;
        column.swapTop = m_plate->top;
        column.bars.jumpN = 0.4;

        auto thin = std::make_shared<core::terrain::ToothAnatomy>(*m_plate);
        thin->bottom.assign(thin->bottom.size(), -0.3F);
        StabilityScene& through = add(9, "perforation", thin, [](double t, double mmPerN) {
            return glm::dvec3(0.0, 0.0, leaning(t, 0.3, mmPerN, 2.0));
        });
        through.drill = true;
        through.seconds = 2.5;
        through.jumpsAboveMm = -2.0;
        through.bars.jumpN = 0.5;
    }

    void device()
    {
        // The hand brushes over the plate: three strokes of 8 mm, at up to 130 mm/s.
        for (const bool drilling : {false, true}) {
            StabilityScene& brush =
                add(10, drilling ? "brush, drilling" : "brush", m_plate, [](double t, double mmPerN) {
                    return glm::dvec3(0.0, 0.0, 0.5 - (rise(t, 0.3, 0.5) - rise(t, 0.8, 0.85)) * (0.5 + 0.3 * mmPerN));
                });
            brush.strokeMm = 4.0;
            brush.strokeHz = 5.0;
            brush.strokesToS = 1.2;
            brush.steadyS = {{0.55, 0.8}};
            brush.seconds = 2.4;
            brush.drill = drilling;
            if (drilling) {
                brush.bars.depthMm = 0.005;  // a trench holds the bur back: no limit of the lag
            } else {
                brush.along = {1.0, 0.0, 0.0};
                brush.bars.lagMm = 0.02;
            }
        }

        for (const int ms : {5, 20, 100, 500}) {
            // A hand that has sunk in meanwhile must lift the bur out before it feels a force again.
            StabilityScene& scene = add(11, "dropout " + std::to_string(ms), m_plate, [](double t, double mmPerN) {
                const double lifted = rise(t, 1.1, 1.3) - rise(t, 1.5, 1.8);
                return glm::dvec3(0.0, 0.0, leaning(t, 0.3, mmPerN, 2.0) * (1.0 - lifted) + 1.0 * lifted);
            });
            scene.silentFromS = 0.6;
            scene.silentForS = 0.001 * ms;
            scene.seconds = 2.6;
            scene.jumpsFromS = 0.6 + scene.silentForS;
            scene.jumpsToS = scene.jumpsFromS + 0.3;
            scene.bars.jumpN = 0.5;
        }
        StabilityScene& jitter = add(11, "jitter", m_plate, [](double t, double mmPerN) {
            return glm::dvec3(0.0, 0.0, leaning(t, 0.3, mmPerN, 2.0));
        });
        jitter.jitterS = 0.003;

        for (const auto& [name, um, dryN] :
             {std::tuple("counts 30", 30, -1.0), std::tuple("counts 100", 100, -1.0),
              std::tuple("counts 50, least friction", 50, 0.1), std::tuple("counts 50, no friction", 50, 0.0)}) {
            StabilityScene& scene = add(12, name, m_plate, [](double t, double mmPerN) {
                return glm::dvec3(0.0, 0.0, leaning(t, 0.3, mmPerN, 2.0));
            });
            scene.countShare = um / 48.0;  // of the real count sideways (docs/facts/haptics.md, section 5)
            scene.dryN = dryN;
        }
        StabilityScene& tremor = add(12, "tremor", m_plate, [](double t, double mmPerN) {
            return glm::dvec3(0.0, 0.0, leaning(t, 0.3, mmPerN, 2.0));
        });
        tremor.trembling = true;
        tremor.steadyS = {{0.7, 1.5}};

        // The hand is released at the end of the reach and led home; or it grabs the grip on the way, holds it, and
        // pulls it back.
        for (const bool grabbed : {false, true}) {
            StabilityScene& scene = add(13, grabbed ? "centring, grabbed" : "centring", m_plate, [](double t, double) {
                return glm::dvec3(39.5 + 10.0 * rise(t, 0.8, 1.1), 0.0, 5.0);
            });
            scene.startMm = {39.5, 0.0, 5.0};
            scene.homeAtS = 0.05;
            scene.grabAtS = grabbed ? 0.5 : kNever;
            scene.jumpsFromS = 0.0;
            scene.bars = {.jumpN = 0.2, .mostN = 2.0, .mmPerS = 100.0};
        }
    }

    void drilling()
    {
        auto layered = std::make_shared<core::terrain::ToothAnatomy>(*m_plate);
        for (core::terrain::ColumnLayers& column : layered->layers)
            column.dej = -0.4F;
        for (const auto& [name, newtons] : {std::pair("drill 0.5", 0.5), std::pair("drill 1", 1.0),
                                            std::pair("drill 2", 2.0), std::pair("drill 4", 4.0)}) {
            StabilityScene& scene = add(14, name, layered, [newtons = newtons](double t, double mmPerN) {
                return glm::dvec3(0.0, 0.0, leaning(t, 0.3, mmPerN, newtons));
            });
            scene.drill = true;
            scene.steadyS = {{0.6, 1.4}};
            scene.bars.buzzN = 0.1;
        }
        StabilityScene& inside = add(15, "inside", m_plate, [](double t, double mmPerN) {
            return glm::dvec3(0.0, 0.0, -2.0 + 2.5 * rise(t, 0.4, 0.7) - rise(t, 0.9, 1.2) * (0.5 + 2.0 * mmPerN));
        });
        inside.beginsInside = true;
    }

    void loops()
    {
        const auto around = [&](std::string name, const std::shared_ptr<const core::terrain::ToothAnatomy>& on,
                                const glm::dvec3& at) {
            StabilityScene& scene = add(16, std::move(name), on, {});
            scene.loops = true;
            scene.loopsAtMm = at;
        };
        around("loops, plate", m_plate, {0.0, 0.0, -0.1});
        around("loops, pit", m_pit, {0.0, 0.0, -0.2});
        around("loops, groove", m_groove[2], {0.0, 0.0, 0.05});
        around("loops, wall", m_wall, {-0.4, 0.0, -0.1});
        around("loops, ridge", m_ridge[0], {-0.4, 0.0, 0.4});
        around("loops, step", m_step[1], {-0.2, 0.0, 0.0});
    }

    std::shared_ptr<const core::terrain::ToothAnatomy> m_plate = enamelBlock(flat);
    std::shared_ptr<const core::terrain::ToothAnatomy> m_pit = enamelBlock(pit);
    std::shared_ptr<const core::terrain::ToothAnatomy> m_slope =
        enamelBlock([](glm::dvec2 at) { return kSlope * at.x; });
    std::shared_ptr<const core::terrain::ToothAnatomy> m_wall = enamelBlock(wall);
    /// With the crease on a row of columns, a quarter of a cell beside it, and between two rows.
    std::array<std::shared_ptr<const core::terrain::ToothAnatomy>, 3> m_groove{
        enamelBlock(groove, core::terrain::kDefaultGridSide, {0.5, 0.0}),
        enamelBlock(groove, core::terrain::kDefaultGridSide, {0.25, 0.0}), enamelBlock(groove)};
    std::array<std::shared_ptr<const core::terrain::ToothAnatomy>, 2> m_ridge{enamelBlock(ridge(1)),
                                                                              enamelBlock(ridge(2))};
    std::array<std::shared_ptr<const core::terrain::ToothAnatomy>, 3> m_step{
        enamelBlock(step(0.07)), enamelBlock(step(0.2)), enamelBlock(step(0.5))};
};

}  // namespace

const std::vector<StabilityScene>& stabilityScenesInFull()
{
    static const std::vector<StabilityScene> all = Scenes().list;
    return all;
}

}  // namespace lab
