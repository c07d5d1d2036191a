// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include "core/teeth/ToothBuilder.h"

namespace ui::text {

/// Returns what the importer assumed, left out or did not understand, one sentence each. Empty if there is nothing to
/// report.
[[nodiscard]] QStringList scanNotes(const core::teeth::ToothReport& report);

}  // namespace ui::text
