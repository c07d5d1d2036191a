// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/Sodium.h"

#include <sodium.h>

namespace database {

bool beginSodium()
{
    return sodium_init() >= 0;
}

std::string hexOf(const unsigned char* bytes, std::size_t count)
{
    std::string hex(2 * count + 1, '\0');
    sodium_bin2hex(hex.data(), hex.size(), bytes, count);
    hex.pop_back();
    return hex;
}

}  // namespace database
