// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <variant>

#include <QByteArray>
#include <QList>
#include <QString>
#include <QStringList>

#include "ui/charts/Chart.h"

namespace ui::charts {

using Cell = std::variant<QString, double, std::int64_t>;

struct Table
{
    QStringList heads;
    QList<QList<Cell>> rows;
    bool operator==(const Table&) const = default;
};

/// Returns CSV according to RFC 4180, in UTF-8: commas between cells, CR LF after each row, quotes doubled within
/// quotes. Numbers are in the C locale; non-finite values are empty. Text that a spreadsheet would evaluate as a
/// formula (it begins with = + - @ or a control character) gets an apostrophe in front.
[[nodiscard]] QByteArray csv(const Table& table);

/// Returns the numbers of a chart: one row per value, times as "2026-11-20T10:15:00Z".
[[nodiscard]] Table tableOf(const Chart& chart);

}  // namespace ui::charts
