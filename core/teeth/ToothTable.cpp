// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/ToothTable.h"

#include <algorithm>
#include <array>
#include <string>

namespace core::teeth {
namespace {

// fdi, crown height, root, MD, MD at the cervix, BL, BL at the cervix, CEJ curve mesial, distal
constexpr std::array<ToothSizes, 16> kSizes{{
    {21, 10.5, 13.0, 8.5, 7.0, 7.0, 6.0, 3.5, 2.5},
    {22, 9.0, 13.0, 6.5, 5.0, 6.0, 5.0, 3.0, 2.0},
    {23, 10.0, 17.0, 7.5, 5.5, 8.0, 7.0, 2.5, 1.5},
    {24, 8.5, 14.0, 7.0, 5.0, 9.0, 8.0, 1.0, 0.0},
    {25, 8.5, 14.0, 7.0, 5.0, 9.0, 8.0, 1.0, 0.0},
    {26, 7.5, 12.0, 10.0, 8.0, 11.0, 10.0, 1.0, 0.0},
    {27, 7.0, 11.0, 9.0, 7.0, 11.0, 10.0, 1.0, 0.0},
    {28, 6.5, 11.0, 8.5, 6.5, 10.0, 9.5, 1.0, 0.0},
    {31, 9.0, 12.5, 5.0, 3.5, 6.0, 5.3, 3.0, 2.0},
    {32, 9.5, 14.0, 5.5, 4.0, 6.5, 5.8, 3.0, 2.0},
    {33, 11.0, 16.0, 7.0, 5.5, 7.5, 7.0, 2.5, 1.0},
    {34, 8.5, 14.0, 7.0, 5.0, 7.5, 6.5, 1.0, 0.0},
    {35, 8.0, 14.5, 7.0, 5.0, 8.0, 7.0, 1.0, 0.0},
    {36, 7.5, 14.0, 11.0, 9.0, 10.5, 9.0, 1.0, 0.0},
    {37, 7.0, 13.0, 10.5, 8.0, 10.0, 9.0, 1.0, 0.0},
    {38, 7.0, 11.0, 10.0, 7.5, 9.5, 9.0, 1.0, 0.0},
}};

}  // namespace

std::span<const ToothSizes> toothSizes()
{
    return kSizes;
}

Result<ToothSizes> findToothSizes(int fdi)
{
    const auto found = std::find_if(kSizes.begin(), kSizes.end(), [&](const ToothSizes& t) { return t.fdi == fdi; });
    if (found != kSizes.end())
        return *found;
    return unexpected(ErrorCode::UnknownName,
                      "There is no generated tooth " + std::to_string(fdi) + "; choose 21 to 28 or 31 to 38.");
}

double buccalSign(int fdi)
{
    return fdi < 30 ? 1.0 : -1.0;
}

}  // namespace core::teeth
