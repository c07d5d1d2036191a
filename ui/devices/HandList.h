// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListWidget>

#include "ui/devices/DeviceWords.h"

namespace ui::devices {

/// The list of input devices, head tracking and sound, each with its state as an icon and a sentence.
class HandList : public QListWidget
{
    Q_OBJECT
public:
    explicit HandList(QWidget* parent);

    struct Row
    {
        QString id;
        QString name;
        QString state;
        Sign sign = Sign::Ready;
        bool isChosen = false;
        bool isApart = false;  ///< a line separates it from the rows above
        bool operator==(const Row&) const = default;
    };
    /// Sets the rows. Keeps the selection.
    void setRows(const QList<Row>& rows);
    [[nodiscard]] const QList<Row>& rows() const { return m_rows; }
    void selectHand(const QString& id);
    /// Returns the id of the selected row.
    [[nodiscard]] QString selectedHand() const;

private:
    QList<Row> m_rows;
};

}  // namespace ui::devices
