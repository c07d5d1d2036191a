// SPDX-License-Identifier: GPL-3.0-or-later
// The main program of all test classes of one folder: `core_tests tst_rim [options of Qt Test]`.
#ifdef QT_WIDGETS_LIB
#include <QApplication>
#else
#include <QCoreApplication>
#endif
#include <QFileInfo>
#include <QTest>

#include "tests/support/Suite.h"

namespace support {

QString SuiteEntry::name() const
{
    return QFileInfo(QString::fromUtf8(file_)).completeBaseName();
}

std::unique_ptr<QObject> SuiteEntry::makeTest(const QString& name)
{
    for (const SuiteEntry* entry = last_; entry; entry = entry->next_)
        if (entry->name() == name)
            return entry->make_();
    return nullptr;
}

QStringList SuiteEntry::names()
{
    QStringList names;
    for (const SuiteEntry* entry = last_; entry; entry = entry->next_)
        names.append(entry->name());
    names.sort();
    return names;
}

}  // namespace support

int main(int argc, char** argv)
{
#ifdef QT_WIDGETS_LIB
    QApplication application(argc, argv);
    QApplication::setAttribute(Qt::AA_Use96Dpi);
#else
    QCoreApplication application(argc, argv);
#endif
    QStringList arguments = QCoreApplication::arguments();
    const auto test = support::SuiteEntry::makeTest(arguments.value(1));
    if (!test) {
        qCritical("Name one of these tests first:\n  %s",
                  qPrintable(support::SuiteEntry::names().join(QStringLiteral("\n  "))));
        return 2;
    }
    // Qt Test names its output after the program, so it gets the name of the test.
    arguments.removeFirst();
    return QTest::qExec(test.get(), arguments);
}
