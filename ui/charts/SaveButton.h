// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QToolButton>

#include "ui/charts/Chart.h"

namespace ui::charts {

/// The outcome of writing a file, with a sentence about it.
struct Written
{
    bool isDone = false;
    QString told;
};

/// Writes .png, .svg or .csv, by the suffix of the name. An existing file is kept if writing fails. Ui thread.
[[nodiscard]] Written writeChart(const Chart& chart, const QString& path);

/// A button that saves a chart as a picture, a drawing or a table. Requests the chart when it is pressed, and asks for
/// a file.
class SaveButton : public QToolButton
{
    Q_OBJECT
public:
    SaveButton(std::function<Chart()> chart, QWidget* parent);

    /// Writes .png, .svg or .csv, by the suffix of the name, and emits told() with the outcome.
    bool save(const QString& path);
    /// Updates the name of the button. Call after the title of the chart has changed.
    void nameIt();
    /// Reduces the button to its icon, to save width beside a chart.
    void beSmall();

signals:
    /// Emitted with a sentence about a file that was written or could not be.
    void told(const QString& sentence);

protected:
    void changeEvent(QEvent* event) override;

private:
    void askForFile(const QString& ending);

    std::function<Chart()> m_chart;
};

}  // namespace ui::charts
