// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/admin/TypedPerson.h"

#include <algorithm>

namespace ui::admin {

TypedPerson TypedPerson::asEntered(const database::Person& person)
{
    TypedPerson form{person,
                     QString::fromStdString(person.username),
                     QString::fromStdString(person.givenName),
                     QString::fromStdString(person.familyName),
                     static_cast<int>(std::find(kRoles.begin(), kRoles.end(), person.role) - kRoles.begin()),
                     {}};
    for (const database::ClassId one : person.classes)
        form.classes.insert(one.value);
    return form;
}

TypedPerson TypedPerson::onto(const database::Person& now) const
{
    const TypedPerson before = asEntered(asItWas);
    TypedPerson form = asEntered(now);
    if (given != before.given)
        form.given = given;
    if (family != before.family)
        form.family = family;
    if (role != before.role)
        form.role = role;
    form.classes += classes - before.classes;
    form.classes -= before.classes - classes;
    return form;
}

}  // namespace ui::admin
