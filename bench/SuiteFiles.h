// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QStringList>

#include "bench/Suites.h"

namespace bench {

/// Writes bench-SUITE.csv and bench-SUITE.json and, for each chart, bench-CHART.svg and bench-CHART.png.
/// @return the names of the files, in that order
[[nodiscard]] core::Result<QStringList> writeFiles(const QDir& folder, const QString& suite, const Figures& figures,
                                                   const QList<NamedChart>& charts);

}  // namespace bench
