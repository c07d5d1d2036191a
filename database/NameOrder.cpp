// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/NameOrder.h"

#include <QLocale>

namespace database {
namespace {

/// Returns the language of the program. The C locale, which a service has, would sort by bytes.
QLocale sortingLocale()
{
    const QLocale locale;
    return locale.language() == QLocale::C ? QLocale(QLocale::English) : locale;
}

}  // namespace

NameOrder::NameOrder() : m_collator(sortingLocale())
{
    m_collator.setNumericMode(true);
}

int NameOrder::compare(const std::string& a, const std::string& b) const
{
    return m_collator.compare(QString::fromStdString(a), QString::fromStdString(b));
}

bool NameOrder::operator()(const SortedName& a, const SortedName& b) const
{
    if (const int family = compare(a.family, b.family); family != 0)
        return family < 0;
    if (const int given = compare(a.given, b.given); given != 0)
        return given < 0;
    return compare(a.username, b.username) < 0;
}

}  // namespace database
