// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grading/Perforation.h"

#include <utility>

#include "core/grading/Columns.h"

namespace core::grading {
namespace {

constexpr double kRimMm = 0.5;

/// Returns whether a column lies within kRimMm of the outside of the uncut tooth.
bool isAtTheRim(const terrain::ToothAnatomy& anatomy, std::size_t k)
{
    const terrain::Grid& grid = anatomy.grid;
    const auto side = static_cast<std::size_t>(grid.side);
    const auto i = static_cast<int>(k % side);
    const auto j = static_cast<int>(k / side);
    const int reach = static_cast<int>(kRimMm / grid.cellMm);
    for (int dj = -reach; dj <= reach; ++dj)
        for (int di = -reach; di <= reach; ++di)
            if (!grid.contains(i + di, j + dj) || !wasSolid(anatomy, grid.index(i + di, j + dj)))
                return true;
    return false;
}

}  // namespace

std::vector<std::uint8_t> perforationsBeside(const terrain::Tooth& tooth, const IdealTop& ideal)
{
    const terrain::ToothAnatomy& anatomy = *tooth.anatomy;
    const terrain::Grid& grid = anatomy.grid;
    std::vector<std::uint8_t> holes = terrain::perforations(tooth);
    if (ideal == nullptr || holes.empty())
        return holes;
    std::vector<std::size_t> open;
    const auto clear = [&](std::size_t k) {
        if (holes[k] != 0)
            open.push_back(k);
        holes[k] = 0;
    };
    for (std::size_t k = 0; k < holes.size(); ++k)
        if (wasSolid(anatomy, k) && (!((*ideal)[k] > anatomy.bottom[k]) ||
                                     (holes[k] != 0 && (*ideal)[k] < anatomy.top[k] && isAtTheRim(anatomy, k))))
            clear(k);
    const auto side = static_cast<std::size_t>(grid.side);
    while (!open.empty()) {
        const auto i = static_cast<int>(open.back() % side);
        const auto j = static_cast<int>(open.back() / side);
        open.pop_back();
        for (const auto& [ni, nj] :
             {std::pair(i - 1, j), std::pair(i + 1, j), std::pair(i, j - 1), std::pair(i, j + 1)})
            if (grid.contains(ni, nj))
                clear(grid.index(ni, nj));
    }
    return holes;
}

}  // namespace core::grading
