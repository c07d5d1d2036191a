// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

class QAction;

namespace ui::practice {

/// A large switch that runs the bur: filled when on, outlined when off, with its shortcut beside it.
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
