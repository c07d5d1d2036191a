// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/PadKeys.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QButtonGroup>
#include <QComboBox>
#include <QKeyEvent>
#include <QPointer>

#include "ui/kit/ConfirmOverlay.h"

namespace ui::window {
namespace {

void sendKey(QWidget& receiver, Qt::Key key)
{
    const QPointer<QWidget> alive(&receiver);
    QKeyEvent press(QEvent::KeyPress, key, Qt::NoModifier);
    QCoreApplication::sendEvent(&receiver, &press);
    if (alive.isNull())
        return;
    QKeyEvent release(QEvent::KeyRelease, key, Qt::NoModifier);
    QCoreApplication::sendEvent(&receiver, &release);
}

Qt::Key arrowKey(PadArrow arrow)
{
    switch (arrow) {
    case PadArrow::Up:
        return Qt::Key_Up;
    case PadArrow::Down:
        return Qt::Key_Down;
    case PadArrow::Left:
        return Qt::Key_Left;
    case PadArrow::Right:
        break;
    }
    return Qt::Key_Right;
}

/// Returns the open menu or list; null if none is open.
QWidget* openPopup()
{
    QWidget* const popup = QApplication::activePopupWidget();
    if (popup == nullptr)
        return nullptr;
    QWidget* const inside = popup->focusWidget();
    return inside != nullptr ? inside : popup;
}

/// Returns whether a button belongs to a group of exclusive buttons, in which only the arrow keys move the focus.
bool isOneOfGroup(const QAbstractButton& button)
{
    return button.isCheckable() &&
           (button.autoExclusive() || (button.group() != nullptr && button.group()->exclusive()));
}

}  // namespace

void stepByPad(QWidget& window, PadArrow arrow)
{
    if (QWidget* const popup = openPopup()) {
        sendKey(*popup, arrowKey(arrow));
        return;
    }
    const bool isOn = arrow == PadArrow::Down || arrow == PadArrow::Right;
    const bool isSideways = arrow == PadArrow::Left || arrow == PadArrow::Right;
    QWidget* const focus = QApplication::focusWidget();
    if (focus == nullptr) {
        window.setFocus();
        sendKey(window, isOn ? Qt::Key_Tab : Qt::Key_Backtab);
        return;
    }
    if (auto* const list = qobject_cast<QAbstractItemView*>(focus)) {
        const QModelIndex before = list->currentIndex();
        sendKey(*list, arrowKey(arrow));
        if (list->currentIndex() != before)
            return;  // otherwise it was the last entry in this direction, and the focus leaves the list
    }
    if (const auto* button = qobject_cast<QAbstractButton*>(focus); button != nullptr && isOneOfGroup(*button)) {
        sendKey(*focus, arrowKey(arrow));
        if (QApplication::focusWidget() != focus)
            return;
    }
    if (isSideways && qobject_cast<QAbstractSlider*>(focus) != nullptr) {
        sendKey(*focus, arrowKey(arrow));
        return;
    }
    if (isSideways &&
        (qobject_cast<QAbstractSpinBox*>(focus) != nullptr || qobject_cast<QComboBox*>(focus) != nullptr)) {
        // In a combo box the next entry is below; in a spin box the next number is above.
        const bool isUp = (qobject_cast<QComboBox*>(focus) != nullptr) != isOn;
        sendKey(*focus, isUp ? Qt::Key_Up : Qt::Key_Down);
        return;
    }
    sendKey(*focus, isOn ? Qt::Key_Tab : Qt::Key_Backtab);
}

void chooseByPad()
{
    if (QWidget* const popup = openPopup()) {
        sendKey(*popup, Qt::Key_Return);
        return;
    }
    QWidget* const focus = QApplication::focusWidget();
    if (auto* const button = qobject_cast<QAbstractButton*>(focus))
        button->click();
    else if (qobject_cast<QAbstractItemView*>(focus) != nullptr)
        sendKey(*focus, Qt::Key_Return);
    else if (focus != nullptr)
        sendKey(*focus, Qt::Key_Space);
}

bool closeByPad()
{
    if (QWidget* const popup = openPopup()) {
        sendKey(*popup, Qt::Key_Escape);
        return true;
    }
    const QWidget* const focus = QApplication::focusWidget();
    for (QWidget* parent = focus != nullptr ? focus->parentWidget() : nullptr; parent != nullptr;
         parent = parent->parentWidget())
        if (auto* const question = qobject_cast<kit::ConfirmOverlay*>(parent)) {
            sendKey(*question, Qt::Key_Escape);
            return true;
        }
    return false;
}

}  // namespace ui::window
