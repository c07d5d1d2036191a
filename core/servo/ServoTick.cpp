// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/servo/ServoTick.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/cutting/BreakOff.h"
#include "core/servo/ServoParameters.h"

namespace core::servo {
namespace {

/// The bur counts as hovering below this penetration: a nanometre is rounding.
constexpr double kTouchMm = 1.0e-6;

/// A device that reconnects deeper in the tooth than this must be lifted out before it gets a force again.
constexpr double kSunkMm = 1.0;

/// If an undo or another bur raises the ground under the tip by more than this, ground counts as having come back.
constexpr double kComesBackMm = 0.05;

/// A reading farther away than this is impossible for a hand and counts as missing.
constexpr float kFarthestMm = 1000.0F;

/// Least slope of the uncut surface, mm per mm, that may be a flank: 70 degrees.
constexpr double kFlankRise = 2.75;
/// Largest distance of a flank from the outline, mm. The wall of a fissure is as steep, but farther away.
constexpr double kFlankWidthMm = 0.8;

/// Returns whether the uncut tooth ends or drops here, so that a depth measured straight down has no meaning.
bool isFlank(const terrain::ToothAnatomy& anatomy, int i, int j)
{
    const terrain::Grid& grid = anatomy.grid;
    const auto height = [&](int di, int dj) {
        if (!grid.contains(i + di, j + dj))
            return static_cast<double>(terrain::kEmptyTop);
        return static_cast<double>(anatomy.top[grid.index(i + di, j + dj)]);
    };
    // Beside an empty node the rise is very large.
    const double east = (height(1, 0) - height(-1, 0)) / (2.0 * grid.cellMm);
    const double north = (height(0, 1) - height(0, -1)) / (2.0 * grid.cellMm);
    if (east * east + north * north <= kFlankRise * kFlankRise)
        return false;
    const int reach = static_cast<int>(std::ceil(kFlankWidthMm / grid.cellMm));
    for (const int dj : {-reach, 0, reach})
        for (const int di : {-reach, 0, reach})
            if (height(di, dj) <= static_cast<double>(terrain::kEmptyTop))
                return true;
    return false;
}

/// A hand is never so fast and never jumps so far in a tick. So such a reading is bad (a corrupted packet) and counts
/// as missing. During a few missing readings the hand is assumed to rest: without force for a millisecond, a hand that
/// leans on the tooth would fall into it. If more readings are missing, the device is lost.
constexpr double kFastestMmPerS = 10'000.0;
constexpr double kLeastLeapMm = 10.0;
constexpr std::chrono::milliseconds kPassedOver{10};

bool isPlausible(const glm::vec3& device)
{
    // The comparison is also false for NaN.
    return std::abs(device.x) <= kFarthestMm && std::abs(device.y) <= kFarthestMm && std::abs(device.z) <= kFarthestMm;
}

}  // namespace

ServoTick::ServoTick(std::unique_ptr<contact::ContactMethod> method, ServoSettings settings)
    : m_settings(std::move(settings)), m_firstForce(m_settings.force), m_firstHardness(m_settings.hardness),
      m_method(std::move(method)), m_force(m_settings.force), m_workArea(m_settings.force.workAreaMm),
      m_vibration(m_settings.force.vibrationN), m_drill(m_settings.hardness, m_settings.handpieces.front())
{}

Result<std::unique_ptr<ServoTick>> makeServoTick(const ServoSettings& settings)
{
    if (auto sound = contact::check(settings.force); !sound)
        return tl::unexpected(sound.error());
    if (auto sound = settings::check(settings.hardness); !sound)
        return tl::unexpected(sound.error());
    if (settings.handpieces.empty() || settings.handpieces.size() > kMostHandpieces)
        return unexpected(ErrorCode::OutOfRange,
                          "There must be from 1 to " + std::to_string(kMostHandpieces) + " handpieces at hand.");
    for (const settings::Handpiece& handpiece : settings.handpieces)
        if (auto sound = settings::check(handpiece); !sound)
            return tl::unexpected(sound.error());
    if (auto sound = settings::check(settings.breakOff); !sound)
        return tl::unexpected(sound.error());
    auto method = contact::makeContactMethod(settings.method);
    if (!method)
        return tl::unexpected(method.error());
    return std::make_unique<ServoTick>(std::move(*method), settings);
}

contact::LiveTooth* ServoTick::swapTooth(contact::LiveTooth* tooth, bool anew, std::uint64_t tick) noexcept
{
    assert(tooth != nullptr);
    contact::LiveTooth* old = m_tooth;
    m_tooth = tooth;
    m_tooth->selectBur(m_state.burIndex);
    m_method->toothChanged();
    m_drill.rest();
    m_groundIsNew = !anew;
    if (anew) {
        m_settings.force = m_firstForce;
        m_settings.hardness.takeFigures(m_firstHardness);
        takeNumbers();
        const ServoState before = m_state;
        m_state = ServoState{};
        m_state.tick = tick;
        m_state.burIndex = before.burIndex;
        m_state.handpieceIndex = before.handpieceIndex;
        m_state.drillOn = before.drillOn;
        m_state.deviceMm = before.deviceMm;
        m_state.anchorMm = before.anchorMm;
        m_force.restart();
        m_restart = true;
        m_mayAct = false;
    }
    return old;
}

void ServoTick::setBur(std::size_t index) noexcept
{
    assert(index < bur::burs().size());
    m_state.burIndex = static_cast<std::uint8_t>(index);
    m_method->toothChanged();
    m_drill.rest();
    m_groundIsNew = true;
    if (m_tooth != nullptr)
        m_tooth->selectBur(index);
}

void ServoTick::setHandpiece(std::size_t index) noexcept
{
    if (index >= m_settings.handpieces.size())
        return;
    m_state.handpieceIndex = static_cast<std::uint8_t>(index);
    m_drill.setHandpiece(m_settings.handpieces[index]);
}

void ServoTick::setNumber(const SetParameter& number) noexcept
{
    setServoNumber(m_settings, number);
    takeNumbers();
}

void ServoTick::takeNumbers() noexcept
{
    m_drill.setHardness(m_settings.hardness);
    m_force.setSettings(m_settings.force);
}

void ServoTick::beginAs(const ServoState& left) noexcept
{
    m_state.burIndex = left.burIndex;
    m_state.drillOn = left.drillOn;
    m_state.deviceMm = left.deviceMm;
    m_state.anchorMm = left.anchorMm;
}

void ServoTick::step(const glm::vec3* device, std::chrono::microseconds dt) noexcept
{
    assert(m_tooth != nullptr && dt.count() >= 0);
    ++m_state.tick;
    m_changed = {};
    m_state.cutting = false;
    m_state.burRpm = m_state.drillOn ? m_drill.rpmUnder(0.0, 0.0) : 0.0;
    m_state.health &= ~(kDeviceLost | kForceClamped | kBegunInside | kLedHome);
    const double seconds = static_cast<double>(dt.count()) * 1.0e-6;
    if (device != nullptr && isPlausible(*device) && !leapt(glm::dvec3(*device), seconds)) {
        m_unread = {};
        m_state.deviceMm = glm::dvec3(*device);
    } else {
        m_unread += dt;
        if (m_restart || m_wasLost || m_unread >= kPassedOver) {
            lose();
            return;
        }
    }
    if (m_restart) {
        m_method->restart(m_state.deviceMm);
        m_restart = false;
    }
    // The handpiece stops at the tooth like the bur. The force beyond that presses on the crown and does not cut.
    glm::dvec3 reached = m_state.deviceMm;
    m_state.handpieceOnCrown = reached.z < m_tooth->floorMm();
    reached.z = std::max(reached.z, m_tooth->floorMm());
    const double before = glm::length(m_state.anchorMm - reached);
    m_state.anchorMm = m_method->update(*m_tooth, reached);
    const double stretchMm = glm::length(m_state.anchorMm - reached);
    const bool hasComeBack = m_groundIsNew && stretchMm > before + kComesBackMm;
    if (hasComeBack)  // ground that came back, by an undo or a wider bur, pushes softly at first
        m_force.drop();
    // A hand that moved into the tooth while it had no force must not be thrown out.
    if ((m_wasLost || hasComeBack) && stretchMm > kSunkMm)
        m_mayAct = false;
    m_wasLost = false;
    m_groundIsNew = false;
    // A bur that starts inside a tooth neither pushes nor cuts until it has been outside.
    if (!m_mayAct) {
        const glm::dvec2 over(reached);
        m_mayAct =
            m_tooth->clearanceAt(over, reached.z) <= reached.z || m_tooth->undersideAt(over, reached.z) >= reached.z;
        if (!m_mayAct) {
            letGo();
            m_state.health |= kBegunInside;
            return;
        }
        m_method->restart(m_state.deviceMm);
        m_state.anchorMm = m_method->update(*m_tooth, reached);
    }
    const glm::dvec3 stretch = m_state.anchorMm - reached;
    const double depth = std::sqrt(glm::dot(stretch, stretch));
    m_state.touching = depth > kTouchMm;

    if (m_state.drillOn && m_state.touching)
        cut(reached, m_force.springN(stretch), seconds);
    else
        m_drill.rest();
    m_state.forceN = around(m_force.update(m_state.deviceMm, m_state.anchorMm, seconds), seconds);
    if (m_force.clamped())
        m_state.health |= kForceClamped;
    describe();
}

/// Removes the material that the bur, pulled towards `reached` with `forceN` newtons, removes in `seconds`.
void ServoTick::cut(const glm::dvec3& reached, double forceN, double seconds) noexcept
{
    const cutting::Cut done = m_drill.cut(*m_tooth, m_state.anchorMm, m_method->cutTowards(reached), forceN, seconds);
    m_changed = done.changed;
    m_state.burRpm = m_drill.rpmUnder(forceN, static_cast<double>(m_tooth->mask().radiusMm));
    m_state.cutting = !done.changed.isEmpty();
    double most = 0.0;
    for (std::size_t m = 0; m < done.removedMm3.size(); ++m) {
        m_state.removedMm3[m] += done.removedMm3[m];
        if (done.removedMm3[m] > most) {
            most = done.removedMm3[m];
            m_state.materialUnderBur = static_cast<terrain::Material>(m);
        }
    }
    if (m_state.cutting && m_settings.breakOff.on) {
        const terrain::PerMaterial broken = cutting::breakOff(*m_tooth, m_settings.breakOff.slenderness, m_changed);
        for (std::size_t m = 0; m < broken.size(); ++m) {
            m_state.brokenMm3[m] += broken[m];
            m_state.removedMm3[m] += broken[m];
        }
    }
    if (m_state.cutting) {
        m_state.anchorMm = done.tipMm;
        m_method->moveTo(done.tipMm);
    }
}

/// Returns true if a hand cannot have moved from its last position to this one.
bool ServoTick::leapt(const glm::dvec3& device, double seconds) const noexcept
{
    const glm::dvec3 way = device - m_state.deviceMm;
    const double farthest = std::max(kLeastLeapMm, kFastestMmPerS * seconds);
    return !m_restart && !m_wasLost && glm::dot(way, way) > farthest * farthest;
}

/// Handles a lost device: its force is zero, and nothing is cut.
void ServoTick::lose() noexcept
{
    letGo();
    m_drill.rest();
    m_state.handpieceOnCrown = false;
    m_state.health |= kDeviceLost;
    m_wasLost = true;
    m_unread = {};
}

/// Sets all forces to zero and resets all state from which a force could arise.
void ServoTick::letGo() noexcept
{
    m_force.drop();
    m_workArea.drop();
    m_vibration.stop();
    m_state.forceN = glm::dvec3(0.0);
    m_state.touching = false;
}

/// Returns the contact force plus forces that do not come from the tooth, which neither cut nor count as contact.
glm::dvec3 ServoTick::around(const glm::dvec3& contactN, double seconds) noexcept
{
    const glm::dvec3 sum = contactN + m_workArea.update(m_state.deviceMm, seconds) +
                           m_vibration.update(m_state.drillOn && !m_state.touching, seconds);
    if (m_workArea.isLeading())
        m_state.health |= kLedHome;
    const double newtons = std::sqrt(glm::dot(sum, sum));
    const double clampN = m_force.settings().clampN;
    return newtons > clampN ? sum * (clampN / newtons) : sum;
}

/// Sets the depth and material under the tip for the display, from the nearest column.
void ServoTick::describe() noexcept
{
    const terrain::Tooth& tooth = m_tooth->tooth();
    const glm::dvec2 at = tooth.grid().latticeOf({m_state.anchorMm.x, m_state.anchorMm.y});
    const int i = static_cast<int>(std::floor(at.x + 0.5));
    const int j = static_cast<int>(std::floor(at.y + 0.5));
    m_state.depthMm = 0.0;
    m_state.hasDepth = false;
    if (!tooth.grid().contains(i, j))
        return;
    const std::size_t k = tooth.grid().index(i, j);
    const terrain::ToothAnatomy& anatomy = *tooth.anatomy;
    if (anatomy.top[k] > anatomy.bottom[k])
        m_state.depthMm = std::max(0.0, static_cast<double>(anatomy.top[k]) - m_state.anchorMm.z);
    m_state.hasDepth =
        tooth.isSolid(k) && m_state.anchorMm.z >= static_cast<double>(tooth.bottom[k]) && !isFlank(anatomy, i, j);
    if (m_state.touching && !m_state.cutting && tooth.isSolid(k))
        m_state.materialUnderBur = terrain::materialAt(anatomy.layers[k], tooth.top[k]);
}

}  // namespace core::servo
