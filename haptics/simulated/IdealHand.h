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

/// A patient expert: cuts an ideal and nothing beside it, with one bur, in layers that are thinner than its head is
/// long. It plunges where most is to go, then mills on to the nearest column that is not yet cut, at depth where the
/// way there is free. It steers a PointerDevice as a mouse would.
class IdealHand
{
public:
    /// @param idealTop  as core::grading::IdealTop, of the anatomy that is cut
    /// @param beside    the neighbours, which the bur keeps off; may be null, is not kept
    IdealHand(const core::terrain::ToothAnatomy& anatomy, std::span<const float> idealTop, const core::bur::Bur& bur,
              const core::terrain::HeightMaps* beside = nullptr);

    /// What the hand wants now, given the bur and the tooth. Call once every few ticks.
    [[nodiscard]] core::servo::PointerInput decide(const core::servo::ServoState& state,
                                                   const core::terrain::Tooth& tooth);

    /// True when all is cut that this bur can reach, or what is left does not yield.
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
    std::vector<float> m_lowestMm;        ///< of the tip at each node, so that no column is cut below its ideal
    std::vector<float> m_reachMm;         ///< to which this bur can cut each column
    std::vector<std::size_t> m_fromAt;    ///< the node from which it does
    std::vector<bool> m_isKeptOff;        ///< nodes from which the bur would touch a neighbour
    std::vector<bool> m_isGivenUp;        ///< nodes where nothing yields any more
    std::size_t m_wanted = 0;             ///< columns that are to be cut
    float m_layerMm = 0.0F;               ///< the tip goes no lower now
    float m_thickMm = 0.0F;               ///< of a layer
    std::optional<std::size_t> m_column;  ///< the one that is cut now
    int m_patience = 0;                   ///< decisions spent on it
    bool m_isDone = false;
};

}  // namespace haptics
