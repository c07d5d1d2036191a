// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

class QGridLayout;
class QLabel;
class QSpinBox;

namespace ui::admin {

/// Information about this computer: its device, key and versions. Also the time after which an idle window is locked,
/// on this and all computers of the school.
class StationPart final : public QWidget
{
    Q_OBJECT
public:
    explicit StationPart(QWidget* parent);

    struct Facts
    {
        QString hand;  ///< the device that moves the bur
        double servoHz = 0.0;
        double middleMs = 0.0;  ///< median time between two servo ticks, measured; NaN: not measured yet
        double mostMs = 0.0;    ///< 99th percentile of that time
        QString stationKey;     ///< public, hex
        QString database;
        QString program;  ///< version
        int waiting = 0;  ///< attempts not yet sent to the database
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
    int m_idleMinutes = 0;  ///< the school's setting
    QLabel* m_idleWords;
};

}  // namespace ui::admin
