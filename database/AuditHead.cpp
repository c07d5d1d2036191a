// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/AuditHead.h"

#include <QRegularExpression>

namespace database {
namespace {

constexpr std::size_t kCodeDigits = 12;  ///< of the hash

}  // namespace

std::string AuditHead::code() const
{
    return seq == 0 ? std::string("0") : std::to_string(seq) + '-' + hash.substr(0, kCodeDigits);
}

std::optional<AuditHead> readAuditCode(const std::string& typed)
{
    static const QRegularExpression kCode(QStringLiteral("^([1-9][0-9]{0,17})-([0-9a-f]{12,64})$"));
    const QRegularExpressionMatch found = kCode.match(QString::fromStdString(typed).trimmed().toLower());
    if (!found.hasMatch())
        return std::nullopt;
    return AuditHead{found.captured(1).toLongLong(), found.captured(2).toStdString()};
}

}  // namespace database
