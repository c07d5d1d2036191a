// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drilling/Drill.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <glm/geometric.hpp>

#include "core/contact/Head.h"

namespace core::drilling {
namespace {

/// Tries at finding the advance. It is found when removal uses from 95 to 100 % of the time granted; what is left goes
/// to the next tick.
constexpr int kMaxTries = 6;
constexpr double kFirstGuessMm = 0.001;  ///< advance tried first in fresh material
constexpr double kTightMm = 0.002;       ///< a bracket this narrow holds a wall, not the advance
constexpr double kCloseEnough = 0.95;
constexpr double kAim = 0.975;
/// Of the way a column has to go: less is a material that does not yield to this force.
constexpr double kLeastShare = 1.0e-6;
constexpr double kRoundingMm = 1.0e-5;  ///< heights are floats
/// What is looked at between two questions whether it is enough.
constexpr std::size_t kColumnsAtOnce = 64;
/// Impulse of a touch, N s, until which it is a brush: 0.3 N for 20 ms must leave no mark (dentists, 2011), which the
/// threshold of force alone would let a ball's tip make 30 um deep.
constexpr double kBrushNS = 0.008;

/// The columns that a bur moving from `from` towards `towards` for up to `reachMm` may lower: no column is missed, some
/// are listed in vain. They go into the tooth's columnsRoom(); false if there is not enough of it.
bool listColumns(contact::LiveTooth& live, const glm::dvec3& from, const glm::dvec3& towards, double reachMm,
                 std::size_t& count) noexcept
{
    const terrain::Grid& grid = live.grid();
    const BurMask& mask = live.mask();
    const terrain::Tooth& tooth = live.tooth();
    const glm::dvec2 at = grid.latticeOf({from.x, from.y});
    const double sideways = reachMm * std::sqrt(towards.x * towards.x + towards.y * towards.y);
    const double radius = static_cast<double>(mask.radiusMm) + sideways;
    // (r - sideways)^2 is no less than r^2 - 2 radius sideways anywhere in the circle: no square root a column.
    const auto nearer = static_cast<float>(2.0 * radius * sideways + kRoundingMm);
    const auto lowestZ = static_cast<float>(from.z + std::min(0.0, reachMm * towards.z) - kRoundingMm);
    const contact::Head head = contact::headAt(mask, grid.cellMm, at.x, at.y);
    const double cells = radius / grid.cellMm + kRoundingMm;
    const int firstRow = std::max(0, static_cast<int>(std::ceil(at.y - cells)));
    const int lastRow = std::min(grid.side - 1, static_cast<int>(std::floor(at.y + cells)));
    contact::ColumnsRoom& room = live.columnsRoom();
    count = 0;
    for (int j = firstRow; j <= lastRow; ++j) {
        const double dv = j - at.y;
        const double half = std::sqrt(std::max(0.0, cells * cells - dv * dv));
        const int first = std::max(0, static_cast<int>(std::ceil(at.x - half)));
        const int last = std::min(grid.side - 1, static_cast<int>(std::floor(at.x + half)));
        std::size_t end = count;
        for (int i = first; i <= last; ++i) {
            const std::size_t k = grid.index(i, j);
            if (!(tooth.top[k] > lowestZ))
                continue;
            room.i[end] = static_cast<float>(i);
            room.j[end] = static_cast<float>(j);
            room.index[end++] = static_cast<std::uint32_t>(k);
        }
        live.kernels().undersides(room.i.data() + count, room.j.data() + count, contact::wholeBlocks(end - count), head,
                                  nearer, room.under.data() + count);
        for (std::size_t n = count; n < end; ++n) {
            if (!(tooth.top[room.index[n]] > lowestZ + room.under[n]))
                continue;
            if (count == room.most)
                return false;
            room.i[count] = room.i[n];
            room.j[count] = room.j[n];
            room.index[count++] = room.index[n];
        }
    }
    return true;
}

/// One advance of the bur: the tooth, where the tip began, and how many columns it may meet: the list is in the
/// tooth's columnsRoom().
struct Advance
{
    contact::LiveTooth& tooth;
    double beginZ;
    std::size_t count;
};

/// Calls visit(index, limit) for every listed column that a bur with its tip at `tip` would lower to `limit`.
template <class Visit>
void forEachColumn(const Advance& advance, const glm::dvec3& tip, Visit&& visit) noexcept
{
    const terrain::Grid& grid = advance.tooth.grid();
    const terrain::Tooth& tooth = advance.tooth.tooth();
    const BurMask& mask = advance.tooth.mask();
    contact::ColumnsRoom& room = advance.tooth.columnsRoom();
    const glm::dvec2 at = grid.latticeOf({tip.x, tip.y});
    const contact::Head head = contact::headAt(mask, grid.cellMm, at.x, at.y);
    const auto tipZ = static_cast<float>(tip.z);
    // The head has been everywhere on its way down: thin material is not spared because its far side was reached.
    const auto highestZ = static_cast<float>(std::max(tip.z, advance.beginZ));
    for (std::size_t from = 0; from < advance.count; from += kColumnsAtOnce) {
        const std::size_t to = std::min(advance.count, from + kColumnsAtOnce);
        advance.tooth.kernels().undersides(room.i.data() + from, room.j.data() + from, contact::wholeBlocks(to - from),
                                           head, 0.0F, room.under.data() + from);
        for (std::size_t n = from; n < to; ++n) {
            const std::size_t k = room.index[n];
            const float limit = tipZ + room.under[n];
            if (!(tooth.top[k] > limit))
                continue;
            if (!(highestZ + mask.lowestUpperMm > tooth.bottom[k])) {
                const float r2 =
                    contact::r2Of(static_cast<int>(room.i[n]), contact::dy2Of(static_cast<int>(room.j[n]), head), head);
                if (!(highestZ + contact::upperAt(r2, head) > tooth.bottom[k]))
                    continue;
            }
            if (!visit(k, limit))
                return;
        }
    }
}

/// Calls take(material, mm3) for each material in column k from `height` up to its top.
template <class Take>
void forEachVolume(const terrain::Tooth& tooth, std::size_t k, float height, Take&& take) noexcept
{
    const terrain::ToothAnatomy& anatomy = *tooth.anatomy;
    const terrain::ColumnLayers& layers = anatomy.layers[k];
    const float top = tooth.top[k];
    const float low = std::max(height, tooth.bottom[k]);
    const auto area = static_cast<double>(anatomy.areaMm2[k]);
    if (terrain::Material only{}; terrain::isOneMaterial(layers, low, top, only)) {
        take(static_cast<std::size_t>(only), (static_cast<double>(top) - static_cast<double>(low)) * area);
        return;
    }
    const terrain::PerMaterial length = terrain::lengthsBetween(layers, low, top);
    for (std::size_t m = 0; m < length.size(); ++m)
        if (length[m] > 0.0)
            take(m, length[m] * area);
}

/// Time that it takes to remove what is under a bur with its tip at `tip`; any time above `limit` may be given as
/// another above it.
double secondsToRemove(const Advance& advance, const glm::dvec3& tip, const terrain::PerMaterial& secondsPerMm3,
                       double limit) noexcept
{
    double seconds = 0.0;
    forEachColumn(advance, tip, [&](std::size_t k, float height) {
        forEachVolume(advance.tooth.tooth(), k, height,
                      [&](std::size_t m, double volume) { seconds += volume * secondsPerMm3[m]; });
        return seconds <= limit;
    });
    return std::min(seconds, 2.0 * limit);
}

/// Lowers every column that a bur with its tip at `tip` would lower, by a share of the way, and adds to `done`.
void removeUnder(const Advance& advance, const glm::dvec3& tip, float share, Cut& done) noexcept
{
    contact::LiveTooth& tooth = advance.tooth;
    const auto side = static_cast<std::size_t>(tooth.grid().side);
    forEachColumn(advance, tip, [&](std::size_t k, float height) {
        const auto i = static_cast<int>(k % side);
        const auto j = static_cast<int>(k / side);
        const float top = tooth.tooth().top[k];
        const float low = std::max(height, tooth.tooth().bottom[k]);
        const float to = share < 1.0F ? top - share * (top - low) : height;
        forEachVolume(tooth.tooth(), k, to, [&](std::size_t m, double volume) { done.removedMm3[m] += volume; });
        tooth.lower(i, j, to);
        CutRect& rect = done.changed;
        if (rect.isEmpty())
            rect = {i, j, i, j};
        rect = {std::min(rect.i0, i), std::min(rect.j0, j), std::max(rect.i1, i), std::max(rect.j1, j)};
        return true;
    });
}

}  // namespace

Drill::Drill(const settings::HardnessPreset& preset, const settings::Handpiece& handpiece) noexcept
    : m_preset(preset), m_handpiece(handpiece)
{}

Cut Drill::cut(contact::LiveTooth& tooth, const glm::dvec3& anchor, const glm::dvec3& device, double forceN,
               double seconds) noexcept
{
    Cut done;
    done.tipMm = anchor;
    const glm::dvec3 pull = device - anchor;
    const double gap = std::sqrt(glm::dot(pull, pull));
    m_pressedNS = std::min(kBrushNS, m_pressedNS + forceN * seconds);
    if (!(gap > 0.0) || m_pressedNS < kBrushNS)
        return done;
    const glm::dvec3 towards = pull / gap;

    const double sideways = std::sqrt(towards.x * towards.x + towards.y * towards.y);
    const double direction = m_preset.axialShare + (1.0 - m_preset.axialShare) * sideways;
    const auto radiusMm = static_cast<double>(tooth.mask().radiusMm);
    const double speed = rpmUnder(forceN, radiusMm) * radiusMm / kReferenceRpmMm;
    terrain::PerMaterial secondsPerMm3{};
    for (std::size_t m = 0; m < secondsPerMm3.size(); ++m) {
        const settings::MaterialHardness& hardness = m_preset.material[m];
        const double rate = hardness.rateMm3PerNs * std::max(0.0, forceN - hardness.thresholdN) * direction * speed;
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
    double tried = std::min(gap, std::max(m_lastAdvance, kFirstGuessMm));
    int side = 0;
    double listed = -1.0;  // the list holds what an advance up to here meets
    Advance advance{tooth, anchor.z, 0};
    for (int attempt = 0; attempt < kMaxTries; ++attempt) {
        if (tried > listed) {
            listed = std::min(gap, 2.0 * tried);
            while (!listColumns(tooth, anchor, towards, listed, advance.count))
                listed *= 0.5;  // a long way sideways: go half of it
            tried = std::min(tried, listed);
        }
        const double needed = secondsToRemove(advance, anchor + towards * tried, secondsPerMm3, 4.0 * granted);
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
        removeUnder(advance, done.tipMm, 1.0F, done);

    // A column of a high wall comes under the rim of the bur all at once and costs more than a tick has: no advance
    // uses the time. Then the columns just beyond are lowered by that share of their way which the time pays for.
    if (far > 0.0 && spent < kCloseEnough * granted) {
        const glm::dvec3 beyond = anchor + towards * far;
        const double share = (granted - spent) / secondsToRemove(advance, beyond, secondsPerMm3, 1.0e12);
        if (share > kLeastShare) {
            removeUnder(advance, beyond, static_cast<float>(std::min(1.0, share)), done);
            spent = granted;
        }
    }
    m_leftS = std::min(seconds, granted - spent);
    return done;
}

}  // namespace core::drilling
