// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/NextStep.h"

#include <QPushButton>
#include <QStyle>

namespace ui::devices {

void setFilled(QPushButton& button, bool isFilled)
{
    const QString kind = isFilled ? QStringLiteral("filled") : QString();
    if (button.property("kind").toString() == kind)
        return;
    button.setProperty("kind", kind);
    button.style()->unpolish(&button);
    button.style()->polish(&button);
    button.updateGeometry();  // bold words are wider
}

}  // namespace ui::devices
