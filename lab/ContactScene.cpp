// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/ContactScene.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/bur/Bur.h"
#include "haptics/simulated/Simulation.h"
#include "haptics/simulated/TickTimes.h"
#include "lab/Block.h"

namespace lab {
namespace {

using core::bur::Bur;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kPushS = 0.15;
constexpr double kWaitS = 0.01;  ///< pause after it
constexpr double kPushMm = 0.5;
constexpr double kWallMm = 3.0;
constexpr double kStillMm = 1.0e-6;  ///< in a tick: no lag can be measured on a shorter way

using Profile = std::function<double(double)>;

/// A surface made of one profile, swept along a line or turned about the origin.
struct Surface
{
    enum class Kind { Ruled, Round };
    Kind kind = Kind::Ruled;
    glm::dvec2 across{1.0, 0.0};  ///< of a ruled surface: direction of its profile
    Profile height;
    Profile clearance;  ///< of the bur, exactly: the profile's own offset

    [[nodiscard]] double along(glm::dvec2 at) const
    {
        return kind == Kind::Ruled ? glm::dot(at, across) : std::sqrt(glm::dot(at, at));
    }
    [[nodiscard]] glm::dvec2 direction(glm::dvec2 at) const
    {
        const double length = std::sqrt(glm::dot(at, at));
        return kind == Kind::Ruled || length <= 0.0 ? across : at / length;
    }
};

/// Returns max over 0 <= r <= R of slope * r - underside(r): height of a bur over a plane under its axis.
double standOff(const Bur& bur, double slope)
{
    constexpr int kSteps = 200'000;
    double most = -1.0e9;
    for (int k = 0; k <= kSteps; ++k) {
        const double r = bur.headRadiusMm * k / kSteps;
        most = std::max(most, slope * r - bur.undersideMm(r));
    }
    return most;
}

/// Returns the offset of a smooth profile, as a table.
Profile offsetOf(const Profile& height, const Bur& bur)
{
    constexpr int kPlaces = 8192;
    constexpr int kSteps = 2000;
    constexpr double kFrom = -4.0;
    constexpr double kTo = 4.0;
    auto table = std::make_shared<std::vector<double>>();
    const auto over = [&](double u, double r) { return height(u + r) - bur.undersideMm(std::abs(r)); };
    for (int place = 0; place <= kPlaces; ++place) {
        const double u = kFrom + (kTo - kFrom) * place / kPlaces;
        double best = -1.0e9;
        double bestR = 0.0;
        for (int k = 0; k <= kSteps; ++k) {
            const double r = bur.headRadiusMm * (2.0 * k / kSteps - 1.0);
            if (over(u, r) > best) {
                best = over(u, r);
                bestR = r;
            }
        }
        double low = std::max(-bur.headRadiusMm, bestR - 2.0 * bur.headRadiusMm / kSteps);
        double high = std::min(bur.headRadiusMm, bestR + 2.0 * bur.headRadiusMm / kSteps);
        for (int k = 0; k < 40; ++k) {
            const double a = low + (high - low) / 3.0;
            const double b = high - (high - low) / 3.0;
            (over(u, a) < over(u, b) ? low : high) = over(u, a) < over(u, b) ? a : b;
        }
        table->push_back(std::max(best, over(u, 0.5 * (low + high))));
    }
    return [table](double u) {
        const double at = std::clamp((u - kFrom) / (kTo - kFrom) * kPlaces, 0.0, kPlaces - 1.0e-9);
        const auto k = static_cast<std::size_t>(at);
        const double share = at - static_cast<double>(k);
        return (*table)[k] * (1.0 - share) + (*table)[k + 1] * share;
    };
}

/// The position of a bur without friction while the hand moves. It walks downhill in distance to the hand along the
/// offset surface, a micrometre at a time, so that it skips no place.
class Slider
{
public:
    Slider(const Surface& surface, const glm::dvec3& start) : m_surface(surface), m_u(surface.along(start)) {}

