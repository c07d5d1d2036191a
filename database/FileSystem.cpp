// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/FileSystem.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <QDir>
#include <QFile>
#include <QFileInfo>

#ifdef __linux__
#include <sys/vfs.h>
#endif

namespace database {

FileSystem fileSystemOf(const QString& path)
{
#ifdef __linux__
    // Magic numbers of network file systems, see statfs(2).
    static constexpr std::array<std::uint32_t, 14> kNetworks{0x6969,       // NFS
                                                             0x517B,       // SMB
                                                             0xFF534D42,   // CIFS
                                                             0xFE534D42,   // SMB 2
                                                             0x65735546,   // FUSE
                                                             0x5346414F,   // AFS
                                                             0x73757245,   // Coda
                                                             0x0BD00BD0,   // Lustre
                                                             0x00C36400,   // Ceph
                                                             0x7461636F,   // OCFS2
                                                             0x01161970,   // GFS2
                                                             0x01021997,   // 9P, of virtual machines
                                                             0x786F4256,   // VirtualBox
                                                             0xBACBACBC};  // VMware
    struct statfs found
    {};
    const QByteArray folder = QFile::encodeName(QFileInfo(path).absolutePath());
    if (statfs(folder.constData(), &found) == 0 &&
        std::find(kNetworks.begin(), kNetworks.end(), static_cast<std::uint32_t>(found.f_type)) != kNetworks.end())
        return FileSystem::Network;
#else
    static_cast<void>(path);
#endif
    return FileSystem::Local;
}

void makeOwnFolder(const QString& path)
{
    QDir().mkpath(QFileInfo(path).absolutePath());
    QDir().mkdir(path, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
}

std::optional<QByteArray> contentOf(const QString& path, qint64 most)
{
    QFile file(path);
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly) || file.size() > most)
        return std::nullopt;
    return file.read(file.size());
}

}  // namespace database
