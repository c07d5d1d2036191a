// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

class QAction;

namespace ui::practice {

/// Whether the bur turns, readable from across the room: filled and lit when on, outlined when off, its key beside it.
class DrillSwitch : public QAbstractButton
{
    Q_OBJECT
public:
    DrillSwitch(QAction* action, QWidget* parent);
    [[nodiscard]] QSize sizeHint() const override { return {200, 48}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString m_key;
};

}  // namespace ui::practice
