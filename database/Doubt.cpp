// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/Doubt.h"

#include <algorithm>
#include <array>
#include <utility>

namespace database {
namespace {

constexpr std::array kDoubts{std::pair(Doubt::None, ""), std::pair(Doubt::Version, "version"),
                             std::pair(Doubt::Recording, "recording"), std::pair(Doubt::Score, "score"),
                             std::pair(Doubt::Start, "start")};

}  // namespace

std::string doubtId(Doubt doubt)
{
    return std::find_if(kDoubts.begin(), kDoubts.end(), [&](const auto& one) { return one.first == doubt; })->second;
}

Doubt doubtNamed(std::string_view id)
{
    const auto* const found =
        std::find_if(kDoubts.begin(), kDoubts.end(), [&](const auto& one) { return id == one.second; });
    return found == kDoubts.end() ? Doubt::Score : found->first;
}

}  // namespace database
