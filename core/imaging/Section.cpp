// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/imaging/Section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace core::imaging {
namespace {

using terrain::ColumnLayers;
using terrain::Grid;
using terrain::Material;
using terrain::Tooth;
using terrain::ToothAnatomy;

/// The four nodes around a point, and their weights.
struct Corners
{
    std::array<std::size_t, 4> node{};
    std::array<float, 4> share{};
};

float mixed(const Corners& around, const auto& value)
{
    float sum = 0.0F;
    for (std::size_t c = 0; c < 4; ++c)
        sum += around.share.at(c) * value(around.node.at(c));
    return sum;
}

/// Interpolates a layer with two interfaces if all four columns have it. Otherwise uses that of the nearest column.
void mixLens(const Corners& around, const auto& roof, const auto& floor, float& mixedRoof, float& mixedFloor)
{
    const bool everywhere =
        std::all_of(around.node.begin(), around.node.end(), [&](std::size_t k) { return roof(k) > floor(k); });
    if (!everywhere)
        return;
    mixedRoof = mixed(around, roof);
    mixedFloor = mixed(around, floor);
}

SectionSample sampleAt(const Tooth& tooth, const std::vector<float>& ideal, glm::dvec2 pointMm)
{
    const Grid& grid = tooth.grid();
    const ToothAnatomy& anatomy = *tooth.anatomy;
    const glm::dvec2 at = grid.latticeOf(pointMm);
    const int nearI = static_cast<int>(std::floor(at.x + 0.5));
    const int nearJ = static_cast<int>(std::floor(at.y + 0.5));
    SectionSample sample;
    if (!grid.contains(nearI, nearJ))
        return sample;
    const std::size_t nearest = grid.index(nearI, nearJ);
    if (!(anatomy.top[nearest] > anatomy.bottom[nearest]))
        return sample;
    sample.wasTooth = true;
    sample.originalTopMm = anatomy.top[nearest];
    sample.idealTopMm = ideal[nearest];
    ColumnLayers layers = anatomy.layers[nearest];
    float top = tooth.top[nearest];
    float bottom = tooth.bottom[nearest];

    const int i = static_cast<int>(std::floor(at.x));
    const int j = static_cast<int>(std::floor(at.y));
    if (!grid.contains(i, j) || !grid.contains(i + 1, j + 1)) {
        sample.present = terrain::spansBetween(layers, bottom, top);
        return sample;
    }
    const auto fx = static_cast<float>(at.x - i);
    const auto fy = static_cast<float>(at.y - j);
    const Corners around{{grid.index(i, j), grid.index(i + 1, j), grid.index(i, j + 1), grid.index(i + 1, j + 1)},
                         {(1.0F - fx) * (1.0F - fy), fx * (1.0F - fy), (1.0F - fx) * fy, fx * fy}};
    const auto all = [&](const auto& holds) { return std::all_of(around.node.begin(), around.node.end(), holds); };
    if (all([&](std::size_t k) { return anatomy.top[k] > anatomy.bottom[k]; })) {
        const auto of = [&](float ColumnLayers::*height) {
            return [&anatomy, height](std::size_t k) { return anatomy.layers[k].*height; };
        };
        sample.originalTopMm = mixed(around, [&](std::size_t k) { return anatomy.top[k]; });
        if (all([&](std::size_t k) { return ideal[k] > anatomy.bottom[k]; }))
            sample.idealTopMm = mixed(around, [&](std::size_t k) { return ideal[k]; });
        layers.dej = mixed(around, of(&ColumnLayers::dej));
        mixLens(around, of(&ColumnLayers::cariesRoof), of(&ColumnLayers::cariesFloor), layers.cariesRoof,
                layers.cariesFloor);
        mixLens(around, of(&ColumnLayers::pulpRoof), of(&ColumnLayers::pulpFloor), layers.pulpRoof, layers.pulpFloor);
    }
    if (all([&](std::size_t k) { return tooth.isSolid(k); })) {
        top = mixed(around, [&](std::size_t k) { return tooth.top[k]; });
        bottom = mixed(around, [&](std::size_t k) { return tooth.bottom[k]; });
    }
    if (anatomy.hasDecayZones)
        sample.zones = terrain::decayZonesOf(layers);
    sample.present = terrain::spansBetween(layers, bottom, top);
    return sample;
}

}  // namespace

