// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/LiveTooth.h"

#include <algorithm>
#include <cmath>

#include "core/contact/Head.h"

namespace core::contact {
namespace {

double bilinear(float a, float b, float c, float d, double fx, double fy)
{
    const double low = static_cast<double>(a) + (static_cast<double>(b) - static_cast<double>(a)) * fx;
    const double high = static_cast<double>(c) + (static_cast<double>(d) - static_cast<double>(c)) * fx;
    return low + (high - low) * fy;
}

}  // namespace

LiveTooth::LiveTooth(terrain::Tooth tooth)
    : m_tooth(std::move(tooth)),
      m_floorMm(static_cast<double>(*std::max_element(m_tooth.anatomy->top.begin(), m_tooth.anatomy->top.end())) -
                drilling::kChuckMm),
      m_kernels(kernels())
{
    for (const drilling::Bur& bur : drilling::burs())
        m_masks.emplace_back(bur, grid().cellMm);
    std::size_t widest = 0;
    for (const drilling::BurMask& mask : m_masks)
        widest = std::max(widest, static_cast<std::size_t>(mask.width));
    m_columnsRoom.resize((widest + 2) * (widest + 2));  // and those that a cell's advance adds
    m_blocks = (grid().side + kBlock - 1) / kBlock;
    m_cutBlock.resize(static_cast<std::size_t>(m_blocks) * static_cast<std::size_t>(m_blocks), 0);
    for (int j = 0; j < grid().side; ++j)
        for (int i = 0; i < grid().side; ++i)
            if (m_tooth.top[grid().index(i, j)] < m_tooth.anatomy->top[grid().index(i, j)])
                m_cutBlock[blockOf(i, j)] = 1;
    const std::size_t count = grid().count();
    for (Field* field : {&m_above, &m_below}) {
        field->value.resize(count);
        field->stamp.resize(count, 0);
    }
}

void LiveTooth::selectBur(std::size_t index) noexcept
{
    m_bur = index;
    ++m_epoch;
}

float LiveTooth::clearanceAtNode(int i, int j) noexcept
{
    const std::size_t k = grid().index(i, j);
    if (m_above.stamp[k] != m_epoch) {
        m_above.value[k] = m_kernels.highestAtNode({m_tooth.top.data(), grid().side}, mask(), i, j);
        m_above.stamp[k] = m_epoch;
    }
    return m_above.value[k];
}

float LiveTooth::undersideAtNode(int i, int j) noexcept
{
    const std::size_t k = grid().index(i, j);
    if (m_below.stamp[k] != m_epoch) {
        m_below.value[k] = m_kernels.lowestAtNode({m_tooth.bottom.data(), grid().side}, mask(), i, j);
        m_below.stamp[k] = m_epoch;
    }
    return m_below.value[k];
}

bool LiveTooth::corners(glm::dvec2 lattice, int& i, int& j, double& fx, double& fy) const noexcept
{
    const double last = grid().side - 1;
    if (!(lattice.x >= 0.0 && lattice.y >= 0.0 && lattice.x <= last && lattice.y <= last))
        return false;
    i = std::min(static_cast<int>(lattice.x), grid().side - 2);
    j = std::min(static_cast<int>(lattice.y), grid().side - 2);
    fx = lattice.x - i;
    fy = lattice.y - j;
    return true;
}

template <Side side>
float LiveTooth::mostInTheWay(glm::dvec2 lattice, float enough) noexcept
{
    const std::vector<float>& map = side == Side::Above ? m_tooth.top : m_tooth.bottom;
    std::array<Peak, 4>& peaks = side == Side::Above ? m_peaksAbove : m_peaksBeneath;
    const Head head = headAt(mask(), grid().cellMm, lattice.x, lattice.y);
    for (std::size_t k = 0; k < peaks.size() && peaks[k].i >= 0; ++k) {
        const Peak known = peaks[k];
        const float value = valueOver<side>(map[grid().index(known.i, known.j)], known.i, dy2Of(known.j, head), head);
        if (value > enough) {
            const auto at = peaks.begin() + static_cast<std::ptrdiff_t>(k);
            std::rotate(peaks.begin(), at, at + 1);
            return value;
        }
    }
    const auto search = side == Side::Above ? m_kernels.highestAtPoint : m_kernels.lowestAtPoint;
    const Peak peak = search({map.data(), grid().side}, mask(), grid().cellMm, lattice.x, lattice.y, enough);
    const auto isSame = [&](const Peak& known) { return known.i == peak.i && known.j == peak.j; };
    if (peak.i >= 0 && std::none_of(peaks.begin(), peaks.end(), isSame)) {
        std::copy_backward(peaks.begin(), peaks.end() - 1, peaks.end());
        peaks.front() = peak;
    }
    return peak.value;
}

double LiveTooth::clearanceAt(glm::dvec2 pointMm, double enough) noexcept
{
    int i = 0;
    int j = 0;
    double fx = 0.0;
    double fy = 0.0;
    // Beside the grid there are no nodes, but the bur may still reach the tooth.
    const glm::dvec2 lattice = grid().latticeOf(pointMm);
    if (!corners(lattice, i, j, fx, fy) || isCutNear(lattice))
        return static_cast<double>(mostInTheWay<Side::Above>(lattice, static_cast<float>(enough)));
    return bilinear(clearanceAtNode(i, j), clearanceAtNode(i + 1, j), clearanceAtNode(i, j + 1),
                    clearanceAtNode(i + 1, j + 1), fx, fy);
}

bool LiveTooth::isCutNear(glm::dvec2 lattice) const noexcept
{
    const double reach = static_cast<double>(mask().radiusMm) / grid().cellMm + 1.0;
    const auto block = [&](double at) {
        return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(grid().side - 1))) / kBlock;
    };
    // Mostly the bur stands in its own cut.
    if (m_cutBlock[blockOf(block(lattice.x) * kBlock, block(lattice.y) * kBlock)] != 0)
        return true;
    const int lastI = block(lattice.x + reach);
    const int lastJ = block(lattice.y + reach);
    for (int j = block(lattice.y - reach); j <= lastJ; ++j)
        for (int i = block(lattice.x - reach); i <= lastI; ++i)
            if (m_cutBlock[static_cast<std::size_t>(j) * static_cast<std::size_t>(m_blocks) +
                           static_cast<std::size_t>(i)] != 0)
                return true;
    return false;
}

