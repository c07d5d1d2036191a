// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/PrivateFile.h"

#include <QFileInfo>
#include <QSaveFile>

namespace ui::kit {

bool openForOwner(QSaveFile& file)
{
    const bool isNew = !QFileInfo::exists(file.fileName());
    if (!file.open(QIODevice::WriteOnly))
        return false;
    // A share or a stick may have no rights to give: what is written there is as safe as whatever else lies there.
    if (isNew)
        file.setPermissions(QFileDevice::ReadOwner | QFileDevice::WriteOwner);
    return true;
}

}  // namespace ui::kit
