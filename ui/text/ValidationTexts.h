// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/base/LocalizableText.h"
#include "lessons/ValidationIssue.h"

/// Texts about errors in the file of a lesson or a hardness preset, in the user's language.
namespace ui::text {

/// Returns the error alone: "is missing; name the preparation".
[[nodiscard]] QString faultWords(const core::LocalizableText& what);
/// Returns the error with file and key: "deep-36.lesson.json, ideal.kind: is missing; name the preparation".
[[nodiscard]] QString faultWords(const lessons::ValidationIssue& fault);

}  // namespace ui::text
