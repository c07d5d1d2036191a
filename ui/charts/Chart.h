// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <variant>

#include <QColor>
#include <QList>
#include <QString>
#include <QStringList>

/// What a chart shows, as plain values: drawn on the screen and on paper (Drawing.h), written as a table (Table.h).
namespace ui::charts {

/// A value at which one can stop, with the pointer or the arrow keys.
struct Dot
{
    double x = 0.0;
    double y = 0.0;
    QString words;        ///< the value as a sentence
    std::int64_t id = 0;  ///< what opens when it is chosen; 0: nothing
    QString of{};         ///< in a table of the chart: what it belongs to, under Curve::ofTitle
    QString note{};       ///< written beside it
    bool operator==(const Dot&) const = default;
};

/// How dots look. Each kind has a shape of its own: colour only says it again.
enum class Mark : std::uint8_t {
    None,   ///< nobody stops there
    Plain,  ///< nothing but the line
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
    QColor colour{};  ///< where many lines have one each; else the ink's
    Qt::PenStyle stroke = Qt::SolidLine;
    double widthPx = 2.0;
    bool operator==(const Line&) const = default;
};

/// The middle half of many people at one place.
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
    QString name;        ///< of the middle half
    QString middleName;  ///< of the line in it
    QList<Slice> slices;
    bool operator==(const Band&) const = default;
};

/// A straight line across: a pass mark, a median.
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
    bool isWhole = false;  ///< counts: no ticks between whole numbers
    double base = 0.0;     ///< of a logarithmic axis; 0: a linear one
    QStringList labels{};  ///< instead of numbers, at 0, 1, 2 ...

    /// 0 at the low end, 1 at the high one.
    [[nodiscard]] double shareOf(double value) const;
    [[nodiscard]] double valueAt(double share) const;
    bool operator==(const Axis&) const = default;
};

/// Lines and clouds of dots before a band.
struct Curve
{
    Axis x;
    Axis y;
    QList<Line> lines;
    Band band;
    QList<Limit> limits;
    QString ofTitle{};  ///< "Lesson", where dots belong to several; else empty
    bool operator==(const Curve&) const = default;
};

/// Lying bars with a name each, the first on top.
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
    QString nameTitle;  ///< what the names are, for the table
    QList<Bar> bars;
    bool operator==(const Bars&) const = default;
};

/// How many lie between one value and the next.
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
    QStringList groups;   ///< of columns
    QStringList columns;  ///< in each group
    QString columnTitle;
    QList<QList<Cell>> cells;  ///< [row][group * columns + column]
    bool operator==(const Map&) const = default;
};

struct Chart
{
    QString title;
    QString note;        ///< what has to be known to read it: of how many, of when
    QString emptyWords;  ///< instead of a chart without values: what will be here, and how to get it
    std::variant<Curve, Bars, Histogram, Map> content;
    QString of{};  ///< whose it is, told in files, which lie apart from the page: "Year 1, Decay on 36"
    bool operator==(const Chart&) const = default;
};

/// As much of it as so many rows show: of more bars the first ones, and a row that says how many are left out.
[[nodiscard]] Chart fitted(const Chart& chart, int rows);

/// Everything at which one can stop, from left to right, of bars and maps from top to bottom; in the chart's own
/// coordinates. Bar k lies at height -k, and the middle of the first cell of a map at (0.5, -0.5).
[[nodiscard]] QList<Dot> stopsOf(const Chart& chart);

/// The lying and the upright axis, with as much more as marks at their ends need to be seen whole.
[[nodiscard]] std::pair<Axis, Axis> axesOf(const Chart& chart);

/// The end of an axis from 0: the next of 1, 2, 2.5, 5, 10, 20 ... that is not below the value.
[[nodiscard]] double roundEnd(double value);

}  // namespace ui::charts
