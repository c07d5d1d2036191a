// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/Accessibility.h"

#include <QAccessible>
#include <QWidget>

namespace ui::kit {

void announce(QWidget& widget)
{
    QAccessibleEvent event(&widget, QAccessible::Alert);
    QAccessible::updateAccessibility(&event);
}

}  // namespace ui::kit
