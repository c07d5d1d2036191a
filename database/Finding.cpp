// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/Finding.h"

#include "core/base/Words.h"

namespace database {

QString Finding::english() const
{
    return QString::fromStdString(core::filled(words, values));
}

}  // namespace database
