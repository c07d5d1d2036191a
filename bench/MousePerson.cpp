// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/MousePerson.h"
#include "core/rt/TripleBuffer.h"
#include "core/servo/ServoState.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/bur/Bur.h"
#include "haptics/pointer/PointerDevice.h"
#include "haptics/simulated/Simulation.h"
#include "ui/render/WholeSurface.h"
#include "ui/tooth/PointerControl.h"
#include "ui/tooth/Viewpoint.h"

namespace bench {
namespace {

constexpr std::uint64_t kTicksPerPicture = 16;
constexpr int kPicturesPerSight = 6;  ///< pictures between two looks at the whole tooth
constexpr double kPictureS = 0.016;
constexpr double kTremblePx = 2.0;
constexpr double kTrembleS = 0.3;      ///< correlation time of the tremble
constexpr double kHasArrivedS = 0.25;  ///< the bur has arrived under the pointer after this time
constexpr double kLeapPx = 20.0;       ///< a longer step of the pointer in one picture is a jump

}  // namespace

core::Result<Doing> work(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy,
                         const core::servo::ServoSettings& settings, std::size_t bur, const MouseHand& hand,
                         const ui::tooth::Camera& camera, double mostSeconds,
                         const std::function<Deed(const Sight&)>& decide)
{
    const auto surface = ui::render::wholeSurface(anatomy, ui::tooth::operatingLight(false));
    ui::tooth::PointerControl control;
    control.setSurface(surface.get());
    control.setBurRadius(core::bur::burs()[bur].headRadiusMm);
    control.setForce(hand.forceN);
    control.setFeed(hand.feedMmPerS);
    control.setStopOn(hand.stopMm.has_value());
    core::rt::TripleBuffer<core::servo::PointerInput> input;
    haptics::PointerDevice device(input, settings.force.stiffnessNPerMm, 1.0e-3);

    auto shown = std::make_shared<const std::vector<float>>(anatomy->top);
    int picture = 0;
    double arrivingS = 0.0;
    glm::dvec2 pointer{-1000.0};
    std::optional<double> surfaceMm;  ///< original surface at the contact
    double deepestMm = 0.0;
    double mostOffRayPx = 0.0;
    double mostForceN = 0.0;
    double seconds = 0.0;
    const auto before = [&](std::uint64_t tick, const core::servo::ServoState& state,
                            const core::terrain::Tooth& tooth) -> std::optional<bool> {
        if (tick % kTicksPerPicture != 0)
            return true;
        seconds = static_cast<double>(tick) * 1.0e-3;
        control.follow(state);
        if (picture++ % kPicturesPerSight == 0 && tooth.top != *shown) {
            static_cast<void>(surface->refresh(true));
            shown = std::make_shared<const std::vector<float>>(tooth.top);
        }
        Sight sight{seconds, camera.pixelOf(state.anchorMm), state.anchorMm, control.depthMm(state.anchorMm.z), {},
                    shown};
        if (state.touching)
            sight.under = state.materialUnderBur;
        // Compares the bur with the last position of the pointer that the program received.
        arrivingS += kPictureS;
        if (!control.isPushing() && arrivingS > kHasArrivedS)
            mostOffRayPx = std::max(mostOffRayPx, glm::distance(sight.burPx, pointer));
        if (sight.depthMm)
            surfaceMm = state.anchorMm.z + *sight.depthMm;
        const Deed deed = decide(sight);
        if (deed.isDone)
            return std::nullopt;
        if (glm::distance(deed.pointerPx, pointer) > kLeapPx || deed.pressed)
            arrivingS = 0.0;
        pointer = deed.pointerPx;
        control.setStopDepth(deed.stopMm);
        control.push(deed.pressed);
        control.moveTo(camera.rayThrough(pointer), state.anchorMm);
        core::servo::PointerInput wish = control.input(state.anchorMm);
        wish.feedMmPerS = hand.feedMmPerS > 0.0 ? wish.feedMmPerS : 0.0;
        input.publish(wish);
        return true;
    };
    haptics::SimulationOptions options;
    options.settings = settings;
    options.burIndex = bur;
    options.onPatch = [&](const core::servo::TilePatch& patch) { surface->write(patch); };
    const auto after = [&](std::uint64_t, const core::servo::ServoState& state) {
        mostForceN = std::max(mostForceN, glm::length(state.forceN));
        if (surfaceMm && state.cutting)
            deepestMm = std::max(deepestMm, *surfaceMm - state.anchorMm.z);
    };
    auto outcome =
        haptics::simulate(anatomy, device, static_cast<std::uint64_t>(1000.0 * mostSeconds), options, before, after);
    if (!outcome)
        return tl::unexpected(outcome.error());
    return Doing{std::move(outcome->tooth), outcome->last, seconds, deepestMm, mostOffRayPx, mostForceN};
}

Person::Person(std::uint64_t seed) : m_rng(seed), m_delayS(0.3) {}

const Sight* Person::see(const Sight& sight)
{
    m_seen.push_back(sight);
    while (!m_seen.empty() && m_seen.front().seconds <= sight.seconds - m_delayS) {
        m_minded = m_seen.front();
        m_seen.pop_front();
        // Triangular from 0.2 to 0.45 s with its top at 0.25 s: 0.3 s on average.
        const double share = m_rng.uniform();
        m_delayS = share < 0.2 ? 0.2 + std::sqrt(share * 0.0125) : 0.45 - std::sqrt((1.0 - share) * 0.05);
    }
    return m_minded ? &*m_minded : nullptr;
}

glm::dvec2 Person::aim(glm::dvec2 meantPx)
{
    const double kept = std::exp(-kPictureS / kTrembleS);
    const double fresh = kTremblePx * std::sqrt(1.0 - kept * kept);
    m_tremblePx = m_tremblePx * kept + glm::dvec2(m_rng.normal(), m_rng.normal()) * fresh;
    return meantPx + m_tremblePx;
}

}  // namespace bench
