// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QTest>

/// Data of test functions.
namespace support {

/// Adds the columns of a table, in their order.
template <class... Type, class... Name>
void columns(Name... names)
{
    (QTest::addColumn<Type>(names), ...);
}

/// Adds a table of one column, with each row named by its value.
template <class T>
void rows(const char* column, const std::vector<T>& values)
{
    QTest::addColumn<T>(column);
    for (const T& value : values)
        QTest::newRow(qPrintable(QStringLiteral("%1").arg(value))) << value;
}

/// Adds a table of two columns: each value of one with each of the other.
template <class A, class B>
void rows(const char* one, const std::vector<A>& ones, const char* other, const std::vector<B>& others)
{
    columns<A, B>(one, other);
    for (const A& a : ones)
        for (const B& b : others)
            QTest::newRow(qPrintable(QStringLiteral("%1, %2").arg(a).arg(b))) << a << b;
}

}  // namespace support
