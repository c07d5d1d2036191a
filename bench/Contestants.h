// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include <QString>

#include "core/servo/ServoTick.h"
#include "ui/charts/Chart.h"

namespace bench {

/// Which colour, mark and stroke a method has: the same in every chart.
using LookIndex = int;

/// A line that is told from those of other looks by mark and stroke as well.
[[nodiscard]] ui::charts::Line lineOf(const QString& name, LookIndex look);

/// A point with what is written beside it.
[[nodiscard]] ui::charts::Dot pointAt(double x, double y, const QString& note);

/// Someone who is measured: a servo with its settings.
struct Contestant
{
    std::string name;  ///< in tables and charts
    core::servo::ServoSettings settings;
    LookIndex look = 0;

    [[nodiscard]] QString text() const { return QString::fromStdString(name); }
    [[nodiscard]] QString key() const;  ///< for keys of figures: snake_case
};

/// Everyone that lab::contestants() names, in that order, which is that of tables and charts; ours is the first.
[[nodiscard]] std::span<const Contestant> contestants();
/// Those of them that have a contact method which can be tried without the loop around it.
[[nodiscard]] std::span<const Contestant* const> contactMethods();

}  // namespace bench
