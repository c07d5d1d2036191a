// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "core/bur/Bur.h"
#include "core/terrain/Tooth.h"

namespace lab {

/// The outline of a bur over the squared distance from its axis, so that no column needs a square root. Create one per
/// bur.
class VoxelBur
{
public:
    explicit VoxelBur(const core::bur::Bur& bur);

    [[nodiscard]] double radiusMm() const noexcept { return m_radiusMm; }
    /// Return the heights above the tip between which the bur is, at the root of `r2` (up to radiusMm()).
    [[nodiscard]] double underMm(double r2) const noexcept { return m_underMm[stepAt(r2)]; }
    [[nodiscard]] double upperMm(double r2) const noexcept { return m_upperMm[stepAt(r2)]; }

private:
    [[nodiscard]] std::size_t stepAt(double r2) const noexcept { return static_cast<std::size_t>(r2 * m_r2ToStep); }

    double m_radiusMm;
    double m_r2ToStep;
    std::vector<double> m_underMm;
    std::vector<double> m_upperMm;
};

/// The same tooth as a plain dense voxel model, for comparison with the height stack: cubes of the grid's cell, one
/// byte each, a column's in a row. A cube in the bur's outline is removed completely: undercuts are possible, thin
/// slices are not. Used by the lab only.
class VoxelTooth
{
public:
    /// Each cube has the material at its centre, and is empty if that is outside the tooth.
    explicit VoxelTooth(const core::terrain::ToothAnatomy& anatomy);

    [[nodiscard]] std::size_t bytes() const noexcept { return m_cubes.size(); }
    [[nodiscard]] double volumeMm3() const noexcept;

    /// Returns the number of solid cubes with their centre in a bur with its tip at `tip`: the cheapest test for
    /// contact. It gives neither direction nor distance: a god-object needs several tests per tick.
    [[nodiscard]] std::size_t overlap(const VoxelBur& bur, const glm::dvec3& tip) const noexcept;

    /// Empties these cubes and returns their volumes, mm3.
    core::terrain::PerMaterial remove(const VoxelBur& bur, const glm::dvec3& tip) noexcept;

private:
    /// Calls visit(first, last) for the cubes of each column that are in the bur: indices, last beyond the end.
    template <class Visit>
    void forEachRun(const VoxelBur& bur, const glm::dvec3& tip, Visit&& visit) const noexcept;

    core::terrain::Grid m_grid;
    double m_lowMm;  ///< lower end of the lowest cubes
    int m_layers;
    std::vector<std::uint8_t> m_cubes;  ///< 0: empty, otherwise 1 + Material; [column * layers + layer]
};

}  // namespace lab
