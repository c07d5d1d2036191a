// SPDX-License-Identifier: GPL-3.0-or-later
// make_school FILE|URL [STUDENTS [ATTEMPTS [SEED]]]: generates a large school for timing with "cusp db measure --as
// admin". Writes the password of "admin" to standard output.
#include <cstdio>

#include <QCoreApplication>

#include "tests/database/Sample.h"

int main(int argc, char* argv[])
{
    const QCoreApplication application(argc, argv);
    const QStringList words = QCoreApplication::arguments();
    support::SampleSize size;
    size.students = words.value(2, QString::number(size.students)).toInt();
    size.attempts = words.value(3, QString::number(size.attempts)).toLongLong();
    size.seed = words.value(4, QString::number(size.seed)).toULongLong();
    const auto password = support::makeSchool(words.value(1), size);
    if (!password)
        std::fprintf(stderr, "%s\n", password.error().detail.c_str());
    else
        std::printf("%s\n", password->c_str());
    return password ? 0 : 1;
}
