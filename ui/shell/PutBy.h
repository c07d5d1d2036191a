// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QJsonArray>
#include <QString>

#include "core/base/FileLock.h"

namespace ui::shell {

/// What people have typed and kept nowhere, when a window closes at which somebody else stands by then: on the disk of
/// the computer, until a window starts there again. Each window has a file of its own in the folder, and takes over
/// those of its school that no other holds: those of another school wait for that. Nothing is written before there is
/// something.
class PutBy
{
public:
    /// Takes over what lies there.
    /// @param school  in which it was typed, see database::Outbox::schoolAt(). What an earlier program has put by,
    /// which did not say, is taken for this one's.
    PutBy(QString folder, QString school);

    [[nodiscard]] const QJsonArray& found() const { return m_found; }
    /// In place of what was found and of what was kept before; where it is empty nothing is left. Only who runs the
    /// program may read it. False: it could not be written, and what lay there does still.
    [[nodiscard]] bool keep(const QJsonArray& all);

private:
    [[nodiscard]] bool hold(const QString& file);
    [[nodiscard]] bool holdNew();

    /// A file that is this window's for as long as it is locked.
    struct Held
    {
        QString file;
        core::FileLock lock;
    };

    QString m_folder;
    QString m_school;
    std::vector<Held> m_held;  ///< the first is written, the others go when it has been
    QJsonArray m_found;
    QJsonArray m_kept;  ///< what the first of them holds
};

}  // namespace ui::shell