glm::dvec2 SectionPlane::direction() const
{
    return {std::cos(angleRad), std::sin(angleRad)};
}

double SectionPlane::alongMm(glm::dvec2 pointMm) const
{
    return glm::dot(pointMm, direction());
}

glm::dvec2 SectionPlane::pointMm(double alongMm) const
{
    const glm::dvec2 right = direction();
    return throughMm + (alongMm - glm::dot(throughMm, right)) * right;
}

Section sectionOf(const Tooth& tooth, const SectionPlane& plane, double fromMm, double toMm, int count,
                  const std::vector<float>* ideal)
{
    const std::vector<float>& wanted = ideal != nullptr ? *ideal : tooth.anatomy->top;
    Section section{plane, fromMm, (toMm - fromMm) / (count - 1), {}};
    section.samples.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k)
        section.samples.push_back(sampleAt(tooth, wanted, plane.pointMm(fromMm + k * section.stepMm)));
    return section;
}

PulpChamber::PulpChamber(const ToothAnatomy& anatomy) : m_halfCellMm(0.5 * anatomy.grid.cellMm)
{
    const Grid& grid = anatomy.grid;
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            if (!terrain::hasPulp(anatomy, k))
                continue;
            const glm::dvec2 at = grid.nodeMm(i, j);
            m_boxes.push_back({static_cast<float>(at.x), static_cast<float>(at.y),
                               std::max(anatomy.layers[k].pulpFloor, anatomy.bottom[k]),
                               std::min(anatomy.layers[k].pulpRoof, anatomy.top[k])});
        }
    }
}

std::optional<glm::dvec3> PulpChamber::nearest(glm::dvec3 pointMm) const
{
    if (m_boxes.empty())
        return std::nullopt;
    const glm::vec3 point(pointMm);
    const auto half = static_cast<float>(m_halfCellMm);
    float least = std::numeric_limits<float>::max();
    const Box* best = m_boxes.data();
    for (const Box& box : m_boxes) {
        const float dx = std::max(std::abs(point.x - box.x) - half, 0.0F);
        const float dy = std::max(std::abs(point.y - box.y) - half, 0.0F);
        const float dz = std::max({box.low - point.z, point.z - box.high, 0.0F});
        const float squared = dx * dx + dy * dy + dz * dz;
        if (squared < least) {
            least = squared;
            best = &box;
        }
    }
    const glm::dvec3 middle(best->x, best->y, 0.0);
    return glm::dvec3(std::clamp(pointMm.x, middle.x - m_halfCellMm, middle.x + m_halfCellMm),
                      std::clamp(pointMm.y, middle.y - m_halfCellMm, middle.y + m_halfCellMm),
                      std::clamp<double>(pointMm.z, best->low, best->high));
}

DepthReading readDepth(const Tooth& tooth, const PulpChamber& pulp, glm::dvec3 tipMm, double headRadiusMm)
{
    DepthReading reading;
    const glm::dvec3 headMm = tipMm + glm::dvec3(0.0, 0.0, headRadiusMm);
    if (const auto nearest = pulp.nearest(headMm))
        reading.toPulpMm = std::max(0.0, glm::length(*nearest - headMm) - headRadiusMm);
    const Grid& grid = tooth.grid();
    const ToothAnatomy& anatomy = *tooth.anatomy;
    const glm::dvec2 at = grid.latticeOf({tipMm.x, tipMm.y});
    const int i = static_cast<int>(std::floor(at.x + 0.5));
    const int j = static_cast<int>(std::floor(at.y + 0.5));
    if (!grid.contains(i, j))
        return reading;
    const std::size_t k = grid.index(i, j);
    if (!(anatomy.top[k] > anatomy.bottom[k]))
        return reading;
    reading.overTooth = true;
    reading.depthMm = static_cast<double>(anatomy.top[k]) - tipMm.z;
    if (!terrain::hasPulp(anatomy, k))
        return reading;
    const float roof = anatomy.layers[k].pulpRoof;
    reading.downToPulpMm = std::max(0.0, tipMm.z - static_cast<double>(roof));
    const bool dentinLeft = tooth.isSolid(k) && tooth.top[k] > roof;
    reading.dentinOverPulpMm = dentinLeft ? terrain::lengthsBetween(anatomy.layers[k], roof, tooth.top[k])
                                                .at(static_cast<std::size_t>(Material::Dentin))
                                          : 0.0;
    return reading;
}

}  // namespace core::imaging
