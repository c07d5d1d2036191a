// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bench/Contestants.h"

#include <algorithm>
#include <vector>

namespace app::cli::bench {
namespace {

/// What we ship, but for the contact method.
core::session::ServoSettings with(const char* method)
{
    core::session::ServoSettings settings;
    settings.method = method;
    return settings;
}

std::vector<Contestant> everyone()
{
    std::vector<Contestant> list{
        {"continuous", with("continuous")},
        {"lattice", with("lattice")},
        {"penalty", with("penalty")},
    };
    for (std::size_t k = 0; k < list.size(); ++k)
        list[k].look = static_cast<LookIndex>(k);
    return list;
}

}  // namespace

QString Contestant::key() const
{
    return text().replace(u' ', u'_');
}

std::span<const Contestant> contestants()
{
    static const std::vector<Contestant> list = everyone();
    return list;
}

std::span<const Contestant* const> contactMethods()
{
    static const std::vector<const Contestant*> list = [] {
        std::vector<const Contestant*> methods;
        for (const Contestant& one : contestants())
            if (std::none_of(methods.begin(), methods.end(),
                             [&](const Contestant* known) { return known->settings.method == one.settings.method; }))
                methods.push_back(&one);
        return methods;
    }();
    return list;
}

}  // namespace app::cli::bench
