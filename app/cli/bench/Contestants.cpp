// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bench/Contestants.h"

#include <vector>

#include "core/contact/ContactMethod.h"
#include "lab/Contestant.h"

namespace app::cli::bench {
namespace {

/// What we ship, but for the method: the lab names them all.
std::vector<Contestant> everyone()
{
    std::vector<Contestant> list;
    for (const std::string_view name : lab::contestants()) {
        core::session::ServoSettings settings;
        settings.method = name;
        list.push_back({std::string(name), settings, static_cast<LookIndex>(list.size())});
    }
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
            if (core::contact::makeContactMethod(one.settings.method))
                methods.push_back(&one);
        return methods;
    }();
    return list;
}

}  // namespace app::cli::bench
