// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QList>
#include <QWidget>

#include "core/bur/Bur.h"

class QAction;
class QHBoxLayout;

namespace ui::kit {
class Actions;
}

namespace ui::practice {

class BurPicker;

/// One bur as a tile: its outline drawn to scale, tip down, with its number beneath. Checks and unchecks with its
/// action.
class BurTile : public QAbstractButton
{
    Q_OBJECT
public:
    /// @param heightPx  a head that would not fit is drawn smaller
    BurTile(const core::bur::Bur& bur, QAction* action, int heightPx, QWidget* parent);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] const core::bur::Bur& bur() const { return m_bur; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    const core::bur::Bur& m_bur;
    int m_heightPx;
};

/// The burs at hand side by side (Actions::bursAtHand()), then the one in use if it is not among them, and a button
/// that opens all of them.
class BurChooser : public QWidget
{
    Q_OBJECT
public:
    BurChooser(kit::Actions& actions, QWidget* parent);

private:
    void arrange();

    kit::Actions& m_actions;
    QHBoxLayout* m_row;
    BurPicker* m_picker;
    QList<BurTile*> m_tiles;  ///< one for each bur; most are hidden
    QAbstractButton* m_all;
};

}  // namespace ui::practice
