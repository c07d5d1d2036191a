// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drilling/Drill.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace core::drilling {
namespace {

/// Tries at finding the advance. It is found when removal uses from 95 to 100 % of the time granted; what is left goes
/// to the next tick.
constexpr int kMaxTries = 8;
constexpr double kTightMm = 0.0005;  ///< a bracket this narrow holds a wall, not the advance
constexpr double kCloseEnough = 0.95;
constexpr double kAim = 0.975;
/// Of the way a column has to go: less is a material that does not yield to this force.
constexpr double kLeastShare = 1.0e-6;

/// Calls visit(index, i, j, limit) for every column that a bur with its tip at `tip` would lower to `limit`.
template <class Visit>
void forEachColumn(const contact::LiveTooth& live, const glm::dvec3& tip, Visit&& visit) noexcept
{
    const terrain::Grid& grid = live.grid();
    const BurMask& mask = live.mask();
    const terrain::Tooth& tooth = live.tooth();
    const glm::dvec2 at = grid.latticeOf({tip.x, tip.y});
    const double reach = static_cast<double>(mask.radiusMm) / grid.cellMm;
    const auto cell = static_cast<float>(grid.cellMm);
    const auto tipZ = static_cast<float>(tip.z);
    const float last2 = mask.radiusMm * mask.radiusMm;
    const int firstRow = std::max(0, static_cast<int>(std::ceil(at.y - reach)));
    const int lastRow = std::min(grid.side - 1, static_cast<int>(std::floor(at.y + reach)));
    for (int j = firstRow; j <= lastRow; ++j) {
        const double dv = j - at.y;
        const double half = std::sqrt(std::max(0.0, reach * reach - dv * dv));
        const int first = std::max(0, static_cast<int>(std::ceil(at.x - half)));
        const int last = std::min(grid.side - 1, static_cast<int>(std::floor(at.x + half)));
        const float dy = static_cast<float>(dv) * cell;
        const float dy2 = dy * dy;
        const float start = static_cast<float>(first - at.x) * cell;
        for (int i = first; i <= last; ++i) {
            const std::size_t k = grid.index(i, j);
            if (!(tooth.top[k] > tipZ))
                continue;
            const float dx = start + static_cast<float>(i - first) * cell;
            const auto step = static_cast<std::size_t>(std::min(dx * dx + dy2, last2) * mask.r2ToStep);
            const float limit = tipZ + mask.underOfR2[step];
            if (!(tooth.top[k] > limit))
                continue;
            if (!(tipZ + mask.upperOfR2[step] > tooth.bottom[k]))
                continue;
            if (!visit(k, i, j, limit))
                return;
        }
    }
}

/// Volume of each material in column k from `height` up to its top, added to `volumes`.
void addVolumes(const terrain::Tooth& tooth, std::size_t k, float height, terrain::PerMaterial& volumes) noexcept
{
    const terrain::ToothAnatomy& anatomy = *tooth.anatomy;
    const terrain::PerMaterial length =
        terrain::lengthsBetween(anatomy.layers[k], std::max(height, tooth.bottom[k]), tooth.top[k]);
    for (std::size_t m = 0; m < length.size(); ++m)
        volumes[m] += length[m] * static_cast<double>(anatomy.areaMm2[k]);
}

/// Time that it takes to remove what is under a bur with its tip at `tip`; any time above `limit` may be given as
/// another above it.
double secondsToRemove(const contact::LiveTooth& tooth, const glm::dvec3& tip,
                       const terrain::PerMaterial& secondsPerMm3, double limit) noexcept
{
    double seconds = 0.0;
    forEachColumn(tooth, tip, [&](std::size_t k, int, int, float height) {
        terrain::PerMaterial volume{};
        addVolumes(tooth.tooth(), k, height, volume);
        for (std::size_t m = 0; m < volume.size(); ++m)
            if (volume[m] > 0.0)
                seconds += volume[m] * secondsPerMm3[m];
        return seconds <= limit;
    });
    return std::min(seconds, 2.0 * limit);
}

/// Lowers every column that a bur with its tip at `tip` would lower, by a share of the way, and adds to `done`.
void removeUnder(contact::LiveTooth& tooth, const glm::dvec3& tip, float share, Cut& done) noexcept
{
    forEachColumn(tooth, tip, [&](std::size_t k, int i, int j, float height) {
        const float top = tooth.tooth().top[k];
        const float low = std::max(height, tooth.tooth().bottom[k]);
        const float to = share < 1.0F ? top - share * (top - low) : height;
        addVolumes(tooth.tooth(), k, to, done.removedMm3);
        tooth.lower(k, to);
        CutRect& rect = done.changed;
        if (rect.isEmpty())
            rect = {i, j, i, j};
        rect = {std::min(rect.i0, i), std::min(rect.j0, j), std::max(rect.i1, i), std::max(rect.j1, j)};
        return true;
    });
}

}  // namespace

