// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"
#include "core/grading/Preparation.h"
#include "core/terrain/Tooth.h"

namespace core::preparation {

/// The tolerances that the teacher chose when an ideal was captured. Grading uses the rubric of the lesson; these
/// values are put into it when the lesson is made.
struct Tolerances
{
    double outlineMm = 0.3;
    double depthMm = 0.25;
    double wallDeg = 5.0;
    double floorMm = 0.1;  ///< root mean square unevenness of the floor
    bool operator==(const Tolerances&) const = default;
};

/// An ideal preparation that was cut instead of constructed, as stored in a file (*.cuspideal): over the grid of one
/// tooth, the columns to be cut, and their depth. Identifies the tooth by its surface and fits no other.
struct CapturedIdeal
{
    std::string tooth;  ///< its name: "36"
    int fdi = 0;
    std::uint64_t seed = 0;
    std::uint64_t surface = 0;  ///< surfaceHash() of the tooth
    terrain::Grid grid;
    std::vector<grading::Part> parts;  ///< [side * side]
    std::vector<float> heightsMm;      ///< of the columns that are not Keep, in order; kEmptyTop where no material is
                                       ///< left
    std::optional<grading::Preparation::Isthmus> isthmus;
    Tolerances tolerances;
    std::vector<std::string> sources;  ///< its sources, as text: file names
};

inline constexpr std::uint32_t kCapturedVersion = 1;
inline constexpr std::size_t kMostSources = 100;
/// The largest file that is read: any ideal on the finest grid fits into it.
inline constexpr std::uintmax_t kLargestCapturedBytes = std::uintmax_t{8} * 1024 * 1024;

/// Returns the FNV-1a hash of grid, upper and under surface, bit for bit. Two teeth that differ only in layers or decay
/// have the same hash.
[[nodiscard]] std::uint64_t surfaceHash(const terrain::ToothAnatomy& anatomy);

/// Returns averagePreparation() of the attempts as a value to be stored. The isthmus is that of a Class I of this tooth
/// if most attempts have cut there; otherwise it is unknown. Some tens of milliseconds; any thread but the ui thread.
/// Errors of averagePreparation(); OutOfRange for tolerances below zero or over 5 mm (45 degrees).
[[nodiscard]] Result<CapturedIdeal> capture(std::span<const terrain::Tooth* const> attempts,
                                            const Tolerances& tolerances, std::vector<std::string> sources);

/// Returns a captured ideal as a preparation. The error names the tooth it was captured on if that is another.
[[nodiscard]] Result<grading::Preparation> preparationOf(const CapturedIdeal& ideal,
                                                         const terrain::ToothAnatomy& anatomy);

/// Returns the bytes of the file: a magic word, a version, length and checksum, and the rest compressed by Zstandard.
[[nodiscard]] std::string toBytes(const CapturedIdeal& ideal);
/// Reads and checks the bytes of a file. The error does not name the file: that of readCaptured() does.
[[nodiscard]] Result<CapturedIdeal> capturedFrom(std::string_view bytes);

[[nodiscard]] Result<CapturedIdeal> readCaptured(const std::filesystem::path& path);
/// Writes a file. An existing file is unchanged on failure (writeWhole).
[[nodiscard]] Status writeCaptured(const std::filesystem::path& path, const CapturedIdeal& ideal);

}  // namespace core::preparation