    glm::dvec3 follow(const glm::dvec3& device)
    {
        const double deviceU = m_surface.along(device);
        const auto far2 = [&](double u) {
            const double rise = std::max(0.0, m_surface.clearance(u) - device.z);
            return (u - deviceU) * (u - deviceU) + rise * rise;
        };
        constexpr double kStepMm = 1.0e-3;
        // A ball with its equator at an edge rises by 0.03 mm in the first step. A higher step is a cliff, which no bur
        // climbs.
        constexpr double kCliffMm = 0.035;
        const auto isCliff = [&](double from, double to) {
            const double rise = m_surface.clearance(to) - m_surface.clearance(from);
            return rise > kCliffMm && m_surface.clearance(to) > device.z;
        };
        for (const double step : {kStepMm, -kStepMm})
            while (far2(m_u + step) < far2(m_u) && !isCliff(m_u, m_u + step))
                m_u += step;
        double low = m_u - (isCliff(m_u, m_u - kStepMm) ? 0.0 : kStepMm);
        double high = m_u + (isCliff(m_u, m_u + kStepMm) ? 0.0 : kStepMm);
        for (int k = 0; k < 40; ++k) {
            const double a = low + (high - low) / 3.0;
            const double b = high - (high - low) / 3.0;
            (far2(a) > far2(b) ? low : high) = far2(a) > far2(b) ? a : b;
        }
        // At an edge, the middle may be beyond it.
        m_u = far2(low) < far2(high) ? low : high;
        const glm::dvec2 place = glm::dvec2(device) + m_surface.direction(device) * (m_u - deviceU);
        return {place, std::max(device.z, m_surface.clearance(m_u))};
    }

private:
    const Surface& m_surface;
    double m_u;
};

/// Position of the lattice under a scene: turned, and moved by parts of a cell.
struct Lie
{
    double turnDeg;
    glm::dvec2 shift;
};
constexpr std::array<Lie, 6> kLies{{{0.0, {0.0, 0.0}},
                                    {0.0, {0.5, 0.5}},
                                    {0.0, {0.25, 0.25}},
                                    {15.0, {0.1, 0.4}},
                                    {33.0, {0.7, 0.2}},
                                    {45.0, {0.3, 0.9}}}};

glm::dvec2 turned(double degrees)
{
    return {std::cos(degrees * kDegree), std::sin(degrees * kDegree)};
}

std::size_t ticksIn(double seconds, const ContactConditions& conditions)
{
    return static_cast<std::size_t>(std::lround(seconds * conditions.rateHz));
}

/// Returns a scene in which the hand presses into the surface at `place(0)`, along `inwards`, and then follows place().
/// @param place   path over the surface, mm, of the travel so far
/// @param ground  height that the hand assumes for the surface, over u
ContactScene slide(const Surface& surface, const Profile& ground, const ContactConditions& conditions, glm::dvec2 shift,
                   const glm::dvec3& inwards, const std::function<glm::dvec2(double)>& place, double lengthMm,
                   double mmPerS)
{
    ContactScene scene;
    scene.anatomy =
        enamelBlock([&](glm::dvec2 at) { return surface.height(surface.along(at)); }, conditions.side, shift);
    scene.burIndex = conditions.bur;
    const auto onSurface = [&](glm::dvec2 at) { return glm::dvec3(at, ground(surface.along(at))); };
    Slider slider(surface, onSurface(place(0.0)));
    const double tickS = 1.0 / conditions.rateHz;
    const auto travelTicks = static_cast<std::size_t>(lengthMm / (mmPerS * tickS));
    scene.counted = ticksIn(kPushS + kWaitS, conditions);
    for (std::size_t tick = 0; tick < scene.counted + travelTicks; ++tick) {
        const double depth = kPushMm * std::min(1.0, static_cast<double>(tick) * tickS / kPushS - 0.1);
        const double travel = tick < scene.counted ? 0.0 : static_cast<double>(tick - scene.counted) * mmPerS * tickS;
        const glm::dvec3 device = onSurface(place(travel)) + inwards * depth;
        scene.device.push_back(device);
        scene.right.push_back(slider.follow(device));
    }
    return scene;
}

ContactFamily planes(double degrees, const ContactConditions& conditions)
{
    const double slope = std::tan(degrees * kDegree);
    const double stand = standOff(core::bur::burs()[conditions.bur], slope);
    ContactFamily family;
    const auto row = [&](double rms, double most, double jump) {
        family.reachRmsUm = rms;
        family.reachMostUm = most;
        family.reachJumpN = jump;
    };
    if (degrees < 50.0)
        row(1.0, 5.0, 0.01);
    else if (degrees < 70.0)
        row(3.0, 15.0, 0.05);
    else
        row(15.0, 60.0, 0.05);
    for (const Lie& lie : kLies) {
        Surface surface;
        surface.across = turned(lie.turnDeg);
        surface.height = [slope](double u) { return slope * u; };
        surface.clearance = [slope, stand](double u) { return slope * u + stand; };
        const glm::dvec3 inwards = -glm::normalize(glm::dvec3(-slope * surface.across, 1.0));
        for (const double speed : {20.0, 100.0, 300.0}) {
            const glm::dvec2 heading = turned(lie.turnDeg + 40.0) * std::cos(degrees * kDegree);
            const auto place = [&](double travel) { return heading * (travel - 1.5); };
            family.scenes.push_back(
                slide(surface, surface.clearance, conditions, lie.shift, inwards, place, 3.0, speed));
        }
    }
    return family;
}

ContactFamily bowls(bool isFossa, const ContactConditions& conditions)
{
    const double radius = isFossa ? 3.0 : 2.0;
    // Beyond 60 degrees the sphere continues as its tangent cone.
    const double edge = radius * std::sin(60.0 * kDegree);
    const Profile cap = [radius, edge](double u) {
        const double r = std::min(std::abs(u), edge);
        const double depth = std::sqrt(radius * radius - r * r);
        return radius - depth + std::tan(60.0 * kDegree) * (std::abs(u) - r);
    };
    Surface surface;
    surface.kind = Surface::Kind::Round;
    surface.height = isFossa ? cap : Profile([cap](double u) { return -cap(u); });
    surface.clearance = offsetOf(surface.height, core::bur::burs()[conditions.bur]);
    ContactFamily family{{}, {}, 3.0, 10.0, 0.02};
    for (const Lie& lie : kLies) {
        for (const double speed : {20.0, 100.0}) {
            const glm::dvec2 heading = turned(lie.turnDeg + 25.0);
            const glm::dvec2 aside(-heading.y, heading.x);
            // Beside the axis, where a cusp has a nearest point.
            const auto place = [&](double travel) { return heading * (travel - 0.8) + aside * 0.5; };
            family.scenes.push_back(
                slide(surface, surface.clearance, conditions, lie.shift, {0.0, 0.0, -1.0}, place, 1.6, speed));
        }
    }
    return family;
}

ContactFamily grooves(double degrees, bool creaseOnNodes, const ContactConditions& conditions)
{
    const double slope = std::tan(degrees * kDegree);
    const double stand = standOff(core::bur::burs()[conditions.bur], slope);
    ContactFamily family;
    const double cell = kBlockExtentMm / conditions.side;
    family.reachRmsUm = creaseOnNodes ? 5.0 : 500.0 * slope * cell;
    family.reachMostUm = creaseOnNodes ? 15.0 : 750.0 * slope * cell;
    family.reachJumpN = 0.05;
    for (const Lie& lie : kLies) {
        Surface surface;
        // A row of nodes is at the origin if the side is odd or the lattice is shifted by half a cell.
        const double onNodes = conditions.side % 2 == 0 ? 0.5 : 0.0;
        surface.across = creaseOnNodes ? glm::dvec2(1.0, 0.0) : turned(lie.turnDeg);
        const glm::dvec2 shift = creaseOnNodes ? glm::dvec2(onNodes, lie.shift.y) : lie.shift;
        surface.height = [slope](double u) { return slope * std::abs(u); };
        surface.clearance = [slope, stand](double u) { return slope * std::abs(u) + stand; };
        const glm::dvec2 along(-surface.across.y, surface.across.x);
        for (const double speed : {20.0, 100.0}) {
            // The hand weaves slightly sideways while it slides along.
            const auto place = [&](double travel) {
                return along * (travel - 1.5) + surface.across * (0.1 * std::sin(4.0 * travel));
            };
            family.scenes.push_back(
                slide(surface, surface.clearance, conditions, shift, {0.0, 0.0, -1.0}, place, 3.0, speed));
        }
    }
    return family;
}

/// Returns the offset of a step from 0 up to `heightMm` at u = 0.
Profile overStep(double heightMm, const Bur& bur)
{
    return [heightMm, bur](double u) {
        if (u >= 0.0)
            return heightMm;
        return -u > bur.headRadiusMm ? 0.0 : std::max(0.0, heightMm - bur.undersideMm(-u));
    };
}

ContactFamily walls(const ContactConditions& conditions)
{
    const Bur& shape = core::bur::burs()[conditions.bur];
    const double cell = kBlockExtentMm / conditions.side;
    ContactFamily family{{}, {}, 500.0 * cell, 1000.0 * cell, 0.1};
    for (const Lie& lie : kLies) {
        Surface surface;
        surface.across = turned(lie.turnDeg);
        surface.height = [](double u) { return u > 0.0 ? kWallMm : 0.0; };
        surface.clearance = overStep(kWallMm, shape);
        const glm::dvec2 along(-surface.across.y, surface.across.x);
        // The hand moves onto the floor 0.5 mm before the wall, then 0.4 mm into the wall, then along it.
        const double before = shape.headRadiusMm + 0.5;
        const auto place = [&](double travel) {
            return along * (std::max(0.0, travel - 1.5) - 0.7) + surface.across * (std::min(travel, 0.9) - before);
        };
        for (const double speed : {20.0, 100.0})
            family.scenes.push_back(slide(
                surface, [](double) { return 0.0; }, conditions, lie.shift, {0.0, 0.0, -1.0}, place, 3.5, speed));
    }
    return family;
}

ContactFamily corners(const ContactConditions& conditions)
{
    const Bur& shape = core::bur::burs()[conditions.bur];
    const double cell = kBlockExtentMm / conditions.side;
    const double radius = shape.headRadiusMm;
    ContactFamily family{{}, {}, 500.0 * cell, 1000.0 * cell, 0.1};
    for (const Lie& lie : kLies) {
        const glm::dvec2 x = turned(lie.turnDeg);
        const glm::dvec2 y(-x.y, x.x);
        ContactScene scene;
        scene.burIndex = conditions.bur;
        scene.anatomy =
            enamelBlock([&](glm::dvec2 at) { return glm::dot(at, x) > 0.0 || glm::dot(at, y) > 0.0 ? kWallMm : 0.0; },
                        conditions.side, lie.shift);
        scene.counted = ticksIn(0.1, conditions);
        for (std::size_t tick = 0; tick < ticksIn(1.5, conditions); ++tick) {
            // The hand moves down onto the floor, then into the corner, and slightly to and fro in it.
            const double t = static_cast<double>(tick) / conditions.rateHz;
            const double depth = 0.3 * std::min(1.0, t / 0.08 - 0.1);
            const double far = std::clamp((t - 0.1) * 2.0, 0.0, 0.9);
            const double sway = 0.05 * std::sin(20.0 * t);
            const double u = -radius - 0.5 + far + sway;
            const double v = -radius - 0.5 + far - sway;
            scene.device.emplace_back(x * u + y * v, -depth);
            scene.right.emplace_back(x * std::min(u, -radius) + y * std::min(v, -radius), std::max(0.0, -depth));
        }
        family.scenes.push_back(std::move(scene));
    }
    return family;
}

ContactFamily steps(double heightMm, const ContactConditions& conditions)
{
    const Bur& shape = core::bur::burs()[conditions.bur];
    const double cell = kBlockExtentMm / conditions.side;
    ContactFamily family{{}, {}, 500.0 * cell, 1000.0 * cell, 0.1};
    for (const Lie& lie : kLies) {
        Surface surface;
        surface.across = turned(lie.turnDeg);
        surface.height = [heightMm](double u) { return u > 0.0 ? heightMm : 0.0; };
        surface.clearance = overStep(heightMm, shape);
        for (const bool up : {true, false}) {
            ContactScene scene;
            scene.burIndex = conditions.bur;
            scene.anatomy = enamelBlock([&](glm::dvec2 at) { return surface.height(surface.along(at)); },
                                        conditions.side, lie.shift);
            scene.counted = ticksIn(0.06, conditions);
            const double from = up ? -1.2 : 1.2;
            const double low = up ? 0.0 : heightMm;
            Slider slider(surface, {surface.across * from, low});
            for (std::size_t tick = 0; tick < ticksIn(1.3, conditions); ++tick) {
                const double t = static_cast<double>(tick) / conditions.rateHz;
                const double depth = 0.25 * std::min(1.0, t / 0.05 - 0.1);
                const double travel = 2.0 * std::max(0.0, t - 0.06);
                const double u = from + (up ? travel : -travel);
                // The hand keeps its height until the bur is past the edge, then follows the new ground.
                const double ground = up ? heightMm * std::clamp((u + 0.4) / 0.8, 0.0, 1.0)
                                         : heightMm * std::clamp((u + shape.headRadiusMm) / 0.8, 0.0, 1.0);
                const glm::dvec3 device(surface.across * u, ground - depth);
                scene.device.push_back(device);
                scene.right.push_back(slider.follow(device));
            }
            family.scenes.push_back(std::move(scene));
        }
    }
    return family;
}

/// One row of the table.
struct Maker
{
    std::string name;
    std::function<ContactFamily(const ContactConditions&)> make;
};

const std::vector<Maker>& makers()
{
    using Conditions = ContactConditions;
    static const std::vector<Maker> all = [] {
        std::vector<Maker> list;
        for (const int degrees : {0, 10, 20, 27, 45, 60, 75})
            list.push_back(
                {"plane " + std::to_string(degrees), [=](const Conditions& with) { return planes(degrees, with); }});
        list.push_back({"fossa", [](const Conditions& with) { return bowls(true, with); }});
        list.push_back({"cusp", [](const Conditions& with) { return bowls(false, with); }});
        for (const int degrees : {30, 45})
            for (const bool onNodes : {true, false})
                list.push_back({"groove " + std::to_string(degrees) + (onNodes ? "" : " anywhere"),
                                [=](const Conditions& with) { return grooves(degrees, onNodes, with); }});
        list.push_back({"wall", walls});
        list.push_back({"pit corner", corners});
        for (const char* height : {"0.07", "0.20", "0.50"})
            list.push_back({std::string("step ") + height,
                            [=](const Conditions& with) { return steps(std::strtod(height, nullptr), with); }});
        return list;
    }();
    return all;
}

}  // namespace

std::vector<std::string> contactFamilyNames()
{
    std::vector<std::string> names;
    for (const Maker& maker : makers())
        names.push_back(maker.name);
    return names;
}

ContactFamily contactFamily(const std::string& name, const ContactConditions& conditions)
{
    const auto found =
        std::find_if(makers().begin(), makers().end(), [&](const Maker& maker) { return maker.name == name; });
    assert(found != makers().end());
    ContactFamily family = found->make(conditions);
    family.name = name;
    family.rateHz = conditions.rateHz;
    return family;
}

std::vector<ContactFamily> contactFamilies(int side, std::size_t bur)
{
    std::vector<ContactFamily> families;
    for (const std::string& name : contactFamilyNames())
        families.push_back(contactFamily(name, {side, bur}));
    return families;
}

double ridgeHoldsN(const std::string& method, int cells, std::size_t bur, double stiffnessNPerMm)
{
    constexpr int kSide = 150;
    constexpr double kStepN = 0.25;
    constexpr double kMostN = 6.0;
    const double cell = kBlockExtentMm / kSide;
    const double half = 0.5 * cell * cells;
    const double radius = core::bur::burs()[bur].headRadiusMm;
    double least = kMostN;
    for (const Lie& lie : kLies) {
        const glm::dvec2 across = turned(lie.turnDeg);
        const auto anatomy = enamelBlock(
            [&](glm::dvec2 at) { return std::abs(glm::dot(at, across)) < half + 0.01 * cell ? kWallMm : 0.0; }, kSide,
            lie.shift);
        for (const double mmPerS : {1.0, 20.0, 200.0}) {
            core::contact::LiveTooth tooth{core::terrain::Tooth(anatomy)};
            tooth.selectBur(bur);
            const auto contact = core::contact::makeContactMethod(method).value();
            const double start = -radius - 0.3;
            contact->restart({across * start, 0.5});
            const double reach = kMostN / stiffnessNPerMm - radius - half;
            double held = 0.0;
            for (double u = start; u < reach; u += mmPerS * 1.0e-3) {
                const glm::dvec3 anchor = contact->update(tooth, {across * u, 0.5});
                if (glm::dot(glm::dvec2(anchor), across) > 0.0 || anchor.z > 1.0)
                    break;
                held = std::max(held, stiffnessNPerMm * (u + radius + half));
            }
            least = std::min(least, std::floor(held / kStepN + 1.0e-9) * kStepN);
        }
    }
    return least;
}

namespace {

/// Returns for every tick the longest leap of the right bur within kLeapS of it, mm; 0 if there is none.
std::vector<double> leapsNear(const ContactScene& scene, double rateHz)
{
    const auto reach = static_cast<std::size_t>(std::lround(kLeapS * rateHz));
    std::vector<double> leaps(scene.right.size(), 0.0);
    for (std::size_t tick = 1; tick < scene.right.size(); ++tick) {
        const double moved = glm::length(scene.right[tick] - scene.right[tick - 1]);
        if (moved < kLeapMm + glm::length(scene.device[tick] - scene.device[tick - 1]))
            continue;
        const std::size_t last = std::min(leaps.size() - 1, tick + reach);
        for (std::size_t near = tick - std::min(tick, reach); near <= last; ++near)
            leaps[near] = std::max(leaps[near], moved);
    }
    return leaps;
}

}  // namespace

ContactErrors measureContact(const ContactFamily& family, const std::string& method, double stiffnessNPerMm)
{
    ContactErrors errors;
    double sum2 = 0.0;
    double count = 0.0;
    double lag = 0.0;
    double moving = 0.0;
    for (const ContactScene& scene : family.scenes) {
        core::contact::LiveTooth tooth{core::terrain::Tooth(scene.anatomy)};
        tooth.selectBur(scene.burIndex);
        const auto contact = core::contact::makeContactMethod(method).value();
        contact->restart(scene.device.front());
        const std::vector<double> leaps = leapsNear(scene, family.rateHz);
        glm::dvec3 before{0.0};
        glm::dvec3 anchorBefore{0.0};
        for (std::size_t tick = 0; tick < scene.device.size(); ++tick) {
            const double started = haptics::threadCpuUs();
            const glm::dvec3 anchor = contact->update(tooth, scene.device[tick]);
            const double took = haptics::threadCpuUs() - started;
            const glm::dvec3 apart = anchor - scene.right[tick];
            if (tick >= scene.counted) {
                errors.times.add(took);
                double jump = glm::length(apart - before);
                if (leaps[tick] > 0.0) {
                    jump = glm::length(anchor - anchorBefore) - leaps[tick];
                } else {
                    const double far = 1000.0 * glm::length(apart);
                    sum2 += far * far;
                    count += 1.0;
                    errors.mostUm = std::max(errors.mostUm, far);
                    const glm::dvec3 way = scene.right[tick] - scene.right[tick - 1];
                    const double wayMm = glm::length(way);
                    if (wayMm > kStillMm) {
                        lag -= 1000.0 * glm::dot(apart, way) / wayMm;
                        moving += 1.0;
                    }
                }
                errors.jumpN = std::max(errors.jumpN, stiffnessNPerMm * jump);
            }
            before = apart;
            anchorBefore = anchor;
        }
    }
    errors.rmsUm = std::sqrt(sum2 / std::max(1.0, count));
    errors.lagUm = lag / std::max(1.0, moving);
    errors.tickUs = errors.times.percentileUs(0.99);
    return errors;
}

}  // namespace lab
