// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <QCollator>
#include <QString>

namespace database {

/// The parts of a person's name in the order in which a list of names is sorted.
struct SortedName
{
    std::string family;
    std::string given;
    std::string username;
};

/// Sorts names as a directory in the language of the program does: Celik and Çelik before Yilmaz, DEN2 before DEN10.
/// A database sorts by the bytes or by the language of its server. One thread.
class NameOrder
{
public:
    NameOrder();

    /// Each returns whether the first comes before the second.
    [[nodiscard]] bool operator()(const QString& a, const QString& b) const { return m_collator.compare(a, b) < 0; }
    [[nodiscard]] bool operator()(const std::string& a, const std::string& b) const { return compare(a, b) < 0; }
    [[nodiscard]] bool operator()(const SortedName& a, const SortedName& b) const;

private:
    [[nodiscard]] int compare(const std::string& a, const std::string& b) const;

    QCollator m_collator;
};

}  // namespace database
