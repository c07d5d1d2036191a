// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <variant>

#include <QColor>
#include <QList>
#include <QString>
#include <QStringList>

/// Charts as plain values: drawn on the screen and on paper (Drawing.h), and written as a table (Table.h).
namespace ui::charts {

/// A value that the pointer or the arrow keys can select.
struct Dot
{
    double x = 0.0;
    double y = 0.0;
    QString words;        ///< the value as a sentence
    std::int64_t id = 0;  ///< the attempt that a click opens; 0: none
    QString of{};         ///< subject of the value in the exported table, under Curve::ofTitle
    QString note{};       ///< written beside it
    bool operator==(const Dot&) const = default;
};

/// The shape of dots. Each kind has its own shape, so that colour is not the only difference.
enum class Mark : std::uint8_t {
    None,   ///< the dots cannot be selected
    Plain,  ///< no shape, only the line
    Circle,
    HollowDiamond,
    Square,
    Triangle,
    Diamond,
    Pentagon
};

struct Line
{
    QString name;
    QList<Dot> dots;
    Mark mark = Mark::Circle;
    bool isJoined = true;
    QColor colour{};  ///< if many lines have one each; invalid: the colour of the ink
    Qt::PenStyle stroke = Qt::SolidLine;
    double widthPx = 2.0;
    bool operator==(const Line&) const = default;
};

/// The middle half of the values of many people at one position.
struct Slice
{
    double x = 0.0;
    double low = 0.0;
    double middle = 0.0;
    double high = 0.0;
    QString words;
    bool operator==(const Slice&) const = default;
};

struct Band
{
    QString name;        ///< name of the middle half
    QString middleName;  ///< name of the line in it
    QList<Slice> slices;
    bool operator==(const Band&) const = default;
};

/// A straight line across the chart: a pass mark, a median.
struct Limit
{
    double at = 0.0;
    bool isUpright = false;
    QString name;
    bool operator==(const Limit&) const = default;
};

struct Axis
{
    QString title;
    double low = 0.0;
    double high = 1.0;
    bool isWhole = false;  ///< counts: ticks at whole numbers only
    double base = 0.0;     ///< base of a logarithmic axis; 0: the axis is linear
    QStringList labels{};  ///< instead of numbers, at the values 0, 1, 2 ...

    /// Returns the position of a value on the axis: 0 at the low end, 1 at the high end.
    [[nodiscard]] double shareOf(double value) const;
    [[nodiscard]] double valueAt(double share) const;
    bool operator==(const Axis&) const = default;
};

/// Lines and dots in front of a band.
struct Curve
{
    Axis x;
    Axis y;
    QList<Line> lines;
    Band band;
    QList<Limit> limits;
    QString ofTitle{};  ///< such as "Lesson", if dots belong to several; otherwise empty
    bool operator==(const Curve&) const = default;
};

/// Horizontal bars with names, the first on top.
struct Bars
{
    struct Bar
    {
        QString name;
        double value = 0.0;
        QString words;
        bool operator==(const Bar&) const = default;
    };
    Axis value;
    QString nameTitle;  ///< title of the names in the table
    QList<Bar> bars;
    bool operator==(const Bars&) const = default;
};

/// The number of values in each interval.
struct Histogram
{
    struct Bin
    {
        double from = 0.0;
        double to = 0.0;
        int count = 0;
        QString words;
        bool operator==(const Bin&) const = default;
    };
    Axis x;
    Axis count;
    QList<Bin> bins;
    QList<Limit> limits;
    bool operator==(const Histogram&) const = default;
};

/// A table of coloured cells.
struct Map
{
    struct Cell
    {
        QColor colour;
        QString letter;  ///< distinguishes cells without colour; may be empty
        QString note;
        bool operator==(const Cell&) const = default;
    };
    QStringList rows;
    QStringList groups;   ///< names of the groups of columns
    QStringList columns;  ///< names of the columns in each group
    QString columnTitle;
    QList<QList<Cell>> cells;  ///< [row][group * columns + column]
    bool operator==(const Map&) const = default;
};

struct Chart
{
    QString title;
    QString note;        ///< what a reader must know, for example the number of people and the dates
    QString emptyWords;  ///< shown instead of a chart without values: what the chart will show, and what is needed for
                         ///< it
    std::variant<Curve, Bars, Histogram, Map> content;
    QString of{};  ///< subject of the chart in an exported file: "Year 1, Decay on 36"
    bool operator==(const Chart&) const = default;
};

/// Returns the chart reduced to a number of rows. Of bars, keeps the first ones and adds a row with the number of
/// omitted ones.
[[nodiscard]] Chart fitted(const Chart& chart, int rows);

/// Returns all values that can be selected, in the coordinates of the chart: from left to right, and from top to bottom
/// for bars and maps. Bar k is at height -k, and the middle of a map's first cell is at (0.5, -0.5).
[[nodiscard]] QList<Dot> stopsOf(const Chart& chart);

/// Returns the horizontal and the vertical axis, extended so that shapes at the ends are fully visible.
[[nodiscard]] std::pair<Axis, Axis> axesOf(const Chart& chart);

/// Returns the end of an axis from 0: the smallest of 1, 2, 2.5, 5, 10, 20 ... that is not below the value.
[[nodiscard]] double roundEnd(double value);

}  // namespace ui::charts
