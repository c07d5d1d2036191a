// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace fuzz {

/// Reads the bytes as each mesh format in turn and takes whatever comes out through analysis, placement, patching and
/// rasterising. Aborts when a promise of the readers is broken: an index out of range, a number that is not finite.
void exerciseMesh(std::string_view bytes);

}  // namespace fuzz
