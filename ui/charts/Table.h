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

/// As RFC 4180 has it, in UTF-8: a comma between cells, CR LF after each row, a quote doubled in quotes. Numbers are
/// written in the C locale whatever the user's language; what is not finite stays empty. Words that a spreadsheet would
/// take for a formula (they begin with = + - @ or a control character) get an apostrophe before them.
[[nodiscard]] QByteArray csv(const Table& table);

/// The numbers of a chart: one row a value, times as "2026-11-20T10:15:00Z".
[[nodiscard]] Table tableOf(const Chart& chart);

}  // namespace ui::charts
