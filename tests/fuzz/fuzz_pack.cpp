// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <cstdint>

#include "core/recording/Format.h"
#include "tests/fuzz/ExerciseLesson.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    fuzz::exercisePack(bytes);
    fuzz::exercisePack(core::recording::pack(bytes));
    return 0;
}
