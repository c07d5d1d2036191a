// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/Stability.h"
#include "core/servo/ServoState.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "haptics/falcon/FalconFeel.h"
#include "lab/BandPass.h"
#include "lab/StabilityScenes.h"

namespace lab {
namespace {

constexpr double kTickS = 0.001;
constexpr double kWatchedS = 0.5;  ///< part of the time that the hand is still
constexpr double kSettledMm = 0.05;
constexpr double kEndS = 0.1;      ///< average at the end of the grip's motion
constexpr double kStaleS = 0.010;  ///< a device without data for this time has no reading (HapticDevice.h)
constexpr double kLetGoS = 0.020;  ///< time after which the servo must give no force
constexpr double kPressingMm = 0.05;

/// The device of a trial, silent for a while if the scene asks for it.
class TrialDevice final : public haptics::HapticDevice
{
public:
    TrialDevice(const haptics::FalconFigures& figures, const haptics::HandFigures& hand, const glm::dvec3& start)
        : falcon(figures, hand, kTickS, 1, start)
    {}
    haptics::DeviceSample exchange(const glm::dvec3& forceOnHandN) noexcept override
    {
        haptics::DeviceSample sample = falcon.exchange(forceOnHandN);
        if (!silent) {
            m_silentS = 0.0;
            m_last = sample;
            return sample;
        }
        m_silentS += kTickS;
        sample = m_last;
        sample.present = m_silentS <= kStaleS;
        return sample;
    }

    haptics::SimulatedFalcon falcon;
    bool silent = false;

private:
    haptics::DeviceSample m_last;
    double m_silentS = 0.0;
};

/// A hand on a fixed path, and the work of the forces on it.
class GivenPath final : public haptics::HapticDevice
{
public:
    haptics::DeviceSample exchange(const glm::dvec3& forceOnHandN) noexcept override
    {
        // The force answers the last position of the hand, and is constant while the hand moves on.
        trapeziumMj += 0.5 * glm::dot(m_forceN + forceOnHandN, m_at - m_before);
        const glm::dvec3 at{glm::vec3(next)};  // the servo uses floats
        heldMj += glm::dot(forceOnHandN, at - m_at);
        m_before = m_at;
        m_at = at;
        m_forceN = forceOnHandN;
        return {glm::vec3(next), true};
    }
    glm::dvec3 next{0.0};
    double heldMj = 0.0;       ///< given to the hand by the force as the device holds it
    double trapeziumMj = 0.0;  ///< and by a force that changes evenly

private:
    glm::dvec3 m_at{0.0};
    glm::dvec3 m_before{0.0};
    glm::dvec3 m_forceN{0.0};
};

std::unique_ptr<Contestant> contestantFor(const StabilityScene& scene, const StabilityTrial& trial,
                                          haptics::HapticDevice& device)
{
    core::servo::ServoSettings settings = trial.settings;
    haptics::falcon::addFalconFeel(settings.force);
    settings.force.vibrationN = 0.0;  // an intended tremble is not the loop's
    return *makeContestant(settings, trial.ceds, device,
                           std::make_unique<core::contact::LiveTooth>(core::terrain::Tooth(scene.anatomy)), scene.drill,
                           std::chrono::milliseconds(1));
}

/// A circle on which the device is led.
struct Circle
{
    glm::dvec3 a;
    glm::dvec3 b;
    double radiusMm;
    double hz;
};

/// Moves the device along several circles and returns the largest energy that one revolution adds to the hand, in uJ.
/// The first revolutions are not counted.
double worstLeakUj(const StabilityScene& scene, const StabilityTrial& trial, double GivenPath::*energy)
{
    constexpr double kDownS = 0.1;
    const glm::dvec3 x(1.0, 0.0, 0.0);
    const glm::dvec3 y(0.0, 1.0, 0.0);
    const glm::dvec3 z(0.0, 0.0, 1.0);
    double worst = -1.0e9;
    for (const Circle& circle : {Circle{z, x, 0.3, 5.0}, Circle{z, y, 0.4, 2.0}, Circle{x, y, 0.2, 5.0},
                                 Circle{glm::normalize(x + z), y, 0.3, 2.0}, Circle{z, x, 1.0, 1.0}}) {
        GivenPath device;
        const auto at = [&](double t) {
            const double turn = 2.0 * std::numbers::pi * circle.hz * std::max(0.0, t - kDownS);
            const double above = 2.0 * std::max(0.0, 1.0 - t / kDownS);
            return scene.loopsAtMm + circle.radiusMm * (circle.a * std::cos(turn) + circle.b * std::sin(turn)) +
                   glm::dvec3(0.0, 0.0, above);
        };
        device.next = at(0.0);
        const auto servo = contestantFor(scene, trial, device);
        const int round = static_cast<int>(std::lround(1.0 / (circle.hz * kTickS)));
        // If a bur began inside the tooth, its force builds up gradually: that time is not counted.
        const int first =
            static_cast<int>(std::lround(kDownS / kTickS)) +
            round * (1 + static_cast<int>(std::ceil(circle.hz * 2.0 * core::contact::ForceLaw::kReturnS)));
        double before = 0.0;
        for (int tick = 0; tick <= first + round; ++tick) {
            device.next = at(tick * kTickS);
            servo->tick();
            if (tick == first)
                before = device.*energy;
        }
        worst = std::max(worst, 1000.0 * (device.*energy - before));
    }
    return worst;
}

/// Returns the trial with the spring alone, so that no friction hides the effect of the method.
StabilityTrial bare(const StabilityTrial& trial)
{
    StabilityTrial spring = trial;
    core::contact::ForceSettings& force = spring.settings.force;
    force.dampingNSPerM = 0.0;
    force.fastDampingNSPerM = 0.0;
    force.brakeN = 0.0;
    force.friction = 0.0;
    force.clampN = 20.0;
    force.slewNPerS = 1.0e6;
    spring.ceds.frictionNSPerM = 0.0;
    spring.ceds.slewNPerS = 1.0e6;
    return spring;
}

/// Collects the results of a held trial, tick by tick.
class Watch
{
public:
    Watch(const StabilityScene& scene, std::size_t ticks) : m_scene(scene), m_band(kTickS) { m_grip.reserve(ticks); }

