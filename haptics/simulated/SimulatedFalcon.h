// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/base/Rng.h"
#include "haptics/HapticDevice.h"

namespace haptics {

/// Parameters of a simulated Novint Falcon (docs/facts/haptics.md, section 5). Certainty: R read in a source, K known
/// from literature, A assumed until there is a device to measure. Geometry and encoders [R] are in falcon/Kinematics.h.
struct FalconFigures
{
    double massKg = 0.25;         ///< effective at the grip, the same in all directions; 0.15 to 0.4 [A]
    double viscousNSPerM = 0.8;   ///< 0.3 to 2 [A]
    double coulombN = 0.25;       ///< dry friction against any motion; 0.1 to 0.5 [A]
    double motorLagS = 0.001;     ///< first order [A]
    double forceLimitN = 8.9;     ///< largest force, its direction kept; the vendor's 2 lbf [K]
    double delayS = 0.001;        ///< from a sample to its force at the motor, without the computation [A]
    double delayJitterS = 0.001;  ///< additional, uniform, drawn for every force; forces stay in order [A]
    double countShare = 1.0;      ///< step of the encoders relative to the real device; 0: exact
};

/// Parameters of a hand at the grip: a mass that moves with it, with spring and damper to the intended position
/// (docs/facts/haptics.md, section 6). All values are assumed within the range of the literature [A], except the bands
/// of the tremor [R].
struct HandFigures
{
    std::string_view name;
    double massKg;
    double dampingNSPerM;
    double stiffnessNPerM;
    double tremorMm = 0.04;  ///< rms along x and y each, 7.5 to 10.5 Hz
    double driftMm = 0.075;  ///< rms along each axis, under 2 Hz
};
/// The light hand has the least damping and is the hardest to keep stable; medium is the default.
inline constexpr std::array<HandFigures, 3> kHands{{
    {"light", 0.02, 0.5, 60.0},
    {"medium", 0.1, 3.0, 250.0},
    {"firm", 0.15, 8.0, 700.0},
}};

/// Device and hand as one closed loop, to test and watch contact and force without a device.
///
///     (m + m_hand) x'' = F(t - delay) + k (x_ref - x) + b (x_ref' - x') - viscous x' - Coulomb
///
/// Integrates in steps of at most 20 us, at least ten per tick. Coulomb friction removes at most the speed of a step,
/// so a grip at rest sticks until it is pushed harder. This is Karnopp's model; its band is here the speed that
/// friction removes in one step. The position is read as from the device, from encoder counts of its arms. Weight is
/// neglected because the hand carries it. At the end of the work area the arms reach their stops.
///
/// The same seed gives the same motion. exchange() and follow() never allocate, lock or wait.
class SimulatedFalcon final : public HapticDevice
{
public:
    /// @param periodS  between two calls of exchange(); 250 us to 4 ms
    /// @param tipMm    initial position of grip and hand, at rest, in the tooth frame. See falcon/Kinematics.h for the
    ///                 device frame
    SimulatedFalcon(const FalconFigures& falcon, const HandFigures& hand, double periodS, std::uint64_t seed,
                    const glm::dvec3& tipMm);

    /// Sets the intended position of the hand at the end of the next tick, without its tremor. The hand moves there at
    /// a constant speed. The first call also sets the initial position.
    void follow(const glm::dvec3& wantedMm) noexcept;

    /// Applies the force for one period and reads the position at its end. A delay of 0 thus simulates a servo that
    /// computes instantly. A servo that passes its force with the next exchange, as with a real device, adds a delay of
    /// one period.
    DeviceSample exchange(const glm::dvec3& forceOnHandN) noexcept override;

    /// Returns the exact position of the grip, without rounding to counts.
    [[nodiscard]] glm::dvec3 tipMm() const noexcept { return m_at / kMPerMm; }
    /// Sets the velocity of the grip.
    void push(const glm::dvec3& mmPerS) noexcept { m_speed = mmPerS * kMPerMm; }

private:
    static constexpr double kMPerMm = 0.001;  ///< internal units are kg, m, s, N
    struct Command
    {
        std::int64_t due = 0;  ///< step at which the force begins to act
        glm::dvec3 forceN{0.0};
    };
    struct Wave
    {
        int axis;
        double amplitude;
        double radPerS;
        double phaseRad;
    };

    void send(const glm::dvec3& forceN) noexcept;
    [[nodiscard]] glm::dvec3 unrest(std::int64_t step) const noexcept;
    void step(const glm::dvec3& reference, const glm::dvec3& referenceSpeed) noexcept;
    [[nodiscard]] DeviceSample read() noexcept;

    FalconFigures m_falcon;
    HandFigures m_hand;
    int m_steps;  ///< per tick
    double m_stepS;
    double m_motorShare;  ///< share of the difference to the commanded force made up in one step
    core::Rng m_rng;
    std::vector<Wave> m_waves;
    std::vector<Command> m_line;  ///< ring of the forces on their way
    std::size_t m_first = 0;
    std::size_t m_underWay = 0;
    std::int64_t m_now = 0;  ///< in steps
    std::int64_t m_lastDue = 0;

    glm::dvec3 m_at;
    glm::dvec3 m_speed{0.0};
    glm::dvec3 m_wanted;
    glm::dvec3 m_reference;  ///< at the end of the last tick, tremor included
    glm::dvec3 m_commandedN{0.0};
    glm::dvec3 m_motorN{0.0};
    glm::dvec3 m_readMm;  ///< device frame, last reading
};

}  // namespace haptics
