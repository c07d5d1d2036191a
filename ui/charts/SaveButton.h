// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QToolButton>

#include "ui/charts/Chart.h"

namespace ui::charts {

/// The result of writing a file, with a sentence about it.
struct Written
{
    bool isDone = false;
    QString told;
};

/// Writes .png, .svg or .csv, by the suffix of the path. If writing fails, an existing file is unchanged. Ui thread.
[[nodiscard]] Written writeChart(const Chart& chart, const QString& path);

/// A button that exports a chart as a bitmap, a vector drawing or a table. It requests the chart when it is pressed,
/// and asks for a file.
class SaveButton : public QToolButton
{
    Q_OBJECT
public:
    SaveButton(std::function<Chart()> chart, QWidget* parent);

    /// Writes .png, .svg or .csv, by the suffix of the path, and emits told() with the result.
    bool save(const QString& path);
    /// Updates the name of the button. Call after the title of the chart has changed.
    void nameIt();
    /// Reduces the button to its icon, to save width beside a chart.
    void beSmall();

signals:
    /// Emitted when a file was written or writing has failed, with a sentence about it.
    void told(const QString& sentence);

protected:
    void changeEvent(QEvent* event) override;

private:
    void askForFile(const QString& ending);

    std::function<Chart()> m_chart;
};

}  // namespace ui::charts
