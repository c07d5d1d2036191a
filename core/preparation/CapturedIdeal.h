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

/// How far off an attempt may be at no cost, as the teacher who captured an ideal saw it. What a lesson marks by is its
/// rubric; these go into it when the lesson is made.
struct Tolerances
{
    double outlineMm = 0.3;
    double depthMm = 0.25;
    double wallDeg = 5.0;
    double floorMm = 0.1;  ///< unevenness of the floor, root mean square
    bool operator==(const Tolerances&) const = default;
};

/// An ideal preparation that was cut and not drawn, as a file keeps it (*.cuspideal): over the grid of one tooth, what
/// is to be cut, and how deep. Knows the tooth by its surface and fits no other.
struct CapturedIdeal
{
    std::string tooth;  ///< its name: "36"
    int fdi = 0;
    std::uint64_t seed = 0;
    std::uint64_t surface = 0;  ///< surfaceHash() of the tooth
    terrain::Grid grid;
    std::vector<grading::Part> parts;  ///< [side * side]
    std::vector<float> heightsMm;      ///< of the columns that are not Keep, in order; kEmptyTop where nothing is left
    std::optional<grading::Preparation::Isthmus> isthmus;
    Tolerances tolerances;
    std::vector<std::string> sources;  ///< what it was taken from, in words: file names
};

inline constexpr std::uint32_t kCapturedVersion = 1;
inline constexpr std::size_t kMostSources = 100;
/// The largest file that is read: any ideal on the finest grid fits.
inline constexpr std::uintmax_t kLargestCapturedBytes = std::uintmax_t{8} * 1024 * 1024;

/// FNV-1a over grid, upper and under surface, bit for bit. Two teeth that differ in layers or decay alone have the
/// same.
[[nodiscard]] std::uint64_t surfaceHash(const terrain::ToothAnatomy& anatomy);

/// averagePreparation() of the attempts as a value to keep. The isthmus is where a Class I of this tooth has it, if
/// most attempts have cut there; else none is known.
/// Some tens of milliseconds; any thread that may wait. Errors as averagePreparation(); tolerances below zero or over
/// 5 mm (45 degrees) are OutOfRange.
[[nodiscard]] Result<CapturedIdeal> capture(std::span<const terrain::Tooth* const> attempts,
                                            const Tolerances& tolerances, std::vector<std::string> sources);

/// The same, ready to be seen and marked against. An error says which tooth it was captured on if it is another.
[[nodiscard]] Result<grading::Preparation> preparationOf(const CapturedIdeal& ideal,
                                                         const terrain::ToothAnatomy& anatomy);

/// The file's bytes: a magic word, a version, length and checksum, and the rest by Zstandard.
[[nodiscard]] std::string toBytes(const CapturedIdeal& ideal);
/// Checks everything it reads. The sentence does not name the file: readCaptured() does.
[[nodiscard]] Result<CapturedIdeal> capturedFrom(std::string_view bytes);

[[nodiscard]] Result<CapturedIdeal> readCaptured(const std::filesystem::path& path);
/// An older file survives any failure (writeWhole).
[[nodiscard]] Status writeCaptured(const std::filesystem::path& path, const CapturedIdeal& ideal);

}  // namespace core::preparation
