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

/// A tile that shows one bur: its outline to scale, tip down, with its number below. It is checked when its action is.
class BurTile : public QAbstractButton
{
    Q_OBJECT
public:
    /// @param heightPx  a larger bur head is scaled down to fit
    BurTile(const core::bur::Bur& bur, QAction* action, int heightPx, QWidget* parent);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] const core::bur::Bur& bur() const { return m_bur; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    const core::bur::Bur& m_bur;
    int m_heightPx;
};

/// Shows the available burs side by side (Actions::bursAtHand()), then the bur in use if it is not among them, and a
/// button that opens the bur picker.
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
