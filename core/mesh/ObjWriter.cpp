// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/ObjWriter.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "core/base/WholeFile.h"

namespace core::mesh {
namespace {

void append(std::string& text, float value)
{
    char digits[64];
    const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, 6);
    text.append(digits, end.ptr);
}

void append(std::string& text, std::uint32_t value)
{
    char digits[16];
    const auto end = std::to_chars(digits, digits + sizeof digits, value);
    text.append(digits, end.ptr);
}

std::string objText(const TriangleMesh& mesh, std::string_view comment)
{
    std::string text;
    text.reserve(mesh.vertices.size() * 36 + mesh.triangles.size() * 24 + comment.size() + 64);
    while (!comment.empty()) {
        const std::size_t end = std::min(comment.find('\n'), comment.size());
        text.append("# ").append(comment.substr(0, end)).append("\n");
        comment.remove_prefix(std::min(end + 1, comment.size()));
    }
    for (const glm::vec3& v : mesh.vertices) {
        text += 'v';
        for (int axis = 0; axis < 3; ++axis) {
            text += ' ';
            append(text, v[axis]);
        }
        text += '\n';
    }
    for (const auto& triangle : mesh.triangles) {
        text += 'f';
        for (const std::uint32_t index : triangle) {
            text += ' ';
            append(text, index + 1);
        }
        text += '\n';
    }
    return text;
}

}  // namespace

Status writeObj(const std::filesystem::path& path, const TriangleMesh& mesh, std::string_view comment)
{
    return writeWhole(path, objText(mesh, comment), "The mesh");
}

}  // namespace core::mesh
