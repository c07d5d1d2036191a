// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/Codes.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include "core/base/WholeFile.h"
#include "database/Csv.h"

namespace database {

using core::ErrorCode;

core::Status writeCodes(const QString& path, const std::vector<RosterPerson>& people)
{
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || !file.setPermissions(QFile::ReadOwner | QFile::WriteOwner))
        return core::unexpected(ErrorCode::FileUnwritable,
                                "the codes could not be written to " + path.toStdString() + "; choose another place");
    file.write("username,name,code\r\n");
    for (const RosterPerson& person : people)
        if (person.isNew)
            file.write(
                (csvField(person.username) + ',' + csvField(person.fullName) + ',' + person.code + "\r\n").c_str());
    if (!file.flush() || !file.commit())
        return core::unexpected(ErrorCode::FileUnwritable,
                                "the codes could not be written to " + path.toStdString() + "; make room on the disk");
    core::bringToDisk(
        QFileInfo(path).absolutePath().toStdU16String());  // the folder, which holds the name of the new file
    return {};
}

}  // namespace database
