// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QProcess>
#include <QString>
#include <QTemporaryDir>

namespace support {

/// A PostgreSQL server in a temporary folder, with a socket there. It ends with the object, and with the test if that
/// is killed. As root it runs as "nobody", because PostgreSQL refuses root.
class PostgresServer
{
public:
    PostgresServer();
    ~PostgresServer();
    PostgresServer(const PostgresServer&) = delete;
    PostgresServer& operator=(const PostgresServer&) = delete;

    /// Returns an empty text if the server runs; otherwise the error, or that PostgreSQL is not installed.
    [[nodiscard]] const QString& fault() const { return m_fault; }

    /// Creates a database and returns its address for cusp.
    /// @param like  address of a database to copy, which has no connections; empty: an empty one
    [[nodiscard]] QString newDatabase(const QString& like = {});

    /// Restarts the server so that it takes connections from the network as well. Its certificate, signed by itself, is
    /// for "localhost". Returns false if that fails; fault() gives the reason.
    [[nodiscard]] bool listen(bool isEncrypted);
    /// Returns the file of that certificate, and the port on which the server listens.
    [[nodiscard]] QString certificate() const { return m_folder.filePath("data/server.crt"); }
    [[nodiscard]] int port() const { return m_port; }

    /// Stops the server at once, like a cable that is pulled. start() starts it again.
    void kill();
    /// Stops the server like an administrator: it closes its connections properly.
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
    bool m_isEncrypted = false;
    int m_port = 0;  ///< 0: it listens on its socket only
};

}  // namespace support
