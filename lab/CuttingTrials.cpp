// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/CuttingTrials.h"
#include "core/servo/ServoState.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "lab/Block.h"
#include "lab/SweepVolume.h"

namespace lab {
namespace {

using namespace core;

constexpr double kWallDepthMm = 1.0;
constexpr double kOffWallMm = 0.02;
constexpr glm::dvec2 kLie(0.13, 0.37);  ///< place on the lattice: no feed runs along a row of nodes

/// The mass of the firm hand and the device's moving mass and friction together (docs/facts/haptics.md, sections 5 and
/// 6).
constexpr double kHandKg = 0.4;
constexpr double kHandNSPerMm = 0.0088;
constexpr double kHandNPerMm = 0.7;

/// A servo tick with its own tooth and the drill on.
class Servo
{
public:
    Servo(std::shared_ptr<const terrain::ToothAnatomy> anatomy, const servo::ServoSettings& settings, std::size_t bur,
          double rateHz)
        : m_tooth(terrain::Tooth(std::move(anatomy))), m_tick(servo::makeServoTick(settings).value()),
          m_dt(std::llround(1.0e6 / rateHz))
    {
        m_tick->setBur(bur);
        m_tick->swapTooth(&m_tooth, true);
        m_tick->setDrill(true);
    }
    const servo::ServoState& step(const glm::dvec3& device)
    {
        const glm::vec3 sample(device);
        m_tick->step(&sample, m_dt);
        return m_tick->state();
    }
    [[nodiscard]] const servo::ServoState& state() const { return m_tick->state(); }

private:
    contact::LiveTooth m_tooth;
    std::unique_ptr<servo::ServoTick> m_tick;
    std::chrono::microseconds m_dt;
};

/// The block of a trial, and the start of its bur.
struct Scene
{
    std::shared_ptr<const terrain::ToothAnatomy> anatomy;
    glm::dvec3 startMm;
};

Scene sceneOf(const PaceTrial& trial)
{
    const glm::dvec2 along(trial.towards);
    const double flat = glm::length(along);
    const double radius = bur::burs()[trial.bur].headRadiusMm;
    const auto height = [&](glm::dvec2 p) { return flat > 0.0 && glm::dot(p, along) < 0.0 ? -4.0 : 0.0; };
    const auto layers = [&](glm::dvec2) { return allOf(trial.material); };
    const glm::dvec3 start = flat > 0.0 ? glm::dvec3(-along * ((radius + kOffWallMm) / flat), -kWallDepthMm)
                                        : glm::dvec3(0.0, 0.0, kOffWallMm);
    return {layeredBlock(height, layers, trial.side, kLie), start};
}

/// Returns the speed, mm/s, that the law gives the bur of a trial.
double lawfulSpeed(const PaceTrial& trial)
{
    const double radius = bur::burs()[trial.bur].headRadiusMm;
    const bool isDown = !(glm::length(glm::dvec2(trial.towards)) > 0.0);
    return lawfulMm3PerS(trial) /
           (isDown ? std::numbers::pi * radius * radius : sweptSectionMm2(trial.bur, kWallDepthMm));
}

/// Returns the rms from 20 to 300 Hz of a force sampled every `periodS`: power of the Fourier lines under a Hann
/// window.
double bandRms(const std::vector<glm::dvec3>& force, double periodS)
{
    constexpr double kLowHz = 20.0;
    constexpr double kHighHz = 300.0;
    constexpr double kWindowPower = 0.375;  // mean square of the window
    const auto count = static_cast<double>(force.size());
    glm::dvec3 mean(0.0);
    for (const glm::dvec3& sample : force)
        mean += sample / count;
    double power = 0.0;
    const auto first = static_cast<std::size_t>(std::ceil(kLowHz * count * periodS));
    const auto last = static_cast<std::size_t>(std::floor(kHighHz * count * periodS));
    for (std::size_t line = first; line <= last; ++line) {
        glm::dvec3 even(0.0);
        glm::dvec3 odd(0.0);
        for (std::size_t k = 0; k < force.size(); ++k) {
            const double window = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * static_cast<double>(k) / count);
            const double angle = 2.0 * std::numbers::pi * static_cast<double>(line * k % force.size()) / count;
            even += (force[k] - mean) * (window * std::cos(angle));
            odd += (force[k] - mean) * (window * std::sin(angle));
        }
        power += 2.0 * (glm::dot(even, even) + glm::dot(odd, odd)) / (count * count);
    }
    return std::sqrt(power / kWindowPower);
}

}  // namespace

