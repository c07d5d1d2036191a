// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>

#include "core/base/Result.h"
#include "database/Person.h"

namespace database {

/// Writes the one-time codes of those who are new as CSV (username, name, code), in a file that only its owner may
/// read. FileUnwritable.
[[nodiscard]] core::Status writeCodes(const QString& path, const std::vector<RosterPerson>& people);

}  // namespace database
