// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/Result.h"

namespace core {

/// A number of a struct that users may set, with its name and range: the same for files, editors and tests. The default
/// is that of the struct's initialiser.
template <class Design>
struct NumberField
{
    const char* id;    ///< in files
    const char* name;  ///< in sentences, after "the"
    const char* unit;  ///< empty: no unit
    double Design::*value;
    double minimum;
    double maximum;
    bool whole = false;
};

/// Returns a number as people write it: up to three decimals without trailing zeros; from 1e12 on, the shortest form of
/// the double.
[[nodiscard]] inline std::string plainNumber(double value)
{
    if (!(std::abs(value) < 1.0e12)) {  // its thousandths fit no integer
        std::array<char, 32> written{};
        return {written.data(), std::to_chars(written.data(), written.data() + written.size(), value).ptr};
    }
    const auto thousandths = static_cast<long long>(std::llround(std::abs(value) * 1000.0));
    std::string text = value < 0.0 && thousandths != 0 ? "-" : "";
    text += std::to_string(thousandths / 1000);
    if (thousandths % 1000 != 0) {
        text += '.';
        text += std::to_string(1000 + thousandths % 1000).substr(1);
        text.erase(text.find_last_not_of('0') + 1);
    }
    return text;
}

/// Checks that every number is in its range, and whole if it must be. The error names the first that is not.
template <class Design>
[[nodiscard]] Status validateNumbers(std::span<const NumberField<Design>> fields, const Design& design)
{
    for (const NumberField<Design>& field : fields) {
        const double value = design.*field.value;
        std::vector<LocalizableText> values{{field.name}, noted(field.id), noted(plainNumber(value))};
        if (!std::isfinite(value))
            return unexpected(ErrorCode::BadNumber, LocalizableText{"the %1 (%2) is not a number", std::move(values)});
        if (value < field.minimum || value > field.maximum) {
            values.insert(values.end(),
                          {noted(plainNumber(field.minimum)), noted(plainNumber(field.maximum)), {field.unit}});
            return unexpected(ErrorCode::OutOfRange,
                              LocalizableText{*field.unit == '\0' ? "the %1 (%2) must be from %4 to %5, not %3"
                                                                  : "the %1 (%2) must be from %4 to %5 %6, not %3",
                                              std::move(values)});
        }
        if (field.whole && value != std::floor(value))
            return unexpected(ErrorCode::OutOfRange,
                              LocalizableText{"the %1 (%2) must be a whole number, not %3", std::move(values)});
    }
    return {};
}

/// Sets the number with this id. UnknownName lists the known ids.
template <class Design>
[[nodiscard]] Status setNumber(std::span<const NumberField<Design>> fields, Design& design, std::string_view id,
                               double value)
{
    std::string known;
    for (const NumberField<Design>& field : fields) {
        if (id == field.id) {
            design.*field.value = value;
            return {};
        }
        known += (known.empty() ? "" : ", ") + std::string(field.id);
    }
    return unexpected(ErrorCode::UnknownName,
                      LocalizableText{"there is no size \"%1\"; there are %2", {noted(std::string(id)), noted(known)}});
}

}  // namespace core