    void add(double t, const core::servo::ServoState& state, const glm::dvec3& grip)
    {
        const bool resting = t >= m_scene.seconds - kWatchedS;
        const bool steady =
            resting || std::any_of(m_scene.steadyS.begin(), m_scene.steadyS.end(),
                                   [t](const auto& span) { return t >= span.first && t < span.second; });
        const glm::dvec3 tremble = m_band(state.forceN);
        const double force = glm::length(state.forceN);
        m_finite = m_finite && std::isfinite(force + glm::length(state.anchorMm));
        result.mostN = std::max(result.mostN, force);
        if (!m_grip.empty() && t < m_scene.grabAtS)
            result.mmPerS = std::max(result.mmPerS, glm::length(grip - m_grip.back()) / kTickS);
        if (t >= m_scene.jumpsFromS && t < m_scene.jumpsToS && grip.z > m_scene.jumpsAboveMm)
            result.jumpN = std::max(result.jumpN, glm::length(state.forceN - m_forceN));
        m_forceN = state.forceN;
        m_grip.push_back(grip);

        if (state.touching && m_firstTouchS < 0.0)
            m_firstTouchS = t;
        if (m_touching && !state.touching)
            ++result.bounces;
        m_touching = state.touching;

        m_beenOut = m_beenOut || grip.z > 0.0;
        m_crossed = m_crossed || (m_scene.mustStayLeft && state.anchorMm.x > 0.0) ||
                    (m_scene.beginsInside && !m_beenOut && force > 0.0);
        m_pushedLate = m_pushedLate || (t >= m_scene.silentFromS + kLetGoS + kTickS &&
                                        t < m_scene.silentFromS + m_scene.silentForS && force > 0.0);
        if (!steady)
            return;
        ++m_steadyTicks;
        m_ripple2 += glm::dot(tremble, tremble);
        result.lagMm = std::max(result.lagMm, std::abs(glm::dot(state.anchorMm - state.deviceMm, m_scene.along)));
        const glm::dvec3 stretch = state.anchorMm - state.deviceMm;
        if (m_scene.exact && glm::length(stretch) > kPressingMm) {
            const glm::dvec3 off = state.anchorMm - m_scene.exact(state.deviceMm);
            m_error2 += glm::dot(off, off);
        }
    }

