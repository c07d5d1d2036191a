// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/MeshReader.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>
#include <system_error>

#include <glm/common.hpp>

#include "core/mesh/FormatReaders.h"
#include "core/mesh/TextScanner.h"

namespace core::mesh {
namespace {

constexpr double kFarInSizes = 64.0;

struct CloseFile
{
    void operator()(std::FILE* file) const { std::fclose(file); }
};

Result<std::string> readBytes(const std::filesystem::path& path, const std::string& name)
{
    namespace fs = std::filesystem;
    std::error_code failure;
    const fs::file_status status = fs::status(path, failure);
    if (!fs::exists(status))
        return unexpected(ErrorCode::FileMissing, name + " does not exist; check the name");
    if (fs::is_directory(status))
        return unexpected(ErrorCode::FileUnreadable, name + " is a folder, not a mesh file; name a file in it");
    if (!fs::is_regular_file(status))
        return unexpected(ErrorCode::FileUnreadable, name + " is not a plain file; copy the mesh into one");
    const std::uintmax_t size = fs::file_size(path, failure);
    const std::unique_ptr<std::FILE, CloseFile> file(failure ? nullptr : std::fopen(path.c_str(), "rb"));
    if (!file)
        return unexpected(ErrorCode::FileUnreadable, name + " cannot be opened; check that you may read it");
    if (size == 0)
        return unexpected(ErrorCode::FileEmpty, name + " is empty (0 bytes); export the mesh again");
    if (size > kMaxFileBytes)
        return unexpected(ErrorCode::FileTooLarge,
                          name + " is larger than " + std::to_string(kMaxFileBytes >> 20U) +
                              " MiB, the most Cusp reads; reduce the mesh or save it in a binary format");
    std::string bytes(static_cast<std::size_t>(size), '\0');
    if (std::fread(bytes.data(), 1, bytes.size(), file.get()) != bytes.size())
        return unexpected(ErrorCode::FileUnreadable, name + " could not be read to its end; check the disk");
    return bytes;
}

/// Returns the end of a sentence if the first bytes show that the file is of another kind than its name says; otherwise
/// an empty text.
std::string otherKind(std::string_view bytes, MeshFormat format)
{
    if (bytes.starts_with("\x1F\x8B"))
        return "is compressed with gzip; unpack it first";
    if (bytes.starts_with("PK\x03\x04"))
        return "is a ZIP archive; unpack it first";
    using namespace std::string_view_literals;
    for (const std::string_view archive :
         {"BZh"sv, "\xFD\x37zXZ\0"sv, "\x28\xB5\x2F\xFD"sv, "7z\xBC\xAF\x27\x1C"sv, "Rar!\x1A\x07"sv})
        if (bytes.starts_with(archive))
            return "is an archive; unpack it first";
    for (const std::string_view other : {"%PDF"sv, "\x89PNG"sv, "\xFF\xD8\xFF"sv, "glTF"sv})
        if (bytes.starts_with(other))
            return "is no mesh but a document, a picture or a scene; export the mesh as OBJ, STL or PLY";
    // Text in UTF-16 without a mark: every second byte is 0.
    const auto isLetter = [](char c) { return c >= ' ' && c <= '~'; };
    const auto isWideFrom = [&](std::size_t zero) {
        return bytes.size() >= 4 && bytes[zero] == '\0' && bytes[zero + 2] == '\0' && isLetter(bytes[1 - zero]) &&
               isLetter(bytes[3 - zero]);
    };
    const bool isWide = isWideFrom(0) || isWideFrom(1);
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF") || isWide)
        return "is text in UTF-16; save it as plain text (ASCII or UTF-8)";
    const bool isPly = bytes.starts_with("ply\n") || bytes.starts_with("ply\r");
    if (isPly && format != MeshFormat::Ply)
        return "is a PLY file by its content; rename it so that it ends in .ply";
    std::string_view start = withoutMark(bytes).substr(0, kBytesThatTell);
    if (format != MeshFormat::Stl && looksLikeAsciiStl(start))
        return "is an STL file by its content; rename it so that it ends in .stl";
    const bool isText = start.find('\0') == std::string_view::npos;
    const bool isObj = isText && !isPly && !looksLikeAsciiStl(start) &&
                       (start.starts_with("v ") || start.find("\nv ") != std::string_view::npos);
    if (format != MeshFormat::Obj && isObj)
        return "is an OBJ file by its content; rename it so that it ends in .obj";
    return {};
}

/// Returns the point to which a mesh has to be moved before its coordinates are rounded to float; zero if it lies near
/// enough. 64 times its own size away, a tooth of 12 mm is still exact to 0.1 um.
glm::dvec3 neededOrigin(const TriangleMesh& mesh)
{
    glm::vec3 low(std::numeric_limits<float>::max());
    glm::vec3 high = -low;
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle) {
            low = glm::min(low, mesh.vertices[corner]);
            high = glm::max(high, mesh.vertices[corner]);
        }
    const glm::dvec3 size = glm::dvec3(high) - glm::dvec3(low);
    const glm::dvec3 farthest = glm::max(glm::abs(glm::dvec3(low)), glm::abs(glm::dvec3(high)));
    const auto largest = [](const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); };
    if (largest(farthest) <= kFarInSizes * largest(size))
        return glm::dvec3(0.0);
    return (glm::dvec3(low) + glm::dvec3(high)) * 0.5;
}

}  // namespace

