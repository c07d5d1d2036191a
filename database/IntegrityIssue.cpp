// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/IntegrityIssue.h"

#include "core/base/LocalizableText.h"

namespace database {

QString IntegrityIssue::english() const
{
    return QString::fromStdString(core::filled(words, values));
}

}  // namespace database
