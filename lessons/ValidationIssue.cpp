// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/ValidationIssue.h"

#include <algorithm>

#include <QFileInfo>

namespace lessons {

QString ValidationIssue::english() const
{
    return QString::fromStdString(core::inEnglish(what));
}

QString ValidationIssue::sentence() const
{
    const QString where = QFileInfo(file).fileName();
    return (key.isEmpty() ? where + QLatin1Char(' ') : where + QStringLiteral(", ") + key + QStringLiteral(": ")) +
           english();
}

bool anyGrave(const std::vector<ValidationIssue>& faults)
{
    return std::any_of(faults.begin(), faults.end(), [](const ValidationIssue& fault) { return fault.grave; });
}

}  // namespace lessons
