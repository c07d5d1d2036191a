// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/Secret.h"

#include <QByteArray>
#include <sodium.h>

namespace database {

Secret::Secret(const QString& text)
{
    QByteArray bytes = text.toUtf8();
    m_text.assign(bytes.constData(), static_cast<std::size_t>(bytes.size()));
    sodium_memzero(bytes.data(), static_cast<std::size_t>(bytes.size()));
}

Secret::~Secret()
{
    wipe(m_text);
}

void wipe(QString& text)
{
    if (text.isDetached())
        sodium_memzero(text.data(), static_cast<std::size_t>(text.size()) * sizeof(QChar));
}

void wipe(std::string& text)
{
    sodium_memzero(text.data(), text.size());
}

}  // namespace database
