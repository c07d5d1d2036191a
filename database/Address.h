// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/base/Result.h"

namespace database {

/// Where a school's data is kept: an SQLite file, or a database on a PostgreSQL server.
struct Address
{
    QString file;      ///< of SQLite; empty: a server
    QString host;      ///< a name, a number, or the folder of a socket; empty: this machine's default socket
    int port = 0;      ///< 0: the server's usual one
    QString user;      ///< empty: as the user is called here
    QString password;  ///< better in ~/.pgpass, where a command line does not show it
    QString name;      ///< of the database
    QString sslMode;   ///< as libpq has it: "require", "verify-full" ...; empty: its default

    bool operator==(const Address&) const = default;

    [[nodiscard]] bool isServer() const { return file.isEmpty(); }
    /// For people: the file, or the URL without its password.
    [[nodiscard]] QString shown() const;

    /// "school.sqlite" or "postgresql://user@host:port/name?sslmode=require", each part percent-coded where it holds
    /// what would end it: a socket's folder is "%2Frun%2Fpostgresql".
    [[nodiscard]] static core::Result<Address> parse(const QString& text);
};

}  // namespace database
