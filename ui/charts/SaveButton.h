// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QToolButton>

#include "ui/charts/Chart.h"

namespace ui::charts {

/// What became of a file, as a sentence.
struct Written
{
    bool isDone = false;
    QString told;
};

/// Writes .png, .svg or .csv, by the name's ending. An older file survives any failure. Ui thread.
[[nodiscard]] Written writeChart(const Chart& chart, const QString& path);

/// Saves a chart as a picture, a drawing or a table: asks for the chart when it is needed, and for a file.
class SaveButton : public QToolButton
{
    Q_OBJECT
public:
    SaveButton(std::function<Chart()> chart, QWidget* parent);

    /// Writes .png, .svg or .csv, by the name's ending, and tells what became of it.
    bool save(const QString& path);
    /// To be called when the title of the chart is another.
    void nameIt();
    /// No arrow, and little around the sign: for beside a chart, whose width it takes.
    void beSmall();

signals:
    /// What became of a file, as a sentence.
    void told(const QString& sentence);

protected:
    void changeEvent(QEvent* event) override;

private:
    void askForFile(const QString& ending);

    std::function<Chart()> m_chart;
};

}  // namespace ui::charts
