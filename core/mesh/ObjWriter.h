// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/Result.h"
#include "core/mesh/TriangleMesh.h"

namespace core::mesh {

/// Writes a mesh as Wavefront OBJ: `#` lines of the comment, `v` lines with six decimals, `f` lines. Independent of the
/// locale.
///
/// The file is written completely or not at all (writeWhole()).
[[nodiscard]] Status writeObj(const std::filesystem::path& path, const TriangleMesh& mesh, std::string_view comment);

}  // namespace core::mesh
