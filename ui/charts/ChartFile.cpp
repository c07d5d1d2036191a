// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/ChartFile.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSaveFile>

#include "ui/charts/Drawing.h"
#include "ui/charts/Table.h"
#include "ui/shell/SavedFile.h"

namespace ui::charts {
namespace {

/// Translated with the rest of what a panel says.
struct Words
{
    Q_DECLARE_TR_FUNCTIONS(ui::charts::ChartPanel)
};

}  // namespace

Written writeChart(const Chart& chart, const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    const QByteArray bytes = ending == QLatin1String("csv")   ? csv(tableOf(chart))
                             : ending == QLatin1String("svg") ? svg(chart)
                                                              : png(chart);
    QSaveFile file(path);
    const bool isDone = shell::openForOwner(file) && file.write(bytes) == bytes.size() && !bytes.isEmpty() &&
                        file.flush() && file.commit();
    const QString name = QFileInfo(path).fileName();
    return {isDone, isDone
                        ? Words::tr("Saved: %1").arg(name)
                        //: %2: the system's own words
                        : Words::tr("%1 could not be written (%2). Try another folder.").arg(name, file.errorString())};
}

}  // namespace ui::charts
