// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/base/Result.h"

namespace database {

/// The location of a school's database: an SQLite file, or a database on a PostgreSQL server.
struct Address
{
    QString file;         ///< path of the SQLite file; empty: a server
    QString host;         ///< a name, an address or the folder of a socket; empty: this computer's default socket
    int port = 0;         ///< 0: the default port
    QString user;         ///< empty: the user's name on this computer
    QString name;         ///< of the database
    QString sslMode;      ///< as in libpq: "require", "verify-full" ...; empty: not asked for
    QString sslRootCert;  ///< file of the certificates that may vouch for the server; empty: the usual ones

    bool operator==(const Address&) const = default;

    [[nodiscard]] bool isServer() const { return file.isEmpty(); }
    /// Returns whether the server is on this computer: the host is a socket or a loopback address.
    [[nodiscard]] bool isOnThisComputer() const;
    /// Returns the sslmode of the connection: the one asked for, otherwise "verify-full" for a server on another
    /// computer. libpq itself would take unencrypted connections too, and not check which server answers.
    [[nodiscard]] QString sslModeInForce() const;
    /// Returns whether nobody on the network can read or change what is sent: the server is on this computer, or proves
    /// its name over an encrypted connection.
    [[nodiscard]] bool isProtected() const;
    /// Returns the file, or the URL without its options, for display.
    [[nodiscard]] QString shown() const;

    /// Parses "school.sqlite" or "postgresql://user@host:port/name?sslmode=verify-ca&sslrootcert=/etc/school.crt". Each
    /// part is percent-encoded where it contains a delimiter: a socket's folder is "%2Frun%2Fpostgresql".
    [[nodiscard]] static core::Result<Address> parse(const QString& text);
};

}  // namespace database
