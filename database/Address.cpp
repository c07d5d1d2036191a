// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/Address.h"

#include <QFileInfo>
#include <QRegularExpression>
#include <QUrl>
#include <QUrlQuery>

#include "database/Usernames.h"

namespace database {
namespace {

const QStringList kSchemes{QStringLiteral("postgresql://"), QStringLiteral("postgres://")};
const QStringList kSslModes{QStringLiteral("disable"), QStringLiteral("allow"),     QStringLiteral("prefer"),
                            QStringLiteral("require"), QStringLiteral("verify-ca"), QStringLiteral("verify-full")};
const QString kVerifyFull = QStringLiteral("verify-full");
constexpr int kLastPort = 65535;

QString decoded(const QString& part)
{
    return QUrl::fromPercentEncoding(part.toUtf8());
}

/// Returns the target of a link: -wal and -shm, backups and the station's key are beside the target, not the link.
QString linkedFile(const QString& name)
{
    const QFileInfo file(name);
    if (!file.isSymLink())
        return name;
    return file.exists() ? file.canonicalFilePath() : file.symLinkTarget();
}

core::Error wrong(const QString& what)
{
    return {core::ErrorCode::BadStructure,
            ("the address of the database " + what + "; write it as postgresql://user@host/name").toStdString()};
}

}  // namespace

QString Address::shown() const
{
    if (!isServer())
        return file;
    const auto coded = [](const QString& part) { return QString::fromLatin1(QUrl::toPercentEncoding(part)); };
    return QStringLiteral("postgresql://") + (user.isEmpty() ? QString() : coded(user) + '@') + coded(host) +
           (port > 0 ? QStringLiteral(":%1").arg(port) : QString()) + '/' + coded(name);
}

bool Address::isOnThisComputer() const
{
    static const QRegularExpression loopback(QStringLiteral("^(localhost|::1|127(\\.[0-9]{1,3}){3})$"),
                                             QRegularExpression::CaseInsensitiveOption);
    return host.isEmpty() || host.startsWith(u'/') || host.startsWith(u'@') || loopback.match(host).hasMatch();
}

QString Address::sslModeInForce() const
{
    return sslMode.isEmpty() && !isOnThisComputer() ? kVerifyFull : sslMode;
}

bool Address::isProtected() const
{
    return !isServer() || isOnThisComputer() || sslModeInForce() == kVerifyFull;
}

core::Result<Address> Address::parse(const QString& text)
{
    Address address;
    QString rest;
    for (const QString& scheme : kSchemes)
        if (text.startsWith(scheme, Qt::CaseInsensitive))
            rest = text.mid(scheme.size());
    if (rest.isNull()) {
        // Otherwise a misspelt scheme would become the name of a file.
        if (text.contains(QStringLiteral("://")))
            return tl::unexpected(wrong(QStringLiteral("names a kind of server that Cusp does not know")));
        if (text.trimmed().isEmpty())
            return core::unexpected(core::ErrorCode::FileMissing,
                                    "the database has no name; give a file or postgresql://user@host/name");
        // Qt and SQLite do not treat these as names of files.
        if (text.startsWith(':') || text.startsWith(QStringLiteral("file:"), Qt::CaseInsensitive))
            return core::unexpected(core::ErrorCode::WrongKind,
                                    QStringLiteral("\"%1\" is no name of a file for a database; give another, or its "
                                                   "whole path")
                                        .arg(text)
                                        .toStdString());
        address.file = linkedFile(text);
        return address;
    }
    const QString query = rest.section('?', 1);
    rest = rest.section('?', 0, 0);
    address.name = decoded(rest.section('/', 1));
    QString server = rest.section('/', 0, 0);
    if (server.contains('@')) {
        const QString who = server.section('@', 0, -2);
        if (who.contains(':'))
            return core::unexpected(core::ErrorCode::OutOfRange,
                                    "the address of the database holds a password, which others on this computer can "
                                    "see; write it into the file ~/.pgpass, and leave it out of the address");
        address.user = decoded(who);
        server = server.section('@', -1);
    }
    // The colons of an IPv6 address are inside brackets.
    const auto bracket = server.lastIndexOf(']');
    if (const auto colon = server.indexOf(':', bracket + 1); colon >= 0) {
        bool isNumber = false;
        address.port = server.mid(colon + 1).toInt(&isNumber);
        if (!isNumber || address.port < 1 || address.port > kLastPort)
            return tl::unexpected(wrong(QStringLiteral("has a port that is no number from 1 to 65535")));
        server.truncate(colon);
    }
    if (server.startsWith('[') && server.endsWith(']'))
        server = server.mid(1, server.size() - 2);
    address.host = decoded(server);
    if (address.name.isEmpty() || address.name.contains('/'))
        return tl::unexpected(wrong(QStringLiteral("names no database")));
    const bool isSeen = canBeSeen(address.name.toStdString()) && canBeSeen(address.user.toStdString()) &&
                        canBeSeen(address.host.toStdString());
    if (!isSeen)
        return tl::unexpected(wrong(QStringLiteral("holds a character that cannot be seen")));
    for (const auto& [key, value] : QUrlQuery(query).queryItems(QUrl::FullyDecoded)) {
        if (key == u"sslrootcert") {
            // libpq gets these names in one text, in which Qt uses the semicolon.
            if (value.isEmpty() || value.contains(u';') || value.contains(u'\'') || value.contains(u'\\'))
                return tl::unexpected(
                    wrong(QStringLiteral("has an sslrootcert that names no file, or one with ; ' or \\")));
            address.sslRootCert = value;
            continue;
        }
        if (key != u"sslmode")
            return tl::unexpected(wrong(QStringLiteral("has \"%1\", which Cusp does not know").arg(key)));
        if (!kSslModes.contains(value))
            return tl::unexpected(wrong(QStringLiteral("has an sslmode that is none of %1").arg(kSslModes.join(", "))));
        address.sslMode = value;
    }
    return address;
}

}  // namespace database
