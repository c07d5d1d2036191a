// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/Contestants.h"

#include <array>
#include <vector>

#include "core/contact/ContactMethod.h"
#include "lab/Contestant.h"

namespace bench {
namespace {

/// Returns the shipped contact with every method that the lab names.
std::vector<Contestant> everyone()
{
    std::vector<Contestant> list;
    for (const std::string_view name : lab::contestants()) {
        core::servo::ServoSettings settings;
        settings.method = name;
        list.push_back({std::string(name), settings, static_cast<LookIndex>(list.size())});
    }
    return list;
}

}  // namespace

ui::charts::Line lineOf(const QString& name, LookIndex look)
{
    using ui::charts::Line;
    using ui::charts::Mark;
    // Colours: Okabe & Ito 2008, except their yellow, which is too pale for a line on white.
    static const std::array<Line, 5> looks{{
        {{}, {}, Mark::Circle, true, QColor(0x00, 0x72, 0xB2), Qt::SolidLine},
        {{}, {}, Mark::Square, true, QColor(0xD5, 0x5E, 0x00), Qt::DashLine},
        {{}, {}, Mark::Triangle, true, QColor(0x00, 0x9E, 0x73), Qt::DotLine},
        {{}, {}, Mark::Diamond, true, QColor(0xCC, 0x79, 0xA7), Qt::DashDotLine},
        {{}, {}, Mark::Pentagon, true, QColor(0xE6, 0x9F, 0x00), Qt::DashDotDotLine},
    }};
    Line line = looks[static_cast<std::size_t>(look) % looks.size()];
    line.name = name;
    return line;
}

ui::charts::Dot pointAt(double x, double y, const QString& note)
{
    ui::charts::Dot dot{x, y, note};
    dot.note = note;
    return dot;
}

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

}  // namespace bench
