// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "core/bur/Bur.h"
#include "core/terrain/Tooth.h"

namespace lab {

/// The outline of a bur over the squared distance from its axis, so that no column costs a root. Made once a bur.
class VoxelBur
{
public:
    explicit VoxelBur(const core::bur::Bur& bur);

    [[nodiscard]] double radiusMm() const noexcept { return m_radiusMm; }
    /// Heights above the tip between which the bur is, at the root of `r2` (up to radiusMm()).
    [[nodiscard]] double underMm(double r2) const noexcept { return m_underMm[stepAt(r2)]; }
    [[nodiscard]] double upperMm(double r2) const noexcept { return m_upperMm[stepAt(r2)]; }

private:
    [[nodiscard]] std::size_t stepAt(double r2) const noexcept { return static_cast<std::size_t>(r2 * m_r2ToStep); }

    double m_radiusMm;
    double m_r2ToStep;
    std::vector<double> m_underMm;
    std::vector<double> m_upperMm;
};

/// The same tooth as a plain dense voxel model, to chart the height stack against: cubes of the grid's cell, a byte
/// each, a column's in a row. What the bur's outline has in it is gone whole, what it has not stays whole: undercuts
/// can be, thin slices cannot. Nothing but the lab uses it.
class VoxelTooth
{
public:
    /// A cube is of the material at its centre, and empty if that is outside the tooth.
    explicit VoxelTooth(const core::terrain::ToothAnatomy& anatomy);

    [[nodiscard]] std::size_t bytes() const noexcept { return m_cubes.size(); }
    [[nodiscard]] double volumeMm3() const noexcept;

    /// Contact, at its cheapest: how many cubes that are there have their centre in a bur with its tip at `tip`. More
    /// than none is contact. It says neither which way is out nor how far: a god-object asks several times a tick.
    [[nodiscard]] std::size_t overlap(const VoxelBur& bur, const glm::dvec3& tip) const noexcept;

    /// Empties them; the volumes that were there, mm3.
    core::terrain::PerMaterial remove(const VoxelBur& bur, const glm::dvec3& tip) noexcept;

private:
    /// Calls visit(first, last) for the cubes of each column that are in the bur: indices, last beyond the end.
    template <class Visit>
    void forEachRun(const VoxelBur& bur, const glm::dvec3& tip, Visit&& visit) const noexcept;

    core::terrain::Grid m_grid;
    double m_lowMm;  ///< where the lowest cubes begin
    int m_layers;
    std::vector<std::uint8_t> m_cubes;  ///< 0 empty, else 1 + Material; [column * layers + layer]
};

}  // namespace lab
