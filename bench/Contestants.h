// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include <QString>

#include "core/servo/ServoTick.h"
#include "ui/charts/Chart.h"

namespace bench {

/// Index of the colour, mark and stroke of a method: the same in every chart.
using LookIndex = int;

/// Returns a line that differs from those of other looks by mark and stroke as well as colour.
[[nodiscard]] ui::charts::Line lineOf(const QString& name, LookIndex look);

/// Returns a point with a note beside it.
[[nodiscard]] ui::charts::Dot pointAt(double x, double y, const QString& note);

/// A servo with its settings that is measured.
struct Contestant
{
    std::string name;  ///< in tables and charts
    core::servo::ServoSettings settings;
    LookIndex look = 0;

    [[nodiscard]] QString text() const { return QString::fromStdString(name); }
    [[nodiscard]] QString key() const;  ///< for keys of figures: snake_case
};

/// Returns one for each of lab::contestants(), in the order of tables and charts; ours is the first.
[[nodiscard]] std::span<const Contestant> contestants();
/// Returns those with a contact method that can be measured without the loop around it.
[[nodiscard]] std::span<const Contestant* const> contactMethods();

}  // namespace bench