    StabilityResult done()
    {
        if (m_steadyTicks > 0) {
            result.rippleN = std::sqrt(m_ripple2 / m_steadyTicks);
            result.errorMm = std::sqrt(m_error2 / m_steadyTicks);
        }
        glm::dvec3 low(1.0e9);
        glm::dvec3 high(-1.0e9);
        const auto from = [&](double s) { return m_grip.end() - static_cast<std::ptrdiff_t>(std::lround(s / kTickS)); };
        for (auto grip = from(kWatchedS); grip != m_grip.end(); ++grip) {
            low = glm::min(low, *grip);
            high = glm::max(high, *grip);
        }
        const glm::dvec3 swing = high - low;
        result.swingMm = std::max({swing.x, swing.y, m_scene.drill ? 0.0 : swing.z});
        if (!m_scene.drill)
            settle(from(kEndS), m_grip.end());
        judge();
        return result;
    }

    StabilityResult result;

private:
    template <class Iterator>
    void settle(Iterator begin, Iterator end)
    {
        glm::dvec3 rest(0.0);
        for (auto grip = begin; grip != end; ++grip)
            rest += *grip;
        rest /= static_cast<double>(end - begin);
        const double startS = m_scene.number == 2 ? std::max(0.0, m_firstTouchS) : m_scene.seconds - kStillS;
        std::size_t last = m_grip.size();
        while (last > 0 && glm::length(m_grip[last - 1] - rest) <= kSettledMm)
            --last;
        result.settleS = std::max(0.0, static_cast<double>(last) * kTickS - startS);
    }

    void judge()
    {
        const StabilityBars& bars = m_scene.bars;
        if (m_crossed || !m_finite)
            result.outcome = Outcome::Crosses;
        else if (result.swingMm > kLostMm)
            result.outcome = Outcome::Diverges;
        else if (result.swingMm > kSwingMm)
            result.outcome = Outcome::LimitCycle;
        else if (result.lagMm > kLagMm)
            result.outcome = Outcome::Sticks;
        else if (result.rippleN > bars.buzzN)
            result.outcome = Outcome::Buzzes;
        const std::pair<bool, std::string_view> misses[] = {
            {m_pushedLate, "force after loss"},          {result.swingMm > bars.swingMm, "swing"},
            {result.rippleN > bars.rippleN, "ripple"},   {result.jumpN > bars.jumpN, "jump"},
            {result.lagMm > bars.lagMm, "lag"},          {result.errorMm > bars.errorMm, "error"},
            {result.settleS > bars.settleS, "settling"}, {result.bounces > bars.bounces, "bounces"},
            {result.depthMm > bars.depthMm, "depth"},    {result.mostN > bars.mostN, "force"},
            {result.mmPerS > bars.mmPerS, "speed"},
        };
        for (const auto& [missed, name] : misses)
            if (missed && result.missed.empty())
                result.missed = name;
    }

