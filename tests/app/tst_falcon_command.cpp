// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>
#include <vector>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/Program.h"
#include "tests/support/ToothMaps.h"

using support::Ending;
using support::runCusp;

namespace {

/// The rows of a table; each maps the name of a column to a number.
using Table = std::vector<std::map<QByteArray, double>>;

Table parsed(const QByteArray& csv)
{
    Table table;
    QByteArrayList names;
    for (const QByteArray& line : csv.trimmed().split('\n')) {
        const QByteArrayList cells = line.trimmed().split(',');
        if (names.isEmpty()) {
            names = cells;
            continue;
        }
        auto& row = table.emplace_back();
        for (qsizetype k = 0; k < names.size(); ++k)
            row[names[k]] = cells.value(k).toDouble();
    }
    return table;
}

}  // namespace

/// Runs `cusp falcon` as a user does.
class TestFalconCommand : public QObject
{
    Q_OBJECT
private slots:
    /// Compares the angles and torques with those of another implementation of the same mechanism.
    void kinematicsAreThoseOfTheMechanism()
    {
        const QString vectors = QString::fromStdString(support::sharedData("falcon_kinematics.csv"));
        if (!QFile::exists(vectors))
            QSKIP("the table of positions and angles is not there");
        const Table asked = parsed(read(vectors));
        expectDone(runCusp({"falcon", "kinematics", vectors, out()}));
        const Table answered = parsed(read(out()));
        QCOMPARE(answered.size(), asked.size());
        QVERIFY(!asked.empty());
        for (std::size_t k = 0; k < asked.size(); ++k) {
            const auto got = [&](const char* column) { return answered[k].at(column); };
            const auto want = [&](const char* column) { return asked[k].at(column); };
            QCOMPARE(got("reachable"), 1.0);
            for (const char* column : {"theta1_rad", "theta2_rad", "theta3_rad"})
                QVERIFY(std::abs(got(column) - want(column)) < 1.0e-9);
            for (const char* column : {"tick1", "tick2", "tick3"})
                QVERIFY(std::abs(got(column) - want(column)) < 0.5 + 1.0e-6);
            for (const char* column : {"tau1_Nm", "tau2_Nm", "tau3_Nm"})
                QVERIFY(std::abs(got(column) - want(column)) < 1.0e-6 * std::abs(want(column)) + 1.0e-11);
            for (const auto& [found, place] : {std::pair("fk_x_m", "x_m"), {"fk_y_m", "y_m"}, {"fk_z_m", "z_m"}})
                QVERIFY(std::abs(got(found) - want(place)) < 1.0e-9);
        }
    }

    void whatIsOutOfReachHasNoNumbers()
    {
        // The columns are in another order, with one more, and separated by semicolons and spaces.
        expectDone(runCusp({"falcon", "kinematics",
                            write("fz_N;note;x_m;y_m;z_m;fx_N;fy_N\n1; far ; 0.3;0;0.12;0;0\n-2;near;0;0; 0.12;0;0\n"),
                            out()}));
        const Table table = parsed(read(out()));
        QCOMPARE(table.size(), 2U);
        QCOMPARE(table[0].at("reachable"), 0.0);
        QVERIFY(std::isnan(table[0].at("theta1_rad")) && std::isnan(table[0].at("fk_z_m")));
        QCOMPARE(table[1].at("reachable"), 1.0);
        // On the axis all three arms have the same angle, and a push towards the device turns each of them inwards.
        QVERIFY(std::abs(table[1].at("tau1_Nm") - table[1].at("tau3_Nm")) < 1.0e-9);
        QVERIFY(table[1].at("tau1_Nm") < 0.0);
    }

    void aTableThatIsWrongIsRefused_data()
    {
        QTest::addColumn<QByteArray>("table");
        QTest::addColumn<QByteArray>("words");
        const QByteArray header = "x_m,y_m,z_m,fx_N,fy_N,fz_N\n";
        QTest::newRow("empty") << QByteArray() << QByteArray("empty");
        QTest::newRow("no header") << QByteArray("0,0,0.12,0,0,1\n") << QByteArray("x_m");
        QTest::newRow("a word") << header + "0,0,0.12,0,0,one\n" << QByteArray("line 2 has no number for fz_N");
        QTest::newRow("too few") << header + "0,0,0.12,0,0,1\n0,0,0.12\n" << QByteArray("line 3");
        QTest::newRow("infinite") << header + "inf,0,0.12,0,0,1\n" << QByteArray("line 2");
        QTest::newRow("no UTF-8") << QByteArray("\xff\xfe\0x", 4) << QByteArray("UTF-8");
        QTest::newRow("too large") << header + QByteArray(17 << 20, ' ') << QByteArray("16 MiB");
    }

    void aTableThatIsWrongIsRefused()
    {
        QFETCH(QByteArray, table);
        QFETCH(QByteArray, words);
        QFile::remove(out());
        expectRefusal(runCusp({"falcon", "kinematics", write(table), out()}), words);
        QVERIFY(!QFile::exists(out()));
    }

    void usageIsExplained()
    {
        expectRefusal(runCusp({"falcon", "kinematics", "in.csv"}), "two files", 2);
        expectRefusal(runCusp({"falcon", "kinematics", "none.csv", out()}), "none.csv");
        QVERIFY(runCusp({"falcon", "--help"}).out.contains("kinematics"));
    }

private:
    [[nodiscard]] QString out() const { return m_folder.filePath("out.csv"); }
    [[nodiscard]] static QByteArray read(const QString& name)
    {
        QFile file(name);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    [[nodiscard]] QString write(const QByteArray& bytes) const
    {
        QFile file(m_folder.filePath("in.csv"));
        return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() ? file.fileName() : QString();
    }

    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(TestFalconCommand)
#include "tst_falcon_command.moc"
