// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QSqlDatabase>

#include "core/base/Result.h"
#include "database/Finding.h"

namespace database::sql {

/// Whether tables, indexes and triggers (of a server columns and constraints, too) are those that the migrations made:
/// an index that is gone lets an attempt arrive twice, a trigger that is gone lets the audit be changed, and one that
/// somebody added changes what is written, or refuses it. What a server has is compared with what the migrations make
/// there, in a schema that is gone when this returns; where its user may not create one, names alone are compared, and
/// that is said.
/// @param say  is told each that is missing, changed or foreign
/// @param note  is told what could not be compared
[[nodiscard]] core::Status checkSchema(const QSqlDatabase& db, const std::function<void(const Finding&)>& say,
                                       const std::function<void(const Finding&)>& note);

}  // namespace database::sql
