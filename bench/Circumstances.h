// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QString>

namespace bench {

/// Where, when and with what figures are measured: without it they mean little.
struct Circumstances
{
    QString processor;  ///< model and number of cores
    QString system;
    QString date;  ///< UTC, ISO 8601
    QString version;
    QString compiler;
    QString buildType;
    QString kernels;  ///< of contact: "avx2" or "plain"

    [[nodiscard]] QString line() const;
    [[nodiscard]] QJsonObject json() const;
};
[[nodiscard]] Circumstances circumstancesNow();

/// Resident memory of this process, MiB; 0 where the system does not say.
[[nodiscard]] double residentMiB();

}  // namespace bench
