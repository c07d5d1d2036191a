// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QList>
#include <QWidget>

#include "core/drilling/Bur.h"

class QAction;

namespace ui::shell {

/// One bur as a tile: its outline drawn to scale, tip down, with its number beneath. Checks and unchecks with its
/// action.
class BurTile : public QAbstractButton
{
    Q_OBJECT
public:
    BurTile(const core::drilling::Bur& bur, QAction* action, QWidget* parent);
    [[nodiscard]] QSize sizeHint() const override { return {46, 70}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    const core::drilling::Bur& m_bur;
};

/// The burs side by side.
class BurChooser : public QWidget
{
    Q_OBJECT
public:
    /// @param actions  one for each of core::drilling::burs(), checkable and exclusive
    BurChooser(const QList<QAction*>& actions, QWidget* parent);
};

}  // namespace ui::shell
