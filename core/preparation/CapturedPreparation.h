// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/base/Result.h"
#include "core/grading/Preparation.h"
#include "core/terrain/Tooth.h"

namespace core::preparation {

/// The ideal that an instructor shows: the mean of his attempts at one tooth, or the one he made.
///
/// A column belongs to it where more than half of the attempts cut it (by 0.02 mm or more: a brush is no cut), and
/// where just half of them did, if the mean of their outlines encloses it: it lies farther inside theirs than outside
/// the others'. Its height is the mean of theirs, and of those that went through it, empty. It is Floor where the mean
/// surface is flatter than 45 degrees and Wall where it is steeper, seen over 0.3 mm, and where it borders on what is
/// kept.
///
/// Any thread. An error says in one sentence that there is no attempt, that two are of different teeth, or that they
/// have no cut in common.
[[nodiscard]] Result<grading::Preparation> averagePreparation(std::span<const terrain::Tooth* const> attempts);

}  // namespace core::preparation
