// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/terrain/Tooth.h"

namespace support {

/// Top and bottom of a tooth, in the tooth frame, like those of the importer.
struct ToothMaps
{
    core::terrain::Grid grid;
    std::vector<float> top;
    std::vector<float> bottom;

    [[nodiscard]] bool isSolid(std::size_t k) const { return top[k] > bottom[k]; }
};

/// Returns the path of a file of the shared data folder ($CUSP_SHARED_DATA, or a folder next to the source); empty if
/// the file is absent.
[[nodiscard]] std::string sharedData(const std::string& file);

/// Returns a generated tooth, rasterised like a scan.
[[nodiscard]] ToothMaps generatedMaps(int fdi, std::uint64_t seed, int side);

/// Rasterises shared/data/teeth/dundee_<fdi>.obj (21, 24 or 36), 10.5 mm a unit, crown up, +x distal; nothing if the
/// scan is absent.
[[nodiscard]] std::optional<ToothMaps> scanMaps(int fdi, int side);

/// Returns a molar of formulas: a round crown of radius 5 with cusps 2.5 above a flat fossa, a fissure 0.8 deep and 0.3
/// wide along y = 0, the contour 5 below the cusps, a neck of radius 4.2 at the CEJ (z = -7.5), and one root down to
/// -20.
[[nodiscard]] ToothMaps analyticMolar(int side);

struct NamedMaps
{
    std::string name;
    int fdi = 0;
    ToothMaps maps;
};

/// Returns the analytic molar, a generated tooth of each kind and the scans that are present. The quick run has the
/// analytic molar, a generated molar and a generated incisor.
[[nodiscard]] std::vector<NamedMaps> everyTooth(int side);

/// Returns extreme maps of 64 cells a side: empty, one needle, full to the edge and so on.
[[nodiscard]] std::vector<NamedMaps> oddMaps();

/// Returns the volume of each material, mm3. Each column counts for a whole cell.
[[nodiscard]] core::terrain::PerMaterial volumesOf(const ToothMaps& maps,
                                                   const std::vector<core::terrain::ColumnLayers>& layers);

}  // namespace support
