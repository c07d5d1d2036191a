// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/replay/ReplayTrack.h"

#include <algorithm>

#include <glm/common.hpp>

#include "core/recording/OriginNotes.h"
#include "lessons/Assignment.h"

namespace app {
namespace {

using namespace core::session;
using namespace core::servo;
using core::history::TiledHeights;
using core::recording::MarkedEvent;
using core::recording::Player;
using ui::replay::AttemptTimeline;
using ui::replay::Mark;

/// From a tick on at which something was over, it is seen after so many more: times are told a little roughly.
constexpr std::uint64_t kMarginTicks = 2;

/// The first tick at which all is shown that had been cut by then.
std::uint64_t patchAfter(std::uint64_t tick)
{
    return (tick + Player::kTicksAPatch - 1) / Player::kTicksAPatch * Player::kTicksAPatch + kMarginTicks;
}

/// Returns whether a note is only for the program, and not shown on the time line.
bool isSilent(std::uint64_t note)
{
    return note == core::servo::kRestNote || note == core::servo::kWorkNote || core::recording::isExamNote(note) ||
           core::recording::isPersonNote(note) || core::session::sightOf(note);
}

/// The events in words of a time line. A bur that is taken again and aids that stay the same are no news.
class MarkMaker
{
public:
    std::optional<Mark::Kind> take(const MarkedEvent& marked, std::uint64_t lastCutTick)
    {
        switch (marked.event.kind) {
        case ServoEvent::Kind::Restore:
            return takeRestore(marked, lastCutTick);
        case ServoEvent::Kind::Bur:
            return ifNews(marked, m_bur, Mark::Kind::Bur);
        case ServoEvent::Kind::Aids:
            return ifNews(marked, m_aids, Mark::Kind::Aids);
        case ServoEvent::Kind::Handpiece:
            return ifNews(marked, m_handpiece, Mark::Kind::Handpiece);
        case ServoEvent::Kind::Note:
            return isSilent(marked.event.value) ? std::nullopt : std::optional(Mark::Kind::Note);
        case ServoEvent::Kind::Home:
            return Mark::Kind::Home;
        case ServoEvent::Kind::Resume:
            return Mark::Kind::Resumed;
        default:
            return std::nullopt;
        }
    }

private:
    /// What an attempt begins with is none.
    static std::optional<Mark::Kind> ifNews(const MarkedEvent& marked, std::uint64_t& last, Mark::Kind kind)
    {
        const bool isNews = std::exchange(last, marked.event.value) != marked.event.value && marked.tick > 0;
        return isNews ? std::optional(kind) : std::nullopt;
    }

    /// Undo goes to an older state of the tooth, redo to a younger one.
    Mark::Kind takeRestore(const MarkedEvent& marked, std::uint64_t lastCutTick)
    {
        const std::uint64_t present = lastCutTick > m_restoredAt ? lastCutTick : m_restoredTo;
        m_restoredAt = marked.tick;
        m_restoredTo = marked.event.value;
        return m_restoredTo == 0        ? Mark::Kind::StartAgain
               : m_restoredTo > present ? Mark::Kind::Redo
                                        : Mark::Kind::Undo;
    }

