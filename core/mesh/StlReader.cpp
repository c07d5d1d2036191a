// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/mesh/FormatReaders.h"
#include "core/mesh/TextScanner.h"

namespace core::mesh {
namespace {

constexpr std::size_t kHeaderBytes = 84;  // 80 of text, 4 of count
constexpr std::size_t kRecordBytes = 50;  // normal, three corners, two unused bytes
constexpr std::size_t kNormalBytes = 12;

std::uint32_t littleEndian(std::string_view bytes, std::size_t at)
{
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 4; ++k)
        word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + k])) << (8 * k);
    return word;
}

/// Returns "1 triangle", "3 triangles" and so on.
std::string counted(std::size_t triangles)
{
    return std::to_string(triangles) + (triangles == 1 ? " triangle" : " triangles");
}

Status addTriangle(MeshFile& file, const std::array<glm::vec3, 3>& corners, std::string_view name)
{
    if (file.mesh.triangles.size() == kMaxTriangles)
        return tooManyTriangles(name);
    const auto first = static_cast<std::uint32_t>(file.mesh.vertices.size());
    file.mesh.vertices.insert(file.mesh.vertices.end(), corners.begin(), corners.end());
    file.mesh.triangles.push_back({first, first + 1, first + 2});
    return {};
}

Result<MeshFile> readBinary(std::string_view bytes, std::uint32_t count, const std::string& name)
{
    if (count > kMaxTriangles)
        return tooManyTriangles(name);
    MeshFile file;
    file.mesh.vertices.reserve(3 * static_cast<std::size_t>(count));
    file.mesh.triangles.reserve(count);
    for (std::size_t t = 0; t < count; ++t) {
        std::array<glm::vec3, 3> corners{};
        std::size_t at = kHeaderBytes + kRecordBytes * t + kNormalBytes;
        for (glm::vec3& corner : corners)
            for (int k = 0; k < 3; ++k, at += 4) {
                corner[k] = std::bit_cast<float>(littleEndian(bytes, at));
                if (!std::isfinite(corner[k]))
                    return unexpected(ErrorCode::BadNumber, name + ", triangle " + std::to_string(t + 1) +
                                                                ": a coordinate is not a finite number; export the "
                                                                "mesh again");
            }
        if (Status status = addTriangle(file, corners, name); !status)
            return tl::unexpected(std::move(status).error());
    }
    if (count == 0)
        return unexpected(ErrorCode::NoTriangles, name + " states 0 triangles; export the mesh again");
    const std::size_t extra = bytes.size() - kHeaderBytes - kRecordBytes * count;
    if (extra > 0 && extra % kRecordBytes == 0)
        file.warnings.push_back("the header states " + counted(count) + ", but " +
                                std::to_string(count + extra / kRecordBytes) +
                                " are there; the rest was passed over, so the mesh may not be whole");
    else if (extra > 0)
        file.warnings.push_back(std::to_string(extra) + (extra == 1 ? " byte" : " bytes") +
                                " after the last triangle passed over");
    return file;
}

Result<MeshFile> readAscii(std::string_view text, const std::string& name)
{
    MeshFile file;
    std::array<glm::vec3, 3> corners{};
    std::size_t corner = 0;
    bool ended = false;
    Lines lines(text);
    const auto failure = [&](ErrorCode code, const std::string& what) {
        return unexpected(code,
                          name + ", line " + std::to_string(lines.number()) + ": " + what + "; export the mesh again");
    };
    for (std::string_view line; lines.next(line);) {
        const std::string_view keyword = takeWord(line);
        if (equalsIgnoringCase(keyword, "vertex")) {
            if (corner == 3)
                return failure(ErrorCode::BadStructure, "a facet with more than three corners");
            for (int k = 0; k < 3; ++k) {
                const std::string_view word = takeWord(line);
                const auto number = finiteNumber(word);
                if (!number)
                    return failure(ErrorCode::BadNumber, "the coordinate " + quoted(word) + " is not a finite number");
                corners[corner][k] = *number;
            }
            ++corner;
        } else if (equalsIgnoringCase(keyword, "endfacet")) {
            if (corner != 3)
                return failure(ErrorCode::BadStructure, "a facet with fewer than three corners");
            if (Status status = addTriangle(file, corners, name); !status)
                return tl::unexpected(std::move(status).error());
            corner = 0;
        } else if (equalsIgnoringCase(keyword, "endsolid")) {
            ended = true;
        }
    }
    if (file.mesh.triangles.empty())
        return unexpected(corner > 0 ? ErrorCode::FileTruncated : ErrorCode::WrongKind,
                          name + " begins like an ASCII STL but holds no whole facet; check that it is the mesh you "
                                 "meant");
    if (corner != 0 || !ended)
        return unexpected(ErrorCode::FileTruncated, name + " is cut short: it ends after " +
                                                        counted(file.mesh.triangles.size()) +
                                                        " without \"endsolid\"; copy the file again");
    return file;
}

}  // namespace

Result<MeshFile> readStl(std::string_view bytes, std::string_view name)
{
    const std::string file(name);
    // Binary files may also begin with "solid". A file is binary if its size matches the count exactly.
    const bool hasHeader = bytes.size() >= kHeaderBytes;
    const std::uint32_t count = hasHeader ? littleEndian(bytes, kHeaderBytes - 4) : 0;
    const std::uint64_t stated = kHeaderBytes + kRecordBytes * static_cast<std::uint64_t>(count);
    std::string_view start = withoutMark(bytes).substr(0, 512);
    const bool solid = equalsIgnoringCase(takeWord(start).substr(0, 5), "solid");
    const bool text = bytes.substr(0, 4096).find('\0') == std::string_view::npos;
    if (hasHeader && bytes.size() == stated)
        return readBinary(bytes, count, file);
    if (solid && text)
        return readAscii(withoutMark(bytes), file);
    if (text)
        return unexpected(ErrorCode::WrongKind, file + " is not an STL file: neither binary of its stated length nor "
                                                       "text that begins with \"solid\"; check that it is the mesh "
                                                       "you meant");
    if (!hasHeader)
        return unexpected(ErrorCode::FileTruncated, file + " is cut short: " + std::to_string(bytes.size()) +
                                                        " bytes are less than an STL header; copy the file again");
    if (bytes.size() < stated)
        return unexpected(ErrorCode::FileTruncated, file + " is cut short: its header states " + counted(count) +
                                                        ", of which only " +
                                                        std::to_string((bytes.size() - kHeaderBytes) / kRecordBytes) +
                                                        " can be there; copy the file again");
    return readBinary(bytes, count, file);
}

}  // namespace core::mesh