    const StabilityScene& m_scene;
    BandPass m_band;
    std::vector<glm::dvec3> m_grip;
    glm::dvec3 m_forceN{0.0};
    double m_ripple2 = 0.0;
    double m_error2 = 0.0;
    int m_steadyTicks = 0;
    double m_firstTouchS = -1.0;
    bool m_touching = false;
    bool m_beenOut = false;
    bool m_crossed = false;
    bool m_pushedLate = false;
    bool m_finite = true;
};

/// Returns the greatest depth removed from a column that is not gone, mm.
double deepestMm(const core::terrain::Tooth& tooth)
{
    double deepest = 0.0;
    for (std::size_t k = 0; k < tooth.top.size(); ++k)
        if (tooth.isSolid(k))
            deepest = std::max(deepest, static_cast<double>(tooth.anatomy->top[k]) - static_cast<double>(tooth.top[k]));
    return deepest;
}

/// Returns the intended amplitude of a hand whose grip moves by sin(w t). Spring and damper of the hand must move mass
/// and friction of the device: k e + b e' = F.
double strokeWishMm(const StabilityScene& scene, const haptics::FalconFigures& falcon, const haptics::HandFigures& hand,
                    double t)
{
    const double w = 2.0 * std::numbers::pi * scene.strokeHz;
    const double perMm = 0.001 * scene.strokeMm;
    const double inPhaseN = -(falcon.massKg + hand.massKg) * w * w * perMm;
    // The component of dry friction, a square wave, at this frequency.
    const double aheadN = falcon.viscousNSPerM * w * perMm + falcon.coulombN * 4.0 / std::numbers::pi;
    const double k = hand.stiffnessNPerM;
    const double bw = hand.dampingNSPerM * w;
    const double square = k * k + bw * bw;
    const double inPhaseM = (inPhaseN * k + aheadN * bw) / square;
    const double aheadM = (aheadN * k - inPhaseN * bw) / square;
    return scene.strokeMm * std::sin(w * t) + 1000.0 * (inPhaseM * std::sin(w * t) + aheadM * std::cos(w * t));
}

StabilityResult run(const StabilityScene& scene, const StabilityTrial& trial)
{
    haptics::FalconFigures figures = trial.falcon;
    figures.countShare *= scene.countShare;
    if (scene.dryN >= 0.0)
        figures.coulombN = scene.dryN;
    if (scene.jitterS >= 0.0)
        figures.delayJitterS = scene.jitterS;
    haptics::HandFigures hand = trial.hand;
    if (!scene.trembling) {
        hand.tremorMm = 0.0;
        hand.driftMm = 0.0;
    }
    const double mmPerN = 1000.0 / hand.stiffnessNPerM;
    const auto wanted = [&](double t) {
        glm::dvec3 wish = scene.wanted(std::min(t, scene.seconds - kStillS), mmPerN);
        if (t >= scene.strokesFromS && t < scene.strokesToS)
            wish.x += strokeWishMm(scene, figures, hand, t);
        return wish;
    };
    const glm::dvec3 start = scene.startMm == glm::dvec3(0.0) ? wanted(0.0) : scene.startMm;
    TrialDevice device(figures, hand, start);
    device.falcon.follow(wanted(0.0));
    device.falcon.push(scene.throwMmPerS);
    const auto servo = contestantFor(scene, trial, device);

    const auto ticks = static_cast<int>(std::lround(scene.seconds / kTickS));
    glm::dvec3 grabbed(0.0);  // from the intended position of the hand to where it was grabbed
    Watch watch(scene, static_cast<std::size_t>(ticks));
    for (int tick = 0; tick < ticks; ++tick) {
        const double t = tick * kTickS;
        const bool led = t >= scene.homeAtS && t < scene.grabAtS;
        if (led)
            grabbed = device.falcon.tipMm() - wanted(t);
        device.falcon.follow(led ? device.falcon.tipMm() : wanted(t) + grabbed);
        device.silent = t >= scene.silentFromS && t < scene.silentFromS + scene.silentForS;
        const auto isNow = [t](double s) { return t < s + 0.5 * kTickS && t >= s - 0.5 * kTickS; };
        if (isNow(scene.homeAtS))
            servo->bringHome();
        if (isNow(scene.swapAtS))
            servo->swapTooth(
                std::make_unique<core::contact::LiveTooth>(core::terrain::restored(scene.anatomy, scene.swapTop)));
        servo->tick();
        watch.add(t, servo->state(), device.falcon.tipMm());
    }
    watch.result.depthMm = deepestMm(servo->tooth().tooth());
    return watch.done();
}

}  // namespace

std::string_view nameOf(Outcome outcome)
{
    constexpr std::array<std::string_view, 6> kNames{"holds", "buzzes", "limit cycle", "diverges", "crosses", "sticks"};
    return kNames[static_cast<std::size_t>(outcome)];
}

std::span<const StabilitySceneName> stabilityScenesAndBars()
{
    static const std::vector<StabilitySceneName> list = [] {
        std::vector<StabilitySceneName> made;
        for (const StabilityScene& scene : stabilityScenesInFull())
            made.push_back({scene.number, scene.name, scene.bars});
        return made;
    }();
    return list;
}

std::span<const std::string_view> stabilityScenes()
{
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> list;
        for (const StabilityScene& scene : stabilityScenesInFull())
            list.push_back(scene.name);
        return list;
    }();
    return names;
}

core::Result<StabilityResult> tryStability(std::string_view scene, const StabilityTrial& trial)
{
    if (const core::Status sound = checkContestant(trial.settings); !sound)
        return tl::unexpected(sound.error());
    const std::vector<StabilityScene>& all = stabilityScenesInFull();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const StabilityScene& known) { return known.name == scene; });
    if (found == all.end())
        return core::unexpected(core::ErrorCode::UnknownName,
                                "There is no stability scene '" + std::string(scene) + "'.");
    if (!found->loops)
        return run(*found, trial);
    StabilityResult result;
    result.leakUj = worstLeakUj(*found, trial, &GivenPath::heldMj);
    result.springLeakUj = worstLeakUj(*found, bare(trial), &GivenPath::trapeziumMj);
    if (!(result.leakUj <= kLeakUj && result.springLeakUj <= kSpringLeakUj))
        result.outcome = Outcome::Diverges;
    return result;
}

}  // namespace lab
