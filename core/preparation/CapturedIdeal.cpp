// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/preparation/CapturedIdeal.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fstream>
#include <memory>

#include "core/base/Bytes.h"
#include "core/base/NumberField.h"
#include "core/base/WholeFile.h"
#include "core/preparation/CapturedPreparation.h"
#include "core/preparation/ToothPreparation.h"
#include "core/recording/Format.h"

namespace core::preparation {
namespace {

using grading::Part;

constexpr std::string_view kMagic{"CUSPIDL\n", 8};
constexpr std::size_t kLongestWords = 400;
constexpr float kHighestMm = 100.0F;
constexpr std::array<NumberField<Tolerances>, 4> kTolerances{{
    {"outline_mm", "tolerance of the outline", "mm", &Tolerances::outlineMm, 0.0, 5.0},
    {"depth_mm", "tolerance of the depth", "mm", &Tolerances::depthMm, 0.0, 5.0},
    {"wall_deg", "tolerance of the walls", "degrees", &Tolerances::wallDeg, 0.0, 45.0},
    {"floor_mm", "tolerance of the floor", "mm", &Tolerances::floorMm, 0.0, 5.0},
}};

Status checkTolerances(const Tolerances& tolerances)
{
    return validateNumbers(std::span<const NumberField<Tolerances>>(kTolerances), tolerances);
}

/// Returns the place of the isthmus of a Class I of this tooth, if the ideal is cut there.
std::optional<grading::Preparation::Isthmus> isthmusIn(const grading::Preparation& ideal,
                                                       const terrain::ToothAnatomy& anatomy)
{
    const auto design = fittedDesign(Kind::ClassOne, anatomy);
    const auto usual = design ? makePreparation(Kind::ClassOne, *design, anatomy)
                              : Result<grading::Preparation>(tl::unexpected(design.error()));
    if (!usual || !usual->isthmus)
        return std::nullopt;
    const glm::dvec2 at = anatomy.grid.latticeOf(usual->isthmus->atMm);
    const int i = static_cast<int>(std::lround(at.x));
    const int j = static_cast<int>(std::lround(at.y));
    const bool isCut = anatomy.grid.contains(i, j) && ideal.parts[anatomy.grid.index(i, j)] != Part::Keep;
    return isCut ? usual->isthmus : std::nullopt;
}

/// Writes the four byte planes of the heights one after another. Similar bytes together compress better.
void putHeights(ByteWriter& out, const std::vector<float>& heights)
{
    for (unsigned shift = 0; shift < 32; shift += 8)
        for (const float height : heights)
            out.put(static_cast<std::uint8_t>((std::bit_cast<std::uint32_t>(height) >> shift) & 0xFFU));
}

std::vector<float> takeHeights(ByteReader& in, std::size_t count)
{
    std::vector<std::uint32_t> bits(count, 0);
    for (unsigned shift = 0; shift < 32; shift += 8)
        for (std::uint32_t& value : bits)
            value |= static_cast<std::uint32_t>(in.take<std::uint8_t>()) << shift;
    std::vector<float> heights(count);
    std::transform(bits.begin(), bits.end(), heights.begin(),
                   [](std::uint32_t value) { return std::bit_cast<float>(value); });
    return heights;
}

std::string payloadOf(const CapturedIdeal& ideal)
{
    ByteWriter out;
    out.putText(ideal.tooth);
    out.put(static_cast<std::int32_t>(ideal.fdi));
    out.put(ideal.seed);
    out.put(ideal.surface);
    out.put(static_cast<std::int32_t>(ideal.grid.side));
    for (const double number :
         {ideal.grid.cellMm, ideal.grid.originMm.x, ideal.grid.originMm.y, ideal.tolerances.outlineMm,
          ideal.tolerances.depthMm, ideal.tolerances.wallDeg, ideal.tolerances.floorMm})
        out.put(number);
    out.put(static_cast<std::uint8_t>(ideal.isthmus ? 1 : 0));
    const auto isthmus = ideal.isthmus.value_or(grading::Preparation::Isthmus{});
    for (const double number : {isthmus.atMm.x, isthmus.atMm.y, isthmus.across.x, isthmus.across.y, isthmus.lengthMm})
        out.put(number);
    out.put(static_cast<std::uint32_t>(ideal.sources.size()));
    for (const std::string& source : ideal.sources)
        out.putText(source);
    for (const Part part : ideal.parts)
        out.put(static_cast<std::uint8_t>(part));
    putHeights(out, ideal.heightsMm);
    return out.bytes();
}

bool isPlace(double mm)
{
    return std::isfinite(mm) && std::abs(mm) < 1.0e4;
}

/// Returns a text of limited length that is still valid UTF-8.
std::string shortened(std::string words)
{
    words.resize(std::min(words.size(), kLongestWords));
    while (!isUtf8(words))
        words.pop_back();
    return words;
}

bool isWords(const std::string& words)
{
    return words.size() <= kLongestWords && isUtf8(words);
}

std::optional<CapturedIdeal> idealFrom(std::string_view payload)
{
    ByteReader in(payload);
    CapturedIdeal ideal;
    ideal.tooth = in.takeText();
    ideal.fdi = in.take<std::int32_t>();
    ideal.seed = in.take<std::uint64_t>();
    ideal.surface = in.take<std::uint64_t>();
    ideal.grid.side = in.take<std::int32_t>();
    for (double* const number :
         {&ideal.grid.cellMm, &ideal.grid.originMm.x, &ideal.grid.originMm.y, &ideal.tolerances.outlineMm,
          &ideal.tolerances.depthMm, &ideal.tolerances.wallDeg, &ideal.tolerances.floorMm})
        *number = in.take<double>();
    const auto hasIsthmus = in.take<std::uint8_t>();
    grading::Preparation::Isthmus isthmus;
    for (double* const number :
         {&isthmus.atMm.x, &isthmus.atMm.y, &isthmus.across.x, &isthmus.across.y, &isthmus.lengthMm})
        *number = in.take<double>();
    const auto sources = in.take<std::uint32_t>();
    const terrain::Grid& grid = ideal.grid;
    if (!in.ok() || grid.side < terrain::kMinGridSide || grid.side > terrain::kMaxGridSide || hasIsthmus > 1 ||
        sources > kMostSources || !isWords(ideal.tooth) || !checkTolerances(ideal.tolerances) ||
        !(grid.cellMm > 0.0 && grid.cellMm < 10.0) || !isPlace(grid.originMm.x) || !isPlace(grid.originMm.y))
        return std::nullopt;
    for (std::uint32_t k = 0; k < sources; ++k)
        ideal.sources.push_back(in.takeText());
    if (!std::all_of(ideal.sources.begin(), ideal.sources.end(), isWords))
        return std::nullopt;
    if (hasIsthmus != 0) {
        const double across = std::hypot(isthmus.across.x, isthmus.across.y);
        if (!isPlace(isthmus.atMm.x) || !isPlace(isthmus.atMm.y) || !(std::abs(across - 1.0) < 1.0e-6) ||
            !(isthmus.lengthMm >= 0.0 && isthmus.lengthMm < 100.0))
            return std::nullopt;
        ideal.isthmus = isthmus;
    }
    if (in.left() < grid.count())
        return std::nullopt;
    std::size_t cut = 0;
    ideal.parts.resize(grid.count());
    for (Part& part : ideal.parts) {
        const auto value = in.take<std::uint8_t>();
        if (value > static_cast<std::uint8_t>(Part::Wall))
            return std::nullopt;
        part = static_cast<Part>(value);
        cut += part != Part::Keep ? 1 : 0;
    }
    if (in.left() != 4 * cut || cut == 0)
        return std::nullopt;
    ideal.heightsMm = takeHeights(in, cut);
    const bool areHeights = std::all_of(ideal.heightsMm.begin(), ideal.heightsMm.end(), [](float height) {
        return height == terrain::kEmptyTop || std::abs(height) < kHighestMm;
    });
    return in.ok() && areHeights ? std::optional(std::move(ideal)) : std::nullopt;
}

tl::unexpected<Error> damaged()
{
    return unexpected(ErrorCode::BadStructure,
                      LocalizableText{"The captured ideal is damaged. Use a copy of the file, or capture it again."});
}

template <class T>
void addTo(std::uint64_t& hash, std::span<const T> values)
{
    hash = fnv1a({reinterpret_cast<const char*>(values.data()), values.size_bytes()}, hash);
}

}  // namespace

std::uint64_t surfaceHash(const terrain::ToothAnatomy& anatomy)
{
    ByteWriter grid;
    grid.put(static_cast<std::int32_t>(anatomy.grid.side));
    grid.put(anatomy.grid.cellMm);
    grid.put(anatomy.grid.originMm.x);
    grid.put(anatomy.grid.originMm.y);
    std::uint64_t hash = fnv1a(grid.bytes());
    addTo(hash, std::span<const float>(anatomy.top));
    addTo(hash, std::span<const float>(anatomy.bottom));
    return hash;
}

Result<CapturedIdeal> capture(std::span<const terrain::Tooth* const> attempts, const Tolerances& tolerances,
                              std::vector<std::string> sources)
{
    if (Status sound = checkTolerances(tolerances); !sound)
        return tl::unexpected(sound.error());
    const auto mean = averagePreparation(attempts);
    if (!mean)
        return tl::unexpected(mean.error());
    const terrain::ToothAnatomy& anatomy = *attempts.front()->anatomy;
    CapturedIdeal ideal{anatomy.name, anatomy.fdi, anatomy.seed, surfaceHash(anatomy), anatomy.grid,
                        mean->parts,  {},          {},           tolerances,           std::move(sources)};
    for (std::size_t k = 0; k < ideal.parts.size(); ++k)
        if (ideal.parts[k] != Part::Keep)
            ideal.heightsMm.push_back((*mean->top)[k]);
    ideal.isthmus = isthmusIn(*mean, anatomy);
    ideal.tooth = shortened(std::move(ideal.tooth));
    ideal.sources.resize(std::min(ideal.sources.size(), kMostSources));
    for (std::string& source : ideal.sources)
        source = shortened(std::move(source));
    return ideal;
}

Result<grading::Preparation> preparationOf(const CapturedIdeal& ideal, const terrain::ToothAnatomy& anatomy)
{
    if (ideal.surface != surfaceHash(anatomy) || !(ideal.grid == anatomy.grid)) {
        return unexpected(
            ErrorCode::BadStructure,
            LocalizableText{
                "The ideal was captured on the tooth '%1' (seed %2, grid %3) and does not fit '%4' (seed %5, grid %6); "
                "name that tooth, seed and grid, or capture it on this one.",
                {noted(ideal.tooth), noted(std::to_string(ideal.seed)), noted(std::to_string(ideal.grid.side)),
                 noted(anatomy.name), noted(std::to_string(anatomy.seed)), noted(std::to_string(anatomy.grid.side))}});
    }
    std::vector<float> top = anatomy.top;
    auto height = ideal.heightsMm.begin();
    for (std::size_t k = 0; k < top.size(); ++k)
        if (ideal.parts[k] != Part::Keep)
            top[k] = *height++;
    return grading::Preparation{std::make_shared<const std::vector<float>>(std::move(top)), ideal.parts, ideal.isthmus};
}

std::string toBytes(const CapturedIdeal& ideal)
{
    const std::string packed = recording::pack(payloadOf(ideal));
    ByteWriter out;
    out.putAll(std::span(kMagic.data(), kMagic.size()));
    out.put(kCapturedVersion);
    out.put(static_cast<std::uint64_t>(packed.size()));
    out.put(fnv1a(packed));
    out.putAll(std::span(packed.data(), packed.size()));
    return out.bytes();
}

Result<CapturedIdeal> capturedFrom(std::string_view bytes)
{
    if (bytes.empty())
        return unexpected(ErrorCode::FileEmpty, LocalizableText{"The captured ideal is empty; choose another file."});
    ByteReader in(bytes);
    const std::string_view magic = bytes.substr(0, kMagic.size());
    if (magic != kMagic.substr(0, magic.size()))
        return unexpected(
            ErrorCode::WrongKind,
            LocalizableText{"This is not a captured ideal; choose a file that Cusp has saved as one (*.cuspideal)."});
    static_cast<void>(in.takeBytes(kMagic.size()));
    const auto version = in.take<std::uint32_t>();
    if (in.ok() && version > kCapturedVersion)
        return unexpected(
            ErrorCode::NewerVersion,
            LocalizableText{"The captured ideal is of version %1, this Cusp reads up to version %2; open it with a "
                            "newer Cusp.",
                            {noted(std::to_string(version)), noted(std::to_string(kCapturedVersion))}});
    if (in.ok() && version == 0)
        return damaged();
    const auto size = in.take<std::uint64_t>();
    const auto checksum = in.take<std::uint64_t>();
    if (!in.ok() || size > in.left())
        return unexpected(
            ErrorCode::FileTruncated,
            LocalizableText{"The captured ideal ends early: it was cut off while being written or copied. Use a "
                            "whole copy."});
    const std::string_view packed = in.takeBytes(static_cast<std::size_t>(size));
    if (in.left() != 0 || fnv1a(packed) != checksum)
        return damaged();
    const auto payload = recording::unpack(packed, kLargestCapturedBytes);
    auto ideal = payload ? idealFrom(*payload) : std::nullopt;
    if (!ideal)
        return damaged();
    return std::move(*ideal);
}

Result<CapturedIdeal> readCaptured(const std::filesystem::path& path)
{
    std::error_code failure;
    const auto status = std::filesystem::status(path, failure);
    if (!std::filesystem::exists(status))
        return unexpected(ErrorCode::FileMissing,
                          "There is no captured ideal at " + path.string() + "; check the name.");
    if (!std::filesystem::is_regular_file(status))
        return unexpected(ErrorCode::FileUnreadable, path.string() + " is not a file; name a captured ideal.");
    const std::uintmax_t size = std::filesystem::file_size(path, failure);
    if (!failure && size > kLargestCapturedBytes)
        return unexpected(ErrorCode::FileTooLarge,
                          path.string() + " is larger than any captured ideal; choose another file.");
    std::ifstream file(path, std::ios::binary);
    if (failure || !file)
        return unexpected(ErrorCode::FileUnreadable,
                          "The captured ideal " + path.string() + " cannot be opened; check its rights.");
    std::string bytes(static_cast<std::size_t>(size), '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    auto ideal = capturedFrom(bytes);
    if (!ideal)
        return unexpected(ideal.error().code, path.string() + ": " + ideal.error().detail);
    return ideal;
}

Status writeCaptured(const std::filesystem::path& path, const CapturedIdeal& ideal)
{
    return writeWhole(path, toBytes(ideal), "The captured ideal");
}

}  // namespace core::preparation
