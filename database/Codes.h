// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>

#include "core/base/Result.h"
#include "database/Person.h"

namespace database {

/// Writes the one-time codes of new people as CSV (username, name, code) to a file that only its owner may read.
/// The file is on the disk when this function returns. FileUnwritable if that fails.
[[nodiscard]] core::Status writeCodes(const QString& path, const std::vector<RosterPerson>& people);

}  // namespace database
