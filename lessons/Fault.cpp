// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/Fault.h"

#include <algorithm>

#include <QFileInfo>

namespace lessons {

QString Fault::english() const
{
    return QString::fromStdString(core::inEnglish(what));
}

QString Fault::sentence() const
{
    const QString where = QFileInfo(file).fileName();
    return (key.isEmpty() ? where + QLatin1Char(' ') : where + QStringLiteral(", ") + key + QStringLiteral(": ")) +
           english();
}

bool anyGrave(const std::vector<Fault>& faults)
{
    return std::any_of(faults.begin(), faults.end(), [](const Fault& fault) { return fault.grave; });
}

}  // namespace lessons
