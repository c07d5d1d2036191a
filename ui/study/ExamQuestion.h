// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QString>

#include "lessons/Lesson.h"
#include "ui/shell/QuestionCard.h"

namespace ui::study {

/// The card before an exam: its time, the attempts, and what is locked. The clock starts with "Begin exam".
/// @param attempts  used so far and left, in words
/// @param begin     starts the exam
[[nodiscard]] shell::QuestionCard::Question examQuestion(const ::lessons::Lesson& exam, const QString& attempts,
                                                         std::function<void()> begin);

}  // namespace ui::study
