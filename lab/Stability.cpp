// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/Stability.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "haptics/ServoLoop.h"
#include "lab/Block.h"

namespace lab {
namespace {

using core::session::SwapTooth;

constexpr double kTickS = 0.001;
constexpr double kStillS = 0.6;    ///< at the end of every scene the hand holds still
constexpr double kWatchedS = 0.5;  ///< of it
constexpr double kLagMm = 0.3;
constexpr double kPi = std::numbers::pi;

/// What a hand does in a scene, and on what.
struct Scene
{
    std::string_view name;
    std::function<double(glm::dvec2)> heightMm;
    /// Where the hand wants to be at a time, given how far its wish must go into the tooth for a newton, mm.
    std::function<glm::dvec3(double seconds, double mmPerN)> wanted;
    double seconds = 2.0;
    double watchFromS = 1.0;   ///< ripple and jumps count from here
    glm::dvec3 along{0.0};     ///< the way on which nothing holds the bur; zero: no lag is asked for
    double throwMmPerS = 0.0;  ///< downwards, at the start
    bool drill = false;
    double lostFromS = 1.0e9;  ///< the device is silent from here
    double lostToS = 1.0e9;
    bool beginsInside = false;
    bool mustStayLeft = false;  ///< of x = 0
};

double flat(glm::dvec2)
{
    return 0.0;
}

/// From `from` to `to` of the seconds evenly from 0 to 1.
double rise(double seconds, double from, double to)
{
    return std::clamp((seconds - from) / (to - from), 0.0, 1.0);
}

const std::vector<Scene>& scenes()
{
    static const std::vector<Scene> all = [] {
        std::vector<Scene> list;
        const double slope30 = std::tan(kPi / 6.0);
        list.push_back({"push", flat, [](double t, double mmPerN) {
                            return glm::dvec3(0.0, 0.0, 1.0 - rise(t, 0.0, 1.0) * (1.0 + 8.0 * mmPerN));
                        }});
        list.push_back({"impact", flat, [](double, double mmPerN) { return glm::dvec3(0.0, 0.0, -2.0 * mmPerN); }});
        list.back().throwMmPerS = 400.0;
        list.push_back({"pit", [](glm::dvec2 at) { return -std::max(0.0, 1.0 - std::sqrt(glm::dot(at, at)) * 2.75); },
                        [](double t, double mmPerN) {
                            const double turn = 2.0 * kPi * std::min(t, 1.4);
                            return glm::dvec3(0.2 * std::cos(turn), 0.2 * std::sin(turn),
                                              1.0 - rise(t, 0.0, 0.4) * (1.0 + 3.0 * mmPerN));
                        }});
        list.back().watchFromS = 0.5;
        list.push_back({"groove", [slope30](glm::dvec2 at) { return slope30 * std::abs(at.x); },
                        [](double t, double mmPerN) {
                            return glm::dvec3(0.0, -2.0 + 4.0 * rise(t, 0.4, 1.4),
                                              0.5 - rise(t, 0.0, 0.4) * (0.5 + 2.0 * mmPerN));
                        }});
        list.back().along = {0.0, 1.0, 0.0};
        list.back().watchFromS = 0.5;
        list.push_back({"slope", [](glm::dvec2 at) { return 0.5 * at.x; },
                        [](double t, double mmPerN) {
                            return glm::dvec3(0.6 * mmPerN, -2.0 + 4.0 * rise(t, 0.4, 1.4),
                                              0.5 - rise(t, 0.0, 0.4) * (0.5 + 1.2 * mmPerN));
                        }});
        list.back().along = {0.0, 1.0, 0.0};
        list.back().watchFromS = 0.5;
        list.push_back({"wall", [](glm::dvec2 at) { return at.x > 0.0 ? 1.0 : 0.0; },
                        [](double t, double mmPerN) {
                            return glm::dvec3(-1.0 + rise(t, 0.2, 0.6) * (0.5 + 1.5 * mmPerN),
                                              -1.0 + 2.0 * rise(t, 0.6, 1.4),
                                              0.5 - rise(t, 0.0, 0.2) * (0.5 + 0.5 * mmPerN));
                        }});
        list.back().along = {0.0, 1.0, 0.0};
        list.push_back({"ridge", [](glm::dvec2 at) { return std::abs(at.x) < 0.075 ? 3.0 : 0.0; },
                        [](double t, double mmPerN) {
                            return glm::dvec3(-1.0 + rise(t, 0.2, 1.0) * (0.5 + 3.5 * mmPerN), 0.0, 0.3);
                        }});
        list.back().mustStayLeft = true;
        list.push_back({"step", [](glm::dvec2 at) { return at.x > 0.0 ? 0.2 : 0.0; },
                        [](double t, double mmPerN) {
                            return glm::dvec3(-1.5 + 3.0 * rise(t, 0.3, 0.85) - 3.0 * rise(t, 0.85, 1.4), 0.0,
                                              0.5 - rise(t, 0.0, 0.3) * (0.5 + mmPerN));
                        }});
        list.back().along = {1.0, 0.0, 0.0};
        list.back().watchFromS = 1.45;
        list.push_back({"brush", flat, [](double t, double mmPerN) {
                            return glm::dvec3(2.5 * std::sin(2.0 * kPi * 3.0 * std::min(t, 1.4)), 0.0,
                                              0.5 - rise(t, 0.0, 0.3) * (0.5 + 0.3 * mmPerN));
                        }});
        list.back().along = {1.0, 0.0, 0.0};
        list.back().watchFromS = 0.5;
        list.push_back({"drill", flat, [](double t, double mmPerN) {
                            return glm::dvec3(0.0, 0.0, 0.5 - rise(t, 0.0, 0.3) * (0.5 + 2.0 * mmPerN));
                        }});
        list.back().drill = true;
        list.push_back({"dropout", flat, [](double t, double mmPerN) {
                            return glm::dvec3(0.0, 0.0, 0.5 - rise(t, 0.0, 0.3) * (0.5 + 2.0 * mmPerN));
                        }});
        list.back().lostFromS = 0.8;
        list.back().lostToS = 0.9;
        list.back().watchFromS = 0.9;
        list.push_back({"inside", flat, [](double t, double mmPerN) {
                            return glm::dvec3(
                                0.0, 0.0, -2.0 + 2.5 * rise(t, 0.4, 0.7) - rise(t, 0.9, 1.2) * (0.5 + 2.0 * mmPerN));
                        }});
        list.back().beginsInside = true;
        return list;
    }();
    return all;
}

/// Root mean square of what of a force lies between 20 and 300 Hz, one pole each.
class Ripple
{
public:
    void add(const glm::dvec3& forceN, bool counts)
    {
        const auto share = [](double hz) { return 2.0 * kPi * hz * kTickS / (1.0 + 2.0 * kPi * hz * kTickS); };
        m_slow += (forceN - m_slow) * share(20.0);
        m_fast += ((forceN - m_slow) - m_fast) * share(300.0);
        if (!counts)
            return;
        m_sum2 += glm::dot(m_fast, m_fast);
        m_count += 1.0;
    }
    [[nodiscard]] double rmsN() const { return m_count > 0.0 ? std::sqrt(m_sum2 / m_count) : 0.0; }

private:
    glm::dvec3 m_slow{0.0};
    glm::dvec3 m_fast{0.0};
    double m_sum2 = 0.0;
    double m_count = 0.0;
};

/// The device of a trial, silent for a while where the scene wants it.
class TrialDevice final : public haptics::HapticDevice
{
public:
    TrialDevice(const StabilityTrial& trial, const haptics::HandFigures& hand, const glm::dvec3& start)
        : falcon(trial.falcon, hand, kTickS, 1, start)
    {}
    haptics::DeviceSample exchange(const glm::dvec3& forceOnHandN) noexcept override
    {
        haptics::DeviceSample sample = falcon.exchange(forceOnHandN);
        sample.present = !silent;
        return sample;
    }

