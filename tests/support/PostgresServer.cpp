// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/PostgresServer.h"

#include <csignal>

#include <QDir>
#include <QElapsedTimer>
#include <QUrl>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace support {
namespace {

constexpr int kLongMs = 60'000;

/// Returns the folder of the newest PostgreSQL of Debian.
QString binaries()
{
    const QDir versions(QStringLiteral("/usr/lib/postgresql"));
    for (const QString& version : versions.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name | QDir::Reversed))
        if (QFile::exists(versions.filePath(version + "/bin/postgres")))
            return versions.filePath(version + "/bin/");
    return {};
}

}  // namespace

PostgresServer::PostgresServer()
{
    if (binaries().isEmpty()) {
        m_fault = QStringLiteral("PostgreSQL is not installed");
        return;
    }
    // The path of the socket must be short, and the user that runs the server must have access to its folder.
    QFile::setPermissions(m_folder.path(), QFile::Permissions(0x7777));
    if (!run(binaries() + "initdb", {"-D", m_folder.filePath("data"), "-U", "school", "-A", "trust", "-E", "UTF8",
                                     "--locale=C.UTF-8", "--no-sync"}) ||
        !start())
        m_fault = "the server does not start: " + m_fault;
}

PostgresServer::~PostgresServer()
{
    kill();
    if (geteuid() == 0)  // root can remove what "nobody" created
        QDir(m_folder.path()).removeRecursively();
}

QStringList PostgresServer::asUser(const QString& program) const
{
    if (geteuid() != 0)
        return {program};
    return {"setpriv", "--reuid=nobody", "--regid=nogroup", "--clear-groups", "--pdeathsig=QUIT", program};
}

bool PostgresServer::run(const QString& program, const QStringList& arguments)
{
    QProcess process;
    process.setWorkingDirectory(m_folder.path());
    const QStringList words = asUser(program) + arguments;
    process.start(words.first(), words.mid(1));
    if (process.waitForFinished(kLongMs) && process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0)
        return true;
    m_fault = program + ": " + QString::fromUtf8(process.readAllStandardError());
    return false;
}

bool PostgresServer::start()
{
    // Tests do not need data on the disk. A benchmark syncs like a school's server.
    const QString sync = qEnvironmentVariableIsSet("CUSP_FSYNC") ? "fsync=on" : "fsync=off";
    QStringList words = asUser(binaries() + "postgres") +
                        QStringList{"-D", m_folder.filePath("data"), "-k", m_folder.path(),         "-c", sync,
                                    "-c", "max_connections=200",     "-c", "log_min_messages=panic"};
    words += m_port == 0
                 ? QStringList{"-h", ""}
                 : QStringList{"-h", "*", "-p", QString::number(m_port), "-c", m_isEncrypted ? "ssl=on" : "ssl=off"};
    m_server.setWorkingDirectory(m_folder.path());
    m_server.setStandardErrorFile(QProcess::nullDevice());
    m_server.start(words.first(), words.mid(1));
    QElapsedTimer since;
    since.start();
    while (since.elapsed() < kLongMs && m_server.state() != QProcess::NotRunning) {
        if (run(binaries() + "psql", {"-h", m_folder.path(), "-p", QString::number(m_port == 0 ? 5432 : m_port), "-U",
                                      "school", "-d", "postgres", "-c", "SELECT 1"})) {
            m_fault.clear();  // discards the errors of connecting too early
            return true;
        }
        m_server.waitForFinished(50);  // waits a little before the next attempt, unless the server ends
    }
    return false;
}

bool PostgresServer::listen(bool isEncrypted)
{
    const QString data = m_folder.filePath("data");
    const int probe = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    socklen_t size = sizeof(address);
    const bool isBound = bind(probe, reinterpret_cast<const sockaddr*>(&address), size) == 0 &&
                         getsockname(probe, reinterpret_cast<sockaddr*>(&address), &size) == 0;
    close(probe);
    stop();
    m_isEncrypted = isEncrypted;
    m_port = ntohs(address.sin_port);
    return isBound &&
           run("openssl",
               {"req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj", "/CN=localhost", "-addext",
                "subjectAltName=DNS:localhost", "-keyout", data + "/server.key", "-out", data + "/server.crt"}) &&
           run("sh", {"-c", "echo 'host all all all trust' >> '" + data + "/pg_hba.conf' && chmod 600 '" + data +
                                "/server.key'"}) &&
           start();
}

void PostgresServer::end(int signal)
{
    if (m_server.state() == QProcess::NotRunning)
        return;
    ::kill(static_cast<pid_t>(m_server.processId()), signal);
    m_server.waitForFinished(kLongMs);
}

void PostgresServer::kill()
{
    end(SIGQUIT);
}

void PostgresServer::stop()
{
    end(SIGINT);
}

QString PostgresServer::newDatabase(const QString& like)
{
    const QString name = QStringLiteral("school%1").arg(++m_databases);
    const QString model = like.isEmpty() ? QStringLiteral("template1") : like.section(u'/', -1);
    if (!run(binaries() + "createdb", {"-h", m_folder.path(), "-U", "school", "-T", model, name}))
        return {};
    return QStringLiteral("postgresql://school@%1/%2")
        .arg(QString::fromLatin1(QUrl::toPercentEncoding(m_folder.path())), name);
}

}  // namespace support
