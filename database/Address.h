// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/base/Result.h"

namespace database {

/// The location of a school's database: an SQLite file, or a database on a PostgreSQL server.
struct Address
{
    QString file;      ///< path of the SQLite file; empty: a server
    QString host;      ///< a name, an address or the folder of a socket; empty: this computer's default socket
    int port = 0;      ///< 0: the default port
    QString user;      ///< empty: the user's name on this computer
    QString password;  ///< better stored in ~/.pgpass, because others can see command lines
    QString name;      ///< of the database
    QString sslMode;   ///< as in libpq: "require", "verify-full" ...; empty: its default

    bool operator==(const Address&) const = default;

    [[nodiscard]] bool isServer() const { return file.isEmpty(); }
    /// Returns the file, or the URL without the password, for display.
    [[nodiscard]] QString shown() const;

    /// Parses "school.sqlite" or "postgresql://user@host:port/name?sslmode=require". Each part is percent-encoded where
    /// it contains a delimiter: a socket's folder is "%2Frun%2Fpostgresql".
    [[nodiscard]] static core::Result<Address> parse(const QString& text);
};

}  // namespace database