    haptics::SimulatedFalcon falcon;
    bool silent = false;
};

StabilityResult run(const Scene& scene, const StabilityTrial& trial)
{
    haptics::HandFigures hand = trial.hand;
    hand.tremorMm = 0.0;
    hand.driftMm = 0.0;
    const double mmPerN = 1000.0 / hand.stiffnessNPerM;
    const auto wanted = [&](double t) { return scene.wanted(std::min(t, scene.seconds - kStillS), mmPerN); };
    glm::dvec3 start = wanted(0.0);
    if (scene.throwMmPerS > 0.0)
        start.z = 2.0;
    TrialDevice device(trial, hand, start);
    device.falcon.follow(wanted(0.0));
    device.falcon.push({0.0, 0.0, -scene.throwMmPerS});

    const auto links = std::make_unique<core::session::ServoLinks>();
    core::rt::TripleBuffer<core::session::ServoState> states;
    haptics::ServoLoop servo(device, *core::session::makeServoTick(trial.settings), *links, states,
                             std::chrono::milliseconds(1));
    auto tooth = std::make_unique<core::contact::LiveTooth>(core::terrain::Tooth(enamelBlock(scene.heightMm)));
    if (links->commands.tryPush(SwapTooth{tooth.get(), 1, 1, true, 0}))
        static_cast<void>(tooth.release());
    static_cast<void>(links->commands.tryPush(core::session::SetBur{0}));
    static_cast<void>(links->commands.tryPush(core::session::SetDrill{scene.drill}));

    StabilityResult result;
    Ripple ripple;
    glm::dvec3 low(1.0e9);
    glm::dvec3 high(-1.0e9);
    glm::dvec3 forceBefore{0.0};
    bool crossed = false;
    bool pushedInside = false;
    bool beenOut = !scene.beginsInside;
    const auto ticks = static_cast<int>(scene.seconds / kTickS);
    for (int tick = 0; tick < ticks; ++tick) {
        const double t = tick * kTickS;
        device.falcon.follow(wanted(t));
        device.silent = t >= scene.lostFromS && t < scene.lostToS;
        servo.tick(std::chrono::milliseconds(1));
        for (core::session::ServoEvent event; links->events.tryPop(event);) {
            // a trial is not recorded
        }
        for (core::session::TilePatch patch; links->patches.tryPop(patch);) {
            // nor looked at
        }
        const core::session::ServoState& state = servo.state();
        const bool counts = t >= scene.watchFromS;
        ripple.add(state.forceN, counts);
        const glm::dvec3 change = state.forceN - forceBefore;
        forceBefore = state.forceN;
        if (counts)
            result.jumpN = std::max(result.jumpN, std::sqrt(glm::dot(change, change)));
        beenOut = beenOut || device.falcon.tipMm().z > 0.0;
        pushedInside = pushedInside || (!beenOut && glm::dot(state.forceN, state.forceN) > 0.0);
        crossed = crossed || (scene.mustStayLeft && state.anchorMm.x > 0.0);
        if (t >= scene.seconds - kWatchedS) {
            low = glm::min(low, device.falcon.tipMm());
            high = glm::max(high, device.falcon.tipMm());
        }
    }
    const glm::dvec3 swing = high - low;
    result.swingMm = std::max({swing.x, swing.y, scene.drill ? 0.0 : swing.z});
    result.rippleN = ripple.rmsN();
    result.lagMm = std::abs(glm::dot(servo.state().anchorMm - device.falcon.tipMm(), scene.along));
    if (crossed || pushedInside)
        result.outcome = Outcome::Crosses;
    else if (result.swingMm > kLostMm)
        result.outcome = Outcome::Diverges;
    else if (result.swingMm > kSwingMm)
        result.outcome = Outcome::LimitCycle;
    else if (result.lagMm > kLagMm)
        result.outcome = Outcome::Sticks;
    else if (result.rippleN > kBuzzN)
        result.outcome = Outcome::Buzzes;
    return result;
}

}  // namespace

std::string_view nameOf(Outcome outcome)
{
    constexpr std::array<std::string_view, 6> kNames{"holds", "buzzes", "limit cycle", "diverges", "crosses", "sticks"};
    return kNames[static_cast<std::size_t>(outcome)];
}

std::span<const std::string_view> stabilityScenes()
{
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> list;
        for (const Scene& scene : scenes())
            list.push_back(scene.name);
        return list;
    }();
    return names;
}

core::Result<StabilityResult> tryStability(std::string_view scene, const StabilityTrial& trial)
{
    if (const auto sound = core::session::makeServoTick(trial.settings); !sound)
        return tl::unexpected(sound.error());
    const auto found =
        std::find_if(scenes().begin(), scenes().end(), [&](const Scene& known) { return known.name == scene; });
    if (found == scenes().end())
        return core::unexpected(core::ErrorCode::UnknownName,
                                "There is no stability scene '" + std::string(scene) + "'.");
    return run(*found, trial);
}

}  // namespace lab
