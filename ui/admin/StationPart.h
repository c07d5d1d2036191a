// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

class QGridLayout;
class QLabel;
class QSpinBox;

namespace ui::admin {

/// This computer: what is drilled with, its key, versions; and when a place that was left is locked, here and
/// everywhere.
class StationPart final : public QWidget
{
    Q_OBJECT
public:
    explicit StationPart(QWidget* parent);

    struct Facts
    {
        QString hand;  ///< that moves the bur
        double servoHz = 0.0;
        double middleMs = 0.0;  ///< between two servo ticks, as measured; NaN: not yet
        double mostMs = 0.0;    ///< 99 of 100 take no longer
        QString stationKey;     ///< public, hex
        QString database;
        QString program;  ///< version
        int waiting = 0;  ///< attempts on their way to it
    };
    void setFacts(const Facts& facts);
    void setIdleMinutes(int minutes);

signals:
    void idleMinutesRequested(int minutes);

private:
    void retranslateUi();

    Facts m_facts;
    QGridLayout* m_grid;
    QList<QLabel*> m_names;
    QList<QLabel*> m_values;
    QSpinBox* m_idle;
    int m_idleMinutes = 0;  ///< as the school has them
    QLabel* m_idleWords;
};

}  // namespace ui::admin
