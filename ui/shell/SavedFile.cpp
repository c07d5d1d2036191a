// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/SavedFile.h"

#include <QFileInfo>
#include <QSaveFile>

namespace ui::shell {

bool openForOwner(QSaveFile& file)
{
    const bool isNew = !QFileInfo::exists(file.fileName());
    return file.open(QIODevice::WriteOnly) &&
           (!isNew || file.setPermissions(QFileDevice::ReadOwner | QFileDevice::WriteOwner));
}

}  // namespace ui::shell