    std::uint64_t m_bur = 0;
    std::uint64_t m_handpiece = 0;
    std::uint64_t m_aids = 0;
    std::uint64_t m_restoredAt = 0;
    std::uint64_t m_restoredTo = 0;
};

}  // namespace

core::Result<std::unique_ptr<ReplayTrack>> ReplayTrack::make(const core::recording::Recording& recording,
                                                             UiChannels& links, std::uint64_t generation)
{
    auto player = Player::make(recording);
    if (!player)
        return tl::unexpected(player.error());
    // A lesson that cannot be read leaves nothing to be watched; the motion can still be seen.
    const auto assignment = lessons::assignmentOf(recording.anatomy(), recording.lesson());
    const Examination examination = assignment ? lessons::examinationOf(*assignment) : Examination{};
    std::unique_ptr<ReplayTrack> track(new ReplayTrack(std::move(*player), examination, links, generation));
    if (assignment)
        track->m_lesson = assignment->lesson;
    return track;
}

ReplayTrack::ReplayTrack(std::unique_ptr<Player> player, const Examination& examination, UiChannels& links,
                         std::uint64_t generation)
    : m_player(std::move(player)), m_lengthS(std::chrono::duration<double>(m_player->recording().duration()).count()),
      m_ideal(examination.ideal), m_examiner(examination, m_player->recording().anatomy()), m_links(links),
      m_generation(generation), m_shown(m_player->recording().anatomy()->grid, m_player->recording().anatomy()->top),
      m_removed(m_player->recording().anatomy())
{
    if (const auto* asked =
            examination.exercise ? std::get_if<core::grading::PointsToTouch>(&*examination.exercise) : nullptr)
        for (const glm::dvec2& placeMm : asked->pointsMm)
            m_points.push_back({placeMm, asked->reachMm, std::nullopt});
    m_session.toothGeneration = generation;
    m_session.wholeMm3 = core::terrain::volumes(core::terrain::Tooth(m_player->recording().anatomy()));
}

bool ReplayTrack::prepare(std::uint64_t ticks)
{
    const bool goesOn =
        m_player->advance(ticks, [this](const ServoEvent& event, const core::recording::Replayer& replayed) {
            m_examiner.take(event, replayed);
        });
    if (m_examiner.infractions().size() != m_found) {
        m_found = m_examiner.infractions().size();
        const std::lock_guard lock(m_mutex);
        m_infractions = m_examiner.infractions();
    }
    if (const auto practised = m_examiner.practised())
        if (const auto* touched = std::get_if<core::grading::Touched>(&*practised)) {
            const std::lock_guard lock(m_mutex);
            for (std::size_t k = 0; k < m_points.size(); ++k)
                m_points[k].touchedAtS =
                    touched->atS.at(k) ? std::optional(m_examiner.recordedS(*touched->atS.at(k))) : std::nullopt;
        }
    return goesOn;
}

double ReplayTrack::readyS() const
{
    const std::uint64_t ready = m_player->readyTicks();
    return ready == m_player->ticks() ? m_lengthS : m_player->secondsAt(ready);
}

AttemptTimeline ReplayTrack::course() const
{
    AttemptTimeline course;
    course.lengthS = m_lengthS;
    course.readyS = readyS();
    const auto strokes = m_player->strokes();
    for (const core::recording::StrokeSpan& span : strokes)
        course.strokes.push_back({m_player->secondsAt(span.from), m_player->secondsAt(span.to),
                                  m_player->secondsAt(patchAfter(span.to)), m_player->stateAt(span.to).burIndex});
    MarkMaker maker;
    std::size_t begun = 0;
    for (const MarkedEvent& marked : m_player->marks()) {
        while (begun < strokes.size() && strokes[begun].from <= marked.tick)
            ++begun;
        const std::uint64_t lastCut = begun == 0 ? 0 : std::min(strokes[begun - 1].to, marked.tick);
        if (const auto kind = maker.take(marked, lastCut))
            course.marks.push_back({*kind, m_player->secondsAt(marked.tick + kMarginTicks), marked.event.value,
                                    nameOf(*kind, marked.event.value)});
        takeRest(marked, course);
    }
    const std::lock_guard lock(m_mutex);
    course.infractions = m_infractions;
    course.points = m_points;
    for (std::size_t k = 0; k < m_points.size(); ++k)
        if (m_points[k].touchedAtS)
            course.marks.push_back({Mark::Kind::Touched, *m_points[k].touchedAtS, k});
    std::stable_sort(course.marks.begin(), course.marks.end(),
                     [](const Mark& a, const Mark& b) { return a.atS < b.atS; });
    return course;
}

std::optional<Sight> ReplayTrack::sightAt(double seconds) const
{
    std::optional<Sight> sight;
    for (const MarkedEvent& marked : m_player->marks()) {
        if (m_player->secondsAt(marked.tick) > seconds)
            break;
        if (marked.event.kind == ServoEvent::Kind::Note)
            if (const auto seen = sightOf(marked.event.value))
                sight = seen;
    }
    return sight;
}

glm::dvec3 ReplayTrack::burAtMm(double seconds) const
{
    return m_player->stateAt(m_player->tickAt(seconds)).anchorMm;
}

/// As core::recording::IdleIntervals leaves it out; one that nothing ends lasts to the end.
void ReplayTrack::takeRest(const MarkedEvent& marked, AttemptTimeline& course) const
{
    const auto& [tick, event] = marked;
    const bool isOpen = !course.rests.empty() && course.rests.back().toS >= m_lengthS;
    const bool begins = event.kind == ServoEvent::Kind::Note && event.value == core::servo::kRestNote;
    const bool ends = (event.kind == ServoEvent::Kind::Note && event.value == core::servo::kWorkNote) ||
                      event.kind == ServoEvent::Kind::Resume;
    if (begins && !isOpen)
        course.rests.push_back({m_player->secondsAt(tick), m_lengthS});
    else if (ends && isOpen)
        course.rests.back().toS = m_player->secondsAt(tick);
}

/// Of what a mark is about, where it has a name in the attempt's settings.
std::string ReplayTrack::nameOf(Mark::Kind kind, std::uint64_t value) const
{
    const auto& handpieces = m_player->recording().settings().handpieces;
    return kind == Mark::Kind::Handpiece && value < handpieces.size() ? handpieces[value].name : std::string();
}

std::uint64_t ReplayTrack::shownTick(double seconds, std::uint64_t ready) const
{
    return seconds >= m_lengthS ? ready : std::min(ready, m_player->tickAt(seconds));
}

void ReplayTrack::show(double seconds)
{
    const std::uint64_t ready = m_player->readyTicks();
    const std::uint64_t tick = shownTick(seconds, ready);
    sendPatches(tick, ready == m_player->ticks());
    publish(tick);
}

void ReplayTrack::sendPatches(std::uint64_t tick, bool isSettled)
{
    if (m_toSend.empty() && (tick != m_shownTick || !m_isSettled)) {
        TiledHeights wanted = m_shown;
        wanted.update(m_player->heightsAt(tick));
        const std::vector<TilePatch> group = patchesBetween(m_shown, wanted, tick, m_generation);
        m_toSend.assign(group.begin(), group.end());
        m_shown = std::move(wanted);
        m_shownTick = tick;
        m_isSettled = isSettled;
    }
    while (!m_toSend.empty() && m_links.patches.tryPush(m_toSend.front()))
        m_toSend.pop_front();
}

void ReplayTrack::publish(std::uint64_t tick)
{
    ServoState& state = m_links.servo.back();
    state = m_player->stateAt(tick);
    // Between two poses that are kept, so that slow motion is smooth as well.
    const ServoState next = m_player->stateAt(tick + Player::kTicksAPose);
    const double share = static_cast<double>(tick % Player::kTicksAPose) / static_cast<double>(Player::kTicksAPose);
    state.deviceMm = glm::mix(state.deviceMm, next.deviceMm, share);
    state.anchorMm = glm::mix(state.anchorMm, next.anchorMm, share);
    m_tipMm = state.anchorMm;
    if (m_hand)
        state.deviceMm = *m_hand;
    state.toothGeneration = m_generation;
    publishSound(state, tick);
    m_links.servo.publish();
    const core::history::Removed& removed = m_removed.of(m_shown);
    m_session.removedMm3 = removed.volumesMm3;
    m_session.overcutMm3 = removed.overcutMm3;
    m_session.pulpExposedMm2 = removed.pulpExposedMm2;
    m_session.perforated = removed.perforated;
    m_session.recordedS = tick == m_player->ticks() ? m_lengthS : m_player->secondsAt(tick);
    m_links.session.publish(m_session);
}

/// Nothing is heard while the replay is paused. Chatter is not heard either: too few moments of the force are stored.
void ReplayTrack::publishSound(const ServoState& state, std::uint64_t tick)
{
    constexpr int kPausedAfter = 5;
    constexpr double kTickS = 0.001;
    const std::uint64_t ticks = std::max(tick, m_heardTick) - std::min(tick, m_heardTick);
    m_heardTick = tick;
    m_sameTick = ticks == 0 ? m_sameTick + 1 : 0;
    if (m_sameTick >= kPausedAfter) {
        m_links.sound.publish({});
        return;
    }
    const auto& handpieces = m_player->recording().settings().handpieces;
    const std::size_t handpiece = std::min<std::size_t>(state.handpieceIndex, handpieces.size() - 1);
    core::audio::SoundState sound = m_sound.update(state, handpieces[handpiece], static_cast<double>(ticks) * kTickS);
    sound.chatter = 0.0F;
    m_links.sound.publish(sound);
}

}  // namespace app
