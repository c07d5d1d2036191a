// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/bur/Bur.h"
#include "core/servo/ServoState.h"
#include "core/terrain/Rasteriser.h"
#include "core/terrain/Tooth.h"
#include "haptics/simulated/BurFootprint.h"

namespace haptics {

/// A simulated expert who cuts an ideal and nothing beside it, with one bur, in layers thinner than the length of its
/// head. The bur plunges where most is left, then mills to the nearest uncut column, at depth if the path there is
/// free. The hand steers a PointerDevice as a mouse would.
class IdealHand
{
public:
    /// @param idealTop  as core::grading::IdealTop, of the anatomy that is cut
    /// @param beside    the neighbouring teeth, which the bur avoids; may be null; used in the constructor only
    IdealHand(const core::terrain::ToothAnatomy& anatomy, std::span<const float> idealTop, const core::bur::Bur& bur,
              const core::terrain::HeightMaps* beside = nullptr);

    /// Returns the input of the pointer for this state of bur and tooth. Call once every few ticks.
    [[nodiscard]] core::servo::PointerInput decide(const core::servo::ServoState& state,
                                                   const core::terrain::Tooth& tooth);

    /// Returns true if this bur has cut everything it can reach, or if the rest cannot be cut.
    [[nodiscard]] bool isDone() const { return m_isDone; }

private:
    void findLowest(std::span<const float> idealTop, std::span<const FootprintPart> head);
    void keepOff(const core::terrain::HeightMaps& beside, const core::bur::Bur& bur);
    void findReach(std::span<const FootprintPart> head);
    [[nodiscard]] bool goDown(const core::terrain::Tooth& tooth);
    [[nodiscard]] bool isWanting(const core::terrain::Tooth& tooth, std::size_t column) const;
    [[nodiscard]] std::optional<std::size_t> nextColumn(const core::terrain::Tooth& tooth, glm::dvec2 burMm) const;
    [[nodiscard]] double lowestAt(glm::dvec2 placeMm) const;
    [[nodiscard]] bool isKeptOff(glm::dvec2 placeMm) const;
    [[nodiscard]] double lowestOnTheWay(glm::dvec2 fromMm, glm::dvec2 toMm) const;

    core::terrain::Grid m_grid;
    std::vector<float> m_lowestMm;        ///< lowest height of the tip at each node at which no column is cut below its
                                          ///< ideal
    std::vector<float> m_reachMm;         ///< height to which this bur can cut each column
    std::vector<std::size_t> m_fromAt;    ///< the node from which the bur cuts each column to that height
    std::vector<bool> m_isKeptOff;        ///< nodes at which the bur would touch a neighbour
    std::vector<bool> m_isGivenUp;        ///< nodes where cutting makes no progress
    std::size_t m_wanted = 0;             ///< number of columns to be cut
    float m_layerMm = 0.0F;               ///< lowest height of the tip at present
    float m_thickMm = 0.0F;               ///< thickness of a layer
    std::optional<std::size_t> m_column;  ///< the column being cut
    int m_patience = 0;                   ///< number of decisions spent on it
    bool m_isDone = false;
};

}  // namespace haptics
