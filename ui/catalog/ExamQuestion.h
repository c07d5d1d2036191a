// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QString>

#include "lessons/Lesson.h"
#include "ui/kit/ConfirmOverlay.h"

namespace ui::catalog {

/// Returns the question shown before an exam: its time, the attempts, and the locked aids.
/// @param attempts  attempts so far and attempts left, in words
/// @param begin     called when the user accepts
[[nodiscard]] kit::ConfirmOverlay::Question examQuestion(const ::lessons::Lesson& exam, const QString& attempts,
                                                         std::function<void()> begin);

}  // namespace ui::catalog
