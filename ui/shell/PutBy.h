// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include <QByteArray>
#include <QJsonArray>
#include <QString>

namespace ui::shell {

/// What people have typed and kept nowhere, when a window closes at which somebody else stands by then: on the disk of
/// the computer, until a window starts there again. Each window has a file of its own in the folder, and takes over
/// those that no other holds. Nothing is written before there is something.
class PutBy
{
public:
    /// Takes over what lies there.
    explicit PutBy(QString folder);

    [[nodiscard]] const QJsonArray& found() const { return m_found; }
    /// In place of what was found and of what was kept before; where it is empty nothing is left. Only who runs the
    /// program may read it. False: it could not be written, and what lay there does still.
    [[nodiscard]] bool keep(const QJsonArray& all);

private:
    [[nodiscard]] bool hold(const QString& file);
    [[nodiscard]] bool holdNew();

    /// Keeps other windows from a file while it lives (flock): whatever ends the program, and whatever the computer is
    /// called by then, it holds nothing any more.
    class Lock
    {
    public:
        explicit Lock(const QString& file);
        ~Lock();
        Lock(Lock&& other) noexcept : m_name(std::move(other.m_name)), m_file(std::exchange(other.m_file, -1)) {}
        Lock& operator=(Lock&& other) noexcept
        {
            std::swap(m_name, other.m_name);
            std::swap(m_file, other.m_file);
            return *this;
        }
        Lock(const Lock&) = delete;
        Lock& operator=(const Lock&) = delete;
        [[nodiscard]] bool isHeld() const { return m_file >= 0; }

    private:
        QByteArray m_name;
        int m_file = -1;
    };
    /// A file that is this window's for as long as it is locked.
    struct Held
    {
        QString file;
        Lock lock;
    };

    QString m_folder;
    std::vector<Held> m_held;  ///< the first is written, the others go when it has been
    QJsonArray m_found;
    QJsonArray m_kept;  ///< what the first of them holds
};

}  // namespace ui::shell
