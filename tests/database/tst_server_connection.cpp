// SPDX-License-Identifier: GPL-3.0-or-later
// The connection to a real server on the network: which one is taken, and which is refused.
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>

#include "database/sql/Database.h"
#include "database/sql/Statement.h"
#include "tests/support/Checks.h"
#include "tests/support/PostgresServer.h"
#include "tests/support/Suite.h"

using core::ErrorCode;
using database::Address;
using database::sql::Database;

namespace {

/// Returns an address of this computer that is no loopback; empty if it has none.
QString ownAddress()
{
    ifaddrs* all = nullptr;
    if (getifaddrs(&all) != 0)
        return {};
    QString found;
    for (const ifaddrs* one = all; one != nullptr && found.isEmpty(); one = one->ifa_next) {
        if (one->ifa_addr == nullptr || one->ifa_addr->sa_family != AF_INET || (one->ifa_flags & IFF_LOOPBACK) != 0)
            continue;
        char text[INET_ADDRSTRLEN] = {};
        const auto* address = reinterpret_cast<const sockaddr_in*>(one->ifa_addr);
        found = QString::fromLatin1(inet_ntop(AF_INET, &address->sin_addr, text, sizeof(text)));
    }
    freeifaddrs(all);
    return found;
}

}  // namespace

class TestServerConnection : public QObject
{
    Q_OBJECT

private slots:
    void whichServersAreOnThisComputer_data()
    {
        QTest::addColumn<bool>("isHere");
        for (const char* host :
             {"", "%2Frun%2Fpostgresql", "localhost", "LOCALHOST", "127.0.0.1", "127.1.2.3", "[::1]"})
            QTest::newRow(host[0] == 0 ? "none" : host) << true;
        for (const char* host :
             {"server", "10.0.0.7", "127.school.example", "127.0.0.1.example", "localhost.example", "[::2]"})
            QTest::newRow(host) << false;
    }
    void whichServersAreOnThisComputer()
    {
        QFETCH(const bool, isHere);
        const QByteArray tag = QTest::currentDataTag();
        const QString host = tag == "none" ? QString() : QString::fromLatin1(tag);
        const Address plain = Address::parse("postgresql://cusp@" + host + "/school").value();
        QCOMPARE(plain.isOnThisComputer(), isHere);
        QCOMPARE(plain.sslModeInForce(), isHere ? QString() : QString("verify-full"));
        QVERIFY(plain.isProtected());
        for (const char* mode : {"disable", "allow", "prefer", "require", "verify-ca"}) {
            const Address asked = Address::parse("postgresql://cusp@" + host + "/school?sslmode=" + mode).value();
            QCOMPARE(asked.sslModeInForce(), QString(mode));
            QCOMPARE(asked.isProtected(), isHere);
        }
    }

    void certificatesThatAreNoFileAreRefused()
    {
        const QString address = "postgresql://cusp@server/school?sslrootcert=";
        QCOMPARE(Address::parse(address + "/etc/our%20school.crt")->sslRootCert, QString("/etc/our school.crt"));
        for (const char* file : {"", "a;sslmode=disable", "a'", "a%27%20sslmode=disable", "a%3Bb", "a\\"})
            QVERIFY2(!Address::parse(address + file), file);
    }

    /// Other users of a computer can see its command lines.
    void aPasswordInAnAddressIsRefused()
    {
        for (const char* who : {"cusp:secret", "cusp:", "cu%3Asp:secret%40"}) {
            const auto address = Address::parse(QString("postgresql://%1@server/school").arg(who));
            QVERIFY2(!address && address.error().detail.find(".pgpass") != std::string::npos, who);
            QVERIFY2(address.error().detail.find("secret") == std::string::npos, who);
        }
        QCOMPARE(Address::parse("postgresql://cu%3Asp@server/school")->user, QString("cu:sp"));
    }

    void aServerProvesItsName_data()
    {
        QTest::addColumn<QString>("host");
        QTest::addColumn<QString>("options");
        QTest::addColumn<QByteArray>("words");  // of the refusal; empty: it connects
        const auto add = [](const char* name, const char* host, const char* options, const char* words) {
            QTest::newRow(name) << QString(host) << QString(options) << QByteArray(words);
        };
        add("its name and certificate", "localhost", "?sslmode=verify-full&sslrootcert=CERT", "");
        add("another name", "127.0.0.1", "?sslmode=verify-full&sslrootcert=CERT", "prove");
        add("another certificate", "localhost", "?sslmode=verify-full&sslrootcert=OTHER", "prove");
        add("no certificate of the school", "localhost", "?sslmode=verify-full&sslrootcert=/nowhere", "prove");
        add("one that no authority signed", "localhost", "?sslmode=verify-full", "prove");
        add("less is asked for", "localhost", "?sslmode=require", "");
        add("from elsewhere", "OWN", "", "prove");
        add("from elsewhere, less is asked for", "OWN", "?sslmode=require", "");
    }
    void aServerProvesItsName()
    {
        QFETCH(QString, host);
        QFETCH(QString, options);
        QFETCH(const QByteArray, words);
        if (!m_server.fault().isEmpty())
            QSKIP(qPrintable(m_server.fault()));
        if (m_server.port() == 0)
            QVERIFY2(m_server.listen(true), qPrintable(m_server.fault()));
        if (host == "OWN" && (host = ownAddress()).isEmpty())
            QSKIP("This computer is in no network.");
        const bool isElsewhere = host != "localhost" && host != "127.0.0.1";
        QTemporaryDir folder;
        QVERIFY(QFile::copy(m_server.certificate(), folder.filePath("school.crt")));
        options.replace("CERT", folder.filePath("school.crt")).replace("OTHER", "/etc/ssl/certs/ca-certificates.crt");
        Database::Options how;
        how.mayCreate = how.mayMigrate = true;
        const QString address =
            QString("postgresql://school@%1:%2/postgres%3").arg(host).arg(m_server.port()).arg(options);
        const auto open = Database::open(Address::parse(address).value(), how);
        if (!words.isEmpty()) {
            QVERIFY(!open);
            QCOMPARE(open.error().code, ErrorCode::ServerUnknown);
            QVERIFY2(open.error().detail.find(words.toStdString()) != std::string::npos, open.error().detail.c_str());
            return;
        }
        QVERIFY2(open, open ? "" : open.error().detail.c_str());
        const auto isEncrypted =
            database::sql::ask((*open)->handle(), "SELECT ssl FROM pg_stat_ssl WHERE pid = pg_backend_pid()", "ask");
        QVERIFY(isEncrypted && isEncrypted->toBool());
        QCOMPARE((*open)->notice().find("not protected") != std::string::npos, isElsewhere);
    }

    void aServerWithoutEncryptionIsRefused()
    {
        support::PostgresServer server;
        if (!server.fault().isEmpty())
            QSKIP(qPrintable(server.fault()));
        QVERIFY2(server.listen(false), qPrintable(server.fault()));
        const QString address = QString("postgresql://school@localhost:%1/postgres").arg(server.port());
        Database::Options how;
        how.mayCreate = how.mayMigrate = true;
        for (const char* mode : {"?sslmode=require", "?sslmode=verify-full"}) {
            const auto open = Database::open(Address::parse(address + mode).value(), how);
            QVERIFY2(!open && open.error().code == ErrorCode::ServerUnknown, mode);
        }
        QVERIFY(Database::open(Address::parse(address).value(), how).has_value());
    }

private:
    support::PostgresServer m_server;
};

CUSP_TEST(TestServerConnection)
#include "tst_server_connection.moc"
