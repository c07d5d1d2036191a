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

/// Values that are watched and plotted over the view while one drills: a line each, and of the plotted ones the last
/// ten seconds. The mouse goes through it.
class WatchPanel : public QWidget
{
    Q_OBJECT
public:
    static constexpr double kPlottedS = 10.0;
    static constexpr std::size_t kMost = 8;

    /// @param parameters  must outlive the panel
    WatchPanel(const core::settings::Parameters& parameters, QWidget* parent);

    /// False if there are kMost already.
    bool watch(const QString& name, bool plotted);
    /// Empty: all.
    void forget(const QString& name);
    [[nodiscard]] QStringList names() const;
    /// Reads the values once more; done ten times a second by itself.
    /// @param seconds  since some beginning
    void sample(double seconds);
    /// The same as a chart for a file; nothing: it is not plotted.
    [[nodiscard]] std::optional<charts::Chart> chart(const QString& name) const;
    /// What has been plotted of a name so far: values, the oldest first.
    [[nodiscard]] std::vector<double> plotted(const QString& name) const;

signals:
    /// It is another size, and wants to be placed.
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

        /// The least and the greatest that are plotted; nothing: there was nothing to read.
        [[nodiscard]] std::optional<std::pair<double, double>> range() const;
    };
    void fit();

    const core::settings::Parameters& m_parameters;
    std::vector<Row> m_rows;
    QTimer m_beat;
};

}  // namespace ui::console
