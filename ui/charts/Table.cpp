// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/Table.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

namespace ui::charts {
namespace {

struct TableWords
{
    Q_DECLARE_TR_FUNCTIONS(ui::charts::Table)
};

QByteArray written(const QString& words)
{
    QString safe = words;
    // Leading spaces are ignored, because some programs remove them before they evaluate the cell.
    const QString bare = words.trimmed();
    const bool isFormula = !bare.isEmpty() && QStringLiteral("=+-@\uFF1D\uFF0B\uFF0D\uFF20").contains(bare.front());
    const bool beginsOddly = !words.isEmpty() && words.front() < u' ';
    if (isFormula || beginsOddly)
        safe.prepend(u'\'');
    const bool needsQuotes = std::any_of(safe.begin(), safe.end(),
                                         [](QChar c) { return c == u',' || c == u'"' || c == u'\n' || c == u'\r'; }) ||
                             safe.startsWith(u' ') || safe.endsWith(u' ');
    if (needsQuotes)
        safe = u'"' + safe.replace(u'"', QStringLiteral("\"\"")) + u'"';
    return safe.toUtf8();
}

/// Returns a number with 12 significant digits: 76.1 without the rounding error of a sum.
QByteArray written(double value)
{
    constexpr int kDigits = 12;
    return std::isfinite(value) ? QByteArray::number(value, 'g', kDigits) : QByteArray();
}

QByteArray written(std::int64_t value)
{
    return QByteArray::number(static_cast<qlonglong>(value));
}

Table table(const Curve& curve)
{
    Table made{{TableWords::tr("series"), curve.x.title, curve.y.title}, {}};
    for (const Line& line : curve.lines) {
        // The line has no name if it is the only one, or the middle of the band, which is written below.
        const bool isBand = line.name.isEmpty() && !curve.band.slices.isEmpty();
        if (line.mark == Mark::None || isBand)
            continue;
        for (const Dot& dot : line.dots)
            made.rows << QList<Cell>{line.name.isEmpty() ? curve.y.title : line.name, dot.x, dot.y, dot.of};
    }
    for (const Slice& slice : curve.band.slices) {
        made.rows << QList<Cell>{TableWords::tr("class, lower quartile"), slice.x, slice.low};
        made.rows << QList<Cell>{TableWords::tr("class, median"), slice.x, slice.middle};
        made.rows << QList<Cell>{TableWords::tr("class, upper quartile"), slice.x, slice.high};
    }
    for (const Limit& limit : curve.limits)
        made.rows << (limit.isUpright ? QList<Cell>{limit.name, limit.at, QString()}
                                      : QList<Cell>{limit.name, QString(), limit.at});
    for (QList<Cell>& row : made.rows)
        row.resize(curve.ofTitle.isEmpty() ? 3 : 4, QString());
    if (!curve.ofTitle.isEmpty())
        made.heads << curve.ofTitle;
    return made;
}

Table table(const Bars& bars)
{
    Table made{{bars.nameTitle, bars.value.title}, {}};
    for (const Bars::Bar& bar : bars.bars)
        made.rows << QList<Cell>{bar.name, bar.value};
    return made;
}

Table table(const Histogram& histogram)
{
    Table made{{TableWords::tr("from"), TableWords::tr("to"), histogram.count.title}, {}};
    for (const Histogram::Bin& bin : histogram.bins)
        made.rows << QList<Cell>{bin.from, bin.to, static_cast<std::int64_t>(bin.count)};
    return made;
}

/// Returns an empty table, because a map is exported as a picture only.
Table table(const Map&)
{
    return {};
}

}  // namespace

QByteArray csv(const Table& table)
{
    QByteArray text;
    for (qsizetype k = 0; k < table.heads.size(); ++k)
        text += (k > 0 ? "," : "") + written(table.heads[k]);
    text += "\r\n";
    for (const QList<Cell>& row : table.rows) {
        for (qsizetype k = 0; k < row.size(); ++k)
            text += (k > 0 ? "," : "") + std::visit([](const auto& cell) { return written(cell); }, row[k]);
        text += "\r\n";
    }
    return text;
}

Table tableOf(const Chart& chart)
{
    return std::visit([](const auto& content) { return table(content); }, chart.content);
}

}  // namespace ui::charts
