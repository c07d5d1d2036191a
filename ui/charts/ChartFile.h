// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "ui/charts/Chart.h"

namespace ui::charts {

/// What became of a file, as a sentence.
struct Written
{
    bool isDone = false;
    QString told;
};

/// Writes .png, .svg or .csv, by the name's ending. An older file survives any failure. Ui thread.
[[nodiscard]] Written writeChart(const Chart& chart, const QString& path);

}  // namespace ui::charts
