// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/ResumableAttempt.h"
#include "core/history/MomentId.h"

#include <chrono>
#include <map>
#include <set>

#include "core/recording/Format.h"
#include "core/recording/IdleIntervals.h"
#include "core/recording/Replay.h"
#include "core/servo/StrokeDetector.h"

namespace core::session {
namespace {

/// Rebuilds the tree of moments while a recording is replayed.
class HistoryRebuilder
{
public:
    HistoryRebuilder(const recording::Recording& recording, recording::Replayer& servo)
        : m_servo(servo), m_removed(recording.anatomy())
    {
        recording.forEach([this](const servo::ServoEvent& event) {
            if (event.kind == servo::ServoEvent::Kind::Restore)
                m_goneBackTo.insert(event.value);
        });
        m_tree.restart({servo.heights(), 0, 0.0, {}});
        m_unfinished = m_tree.current();
    }

    void play(const servo::ServoEvent& event)
    {
        m_time += std::chrono::microseconds(event.dtUs);
        if (event.kind == servo::ServoEvent::Kind::Restore || event.kind == servo::ServoEvent::Kind::Resume)
            endStroke();
        if (m_servo.play(event)) {
            const bool cut = !m_servo.changed().isEmpty();
            m_hasCut = m_hasCut || cut;
            // Undo made a moment in the middle of a stroke, because the attempt returned to it later.
            if (m_hasCut && m_goneBackTo.contains(m_servo.tick()))
                m_unfinished = now();
            if (m_stroke.endsWith(cut)) {
                m_unfinished = now();
                endStroke();
                ++m_strokes;
            }
        }
        if (event.kind == servo::ServoEvent::Kind::Restore)
            goTo(event.value);
    }

    [[nodiscard]] int strokes() const { return m_strokes; }
    [[nodiscard]] history::UndoTree finish()
    {
        endStroke();
        return std::move(m_tree);
    }

private:
    [[nodiscard]] history::ToothMoment now()
    {
        const history::TiledHeights& top = m_servo.heights();
        return {top, m_servo.tick(), std::chrono::duration<double>(m_time).count(), m_removed.of(top)};
    }

    void endStroke()
    {
        m_stroke.restart();
        if (!m_hasCut)
            return;
        m_hasCut = false;
        if (m_unfinished.tick <= m_strokeBegan)
            m_unfinished = now();
        m_strokeBegan = m_servo.tick();
        m_tree.push(m_unfinished);
        m_ids[m_unfinished.tick] = m_tree.currentId();
    }

    void goTo(std::uint64_t tick)
    {
        m_strokeBegan = m_servo.tick();
        const auto is = [&](bool went) { return went && m_tree.current().tick == tick; };
        const history::MomentId before = m_tree.currentId();
        if (is(m_tree.undo()))
            return;
        m_tree.goTo(before);
        if (is(m_tree.redo()))
            return;
        m_tree.goTo(before);
        const auto known = m_ids.find(tick);
        if (tick != 0 && known != m_ids.end() && (m_tree.goTo(known->second) || m_tree.currentId() == known->second))
            return;
        history::ToothMoment moment = now();
        moment.tick = tick;
        m_tree.push(std::move(moment));
    }

    recording::Replayer& m_servo;
    history::UndoTree m_tree;
    history::RemovedTally m_removed;
    servo::StrokeDetector m_stroke;
    std::set<std::uint64_t> m_goneBackTo;
    std::map<std::uint64_t, history::MomentId> m_ids;  ///< by tick
    history::ToothMoment m_unfinished;                 ///< the moment of the current or last stroke
    std::uint64_t m_strokeBegan = 0;                   ///< events before it belong to another stroke
    std::chrono::microseconds m_time{0};
    bool m_hasCut = false;
    int m_strokes = 0;
};

}  // namespace

Result<std::unique_ptr<ResumableAttempt>> rebuild(recording::Recording recording)
{
    auto servo = recording::Replayer::make(recording);
    if (!servo)
        return tl::unexpected(servo.error());
    history::TiledHeights uncut = servo->heights();
    HistoryRebuilder gardener(recording, *servo);
    // The state after the last tick differs from the final state if an undo was the last action.
    bool wentElsewhere = false;
    const auto witness = [&] { return recording::Witness{servo->tick(), terrain::stateHash(servo->tooth().tooth())}; };
    std::optional<recording::Witness> last;
    std::optional<std::uint8_t> bur;
    std::optional<std::uint8_t> handpiece;
    recording::IdleIntervals rests;
    std::chrono::microseconds rested{0};
    recording.forEach([&](const servo::ServoEvent& event) {
        const bool goes =
            event.kind == servo::ServoEvent::Kind::Restore || event.kind == servo::ServoEvent::Kind::Resume;
        if (event.kind == servo::ServoEvent::Kind::Bur)
            bur = static_cast<std::uint8_t>(event.value);
        if (event.kind == servo::ServoEvent::Kind::Handpiece)
            handpiece = static_cast<std::uint8_t>(event.value);
        if (goes && !wentElsewhere)
            last = witness();
        wentElsewhere = goes || (wentElsewhere && !recording::isTick(event.kind));
        gardener.play(event);
        rests.hear(event);
        if (recording::isStep(event) && rests.leaveOut(servo->state()))
            rested += std::chrono::microseconds(event.dtUs);
    });
    recording.setWitness(wentElsewhere ? *last : witness());
    auto next = servo::makeServoTick(recording.settings());
    if (!next)
        return tl::unexpected(next.error());
    const int strokes = gardener.strokes();
    return std::make_unique<ResumableAttempt>(
        ResumableAttempt{std::move(recording), std::move(uncut), gardener.finish(), strokes, std::move(*next), bur,
                         handpiece, std::chrono::duration<double>(rested).count()});
}

}  // namespace core::session
