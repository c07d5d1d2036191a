// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/ExerciseIdeal.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    fuzz::exerciseIdeal(bytes);
    fuzz::exerciseIdeal(fuzz::idealWithChecksum(bytes));
    fuzz::exerciseIdeal(fuzz::packedIdeal(bytes));
    return 0;
}