tl::unexpected<Error> tooManyTriangles(std::string_view name)
{
    return unexpected(ErrorCode::FileTooLarge, std::string(name) + " has more than " + std::to_string(kMaxTriangles) +
                                                   " triangles or their corners, the most Cusp takes; reduce "
                                                   "(decimate) the mesh and try again");
}

tl::unexpected<Error> onlyThinFaces(std::string_view name)
{
    return unexpected(ErrorCode::NoTriangles, std::string(name) + " has faces, but each has fewer than three corners; "
                                                                  "export the surface, not its edges");
}

std::string thinFaces(std::size_t count)
{
    return std::to_string(count) + (count == 1 ? " face with fewer than three corners was passed over"
                                               : " faces with fewer than three corners were passed over");
}

Result<MeshFile> readMesh(std::string_view bytes, MeshFormat format, std::string_view name)
{
    if (const std::string kind = otherKind(bytes, format); !kind.empty())
        return unexpected(ErrorCode::WrongKind, std::string(name) + ' ' + kind);
    const auto read = format == MeshFormat::Obj ? readObj : format == MeshFormat::Stl ? readStl : readPly;
    Result<MeshFile> file = read(bytes, name, glm::dvec3(0.0));
    if (!file)
        return file;
    if (const glm::dvec3 origin = neededOrigin(file->mesh); origin != glm::dvec3(0.0)) {
        file->mesh = {};  // frees its memory first
        file = read(bytes, name, origin);
        if (!file)
            return file;
    }
    file->format = format;
    return file;
}

Result<MeshFile> readMesh(const std::filesystem::path& path)
{
    const std::string name = path.string();
    const std::string extension = path.extension().string();
    const bool obj = equalsIgnoringCase(extension, ".obj");
    const bool stl = equalsIgnoringCase(extension, ".stl");
    const bool ply = equalsIgnoringCase(extension, ".ply");
    Result<std::string> bytes = readBytes(path, name);
    if (!bytes)
        return tl::unexpected(std::move(bytes).error());
    if (!obj && !stl && !ply)
        return unexpected(ErrorCode::WrongKind,
                          name + " is not a mesh that Cusp reads; give a file that ends in .obj, .stl or .ply");
    return readMesh(*bytes, obj ? MeshFormat::Obj : stl ? MeshFormat::Stl : MeshFormat::Ply, name);
}

}  // namespace core::mesh
