// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/SuiteFiles.h"

#include <QApplication>
#include <QJsonArray>
#include <QJsonDocument>

#include "bench/Circumstances.h"
#include "core/base/WholeFile.h"
#include "ui/charts/Drawing.h"
#include "ui/kit/Theme.h"

namespace bench {
namespace {

QByteArray csvOf(const Figures& figures)
{
    const auto quoted = [](QString text) { return "\"" + text.replace(u'"', u'\'').toUtf8() + "\""; };
    QByteArray csv("key,what,value,unit,reach\n");
    for (const Figure& figure : figures)
        csv += figure.key.toUtf8() + "," + quoted(figure.what) + "," + QByteArray::number(figure.value, 'g', 9) + "," +
               figure.unit.toUtf8() + "," + quoted(figure.reach) + "\n";
    return csv;
}

QByteArray jsonOf(const QString& suite, const Figures& figures, const QList<NamedChart>& charts,
                  const Circumstances& now)
{
    QJsonArray rows;
    for (const Figure& figure : figures)
        rows.append(QJsonObject{{QStringLiteral("key"), figure.key},
                                {QStringLiteral("what"), figure.what},
                                {QStringLiteral("value"), figure.value},
                                {QStringLiteral("unit"), figure.unit},
                                {QStringLiteral("reach"), figure.reach}});
    QJsonArray names;
    for (const NamedChart& chart : charts)
        names.append(chart.name);
    QJsonObject all = now.json();
    all[QStringLiteral("suite")] = suite;
    all[QStringLiteral("charts")] = names;
    all[QStringLiteral("figures")] = rows;
    return QJsonDocument(all).toJson();
}

}  // namespace

core::Result<QStringList> writeFiles(const QDir& folder, const QString& suite, const Figures& figures,
                                     const QList<NamedChart>& charts)
{
    QStringList written;
    core::Status status;
    const auto write = [&](const QString& name, const QByteArray& bytes) {
        if (status)
            status = core::writeWhole(folder.filePath(name).toStdString(), bytes.toStdString(), "The file");
        written << name;
    };
    const Circumstances now = circumstancesNow();
    const QString stem = QStringLiteral("bench-%1.%2");
    write(stem.arg(suite, QStringLiteral("csv")), csvOf(figures));
    write(stem.arg(suite, QStringLiteral("json")), jsonOf(suite, figures, charts, now));
    ui::kit::applyTheme(*qApp, ui::kit::ThemeChoice::Light);  // for its fonts
    for (const auto& [chartName, chart] : charts) {
        ui::charts::Chart dated = chart;
        dated.note += u'\n' + now.line();
        write(stem.arg(chartName, QStringLiteral("svg")), ui::charts::svg(dated));
        write(stem.arg(chartName, QStringLiteral("png")), ui::charts::png(dated));
    }
    if (!status)
        return tl::unexpected(status.error());
    return written;
}

}  // namespace bench
