// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grading/RuleChecker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "core/bur/Bur.h"
#include "core/grading/Columns.h"
#include "core/grading/Perforation.h"
#include "core/teeth/Lattice.h"

namespace core::grading {
namespace {

using terrain::Grid;
using terrain::ToothAnatomy;

constexpr float kScratchMm = 0.1F;
/// Searching for holes floods the whole tooth, so the search runs at most once in so many ticks.
constexpr std::uint64_t kTicksBetweenHoles = 50;

/// Returns how far each column lies outside the ideal's cut; 0 inside.
std::vector<float> besideOf(const ToothAnatomy& anatomy, const std::vector<float>& ideal)
{
    std::vector<std::uint8_t> kept(anatomy.top.size());
    for (std::size_t k = 0; k < kept.size(); ++k)
        kept[k] = ideal[k] < anatomy.top[k] ? 0 : 1;
    return teeth::distanceInside(anatomy.grid, kept, teeth::Beyond::Marked);
}

/// Returns the distance along x from each column to the nearer end of its row, over the middle half of the rows. In the
/// other rows it is infinite.
std::vector<float> ridgeOf(const ToothAnatomy& anatomy)
{
    const Grid& grid = anatomy.grid;
    std::vector<float> ridge(grid.count(), std::numeric_limits<float>::infinity());
    int first = grid.side;
    int last = -1;
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i)
            if (wasSolid(anatomy, grid.index(i, j))) {
                first = std::min(first, j);
                last = std::max(last, j);
            }
    const int quarter = (last - first) / 4;
    for (int j = first + quarter; j <= last - quarter; ++j) {
        int low = grid.side;
        int high = -1;
        for (int i = 0; i < grid.side; ++i)
            if (wasSolid(anatomy, grid.index(i, j))) {
                low = std::min(low, i);
                high = std::max(high, i);
            }
        for (int i = low; i <= high; ++i)
            ridge[grid.index(i, j)] =
                static_cast<float>(grid.cellMm * (static_cast<double>(std::min(i - low, high - i)) + 0.5));
    }
    return ridge;
}

}  // namespace

RuleChecker::RuleChecker(const Rules& rules, std::shared_ptr<const ToothAnatomy> anatomy, const IdealTop& ideal)
    : m_rules(rules), m_anatomy(std::move(anatomy)), m_ideal(ideal)
{
    if (m_rules.besideLimitMm && ideal != nullptr)
        m_besideMm = besideOf(*m_anatomy, *ideal);
    if (m_rules.ridgeLimitMm)
        m_ridgeMm = ridgeOf(*m_anatomy);
    if (m_rules.pulpLimitMm2)
        m_isPulpOpen.assign(m_anatomy->top.size(), 0);
}

void RuleChecker::find(RuleViolation breach, double value, double limit)
{
    if (std::exchange(standing(breach), true))
        return;
    Infraction infraction = m_now;
    infraction.breach = breach;
    infraction.value = value;
    infraction.limit = limit;
    m_found.push_back(infraction);
}

std::vector<Infraction> RuleChecker::look(const servo::ServoState& state, const cutting::CutRect& changed,
                                          const terrain::Tooth& tooth, std::chrono::microseconds dt)
{
    m_found.clear();
    m_time += dt;
    m_now.tick = state.tick;
    m_now.seconds = std::chrono::duration<double>(m_time).count();
    m_now.placeMm = state.anchorMm;
    // Without a device there is no bur, so only the time is checked.
    if ((state.health & servo::kDeviceLost) != 0) {
        m_pressed = {};
        return {};
    }

    const double forceN = std::sqrt(glm::dot(state.forceN, state.forceN));
    m_pressed = m_rules.forceLimitN && state.touching && forceN > *m_rules.forceLimitN ? m_pressed + dt
                                                                                       : std::chrono::microseconds{0};
    if (m_pressed > kForcePatience)
        find(RuleViolation::TooMuchForce, forceN, *m_rules.forceLimitN);
    else if (m_pressed.count() == 0)
        standing(RuleViolation::TooMuchForce) = false;

    m_hasCut = m_hasCut || !changed.isEmpty();
    m_inAir = m_hasCut && state.drillOn && !state.touching ? m_inAir + dt : std::chrono::microseconds{0};
    const double airS = std::chrono::duration<double>(m_inAir).count();
    if (m_rules.airLimitS && airS > *m_rules.airLimitS)
        find(RuleViolation::BurInAir, airS, *m_rules.airLimitS);
    else if (m_inAir.count() == 0)
        standing(RuleViolation::BurInAir) = false;

    if (m_rules.allowedBurs[state.burIndex])
        standing(RuleViolation::WrongBur) = false;
    else if (state.cutting)
        find(RuleViolation::WrongBur, 0.0, 0.0);

    lookBeside(state);
    if (!changed.isEmpty())
        lookAtColumns(changed, tooth);
    if (m_mayBeHole && state.tick >= m_holesAskedAt + kTicksBetweenHoles) {
        m_holesAskedAt = state.tick;
        m_mayBeHole = false;
        if (hasHole(tooth))
            find(RuleViolation::Perforated, 0.0, 0.0);
    }
    return std::exchange(m_found, {});
}