bool LiveTooth::isFeltByColumns(glm::dvec2 pointMm) const noexcept
{
    return isCutNear(grid().latticeOf(pointMm));
}

double LiveTooth::undersideAt(glm::dvec2 pointMm, double enough) noexcept
{
    int i = 0;
    int j = 0;
    double fx = 0.0;
    double fy = 0.0;
    if (!corners(grid().latticeOf(pointMm), i, j, fx, fy)) {
        // Beside the grid: open if the bur reaches nothing, else no room beneath is promised.
        const bool open = clearanceAt(pointMm) <= static_cast<double>(terrain::kEmptyTop);
        return static_cast<double>(open ? terrain::kEmptyBottom : terrain::kEmptyTop);
    }
    if (const glm::dvec2 lattice = grid().latticeOf(pointMm); isCutNear(lattice))
        return -static_cast<double>(mostInTheWay<Side::Beneath>(lattice, static_cast<float>(-enough)));
    return bilinear(undersideAtNode(i, j), undersideAtNode(i + 1, j), undersideAtNode(i, j + 1),
                    undersideAtNode(i + 1, j + 1), fx, fy);
}

Room LiveTooth::roomAt(glm::dvec2 pointMm, double z) const noexcept
{
    const glm::dvec2 lattice = grid().latticeOf(pointMm);
    const Head head = headAt(mask(), grid().cellMm, lattice.x, lattice.y);
    const int span = mask().spanOfRow.front();
    const int midI = static_cast<int>(std::floor(lattice.x));
    const int midJ = static_cast<int>(std::floor(lattice.y));
    const auto tip = static_cast<float>(z);
    float floor = terrain::kEmptyTop;
    float roof = terrain::kEmptyBottom;
    for (int j = std::max(0, midJ - span); j <= std::min(grid().side - 1, midJ + 1 + span); ++j) {
        const float dy2 = dy2Of(j, head);
        for (int i = std::max(0, midI - span); i <= std::min(grid().side - 1, midI + 1 + span); ++i) {
            const std::size_t k = grid().index(i, j);
            if (!m_tooth.isSolid(k))
                continue;
            const float above = valueOver<Side::Above>(m_tooth.top[k], i, dy2, head);
            const float beneath = -valueOver<Side::Beneath>(m_tooth.bottom[k], i, dy2, head);
            if (above <= beneath)  // not under the head
                continue;
            if (2.0F * tip >= above + beneath)
                floor = std::max(floor, above);
            else
                roof = std::min(roof, beneath);
        }
    }
    return {static_cast<double>(floor), static_cast<double>(roof)};
}

void LiveTooth::lower(int i, int j, float heightMm) noexcept
{
    const std::size_t index = grid().index(i, j);
    m_cutBlock[blockOf(i, j)] = 1;
    if (heightMm > m_tooth.bottom[index]) {
        m_tooth.top[index] = heightMm;
        return;
    }
    m_tooth.top[index] = terrain::kEmptyTop;
    m_tooth.bottom[index] = terrain::kEmptyBottom;
}

void LiveTooth::markCut(int i0, int j0, int i1, int j1) noexcept
{
    const int reach = mask().reach;
    const int last = grid().side - 1;
    const int left = std::max(0, i0 - reach);
    const int right = std::min(last, i1 + reach);
    for (int j = std::max(0, j0 - reach); j <= std::min(last, j1 + reach); ++j) {
        const auto from = static_cast<std::ptrdiff_t>(grid().index(left, j));
        const auto to = static_cast<std::ptrdiff_t>(grid().index(right, j)) + 1;
        std::fill(m_above.stamp.begin() + from, m_above.stamp.begin() + to, 0U);
        std::fill(m_below.stamp.begin() + from, m_below.stamp.begin() + to, 0U);
    }
}

}  // namespace core::contact
