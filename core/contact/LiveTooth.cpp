// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/LiveTooth.h"

#include <algorithm>
#include <cmath>

namespace core::contact {
namespace {

double bilinear(float a, float b, float c, float d, double fx, double fy)
{
    const double low = static_cast<double>(a) + (static_cast<double>(b) - static_cast<double>(a)) * fx;
    const double high = static_cast<double>(c) + (static_cast<double>(d) - static_cast<double>(c)) * fx;
    return low + (high - low) * fy;
}

}  // namespace

LiveTooth::LiveTooth(terrain::Tooth tooth) : m_tooth(std::move(tooth)), m_kernels(kernels())
{
    for (const drilling::Bur& bur : drilling::burs())
        m_masks.emplace_back(bur, grid().cellMm);
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

bool LiveTooth::corners(glm::dvec2 pointMm, int& i, int& j, double& fx, double& fy) const noexcept
{
    const glm::dvec2 at = grid().latticeOf(pointMm);
    const double last = grid().side - 1;
    if (!(at.x >= 0.0 && at.y >= 0.0 && at.x <= last && at.y <= last))
        return false;
    i = std::min(static_cast<int>(at.x), grid().side - 2);
    j = std::min(static_cast<int>(at.y), grid().side - 2);
    fx = at.x - i;
    fy = at.y - j;
    return true;
}

double LiveTooth::clearanceAt(glm::dvec2 pointMm, double enough) noexcept
{
    int i = 0;
    int j = 0;
    double fx = 0.0;
    double fy = 0.0;
    // Beside the grid there are no nodes, but the bur may still reach the tooth.
    if (!corners(pointMm, i, j, fx, fy) || isAnyCut(i, j))
        return static_cast<double>(highestAt(grid().latticeOf(pointMm), static_cast<float>(enough)));
    return bilinear(clearanceAtNode(i, j), clearanceAtNode(i + 1, j), clearanceAtNode(i, j + 1),
                    clearanceAtNode(i + 1, j + 1), fx, fy);
}

float LiveTooth::highestAt(glm::dvec2 lattice, float enough) noexcept
{
    const HeightView top{m_tooth.top.data(), grid().side};
    for (std::size_t k = 0; k < m_peaks.size() && m_peaks[k] >= 0; ++k) {
        const float height = m_kernels.heightOverColumn(top, mask(), grid().cellMm, lattice.x, lattice.y, m_peaks[k]);
        if (height > enough) {
            std::rotate(m_peaks.begin(), m_peaks.begin() + static_cast<std::ptrdiff_t>(k),
                        m_peaks.begin() + static_cast<std::ptrdiff_t>(k) + 1);
            return height;
        }
    }
    const Peak peak = m_kernels.highestAtPoint(top, mask(), grid().cellMm, lattice.x, lattice.y, enough);
    if (peak.column >= 0 && std::find(m_peaks.begin(), m_peaks.end(), peak.column) == m_peaks.end()) {
        std::copy_backward(m_peaks.begin(), m_peaks.end() - 1, m_peaks.end());
        m_peaks.front() = peak.column;
    }
    return peak.heightMm;
}

bool LiveTooth::isFeltByColumns(glm::dvec2 pointMm) const noexcept
{
    int i = 0;
    int j = 0;
    double fx = 0.0;
    double fy = 0.0;
    return corners(pointMm, i, j, fx, fy) && isAnyCut(i, j);
}

double LiveTooth::undersideAt(glm::dvec2 pointMm) noexcept
{
    int i = 0;
    int j = 0;
    double fx = 0.0;
    double fy = 0.0;
    if (!corners(pointMm, i, j, fx, fy)) {
        // Beside the grid: open if the bur reaches nothing, else no room beneath is promised.
        const bool open = clearanceAt(pointMm) <= static_cast<double>(terrain::kEmptyTop);
        return static_cast<double>(open ? terrain::kEmptyBottom : terrain::kEmptyTop);
    }
    return bilinear(undersideAtNode(i, j), undersideAtNode(i + 1, j), undersideAtNode(i, j + 1),
                    undersideAtNode(i + 1, j + 1), fx, fy);
}

void LiveTooth::lower(std::size_t index, float heightMm) noexcept
{
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
