// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/ModelCost.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "core/contact/ContactMethod.h"
#include "core/cutting/Drill.h"
#include "haptics/simulated/Simulation.h"
#include "lab/VoxelTooth.h"

namespace lab {
namespace {

using namespace core;

constexpr double kStepMm = 0.005;
constexpr double kFromMm = -1.5;   ///< above the fossa of a molar, 2.6 mm below its highest cusp
constexpr double kFloorMm = -3.6;  ///< a millimetre below it
constexpr double kLengthMm = 3.0;
constexpr double kShiftMm = 0.023;
constexpr double kTurnedDeg = 7.0;  ///< relative to the lattice

/// Returns the places of the tip, one for each tick.
std::vector<glm::dvec3> slot(std::size_t which)
{
    const double angle = 2.0 * std::numbers::pi * (static_cast<double>(which) / kSlots + kTurnedDeg / 360.0);
    const glm::dvec3 outwards(std::cos(angle), std::sin(angle), 0.0);
    // Each slot has another position on the lattice; otherwise all would have the same error.
    const glm::dvec3 shift = kShiftMm * static_cast<double>(which) * glm::dvec3(1.0, 0.38, 0.71);
    std::vector<glm::dvec3> places;
    for (double z = kFromMm; z > kFloorMm; z -= kStepMm)
        places.push_back(shift + glm::dvec3(0.0, 0.0, z));
    for (double out = 0.0; out < kLengthMm; out += kStepMm)
        places.push_back(shift + glm::dvec3(0.0, 0.0, kFloorMm) + outwards * out);
    return places;
}

double sum(const terrain::PerMaterial& mm3)
{
    double all = 0.0;
    for (const double one : mm3)
        all += one;
    return all;
}

}  // namespace

ModelCost millHeightStack(const std::shared_ptr<const terrain::ToothAnatomy>& anatomy, std::size_t bur)
{
    ModelCost cost;
    cost.bytes = anatomy->grid.count() * (4 * sizeof(float) + sizeof(terrain::ColumnLayers) + sizeof(float));
    settings::HardnessPreset yielding;
    yielding.material.fill({settings::kMaxRateMm3PerNs, 0.0});
    for (std::size_t which = 0; which < kSlots; ++which) {
        const std::vector<glm::dvec3> places = slot(which);
        contact::LiveTooth tooth{terrain::Tooth(anatomy)};
        tooth.selectBur(bur);
        const auto contact = contact::makeContactMethod("continuous").value();
        contact->restart(places.front());
        cutting::Drill drill(yielding, {});
        for (const glm::dvec3& device : places) {
            const double started = haptics::threadCpuUs();
            const glm::dvec3 anchor = contact->update(tooth, device);
            const cutting::Cut cut = drill.cut(tooth, anchor, device, 1.0, 1.0);
            contact->moveTo(cut.tipMm);
            cost.times.add(haptics::threadCpuUs() - started);
        }
        cost.removedMm3[which] = sum(terrain::removedVolumes(tooth.tooth()));
    }
    return cost;
}

ModelCost millVoxels(const terrain::ToothAnatomy& anatomy, std::size_t bur)
{
    const VoxelTooth whole(anatomy);
    const VoxelBur outline(bur::burs()[bur]);
    ModelCost cost;
    cost.bytes = whole.bytes();
    for (std::size_t which = 0; which < kSlots; ++which) {
        VoxelTooth tooth = whole;
        for (const glm::dvec3& device : slot(which)) {
            const double started = haptics::threadCpuUs();
            if (tooth.overlap(outline, device) > 0)
                cost.removedMm3[which] += sum(tooth.remove(outline, device));
            cost.times.add(haptics::threadCpuUs() - started);
        }
    }
    return cost;
}

double volumeErrorPercent(const ModelCost& cost, const ModelCost& right)
{
    double squares = 0.0;
    for (std::size_t which = 0; which < kSlots; ++which) {
        const double error = cost.removedMm3[which] / right.removedMm3[which] - 1.0;
        squares += error * error;
    }
    return 100.0 * std::sqrt(squares / kSlots);
}

}  // namespace lab
