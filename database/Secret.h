// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <QString>

namespace database {

/// A password or one-time code in memory. Each object overwrites its copy of the text when it is destroyed, so that the
/// text is not found later in freed memory or in the swap file. Text fields and libraries make copies of their own,
/// which nobody overwrites.
class Secret
{
public:
    explicit Secret(const std::string& text) : m_text(text) {}
    explicit Secret(const QString& text);
    // There is no move: it would leave short texts behind.
    Secret(const Secret&) = default;
    Secret& operator=(const Secret&) = delete;
    ~Secret();

    [[nodiscard]] const std::string& text() const { return m_text; }

private:
    std::string m_text;
};

/// Overwrites a text. Does nothing to a QString that shares its text with another one.
void wipe(QString& text);
void wipe(std::string& text);

}  // namespace database
