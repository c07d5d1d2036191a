// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include <QString>

#include "core/base/Result.h"

namespace support {

struct SampleSize
{
    int students = 200;
    std::int64_t attempts = 10'000;
    std::uint64_t seed = 1;
};

/// Makes up a school in a new file or an empty database: students "s0001" ... in classes with a teacher each
/// ("teacher1"
/// ...), who get better and faster at the shipped lessons, each in their own measure. The same seed gives the same
/// school but for uids. Returns the password of "admin".
[[nodiscard]] core::Result<std::string> makeSchool(const QString& where, const SampleSize& size);

}  // namespace support
