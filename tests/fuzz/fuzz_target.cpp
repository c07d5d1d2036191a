// SPDX-License-Identifier: GPL-3.0-or-later
// The source of every fuzz target. CMake defines which exercise it runs.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/Exercises.h"

#ifndef CUSP_EXERCISE  // clang-tidy compiles this file without the definition from CMake
#define CUSP_EXERCISE exerciseMesh
#endif

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::CUSP_EXERCISE({reinterpret_cast<const char*>(data), size});
    return 0;
}
