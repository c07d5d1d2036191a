// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include <QList>
#include <QPointF>
#include <QString>
#include <QStringList>

/// What a chart shows, as plain data: who measures fills it in, who draws reads it.
namespace app::cli::bench {

/// Which colour, marker, line pattern and hatching a method has: the same in every chart (see Look.h).
using LookIndex = int;

struct Axis
{
    QString title;  ///< with the unit
    double low = 0.0;
    double high = 1.0;
    double base = 0.0;      ///< of a logarithmic axis; 0: a linear one
    double interval = 1.0;  ///< between the figures of a linear one
    QStringList labels{};   ///< instead of figures, at 0, 1, 2 ... of a linear one
};

/// Points in the order in which the line joins them.
struct Curve
{
    QString name;
    LookIndex look = 0;
    QList<QPointF> points;
    QStringList notes;  ///< beside each point; may be empty
};

/// A straight line across the whole chart.
struct Limit
{
    QString text;
    double at = 0.0;
    bool isVertical = false;  ///< x = at, otherwise y = at
};

struct CurveChart
{
    Axis x;
    Axis y;
    QList<Curve> curves;
    QList<Limit> limits;
    QString goodCorner;  ///< what to call the part that is below every limit, which is shaded; empty: no such part
};

/// Bars side by side in groups, in panels one above the other that share their axes.
struct BarChart
{
    struct Bars
    {
        QString name;
        LookIndex look = 0;
        QList<double> values;  ///< one a group
        QStringList notes;     ///< above each bar
    };
    struct Panel
    {
        QString title;
        QList<Bars> bars;  ///< the same names in every panel
    };
    QString valueTitle;
    double most = 1.0;      ///< upper end of the axis of values, with room for a note above the highest
    double interval = 1.0;  ///< between its figures
    QString groupTitle;
    QStringList groups;
    QList<Panel> panels;
};

/// Cells in rows and groups of columns, each with what was found there.
struct MapChart
{
    struct Finding
    {
        QString letter;
        QString colour;  ///< "#rrggbb"
        QString name;    ///< in the legend
    };
    struct Cell
    {
        int finding = 0;  ///< index into findings
        QString note;     ///< beside the letter; may be empty
    };
    QList<Finding> findings;
    QStringList rows;
    QStringList groups;   ///< of columns
    QStringList columns;  ///< within each group
    QString columnTitle;
    QList<QList<Cell>> cells;  ///< [row][group * columns + column]
};

struct Chart
{
    QString name;   ///< of its files, after "bench-": "contact-ground"
    QString title;  ///< one line
    QString about;  ///< what exactly was measured; up to two lines
    std::variant<CurveChart, BarChart, MapChart> content;
};

}  // namespace app::cli::bench
