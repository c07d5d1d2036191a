// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/Player.h"
#include "core/servo/ServoState.h"

#include <algorithm>
#include <cmath>

#include "core/recording/Format.h"

namespace core::recording {
namespace {

using cutting::CutRect;

CutRect both(const CutRect& a, const CutRect& b)
{
    if (a.isEmpty() || b.isEmpty())
        return a.isEmpty() ? b : a;
    return {std::min(a.i0, b.i0), std::min(a.j0, b.j0), std::max(a.i1, b.i1), std::max(a.j1, b.j1)};
}

std::array<float, terrain::kMaterialCount> narrow(const terrain::PerMaterial& volumes)
{
    std::array<float, terrain::kMaterialCount> out{};
    std::transform(volumes.begin(), volumes.end(), out.begin(),
                   [](double volume) { return static_cast<float>(volume); });
    return out;
}

}  // namespace

Result<std::unique_ptr<Player>> Player::make(Recording recording)
{
    auto servo = Replayer::make(recording);
    if (!servo)
        return tl::unexpected(servo.error());
    return std::unique_ptr<Player>(new Player(std::move(recording), std::move(*servo)));
}

Player::Player(Recording recording, Replayer servo)
    : m_recording(std::move(recording)), m_servo(std::move(servo)), m_shown(m_servo.tooth().tooth().top)
{
    keepPose(m_servo.state());
    keepKeyFrame();
}

bool Player::advance(std::uint64_t ticks, const std::function<void(const ServoEvent&, const Replayer&)>& afterEvent)
{
    const std::uint64_t until = m_servo.tick() + std::min(ticks, m_recording.ticks());
    while (m_servo.tick() < until || until == m_recording.ticks()) {
        if (m_nextAtHand == m_events.size()) {
            m_events = m_recording.eventsSince(m_nextEvent);
            m_nextEvent += m_events.size();
            m_nextAtHand = 0;
        }
        if (m_events.empty()) {
            keepPatch();
            const std::lock_guard lock(m_mutex);
            m_ready = m_servo.tick();
            return false;
        }
        const ServoEvent& event = m_events[m_nextAtHand++];
        play(event);
        if (afterEvent)
            afterEvent(event, m_servo);
    }
    return true;
}

void Player::play(const ServoEvent& event)
{
    if (!isTick(event.kind)) {
        const bool otherTooth = event.kind == ServoEvent::Kind::Restore || event.kind == ServoEvent::Kind::Resume;
        if (otherTooth)
            keepPatch();
        m_servo.play(event);
        if (otherTooth) {
            m_watch.restart();
            m_shown = m_servo.tooth().tooth().top;
            keepKeyFrame();
        }
        const std::lock_guard lock(m_mutex);
        m_marks.push_back({m_servo.tick(), event});
        return;
    }
    m_servo.play(event);
    m_time += std::chrono::microseconds(event.dtUs);
    m_changed = both(m_changed, m_servo.changed());
    const std::uint64_t tick = m_servo.tick();
    const bool cut = !m_servo.changed().isEmpty();
    const bool wasInStroke = m_watch.isInStroke();
    m_watch.endsWith(cut);
    if (cut) {
        const std::lock_guard lock(m_mutex);
        if (!wasInStroke)
            m_strokes.push_back({tick, tick});
        m_strokes.back().to = tick;
    }
    if (tick % kTicksAPatch == 0)
        keepPatch();
    if (tick % kTicksAKeyFrame == 0 && m_keyFrames.back().patches != m_patches.size())
        keepKeyFrame();
    if (tick % kTicksAPose == 0)
        keepPose(m_servo.state());
}

void Player::keepPose(const servo::ServoState& state)
{
    const Pose pose{.deviceMm = glm::vec3(state.deviceMm),
                    .anchorMm = glm::vec3(state.anchorMm),
                    .forceN = glm::vec3(state.forceN),
                    .removedMm3 = narrow(state.removedMm3),
                    .brokenMm3 = narrow(state.brokenMm3),
                    .burRpm = static_cast<float>(state.burRpm),
                    .depthMm = static_cast<float>(state.depthMm),
                    .seconds = std::chrono::duration<double>(m_time).count(),
                    .health = state.health,
                    .burIndex = state.burIndex,
                    .handpieceIndex = state.handpieceIndex,
                    .material = state.materialUnderBur,
                    .touching = state.touching,
                    .drillOn = state.drillOn,
                    .cutting = state.cutting,
                    .handpieceOnCrown = state.handpieceOnCrown,
                    .hasDepth = state.hasDepth};
    const std::lock_guard lock(m_mutex);
    m_poses.push_back(pose);
    m_ready = m_servo.tick();
}

void Player::keepPatch()
{
    if (m_changed.isEmpty())
        return;
    const terrain::Tooth& tooth = m_servo.tooth().tooth();
    const std::lock_guard lock(m_mutex);
    for (int j = m_changed.j0; j <= m_changed.j1; ++j) {
        for (int i = m_changed.i0; i <= m_changed.i1; ++i) {
            const std::size_t k = tooth.grid().index(i, j);
            if (m_shown[k] == tooth.top[k])
                continue;
            m_shown[k] = tooth.top[k];
            m_columns.push_back(static_cast<std::uint32_t>(k));
            m_heights.push_back(tooth.top[k]);
        }
    }
    m_patches.push_back({m_servo.tick(), m_columns.size()});
    m_changed = {};
}

void Player::keepKeyFrame()
{
    const history::TiledHeights& top = m_servo.heights();
    const std::lock_guard lock(m_mutex);
    m_keyFrames.push_back({m_servo.tick(), m_patches.size(), top});
}

std::uint64_t Player::readyTicks() const
{
    const std::lock_guard lock(m_mutex);
    return m_ready;
}

double Player::secondsAt(std::uint64_t tick) const
{
    const std::lock_guard lock(m_mutex);
    const std::size_t n = static_cast<std::size_t>(tick / kTicksAPose);
    if (n + 1 >= m_poses.size())
        return m_poses.back().seconds;
    const double share = static_cast<double>(tick % kTicksAPose) / static_cast<double>(kTicksAPose);
    return std::lerp(m_poses[n].seconds, m_poses[n + 1].seconds, share);
}

std::uint64_t Player::tickAt(double seconds) const
{
    const std::lock_guard lock(m_mutex);
    const auto behind = std::upper_bound(m_poses.begin(), m_poses.end(), seconds,
                                         [](double value, const Pose& pose) { return value < pose.seconds; });
    if (behind == m_poses.begin())
        return 0;
    const auto before = behind - 1;
    const auto tick = kTicksAPose * static_cast<std::uint64_t>(before - m_poses.begin());
    if (behind == m_poses.end())
        return tick;
    const double share = (seconds - before->seconds) / (behind->seconds - before->seconds);
    return tick + static_cast<std::uint64_t>(share * static_cast<double>(kTicksAPose));
}

servo::ServoState Player::stateAt(std::uint64_t tick) const
{
    const std::lock_guard lock(m_mutex);
    const std::size_t n = std::min(static_cast<std::size_t>(tick / kTicksAPose), m_poses.size() - 1);
    const Pose& pose = m_poses[n];
    servo::ServoState state;
    state.tick = kTicksAPose * n;
    state.deviceMm = pose.deviceMm;
    state.anchorMm = pose.anchorMm;
    state.forceN = pose.forceN;
    state.touching = pose.touching;
    state.drillOn = pose.drillOn;
    state.cutting = pose.cutting;
    state.handpieceOnCrown = pose.handpieceOnCrown;
    state.burIndex = pose.burIndex;
    state.handpieceIndex = pose.handpieceIndex;
    state.materialUnderBur = pose.material;
    state.burRpm = static_cast<double>(pose.burRpm);
    state.depthMm = static_cast<double>(pose.depthMm);
    state.hasDepth = pose.hasDepth;
    std::copy(pose.removedMm3.begin(), pose.removedMm3.end(), state.removedMm3.begin());
    std::copy(pose.brokenMm3.begin(), pose.brokenMm3.end(), state.brokenMm3.begin());
    state.health = pose.health;
    return state;
}

std::vector<float> Player::heightsAt(std::uint64_t tick) const
{
    const std::lock_guard lock(m_mutex);
    const auto after = std::upper_bound(m_keyFrames.begin(), m_keyFrames.end(), tick,
                                        [](std::uint64_t value, const KeyFrame& frame) { return value < frame.tick; });
    const KeyFrame& frame = *(after - 1);  // there is always one, because the first is at tick 0
    std::vector<float> top = frame.top.flat();
    std::size_t k = frame.patches == 0 ? 0 : m_patches[frame.patches - 1].end;
    for (std::size_t n = frame.patches; n < m_patches.size() && m_patches[n].tick <= tick; ++n)
        for (; k < m_patches[n].end; ++k)
            top[m_columns[k]] = m_heights[k];
    return top;
}

std::vector<StrokeSpan> Player::strokes() const
{
    const std::lock_guard lock(m_mutex);
    return m_strokes;
}

std::vector<MarkedEvent> Player::marks() const
{
    const std::lock_guard lock(m_mutex);
    return m_marks;
}

std::size_t Player::bytes() const
{
    const std::lock_guard lock(m_mutex);
    std::size_t sum = m_poses.capacity() * sizeof(Pose) + m_patches.capacity() * sizeof(Patch) +
                      m_columns.capacity() * sizeof(std::uint32_t) + m_heights.capacity() * sizeof(float);
    const history::TiledHeights* before = nullptr;
    for (const KeyFrame& frame : m_keyFrames) {
        const auto tiles = frame.top.tiles();
        sum += tiles.size_bytes();
        for (std::size_t n = 0; n < tiles.size(); ++n)
            sum += before == nullptr || before->tiles()[n] != tiles[n] ? sizeof(history::Tile) : 0;
        before = &frame.top;
    }
    return sum;
}

}  // namespace core::recording
