// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <QSet>
#include <QString>

#include "database/Person.h"

namespace ui::admin {

/// The roles of the form, in the order of its list.
inline constexpr std::array kRoles{database::Role::Student, database::Role::Instructor, database::Role::Admin};

/// The contents of the form of a person.
struct TypedPerson
{
    database::Person asItWas;  ///< the person that the form was filled with; its id is 0 for a new person
    QString username;
    QString given;
    QString family;
    int role = 0;
    QSet<qint64> classes;

    [[nodiscard]] qint64 person() const { return asItWas.id.value; }
    /// Returns the form of a person without changes.
    [[nodiscard]] static TypedPerson asEntered(const database::Person& person);
    /// Returns the form of the person as they are in the database now, with the user's changes applied.
    [[nodiscard]] TypedPerson onto(const database::Person& now) const;
};

}  // namespace ui::admin
