// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/AppSettings.h"

namespace ui::kit {

QSettings memory()
{
    return QSettings(QStringLiteral("cusp"), QStringLiteral("cusp"));
}

bool recalled(const QSettings& kept, const QString& key, bool otherwise)
{
    const QString word = kept.value(key).toString();
    return word == u"true" || (otherwise && word != u"false");
}

}  // namespace ui::kit
