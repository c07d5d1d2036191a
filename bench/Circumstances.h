// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QString>

namespace bench {

/// The computer, date and build of a measurement, without which its figures mean little.
struct Circumstances
{
    QString processor;  ///< model and number of cores
    QString system;
    QString date;  ///< UTC, ISO 8601
    QString version;
    QString compiler;
    QString buildType;
    QString kernels;  ///< contact kernels: "avx2" or "plain"

    [[nodiscard]] QString line() const;
    [[nodiscard]] QJsonObject json() const;
};
[[nodiscard]] Circumstances circumstancesNow();

/// Returns the resident memory of this process, MiB; 0 if the system does not report it.
[[nodiscard]] double residentMiB();

}  // namespace bench
