// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "core/contact/LatticeContact.h"
#include "core/contact/LiveTooth.h"
#include "core/cutting/Drill.h"
#include "core/servo/ServoState.h"

namespace lab {

/// Parameters of the 2011 pipeline (docs/facts/haptics.md, section 1, items 2, 4 and 6).
///
/// The thesis does not give its constants; these are the best ones. Swept at 1 kHz: the largest stable stiffness with a
/// light hand (stiffnessLimit(), 0 / 1 / 2 / 4 ms of delay, N/mm), and the trembling in the hand when it presses slowly
/// on a spring of 2 N/mm (rms from 20 to 300 Hz in scene "push", medium hand, 1 ms, N):
///
///     c, N s/m     0                5                      10                     20                 30
///     stiffest     3.9 1.7 1.0 0.6  9.8 8.8 2.9 1.6        12 8.1 7.5 2.7         18 10 7.1 5.0      20 12 8.7 5.2
///     tremble      0.025            0.053                  0.090                  0.185              0.285
///
/// The reason is that a backward difference makes a pulse of every encoder count. 4 N s/m is the highest value below
/// the threshold of feeling, 0.05 N; clamping at 0.5 or at 2 N then makes no difference. A filter of 500 N/s costs up
/// to half of the stiffness at 1 ms, one of 100 N/s leaves 1.2 1.1 1.0 0.8, and 2000 N/s or more costs nothing.
struct CedsFigures
{
    double stiffnessNPerMm = 2.0;
    double frictionNSPerM = 4.0;  ///< c over the period: friction is c * (x_k - x_(k-1)), a backward difference
    double frictionMostN = 2.0;   ///< limit of the friction
    double slewNPerS = 2000.0;    ///< the force filter: largest change of the force per second
    double clampN = 8.0;
};

/// The 2011 force on the 2011 anchor: spring to the lattice anchor, backward-difference friction while the bur touches,
/// force filter. Without later additions: no passivity control, no softening on delay, no ramp after a loss; a lost
/// device gets no force. Removal is ours, so that scenes with the drill on compare contact and force. For the lab's
/// comparisons only. Steps like core::servo::ServoTick.
class Ceds2011
{
public:
    /// @param hardness  must be valid
    Ceds2011(const CedsFigures& figures, const core::settings::HardnessPreset& hardness);

    /// Replaces the tooth and returns the old one.
    core::contact::LiveTooth* swapTooth(core::contact::LiveTooth* tooth) noexcept;
    void setDrill(bool on) noexcept { m_state.drillOn = on; }

    /// Computes one tick. There must be a tooth.
    void step(const glm::vec3* device, std::chrono::microseconds dt) noexcept;

    /// Returns device, anchor, force, touching and cutting; the other members have their initial values.
    [[nodiscard]] const core::servo::ServoState& state() const noexcept { return m_state; }
    [[nodiscard]] const core::contact::LiveTooth* tooth() const noexcept { return m_tooth; }

private:
    CedsFigures m_figures;
    core::contact::LatticeContact m_lattice;
    core::cutting::Drill m_drill;
    core::contact::LiveTooth* m_tooth = nullptr;
    core::servo::ServoState m_state;
    bool m_restart = true;
};

}  // namespace lab
