// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include <QString>
#include <QStringList>
#include <QTimer>
#include <QWidget>

#include "core/settings/Parameters.h"
#include "ui/charts/Chart.h"

namespace ui::console {

/// Shows watched values over the view while the user drills: one line per value, with a plot of the last ten seconds
/// for plotted ones. Mouse events pass through the panel.
class WatchPanel : public QWidget
{
    Q_OBJECT
public:
    static constexpr double kPlottedS = 10.0;
    static constexpr std::size_t kMost = 8;

    /// @param parameters  must outlive the panel
    WatchPanel(const core::settings::Parameters& parameters, QWidget* parent);

    /// Adds a value. Returns false if there are kMost already.
    bool watch(const QString& name, bool plotted);
    /// Removes a value.
    /// @param name  empty: all
    void forget(const QString& name);
    [[nodiscard]] QStringList names() const;
    /// Reads the values. A timer calls this ten times a second.
    /// @param seconds  since a fixed moment
    void sample(double seconds);
    /// Returns the plot of a value as a chart for export. Empty if the value is not plotted.
    [[nodiscard]] std::optional<charts::Chart> chart(const QString& name) const;
    /// Returns the plotted values, oldest first.
    [[nodiscard]] std::vector<double> plotted(const QString& name) const;

signals:
    /// Emitted when the panel's size has changed and it must be placed again.
    void resized();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Point
    {
        double seconds;
        double value;
    };
    struct Row
    {
        QString name;
        bool isPlotted = false;
        double now = 0.0;
        std::deque<Point> points;

        /// Returns the smallest and the largest plotted value; empty if there are none.
        [[nodiscard]] std::optional<std::pair<double, double>> range() const;
    };
    void fit();

    const core::settings::Parameters& m_parameters;
    std::vector<Row> m_rows;
    QTimer m_beat;
};

}  // namespace ui::console
