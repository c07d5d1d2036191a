// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "core/contact/LatticeContact.h"
#include "core/contact/LiveTooth.h"
#include "core/cutting/Drill.h"
#include "core/servo/ServoState.h"

namespace lab {

/// What the pipeline of 2011 (docs/facts/haptics.md, section 1, items 2, 4 and 6) leaves open.
///
/// The thesis does not give its constants; these are the best that it can have. Swept at 1 kHz: the stiffest spring
/// that holds a light hand (stiffnessLimit(), 0 / 1 / 2 / 4 ms of delay, N/mm), and what trembles in the hand when a
/// spring of 2 N/mm is leaned on slowly (rms from 20 to 300 Hz in scene "push", medium hand, 1 ms, N):
///
///     c, N s/m     0                5                      10                     20                 30
///     stiffest     3.9 1.7 1.0 0.6  9.8 8.8 2.9 1.6        12 8.1 7.5 2.7         18 10 7.1 5.0      20 12 8.7 5.2
///     tremble      0.025            0.053                  0.090                  0.185              0.285
///
/// for a backward difference makes a pulse of every encoder count. 4 N s/m is the most that stays below what is felt,
/// 0.05 N; clamped at 0.5 or at 2 N makes no difference then. A filter of 500 N/s takes up to half of the stiffness at
/// 1 ms, one of 100 N/s leaves 1.2 1.1 1.0 0.8, any of 2000 N/s or more takes nothing.
struct CedsFigures
{
    double stiffnessNPerMm = 2.0;
    double frictionNSPerM = 4.0;  ///< c over the period: friction is c * (x_k - x_(k-1)), a backward difference
    double frictionMostN = 2.0;   ///< where that is clamped
    double slewNPerS = 2000.0;    ///< the force filter: most that the force changes in a second
    double clampN = 8.0;
};

/// Force of 2011 on the anchor of 2011: spring to the lattice anchor, backward-difference friction while the bur
/// touches, force filter. Without what came after: no passivity control, no softening on delay, no ramp after a loss;
/// a device that is lost gets no force. Removal is ours, so that scenes with the drill on compare contact and force.
/// For the lab's comparisons only. Steps as core::servo::ServoTick does.
class Ceds2011
{
public:
    /// @param hardness  checked
    Ceds2011(const CedsFigures& figures, const core::settings::HardnessPreset& hardness);

    /// Gives the old one back.
    core::contact::LiveTooth* swapTooth(core::contact::LiveTooth* tooth) noexcept;
    void setDrill(bool on) noexcept { m_state.drillOn = on; }

    /// A tooth must be there.
    void step(const glm::vec3* device, std::chrono::microseconds dt) noexcept;

    /// Device, anchor, force, touching and cutting; the rest is as it began.
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
