// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QProcess>
#include <QString>
#include <QTemporaryDir>

namespace support {

/// A PostgreSQL server of its own in a scratch folder, reached by a socket there; it ends with the object, and with the
/// test if that is killed. Root runs it as "nobody", since PostgreSQL refuses root.
class PostgresServer
{
public:
    PostgresServer();
    ~PostgresServer();
    PostgresServer(const PostgresServer&) = delete;
    PostgresServer& operator=(const PostgresServer&) = delete;

    /// Empty: it runs. Else what went wrong, or that PostgreSQL is not installed.
    [[nodiscard]] const QString& fault() const { return m_fault; }

    /// Creates a database and returns its address for cusp.
    /// @param like  address of one to copy, to which nobody is connected; empty: an empty one
    [[nodiscard]] QString newDatabase(const QString& like = {});

    /// As a cable that is pulled, and plugged in again: the server stops at once, and starts anew.
    void kill();
    /// As its administrator stops it: it takes leave of who is connected.
    void stop();
    [[nodiscard]] bool start();

private:
    void end(int signal);
    [[nodiscard]] bool run(const QString& program, const QStringList& arguments);
    [[nodiscard]] QStringList asUser(const QString& program) const;

    QTemporaryDir m_folder;
    QString m_fault;
    QProcess m_server;
    int m_databases = 0;
};

}  // namespace support