void RuleChecker::lookBeside(const servo::ServoState& state)
{
    if (!m_rules.neighbours || state.burIndex >= bur::burs().size())
        return;
    const terrain::HeightMaps& beside = *m_rules.neighbours;
    const bur::Bur& bur = bur::burs()[state.burIndex];
    const double radius = bur.headRadiusMm - kGrazeMm;
    const glm::dvec2 at = beside.grid.latticeOf({state.anchorMm.x, state.anchorMm.y});
    const double reach = radius / beside.grid.cellMm;
    const auto last = static_cast<double>(beside.grid.side - 1);
    bool isIn = false;
    if (at.x > reach && at.y > reach && at.x < last - reach && at.y < last - reach) {
        const auto from = [](double v) { return static_cast<int>(std::ceil(v)); };
        const auto to = [](double v) { return static_cast<int>(std::floor(v)); };
        for (int j = from(at.y - reach); j <= to(at.y + reach) && !isIn; ++j) {
            for (int i = from(at.x - reach); i <= to(at.x + reach) && !isIn; ++i) {
                const std::size_t k = beside.grid.index(i, j);
                const glm::dvec2 away = beside.grid.cellMm * (glm::dvec2(i, j) - at);
                const double distance = std::sqrt(glm::dot(away, away));
                isIn = distance <= radius && beside.top[k] > beside.bottom[k] &&
                       state.anchorMm.z + bur.undersideMm(distance) < static_cast<double>(beside.top[k]) &&
                       state.anchorMm.z + bur.headLengthMm > static_cast<double>(beside.bottom[k]);
            }
        }
    }
    // Reports a violation once, until the bur has left the region, even if it stops there several times.
    if (!isIn)
        standing(RuleViolation::NeighbourHit) = false;
    else if (state.drillOn)
        find(RuleViolation::NeighbourHit, 0.0, 0.0);
}

bool RuleChecker::hasHole(const terrain::Tooth& tooth) const
{
    const std::vector<std::uint8_t> holes = perforationsBeside(tooth, m_ideal);
    return std::find(holes.begin(), holes.end(), 1) != holes.end();
}

void RuleChecker::lookAtColumns(const cutting::CutRect& rect, const terrain::Tooth& tooth)
{
    const Grid& grid = tooth.grid();
    for (int j = rect.j0; j <= rect.j1; ++j) {
        for (int i = rect.i0; i <= rect.i1; ++i) {
            const std::size_t k = grid.index(i, j);
            if (!wasSolid(*m_anatomy, k))
                continue;
            const float end = endOf(tooth, k);
            if (m_rules.perforated && !tooth.isSolid(k) && !standing(RuleViolation::Perforated))
                m_mayBeHole = true;
            if (m_rules.pulpLimitMm2)
                lookAtPulp(k, end);
            const float depth = m_anatomy->top[k] - end;
            if (!(depth > kScratchMm))
                continue;
            if (m_rules.depthLimitMm && static_cast<double>(depth) > *m_rules.depthLimitMm)
                find(RuleViolation::TooDeep, static_cast<double>(depth), *m_rules.depthLimitMm);
            if (!m_ridgeMm.empty() && static_cast<double>(m_ridgeMm[k]) < *m_rules.ridgeLimitMm)
                find(RuleViolation::RidgeCut, static_cast<double>(m_ridgeMm[k]), *m_rules.ridgeLimitMm);
            if (!m_besideMm.empty() && static_cast<double>(m_besideMm[k]) > *m_rules.besideLimitMm)
                find(RuleViolation::WrongPlace, static_cast<double>(m_besideMm[k]), *m_rules.besideLimitMm);
        }
    }
}

void RuleChecker::lookAtPulp(std::size_t k, float end)
{
    const double exposed = pulpExposedMm2(*m_anatomy, k, end);
    if (exposed <= 0.0 || std::exchange(m_isPulpOpen[k], std::uint8_t{1}) != 0)
        return;
    m_pulpOpenMm2 += exposed;
    if (m_pulpOpenMm2 > *m_rules.pulpLimitMm2)
        find(RuleViolation::PulpExposed, 0.0, 0.0);
}

void RuleChecker::restored(const terrain::Tooth& tooth)
{
    for (const RuleViolation mended : {RuleViolation::PulpExposed, RuleViolation::Perforated, RuleViolation::TooDeep,
                                       RuleViolation::RidgeCut, RuleViolation::WrongPlace})
        standing(mended) = false;
    m_isPulpOpen.assign(m_isPulpOpen.size(), 0);
    m_pulpOpenMm2 = 0.0;
    // Damage of the tooth before this state is not reported again.
    m_found.clear();
    lookAtColumns({0, 0, tooth.grid().side - 1, tooth.grid().side - 1}, tooth);
    if (m_mayBeHole && hasHole(tooth))
        standing(RuleViolation::Perforated) = true;
    m_mayBeHole = false;
    m_found.clear();
}

}  // namespace core::grading
