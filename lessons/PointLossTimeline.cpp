// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/PointLossTimeline.h"

#include <algorithm>
#include <cassert>
#include <map>

#include "core/recording/Replay.h"
#include "core/servo/StrokeDetector.h"

namespace lessons {
namespace {

using core::servo::ServoEvent;

constexpr std::uint64_t kTicksAMark = 1000;  ///< between two gradings in a stroke that continues
constexpr std::uint64_t kTicksALook = 10;    ///< between two checks of time, force and the like
constexpr double kFeedOverS = 0.1;           ///< the feed is averaged over this time

/// The tenths of a point lost so far, each with the time of its loss. Regained points cancel the latest losses first.
class Losses
{
public:
    void become(int tenths, const Moment& now)
    {
        while (m_sum > tenths) {
            const int back = std::min(m_moments.back().lostTenths, m_sum - tenths);
            m_moments.back().lostTenths -= back;
            m_sum -= back;
            if (m_moments.back().lostTenths == 0)
                m_moments.pop_back();
        }
        if (m_sum == tenths)
            return;
        m_moments.push_back(now);
        m_moments.back().lostTenths = tenths - m_sum;
        m_sum = tenths;
    }

    [[nodiscard]] const std::vector<Moment>& moments() const { return m_moments; }

private:
    std::vector<Moment> m_moments;
    int m_sum = 0;
};

/// Returns what a criterion has lost so far, to compare two moments: 1 or 0 for a critical one. Whether its points can
/// still be earned is decided at the end.
int lostBy(const Criterion& line, Verdict verdict)
{
    if (line.critical)
        return line.share > 0.0 ? 1 : 0;
    return lostByError(line, verdict);
}

bool isOfTheWay(const std::string& measure)
{
    const auto known = core::grading::findMeasure(measure);
    return known && core::grading::isOfProcess(*known);
}

/// Grades an attempt repeatedly while it is replayed.
class Ledger
{
public:
    Ledger(const Assignment& assignment, const core::recording::Recording& recording, core::recording::Replayer& servo)
        : m_assignment(assignment), m_servo(servo), m_examiner(examinationOf(assignment), recording.anatomy()),
          m_wayRubric(assignment.rubric), m_losses(assignment.rubric.criteria.size())
    {
        recording.forEach([this](const ServoEvent& event) {
            if (event.kind == ServoEvent::Kind::Restore)
                m_kept.try_emplace(event.value);
        });
        m_wayRubric.criteria.clear();
        for (std::size_t k = 0; k < assignment.rubric.criteria.size(); ++k) {
            const CriterionRule& rule = assignment.rubric.criteria[k];
            if (!isOfTheWay(rule.measure) && !(rule.allowance && isOfTheWay(rule.allowance->measure)))
                continue;
            m_wayRubric.criteria.push_back(rule);
            m_wayRubric.criteria.back().title.clear();
            m_wayPlaces.push_back(k);
        }
    }

    [[nodiscard]] core::Status begin()
    {
        if (auto marked = markNow({}); !marked)
            return marked;
        keep();
        return {};
    }

    [[nodiscard]] core::Status play(const ServoEvent& event)
    {
        const bool isOther = event.kind == ServoEvent::Kind::Restore || event.kind == ServoEvent::Kind::Resume;
        if (isOther)
            if (auto marked = endPart(); !marked)
                return marked;
        m_servo.play(event);
        m_examiner.take(event, m_servo);
        if (event.kind == ServoEvent::Kind::Restore)
            goBackTo(event.value);
        if (isOther)
            m_watch.restart();
        return core::recording::isStep(event) ? step(event) : core::Status{};
    }

    [[nodiscard]] core::Result<PointLossTimeline> end()
    {
        if (auto marked = endPart(); !marked)
            return tl::unexpected(marked.error());
        // Records changes since the last check with the present time.
        if (auto marked = markNow({Moment::Kind::Way, 0, m_servo.tick(), secondsNow(), 0}); !marked)
            return tl::unexpected(marked.error());
        PointLossTimeline result;
        result.sheet = m_sheet;
        for (std::size_t k = 0; k < m_losses.size(); ++k) {
            const Criterion& line = result.sheet.criteria[k];
            std::vector<Moment> moments = m_losses[k].moments();
            if (line.critical && !moments.empty())
                moments.front().lostTenths = line.lostTenths;
            else if (line.lostTenths == 0)
                moments.clear();  // only the losses of the worst criterion count
            else if (line.isTooEarly)
                moments = {Moment{Moment::Kind::Never, line.lostTenths, 0, 0.0, 0}};
            [[maybe_unused]] int sum = 0;
            for (Moment& moment : moments) {
                sum += moment.lostTenths;
                if (moment.kind == Moment::Kind::Never)
                    moment = {Moment::Kind::Never, moment.lostTenths, m_servo.tick(), secondsNow(), 0};
            }
            assert(sum == line.lostTenths);
            result.ofCriteria.push_back(std::move(moments));
        }
        return result;
    }

private:
    /// The state that depends on the tooth, saved after a tick to which undo may return.
    struct Kept
    {
        std::vector<Losses> losses;
        core::grading::Measured measured;
    };

    [[nodiscard]] core::Status step(const ServoEvent& event)
    {
        const double began = secondsNow();
        m_time += std::chrono::microseconds(event.dtUs);
        const std::uint64_t tick = m_servo.tick();
        const bool cut = !m_servo.changed().isEmpty();
        const bool wasInStroke = m_watch.isInStroke();
        const bool ended = m_watch.endsWith(cut);
        if (cut) {
            m_strokes += wasInStroke ? 0 : 1;
            if (!m_part)
                m_part = Moment{Moment::Kind::Stroke, 0, tick, began, m_strokes};
        }
        lookAtTheFeed(cut);
        if (m_part && (ended || tick - m_part->tick + 1 >= kTicksAMark))
            if (auto marked = endPart(); !marked)
                return marked;
        if (!m_wayPlaces.empty() && tick % kTicksALook == 0)
            lookAtTheWay();
        if (m_kept.contains(tick)) {
            if (auto marked = endPart(); !marked)
                return marked;
            keep();
        }
        return {};
    }

