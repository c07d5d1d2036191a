// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace core::history {

/// Identifies a moment of the tooth that the user can return to (UndoTree). 0 is no moment.
enum class MomentId : std::uint64_t {};

}  // namespace core::history
