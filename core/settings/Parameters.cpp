// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/settings/Parameters.h"

#include <algorithm>
#include <cmath>

namespace core::settings {
namespace {

bool isBefore(const std::unique_ptr<const Parameter>& one, std::string_view name)
{
    return one->name < name;
}

}  // namespace

void Parameters::add(Parameter parameter)
{
    const auto at = std::lower_bound(m_all.begin(), m_all.end(), std::string_view(parameter.name), isBefore);
    auto made = std::make_unique<const Parameter>(std::move(parameter));
    if (at != m_all.end() && (*at)->name == made->name)
        *at = std::move(made);
    else
        m_all.insert(at, std::move(made));
}

const Parameter* Parameters::find(std::string_view name) const
{
    const auto at = std::lower_bound(m_all.begin(), m_all.end(), name, isBefore);
    return at != m_all.end() && (*at)->name == name ? at->get() : nullptr;
}

std::vector<const Parameter*> Parameters::matching(std::string_view text) const
{
    std::vector<const Parameter*> found;
    for (const auto& one : m_all)
        if (one->name.find(text) != std::string::npos)
            found.push_back(one.get());
    return found;
}

std::vector<const Parameter*> Parameters::beginningWith(std::string_view text) const
{
    std::vector<const Parameter*> found;
    for (const auto& one : m_all)
        if (one->name.starts_with(text))
            found.push_back(one.get());
    return found;
}

SetAnswer Parameters::set(std::string_view name, double value) const
{
    using Outcome = SetAnswer::Outcome;
    const Parameter* parameter = find(name);
    if (parameter == nullptr)
        return {Outcome::Unknown, {}};
    if (parameter->isLive())
        return {Outcome::ReadOnly, {}};
    if (!std::isfinite(value) || (parameter->isSwitch && value != 0.0 && value != 1.0))
        return {Outcome::NotANumber, {}};
    if (value < parameter->minimum || value > parameter->maximum)
        return {Outcome::OutOfRange, {}};
    std::string why = parameter->write(value);
    return {why.empty() ? Outcome::Done : Outcome::Refused, std::move(why)};
}

SetAnswer Parameters::reset(std::string_view name) const
{
    const Parameter* parameter = find(name);
    if (parameter == nullptr)
        return {SetAnswer::Outcome::Unknown, {}};
    return parameter->initial ? set(name, parameter->initial()) : SetAnswer{SetAnswer::Outcome::ReadOnly, {}};
}

}  // namespace core::settings