double removedMm3(const PaceTrial& trial)
{
    const Scene scene = sceneOf(trial);
    Servo servo(scene.anatomy, trial.settings, trial.bur, trial.rateHz);
    servo.step(scene.startMm);
    // The length of the spring sets the force. Only the deviation from the line counts.
    const double stretch = trial.newtons / trial.settings.force.stiffnessNPerMm;
    const auto ticks = std::llround(trial.seconds * trial.rateHz);
    for (long long tick = 0; tick < ticks; ++tick) {
        const glm::dvec3 anchor = servo.state().anchorMm;
        const glm::dvec3 foot = scene.startMm + trial.towards * glm::dot(anchor - scene.startMm, trial.towards);
        const glm::dvec3 aside = anchor - foot;
        servo.step(foot + trial.towards * std::sqrt(std::max(0.0, stretch * stretch - glm::dot(aside, aside))));
    }
    double removed = 0.0;
    for (const double volume : servo.state().removedMm3)
        removed += volume;
    return removed;
}

double secondsTo(double depthMm, const PaceTrial& trial)
{
    const Scene scene = sceneOf(trial);
    Servo servo(scene.anatomy, trial.settings, trial.bur, trial.rateHz);
    servo.step(scene.startMm);
    const double stretch = trial.newtons / trial.settings.force.stiffnessNPerMm;
    const auto most = std::llround(trial.seconds * trial.rateHz);
    for (long long tick = 1; tick <= most; ++tick)
        if (servo.step(servo.state().anchorMm + trial.towards * stretch).anchorMm.z <= -depthMm)
            return static_cast<double>(tick) / trial.rateHz;
    return trial.seconds;
}

Ripple measureRipple(const PaceTrial& trial, Feeder feeder)
{
    const Scene scene = sceneOf(trial);
    Servo servo(scene.anatomy, trial.settings, trial.bur, trial.rateHz);
    const double periodS = 1.0 / trial.rateHz;
    const double speed = lawfulSpeed(trial);
    glm::dvec3 device = scene.startMm;
    glm::dvec3 pace(0.0);  // mm/s
    std::vector<glm::dvec3> force;
    const auto ticks = std::llround(trial.seconds * trial.rateHz);
    for (long long tick = 0; tick < ticks; ++tick) {
        const servo::ServoState& state = servo.step(device);
        if (tick >= std::llround((trial.seconds - 2.0) * trial.rateHz))
            force.push_back(state.forceN);
        if (feeder == Feeder::Speed) {
            device += trial.towards * (speed * periodS);
            continue;
        }
        const glm::dvec3 off = device - scene.startMm;
        const glm::dvec3 aside = off - trial.towards * glm::dot(off, trial.towards);
        const glm::dvec3 sum = trial.towards * trial.newtons + state.forceN - aside * kHandNPerMm - pace * kHandNSPerMm;
        pace += sum * (1000.0 * periodS / kHandKg);
        device += pace * periodS;
    }
    Ripple ripple{bandRms(force, periodS), 0.0};
    for (const glm::dvec3& sample : force)
        ripple.meanN += glm::length(sample) / static_cast<double>(force.size());
    return ripple;
}

glm::dvec3 feed(double headingDegrees, double downDegrees)
{
    const double heading = headingDegrees * std::numbers::pi / 180.0;
    const double down = downDegrees * std::numbers::pi / 180.0;
    // A quarter turn without rounding, so that straight down differs from nearly straight.
    const double flat = downDegrees == 90.0 ? 0.0 : std::cos(down);
    return {flat * std::cos(heading), flat * std::sin(heading), -std::sin(down)};
}

double lawfulMm3PerS(const PaceTrial& trial)
{
    const settings::HardnessPreset& preset = trial.settings.hardness;
    const settings::MaterialHardness& hardness = preset.material[static_cast<std::size_t>(trial.material)];
    const bur::Bur& bur = bur::burs()[trial.bur];
    const double share = preset.shareOfEnd(bur.hasFlatEnd());
    const double direction = share + (1.0 - share) * glm::length(glm::dvec2(trial.towards));
    const auto under = [&](double newtons) {
        const double torque = cutting::kCuttingFriction * newtons * bur.headRadiusMm;
        const double speed =
            trial.settings.handpieces.front().rpmUnder(torque) * bur.headRadiusMm / cutting::kReferenceRpmMm;
        return hardness.rateMm3PerNs * std::max(0.0, newtons - hardness.thresholdN) * direction * speed;
    };
    return trial.newtons > preset.fullLoadN ? std::min(under(trial.newtons), under(preset.fullLoadN))
                                            : under(trial.newtons);
}

}  // namespace lab