    [[nodiscard]] double secondsNow() const { return std::chrono::duration<double>(m_time).count(); }
    [[nodiscard]] Conduct conduct() const
    {
        return {m_examiner.process(), m_examiner.infractions(), m_examiner.aids(), m_examiner.practised()};
    }

    [[nodiscard]] core::Status endPart()
    {
        if (!m_part)
            return {};
        const Moment part = *m_part;
        m_part.reset();
        return markNow(part);
    }

    [[nodiscard]] core::Status markNow(const Moment& now)
    {
        auto marked = mark(m_assignment, m_servo.tooth().tooth(), conduct());
        if (!marked)
            return tl::unexpected(marked.error());
        for (std::size_t k = 0; k < m_losses.size(); ++k)
            m_losses[k].become(lostBy(marked->sheet.criteria[k], m_assignment.rubric.verdict), now);
        m_sheet = std::move(marked->sheet);
        m_measured = marked->measured;
        return {};
    }

    /// Measures the feed over each tenth of a second that begins and ends with cutting.
    void lookAtTheFeed(bool cut)
    {
        if (!cut)
            return;
        const double z = m_servo.state().anchorMm.z;
        const double sinceS = secondsNow() - m_feedSinceS;
        if (sinceS < kFeedOverS)
            return;
        if (m_part && sinceS < 2.0 * kFeedOverS)
            m_part->feedMmPerS = std::max(m_part->feedMmPerS, (m_feedFromMm - z) / sinceS);
        m_feedFromMm = z;
        m_feedSinceS = secondsNow();
    }

    void lookAtTheWay()
    {
        if (m_wayPlaces.empty())
            return;
        const Conduct now = conduct();
        now.addTo(m_measured);
        Values values;
        const auto take = [&](const std::string& id) {
            if (const auto measure = core::grading::findMeasure(id))
                if (const auto value = measure->value(m_measured))
                    values[id] = *value;
        };
        for (const CriterionRule& rule : m_wayRubric.criteria) {
            take(rule.measure);
            if (rule.allowance)
                take(rule.allowance->measure);
        }
        const ScoreSheet sheet = grade(m_wayRubric, values);
        const Moment moment{Moment::Kind::Way, 0, m_servo.tick(), secondsNow(), m_watch.isInStroke() ? m_strokes : 0};
        for (std::size_t n = 0; n < m_wayPlaces.size(); ++n)
            m_losses[m_wayPlaces[n]].become(lostBy(sheet.criteria[n], m_wayRubric.verdict), moment);
    }

    void keep()
    {
        if (const auto kept = m_kept.find(m_servo.tick()); kept != m_kept.end())
            kept->second = Kept{m_losses, m_measured};
    }

    /// Restores the tooth and its losses to the state after that tick. Time and force are not undone.
    void goBackTo(std::uint64_t tick)
    {
        const Kept& then = m_kept.at(tick);
        for (std::size_t k = 0; k < m_losses.size(); ++k)
            if (!isOfTheWay(m_assignment.rubric.criteria[k].measure))
                m_losses[k] = then.losses[k];
        m_measured = then.measured;
        lookAtTheWay();
    }

    const Assignment& m_assignment;
    core::recording::Replayer& m_servo;
    core::session::LiveAssessor m_examiner;
    core::servo::StrokeDetector m_watch;
    Rubric m_wayRubric;                    ///< criteria that can change in a tick without a cut
    std::vector<std::size_t> m_wayPlaces;  ///< their indices in the whole rubric
    std::vector<Losses> m_losses;          ///< by criterion
    ScoreSheet m_sheet;                    ///< of the last grading of the tooth
    core::grading::Measured m_measured;
    std::map<std::uint64_t, Kept> m_kept;  ///< by tick
    std::optional<Moment> m_part;          ///< start of the cuts since the last grading
    std::chrono::microseconds m_time{0};
    int m_strokes = 0;
    double m_feedFromMm = 0.0;  ///< height of the bur at the beginning of the present tenth of a second
    double m_feedSinceS = 0.0;
};

}  // namespace

core::Result<std::optional<PointLossTimeline>> momentsOf(const Assignment& assignment,
                                                         const core::recording::Recording& recording,
                                                         const std::function<bool(double)>& goOn)
{
    auto servo = core::recording::Replayer::make(recording);
    if (!servo)
        return tl::unexpected(servo.error());
    Ledger ledger(assignment, recording, *servo);
    if (auto begun = ledger.begin(); !begun)
        return tl::unexpected(begun.error());
    const std::uint64_t all = recording.events();
    std::uint64_t next = 0;
    while (next < all) {
        const std::vector<ServoEvent> events = recording.eventsSince(next);
        for (std::size_t k = 0; k < events.size(); ++k) {
            if (k % 256 == 0 && goOn && !goOn(static_cast<double>(next + k) / static_cast<double>(all)))
                return std::optional<PointLossTimeline>();
            if (auto played = ledger.play(events[k]); !played)
                return tl::unexpected(played.error());
        }
        next += events.size();
    }
    auto moments = ledger.end();
    if (!moments)
        return tl::unexpected(moments.error());
    return std::optional(std::move(*moments));
}

}  // namespace lessons
