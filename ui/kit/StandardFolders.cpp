// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/StandardFolders.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace ui::kit {

QString documentsFolder()
{
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QFileInfo(documents).isDir() ? documents : QDir::homePath();
}

}  // namespace ui::kit
