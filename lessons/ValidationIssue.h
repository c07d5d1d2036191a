// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>
#include <vector>

#include <QString>

#include "core/base/LocalizableText.h"

namespace lessons {

/// Something wrong with a lesson's file, or with a hardness preset's.
struct ValidationIssue
{
    QString file;
    QString key;                 ///< "rubric.criteria[2].weight"; empty: the whole file
    core::LocalizableText what;  ///< what is wrong and what to do; marked for translation in the context "Fault"
    bool grave = true;           ///< the lesson cannot be given; else it only deserves a look

    [[nodiscard]] QString english() const;   ///< what is wrong
    [[nodiscard]] QString sentence() const;  ///< and where, in English as well
};

[[nodiscard]] bool anyGrave(const std::vector<ValidationIssue>& faults);

/// A name or a number, as it stands in a file.
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
