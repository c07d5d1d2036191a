// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>
#include <vector>

#include <QString>

#include "core/base/LocalizableText.h"

namespace lessons {

/// A fault in the file of a lesson or a hardness preset.
struct ValidationIssue
{
    QString file;
    QString key;                 ///< "rubric.criteria[2].weight"; empty: the whole file
    core::LocalizableText what;  ///< the fault and what to do; marked for translation in the context "Fault"
    bool grave = true;           ///< the lesson is not usable; otherwise a warning

    [[nodiscard]] QString english() const;   ///< the fault
    [[nodiscard]] QString sentence() const;  ///< the fault with its place, in English
};

[[nodiscard]] bool anyGrave(const std::vector<ValidationIssue>& faults);

/// Marks a name or a number from a file as text that is not translated.
[[nodiscard]] inline core::LocalizableText noted(const QString& text)
{
    return core::noted(text.toStdString());
}
template <class Number>
requires std::is_arithmetic_v<Number>
[[nodiscard]] core::LocalizableText noted(Number number)
{
    return noted(QString::number(number));
}

}  // namespace lessons
