// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/MeshReader.h"

#include <cstdio>
#include <memory>
#include <system_error>

#include "core/mesh/FormatReaders.h"
#include "core/mesh/TextScanner.h"

namespace core::mesh {
namespace {

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
    Result<MeshFile> file = format == MeshFormat::Obj   ? readObj(bytes, name)
                            : format == MeshFormat::Stl ? readStl(bytes, name)
                                                        : readPly(bytes, name);
    if (file)
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
