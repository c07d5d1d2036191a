// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grading/Exercise.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace core::grading {
namespace {

using namespace std::chrono_literals;

/// Upper half of a note that stores an answer: "PADS". The lower bytes store the pad and the material.
constexpr std::uint64_t kAnswer = 0x50414453ULL << 32U;

double seconds(std::chrono::microseconds time)
{
    return static_cast<double>(time.count()) / 1.0e6;
}

Practised nothingDone(const Exercise& exercise)
{
    if (const auto* touch = std::get_if<PointsToTouch>(&exercise))
        return Touched{std::vector<std::optional<double>>(touch->pointsMm.size())};
    if (std::holds_alternative<ForceToHold>(exercise))
        return Held{};
    return Named{};
}

}  // namespace

std::size_t Touched::count() const
{
    return static_cast<std::size_t>(
        std::count_if(atS.begin(), atS.end(), [](const auto& at) { return at.has_value(); }));
}

bool isDone(const Practised& practised)
{
    if (const auto* touched = std::get_if<Touched>(&practised))
        return touched->count() == touched->atS.size();
    if (const auto* held = std::get_if<Held>(&practised))
        return held->isDone;
    const auto& said = std::get<Named>(practised).saidToBe;
    return std::all_of(said.begin(), said.end(), [](const auto& answer) { return answer.has_value(); });
}

bool isBegun(const Practised& practised)
{
    if (const auto* touched = std::get_if<Touched>(&practised))
        return touched->count() > 0;
    if (const auto* held = std::get_if<Held>(&practised))
        return held->pressedS > 0.0;
    return std::get<Named>(practised) != Named{};
}

std::uint64_t answerNote(std::size_t pad, terrain::Material said)
{
    return kAnswer | (static_cast<std::uint64_t>(pad) << 8U) | static_cast<std::uint64_t>(said);
}

std::optional<Answer> answerOf(std::uint64_t note)
{
    const std::uint64_t pad = (note & 0xFFFFFFFFULL) >> 8U;
    const std::uint64_t said = note & 0xFFU;
    if ((note & ~0xFFFFFFFFULL) != kAnswer || pad >= kPads || said >= terrain::kMaterialCount)
        return std::nullopt;
    return Answer{static_cast<std::size_t>(pad), static_cast<terrain::Material>(said)};
}

ExerciseMeter::ExerciseMeter(Exercise exercise) : m_exercise(std::move(exercise)), m_practised(nothingDone(m_exercise))
{}

void ExerciseMeter::take(const servo::ServoState& state, std::chrono::microseconds dt)
{
    m_time += std::max(dt, 0us);
    const double newtons = std::sqrt(glm::dot(state.forceN, state.forceN));
    const bool touches = state.touching && !state.drillOn && (state.health & servo::kDeviceLost) == 0 &&
                         std::isfinite(newtons + state.anchorMm.x + state.anchorMm.y);
    if (const auto* touch = std::get_if<PointsToTouch>(&m_exercise); touch != nullptr && touches)
        take(*touch, state.anchorMm, newtons);
    else if (const auto* hold = std::get_if<ForceToHold>(&m_exercise))
        take(*hold, touches, newtons, std::max(dt, 0us));
}

void ExerciseMeter::take(const PointsToTouch& asked, const glm::dvec3& tipMm, double newtons)
{
    if (newtons < kTouchN)
        return;
    auto& touched = std::get<Touched>(m_practised);
    for (std::size_t k = 0; k < asked.pointsMm.size(); ++k) {
        const glm::dvec2 way = glm::dvec2(tipMm) - asked.pointsMm[k];
        if (!touched.atS[k] && glm::dot(way, way) <= asked.reachMm * asked.reachMm)
            touched.atS[k] = seconds(m_time);
    }
}

void ExerciseMeter::take(const ForceToHold& asked, bool presses, double newtons, std::chrono::microseconds dt)
{
    auto& held = std::get<Held>(m_practised);
    if (held.isDone)
        return;
    const double errorN = std::abs(newtons - asked.forceN);
    if (presses && errorN <= asked.withinN) {
        m_stretch += dt;
        m_held += dt;
        m_off = 0us;
    } else {
        m_off += dt;
        if (m_off > kHoldPatience)
            m_stretch = 0us;
    }
    if (presses && m_held > 0us) {
        m_pressed += dt;
        m_errorNS += errorN * seconds(dt);
    }
    m_longest = std::max(m_longest, m_stretch);
    held.longestS = seconds(m_longest);
    held.nowS = seconds(m_stretch);
    held.heldS = seconds(m_held);
    held.pressedS = seconds(m_pressed);
    held.meanErrorN = m_pressed > 0us ? m_errorNS / seconds(m_pressed) : 0.0;
    held.isDone = held.longestS >= asked.seconds;
}

void ExerciseMeter::noted(std::uint64_t note)
{
    const auto* pads = std::get_if<PadsToName>(&m_exercise);
    const auto answer = answerOf(note);
    if (pads == nullptr || !answer)
        return;
    auto& named = std::get<Named>(m_practised);
    named.saidToBe[answer->pad] = answer->said;
    named.right = 0;
    for (std::size_t pad = 0; pad < kPads; ++pad)
        if (named.saidToBe[pad] == pads->madeOf[pad])
            ++named.right;
}

}  // namespace core::grading