Drill::Drill(const settings::HardnessPreset& preset) noexcept : m_preset(preset) {}

Cut Drill::cut(contact::LiveTooth& tooth, const glm::dvec3& anchor, const glm::dvec3& device, double forceN,
               double seconds) noexcept
{
    Cut done;
    done.tipMm = anchor;
    const glm::dvec3 pull = device - anchor;
    const double gap = std::sqrt(glm::dot(pull, pull));
    if (!(gap > 0.0))
        return done;
    const glm::dvec3 towards = pull / gap;

    const double sideways = std::sqrt(towards.x * towards.x + towards.y * towards.y);
    const double direction = m_preset.axialShare + (1.0 - m_preset.axialShare) * sideways;
    const double force = std::min(forceN, m_preset.fullForceN);
    terrain::PerMaterial secondsPerMm3{};
    for (std::size_t m = 0; m < secondsPerMm3.size(); ++m) {
        const settings::MaterialHardness& hardness = m_preset.material[m];
        const double rate = hardness.rateMm3PerNs * std::max(0.0, force - hardness.thresholdN) * direction;
        secondsPerMm3[m] = rate > 0.0 ? 1.0 / rate : std::numeric_limits<double>::infinity();
    }

    // The time that removal takes rises with the advance: bracket it, beginning from the last tick's advance, then
    // close in by false position, kept honest by halving when one end does not move (Illinois).
    const double granted = seconds + m_leftS;
    const double aim = kAim * granted;
    double near = 0.0;
    double nearLack = aim;
    double far = -1.0;  // not found yet
    double farExcess = 0.0;
    double spent = 0.0;
    double tried = m_lastAdvance > 0.0 ? std::min(gap, m_lastAdvance) : gap;
    int side = 0;
    for (int attempt = 0; attempt < kMaxTries; ++attempt) {
        const double needed = secondsToRemove(tooth, anchor + towards * tried, secondsPerMm3, 4.0 * granted);
        if (needed <= granted) {
            near = tried;
            spent = needed;
            nearLack = aim - spent;
            if (near >= gap || spent >= kCloseEnough * granted)
                break;
            if (side == 1)
                farExcess *= 0.5;
            side = 1;
        } else {
            far = tried;
            farExcess = needed - aim;
            if (side == -1)
                nearLack *= 0.5;
            side = -1;
        }
        if (far > 0.0 && far - near < kTightMm)
            break;
        if (far > 0.0)
            tried = near + (far - near) * std::clamp(nearLack / (nearLack + farExcess), 0.02, 0.98);
        else
            tried = std::min(gap, 4.0 * tried);
    }
    m_lastAdvance = near;
    done.tipMm = anchor + towards * near;
    if (spent > 0.0)
        removeUnder(tooth, done.tipMm, 1.0F, done);

    // A column of a high wall comes under the rim of the bur all at once and costs more than a tick has: no advance
    // uses the time. Then the columns just beyond are lowered by that share of their way which the time pays for.
    if (far > 0.0 && spent < kCloseEnough * granted) {
        const glm::dvec3 beyond = anchor + towards * far;
        const double share = (granted - spent) / secondsToRemove(tooth, beyond, secondsPerMm3, 1.0e12);
        if (share > kLeastShare) {
            removeUnder(tooth, beyond, static_cast<float>(std::min(1.0, share)), done);
            spent = granted;
        }
    }
    m_leftS = std::min(seconds, granted - spent);
    if (!done.changed.isEmpty())
        tooth.markCut(done.changed.i0, done.changed.j0, done.changed.i1, done.changed.j1);
    return done;
}

}  // namespace core::drilling
