// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

namespace ui::devices {

/// A field to test a pen in. Its bar shows the pressure.
class PenField : public QWidget
{
    Q_OBJECT
public:
    explicit PenField(QWidget* parent);

    [[nodiscard]] QSize sizeHint() const override { return {320, 96}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 72}; }

signals:
    /// Emitted for each event of a pen in the field.
    /// @param pressure  0 to 1; 0 while the pen hovers
    void penMoved(double pressure);
    /// Emitted when a device without pressure presses the field.
    void mousePressed();

protected:
    void paintEvent(QPaintEvent* event) override;
    void tabletEvent(QTabletEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    QString m_words;
    double m_pressure = 0.0;
};

}  // namespace ui::devices
