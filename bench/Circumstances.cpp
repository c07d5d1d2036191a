// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/Circumstances.h"

#include <thread>

#include <QDateTime>
#include <QFile>
#include <QStringList>
#include <QSysInfo>

#include "core/contact/Kernels.h"

namespace bench {
namespace {

/// Returns the name that the system gives the processor, or its architecture if it gives none.
QString processorModel()
{
    QFile file(QStringLiteral("/proc/cpuinfo"));
    if (file.open(QIODevice::ReadOnly))
        for (const QByteArray& line : file.readAll().split('\n'))
            if (line.startsWith("model name"))
                return QString::fromUtf8(line.mid(line.indexOf(':') + 1)).simplified();
    return QSysInfo::currentCpuArchitecture();
}

}  // namespace

Circumstances circumstancesNow()
{
    Circumstances now;
    now.processor = QStringLiteral("%1, %2 cores").arg(processorModel()).arg(std::thread::hardware_concurrency());
    now.system = QSysInfo::prettyProductName();
    now.date = QDateTime::currentDateTimeUtc().toString(Qt::ISODate);
    now.version = QStringLiteral(CUSP_VERSION);
#ifdef __clang__
    now.compiler = QStringLiteral("Clang %1.%2").arg(__clang_major__).arg(__clang_minor__);
#else
    now.compiler = QStringLiteral("GCC " __VERSION__);
#endif
    now.buildType = QStringLiteral(CUSP_BUILD_TYPE);
    now.kernels = QLatin1String(core::contact::kernels().name);
    return now;
}

QString Circumstances::line() const
{
    return QStringLiteral("%1 | %2 | Cusp %3, %4, %5, %6 kernels")
        .arg(processor, date, version, compiler, buildType, kernels);
}

QJsonObject Circumstances::json() const
{
    return {{QStringLiteral("processor"), processor}, {QStringLiteral("system"), system},
            {QStringLiteral("date"), date},           {QStringLiteral("version"), version},
            {QStringLiteral("compiler"), compiler},   {QStringLiteral("build_type"), buildType},
            {QStringLiteral("kernels"), kernels}};
}

double residentMiB()
{
    QFile status(QStringLiteral("/proc/self/status"));
    if (!status.open(QIODevice::ReadOnly))
        return 0.0;
    for (const QByteArray& line : status.readAll().split('\n'))
        if (line.startsWith("VmRSS:"))
            return line.mid(6).trimmed().split(' ').front().toDouble() / 1024.0;
    return 0.0;
}

}  // namespace bench
