// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/base/Result.h"
#include "core/grading/Preparation.h"
#include "core/terrain/Tooth.h"

namespace core::preparation {

/// Returns the mean of an instructor's attempts at one tooth, or the only one, as an ideal.
///
/// A column belongs to the ideal if more than half of the attempts cut it (by 0.02 mm or more: a brush is no cut). If
/// exactly half did, it belongs if the mean of the outlines encloses it: if it is farther inside those that cut it than
/// outside the others. Its height is the mean of those that cut it; a column that they cut through is empty. It is
/// Floor if the mean surface is flatter than 45 degrees, and Wall if it is steeper, measured over 0.3 mm, or borders on
/// a kept column.
///
/// Any thread. Errors, one sentence each: there is no attempt, two are of different teeth, or they have no cut in
/// common.
[[nodiscard]] Result<grading::Preparation> averagePreparation(std::span<const terrain::Tooth* const> attempts);

}  // namespace core::preparation
