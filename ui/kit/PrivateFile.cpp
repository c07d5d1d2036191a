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
    // Failure is ignored: a network share or a USB stick may not support permissions, and other files there are not
    // protected either.
    if (isNew)
        file.setPermissions(QFileDevice::ReadOwner | QFileDevice::WriteOwner);
    return true;
}

}  // namespace ui::kit
