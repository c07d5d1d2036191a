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

/// Fills a new file or an empty database with a school: students "s0001" to "s0200" and so on, in classes with a
/// teacher each ("teacher1", "teacher2"), and their attempts at the shipped lessons, in which they get better and
/// faster. The same seed gives the same school except for its uids. Returns the password of the user "admin".
[[nodiscard]] core::Result<std::string> makeSchool(const QString& where, const SampleSize& size);

}  // namespace support
