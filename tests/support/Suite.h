// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>

namespace support {

/// A test class of a program that holds all test classes of one folder. The objects form a list, last one first.
class SuiteEntry
{
public:
    using Make = std::unique_ptr<QObject> (*)();

    /// `file` is the source of the class. Its name without folder and extension is the name of the test.
    SuiteEntry(const char* file, Make make) noexcept : file_(file), make_(make), next_(last_) { last_ = this; }

    /// Makes the test that is called `name`, or null if there is none.
    static std::unique_ptr<QObject> makeTest(const QString& name);
    static QStringList names();

private:
    QString name() const;

    const char* file_;
    Make make_;
    const SuiteEntry* next_;
    static inline const SuiteEntry* last_ = nullptr;
};

}  // namespace support

/// Replaces QTEST_MAIN in a program with several test classes.
#define CUSP_TEST(Class)                                                                                               \
    static const support::SuiteEntry entryOf##Class(                                                                   \
        __FILE__, []() -> std::unique_ptr<QObject> { return std::make_unique<Class>(); });
