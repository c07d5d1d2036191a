// SPDX-License-Identifier: GPL-3.0-or-later
// Every fuzz target: CMake tells it which exercise it is.
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
