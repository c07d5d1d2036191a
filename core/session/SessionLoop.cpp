// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/SessionLoop.h"
#include "core/history/MomentId.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"

#include <algorithm>
#include <utility>

#include "core/guidance/Fixture.h"
#include "core/recording/Format.h"

namespace core::session {
namespace {

/// Number of restored moments stored for the loop that follows the attempt. If that loop is further behind, it begins
/// again.
constexpr std::size_t kRestoredKept = 256;

/// Number of events that a recording can take after its last step.
constexpr std::uint64_t kRoomForNotes = 10'000;

}  // namespace

SessionLoop::SessionLoop(servo::ServoChannels& servo, UiChannels& ui, servo::ServoSettings settings,
                         const SessionMemory& memory)
    : m_servo(servo), m_ui(ui), m_settings(std::move(settings)), m_records(memory.recording),
      m_undoBytes(memory.undoBytes)
{}

SessionLoop::~SessionLoop()
{
    freeRetired();
}

void SessionLoop::tick(std::chrono::microseconds)
{
    freeRetired();
    takeEvents();
    takePatches();
    takeCommands();
    forward();
    publish();
}

void SessionLoop::end()
{
    freeRetired();
    takeEvents();
    takePatches();
    publish();
}

void SessionLoop::freeRetired()
{
    for (contact::LiveTooth* tooth = nullptr; m_servo.retired.tryPop(tooth);)
        delete tooth;
    for (servo::ServoTick* servo = nullptr; m_servo.retiredServos.tryPop(servo);)
        delete servo;
    for (const guidance::Fixture* fixture = nullptr; m_servo.retiredFixtures.tryPop(fixture);)
        delete fixture;
}

void SessionLoop::takeEvents()
{
    const std::lock_guard lock(m_mutex);
    for (servo::ServoEvent event; m_servo.events.tryPop(event);) {
        if (event.kind == servo::ServoEvent::Kind::Begin) {
            while (!m_upcoming.empty() && m_upcoming.front().generation < event.value)
                m_upcoming.pop_front();
            if (m_upcoming.empty())
                continue;
            m_attemptTime = m_upcoming.front().recording.duration();
            if (m_records)
                m_recording = std::move(m_upcoming.front().recording);
            m_recordedGeneration = event.value;
            m_upcoming.pop_front();
            if (m_recordedGeneration == m_generation)
                for (const servo::ServoEvent& noted : std::exchange(m_noted, {}))
                    note(noted);
            continue;
        }
        m_attemptTime += std::chrono::microseconds(event.dtUs);
        keep(event);
    }
}

/// Records an event. A recording takes no more steps when it is too long: the window has ended the attempt by then, see
/// SessionState::isFull. Undo steps and notes still find room. The caller holds the mutex.
void SessionLoop::keep(const servo::ServoEvent& event)
{
    const std::uint64_t most = recording::kMaxEvents - (recording::isTick(event.kind) ? kRoomForNotes : 1);
    if (m_recording && m_recording->events() < most)
        m_recording->append(event);
}

void SessionLoop::takePatches()
{
    for (servo::TilePatch patch; m_servo.patches.tryPop(patch);) {
        if (patch.toothGeneration != m_serial) {
            m_group.clear();
            continue;
        }
        m_group.push_back(patch);
        if (patch.last) {
            applyGroup();
            m_group.clear();
        }
    }
}

void SessionLoop::applyGroup()
{
    const std::lock_guard lock(m_mutex);
    for (servo::TilePatch& patch : m_group) {
        m_mirror.setTile(patch.tileX, patch.tileY, patch.top);
        patch.toothGeneration = m_generation;
        m_toUi.push_back(patch);
    }
    m_mirrorTick = m_group.back().tick;
    m_vouched = m_mirror;
    m_vouchedTick = m_mirrorTick;
    m_unfinished = true;
    m_hasCut = true;
    if (m_group.back().strokeEnded) {
        rememberUnfinished();
        ++m_strokes;
    }
}

/// Adds the present mirror to the history as a moment. The caller holds the mutex.
void SessionLoop::rememberUnfinished()
{
    if (!m_unfinished)
        return;
    m_undo.push({m_mirror, m_mirrorTick, std::chrono::duration<double>(m_attemptTime).count(), m_removed.of(m_mirror)});
    m_unfinished = false;
    ++m_historyVersion;
}

void SessionLoop::takeCommands()
{
    // A command may hand a tooth to the servo, so it is taken only if the queue to the servo has room.
    for (SessionCommand command; m_servo.commands.space() > 0 && m_ui.commands.tryPop(command);)
        std::visit([this](auto&& known) { apply(std::forward<decltype(known)>(known)); }, std::move(command));
}

/// Moves to another moment, if `go` finds one. If there are cuts since the last moment, adds a moment first.
void SessionLoop::step(const std::function<bool()>& go)
{
    if (!m_anatomy)
        return;
    {
        const std::lock_guard lock(m_mutex);
        rememberUnfinished();
        if (!go())
            return;
        ++m_historyVersion;
    }
    handOver();
}

void SessionLoop::apply(const Undo&)
{
    step([this] { return m_undo.undo(); });
}

void SessionLoop::apply(const Redo&)
{
    if (!m_unfinished)
        step([this] { return m_undo.redo(); });
}

void SessionLoop::apply(const GoTo& where)
{
    step([this, &where] { return m_undo.goTo(where.id); });
}

void SessionLoop::apply(const Reload&)
{
    step([this] {
        if (m_undo.current().tick == 0)
            return false;
        m_undo.push({m_uncut, 0, std::chrono::duration<double>(m_attemptTime).count(), {}});
        return true;
    });
}

void SessionLoop::apply(ReplaceTooth&& replace)
{
    if (replace.servo)
        m_settings = replace.servo->settings();
    const std::shared_ptr<const terrain::ToothAnatomy>& anatomy = replace.tooth->anatomy;
    const history::TiledHeights uncut(anatomy->grid, anatomy->top);
    history::UndoTree history(m_undoBytes);
    history.restart({uncut, 0, 0.0, {}});
    take({recording::Recording(m_settings, anatomy, replace.lesson), uncut, std::move(history), 0, nullptr},
         replace.generation, false, std::move(replace.servo));
}

void SessionLoop::apply(ResumeAttempt&& resume)
{
    std::unique_ptr<servo::ServoTick> servo = std::move(resume.attempt->servo);
    m_settings = resume.attempt->recording.settings();
    take(std::move(*resume.attempt), resume.generation, true, std::move(servo));
}

/// Begins an attempt, or resumes one.
void SessionLoop::take(ResumableAttempt attempt, std::uint64_t generation, bool resumed,
                       std::unique_ptr<servo::ServoTick> servo)
{
    const std::uint64_t tick = attempt.recording.ticks();
    {
        const std::lock_guard lock(m_mutex);
        m_anatomy = attempt.recording.anatomy();
        m_generation = generation;
        m_uncut = std::move(attempt.uncut);
        m_undo = std::move(attempt.history);
        m_mirror = m_undo.current().top;
        m_mirrorTick = tick;
        m_vouched = m_mirror;
        m_vouchedTick = resumed ? std::nullopt : std::optional(tick);
        ++m_historyVersion;
        m_unfinished = false;
        m_hasCut = resumed;
        m_strokes = attempt.strokes;
        m_wholeMm3 = terrain::volumes(terrain::Tooth(m_anatomy));
        m_removed = history::RemovedTally(m_anatomy);
        m_restored.clear();
        m_group.clear();
        // The view has the whole tooth already, so it needs only the patches that are cut.
        const auto cut = history::patchesBetween(m_uncut, m_mirror, tick, m_generation);
        m_toUi.assign(cut.begin(), cut.end());
        m_noted.clear();
        m_upcoming.push_back({m_generation, std::move(attempt.recording)});
    }
    static_cast<void>(
        m_servo.commands.tryPush(servo::SwapTooth{new contact::LiveTooth(terrain::restored(m_anatomy, m_mirror.flat())),
                                                  m_generation, ++m_serial, true, tick, resumed, servo.release()}));
}

void SessionLoop::apply(const SetAids& aids)
{
    const std::lock_guard lock(m_mutex);
    note({servo::ServoEvent::Kind::Aids, 0, glm::vec3(0.0F), aids.aids});
}

void SessionLoop::apply(const AddNote& added)
{
    const std::lock_guard lock(m_mutex);
    note({servo::ServoEvent::Kind::Note, 0, glm::vec3(0.0F), added.code});
}

/// Records an event, if the recording belongs to the present tooth. The caller holds the mutex.
void SessionLoop::note(const servo::ServoEvent& event)
{
    if (m_recordedGeneration != m_generation)
        m_noted.push_back(event);
    else
        keep(event);
}

void SessionLoop::apply(const servo::SetBur& bur)
{
    static_cast<void>(m_servo.commands.tryPush(bur));
}

void SessionLoop::apply(const servo::SetDrill& drill)
{
    static_cast<void>(m_servo.commands.tryPush(drill));
}

void SessionLoop::apply(const servo::SetHandpiece& handpiece)
{
    static_cast<void>(m_servo.commands.tryPush(handpiece));
}

void SessionLoop::apply(const servo::SetParameter& number)
{
    static_cast<void>(m_servo.commands.tryPush(number));
}

void SessionLoop::apply(SetFixture&& held)
{
    if (m_servo.commands.tryPush(servo::SetFixture{held.fixture.get()}))
        static_cast<void>(held.fixture.release());  // the servo returns it through retiredFixtures
}

void SessionLoop::apply(const servo::BringHome& home)
{
    static_cast<void>(m_servo.commands.tryPush(home));
}

/// Sends the tooth of the present moment to the servo, and the changes to the view.
void SessionLoop::handOver()
{
    const history::ToothMoment& moment = m_undo.current();
    m_group.clear();
    for (const servo::TilePatch& patch : history::patchesBetween(m_mirror, moment.top, moment.tick, m_generation))
        m_toUi.push_back(patch);
    static_cast<void>(m_servo.commands.tryPush(
        servo::SwapTooth{new contact::LiveTooth(terrain::restored(m_anatomy, moment.top.flat())), m_generation,
                         ++m_serial, false, moment.tick}));
    const std::lock_guard lock(m_mutex);
    m_mirror = moment.top;
    m_mirrorTick = moment.tick;
    m_restored.emplace_back(moment.tick, moment.top);
    if (m_restored.size() > kRestoredKept)
        m_restored.pop_front();
}

void SessionLoop::forward()
{
    while (!m_toUi.empty() && m_ui.patches.tryPush(m_toUi.front()))
        m_toUi.pop_front();
}

void SessionLoop::publish()
{
    SessionState& out = m_ui.session.back();
    out = {};
    out.toothGeneration = m_generation;
    out.undoSteps = m_undo.undoSteps() + (m_unfinished ? 1 : 0);
    out.redoSteps = m_unfinished ? 0 : m_undo.redoSteps();
    out.historyVersion = m_historyVersion;
    out.strokes = m_strokes;
    out.wholeMm3 = m_wholeMm3;
    if (m_anatomy) {
        const history::Removed& removed = m_removed.of(m_mirror);
        out.removedMm3 = removed.volumesMm3;
        out.overcutMm3 = removed.overcutMm3;
        out.pulpExposedMm2 = removed.pulpExposedMm2;
        out.perforated = removed.perforated;
    }
    const bool isRecorded = m_recording && m_recordedGeneration == m_generation;
    out.isFull = isRecorded && m_recording->isFull();
    out.recordedS = isRecorded ? std::chrono::duration<double>(m_recording->duration()).count() : 0.0;
    m_ui.session.publish();
}

std::optional<recording::Recording> SessionLoop::recordingSoFar() const
{
    const std::lock_guard lock(m_mutex);
    std::optional<recording::Recording> copy = m_recording;
    // Patches arrive in groups, so the mirror may be a few ticks behind the events, but is never ahead. The copy is
    // valid for the tick of the mirror, unless the recording had to stop before that.
    if (copy && m_recordedGeneration == m_generation && m_vouchedTick && *m_vouchedTick <= copy->ticks())
        copy->setWitness({*m_vouchedTick, terrain::stateHash(terrain::restored(m_anatomy, m_vouched.flat()))});
    return copy;
}

std::optional<history::TiledHeights> SessionLoop::restored(std::uint64_t tick) const
{
    const std::lock_guard lock(m_mutex);
    for (auto known = m_restored.rbegin(); known != m_restored.rend(); ++known)
        if (known->first == tick)
            return known->second;
    return std::nullopt;
}

std::uint64_t SessionLoop::recordedGeneration() const
{
    const std::lock_guard lock(m_mutex);
    return m_recording ? m_recordedGeneration : 0;
}

RecordedPart SessionLoop::recordedSince(std::uint64_t generation, std::uint64_t first) const
{
    const std::lock_guard lock(m_mutex);
    if (!m_recording)
        return {};
    RecordedPart part{m_recordedGeneration, m_hasCut && m_recordedGeneration == m_generation, {}};
    if (m_recordedGeneration == generation)
        part.events = m_recording->eventsSince(first);
    return part;
}

std::optional<terrain::Tooth> SessionLoop::toothSoFar() const
{
    const std::lock_guard lock(m_mutex);
    if (!m_anatomy)
        return std::nullopt;
    return terrain::restored(m_anatomy, m_mirror.flat());
}

std::vector<history::MomentInfo> SessionLoop::historySoFar() const
{
    const std::lock_guard lock(m_mutex);
    return m_undo.list();
}

std::vector<float> SessionLoop::momentHeights(history::MomentId id) const
{
    history::TiledHeights top;
    {
        const std::lock_guard lock(m_mutex);
        const history::ToothMoment* moment = m_undo.find(id);
        if (moment == nullptr)
            return {};
        top = moment->top;
    }
    return top.flat();
}

}  // namespace core::session
