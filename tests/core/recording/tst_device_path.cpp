// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "core/recording/DevicePath.h"
#include "tests/fuzz/Exercises.h"
#include "tests/support/Checks.h"
#include "tests/support/Files.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"

using namespace core;
using recording::parseDevicePath;

namespace {

const std::string kHeader = "t_s,x_mm,y_mm,z_mm,drill\n";

/// Returns whether the text is one sentence: it begins with a capital letter, ends with a full stop, is on one line and
/// has no unprintable characters.
bool isASentence(const std::string& text)
{
    const QString sentence = QString::fromStdString(text);
    for (const QChar c : sentence)
        if (c.unicode() < 32)
            return false;
    return sentence.size() > 20 && sentence.endsWith('.');
}

}  // namespace

class TestDevicePath : public QObject
{
    Q_OBJECT
private slots:
    void readsAPlainFile()
    {
        const auto path = parseDevicePath(kHeader + "0,1.5,-2,3e-1,0\n0.5,+2,0,0,1\n", true);
        QVERIFY(path);
        QCOMPARE(path->points.size(), 2U);
        QCOMPARE(path->points[0].tipMm, glm::dvec3(1.5, -2.0, 0.3));
        QCOMPARE(path->points[0].drill, false);
        QCOMPARE(path->points[1].timeS, 0.5);
        QCOMPARE(path->points[1].tipMm.x, 2.0);
        QCOMPARE(path->points[1].drill, true);
        QCOMPARE(path->durationS(), 0.5);
    }

    void readsOtherWritings_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("CRLF") << QByteArray("t_s,x_mm,y_mm,z_mm,drill\r\n0,1,2,3,0\r\n1,4,5,6,1\r\n");
        QTest::newRow("CR alone") << QByteArray("t_s,x_mm,y_mm,z_mm,drill\r0,1,2,3,0\r1,4,5,6,1\r");
        QTest::newRow("line ends of all kinds")
            << QByteArray("\r\nt_s,x_mm,y_mm,z_mm,drill\r0,1,2,3,0\r\n1,4,5,6,1\n\r");
        QTest::newRow("byte order mark") << QByteArray("\xEF\xBB\xBFt_s,x_mm,y_mm,z_mm,drill\n0,1,2,3,0\n1,4,5,6,1\n");
        QTest::newRow("no newline at the end") << QByteArray("t_s,x_mm,y_mm,z_mm,drill\n0,1,2,3,0\n1,4,5,6,1");
        QTest::newRow("blank lines") << QByteArray("t_s,x_mm,y_mm,z_mm,drill\n\n0,1,2,3,0\n  \n1,4,5,6,1\n\n\n");
        QTest::newRow("other order") << QByteArray("drill,z_mm,t_s,y_mm,x_mm\n0,3,0,2,1\n1,6,1,5,4\n");
        QTest::newRow("further columns") << QByteArray("n,t_s,x_mm,note,y_mm,z_mm,drill,fx_n\n"
                                                       "1,0,1,a word,2,3,0,nan\n2,1,4,\"two, with a comma\",5,6,1,\n");
        QTest::newRow("quoted") << QByteArray("\"t_s\",\"x_mm\",\"y_mm\",\"z_mm\",\"drill\"\n"
                                              "\"0\",\"1\",\"2\",\"3\",\"0\"\n\"1\",\"4\",\"5\",\"6\",\"1\"\n");
        QTest::newRow("blanks around") << QByteArray(" t_s , x_mm ,y_mm,\tz_mm, drill\n 0 , 1,2 , 3 ,0\n1,4,5,6, 1 \n");
        QTest::newRow("drill as 1.0") << QByteArray("t_s,x_mm,y_mm,z_mm,drill\n0,1,2,3,0.0\n1,4,5,6,1.0\n");
    }

    void readsOtherWritings()
    {
        QFETCH(QByteArray, text);
        const auto path = parseDevicePath(text.toStdString(), true);
        QVERIFY(support::succeeds(path));
        QCOMPARE(path->points.size(), 2U);
        QCOMPARE(path->points[0].tipMm, glm::dvec3(1.0, 2.0, 3.0));
        QCOMPARE(path->points[1].timeS, 1.0);
        QCOMPARE(path->points[1].tipMm, glm::dvec3(4.0, 5.0, 6.0));
        QCOMPARE(path->points[0].drill, false);
        QCOMPARE(path->points[1].drill, true);
    }

    void refuses_data()
    {
        support::columns<QByteArray, ErrorCode>("text", "code");
        const QByteArray header = QByteArray::fromStdString(kHeader);
        QTest::newRow("empty") << QByteArray("") << ErrorCode::FileEmpty;
        QTest::newRow("only a byte order mark") << QByteArray("\xEF\xBB\xBF") << ErrorCode::FileEmpty;
        QTest::newRow("only a header") << header << ErrorCode::BadStructure;
        QTest::newRow("no header") << QByteArray("0,1,2,3,0\n1,1,2,3,0\n") << ErrorCode::BadStructure;
        for (const char* column : {"t_s", "x_mm", "y_mm", "z_mm", "drill"}) {
            QByteArray without = header + "0,1,2,3,0\n";
            without.replace(column, "other");
            QTest::addRow("no column %s", column) << without << ErrorCode::BadStructure;
        }
        for (const char* column : {"t_s", "x_mm", "y_mm", "z_mm", "drill"})
            QTest::addRow("two columns %s", column)
                << QByteArray("t_s,x_mm,y_mm,z_mm,drill,") + column + "\n0,1,2,3,0,0\n"
                << ErrorCode::BadStructure;
        QTest::newRow("a line without end") << header + QByteArray(2 * 1024 * 1024, '1') << ErrorCode::WrongKind;
        QTest::newRow("row too short") << header + "0,1,2,3\n" << ErrorCode::BadStructure;
        QTest::newRow("word") << header + "0,1,two,3,0\n" << ErrorCode::BadNumber;
        QTest::newRow("empty cell") << header + "0,1,,3,0\n" << ErrorCode::BadNumber;
        QTest::newRow("number and more") << header + "0,1,2mm,3,0\n" << ErrorCode::BadNumber;
        QTest::newRow("two signs") << header + "0,1,+-2,3,0\n" << ErrorCode::BadNumber;
        QTest::newRow("decimal comma") << header + "0,\"1,5\",2,3,0\n" << ErrorCode::BadNumber;
        QTest::newRow("decimal commas that line up") << header + "0,0,5,0,1,0,0\n" << ErrorCode::BadStructure;
        QTest::newRow("quote left open") << header + "0,\"1,2,3,0\n" << ErrorCode::BadNumber;
        QTest::newRow("hexadecimal") << header + "0,0x10,2,3,0\n" << ErrorCode::BadNumber;
        QTest::newRow("NaN") << header + "0,1,2,nan,0\n" << ErrorCode::BadNumber;
        QTest::newRow("infinite") << header + "0,inf,2,3,0\n" << ErrorCode::BadNumber;
        QTest::newRow("too large for a double") << header + "0,1e999,2,3,0\n" << ErrorCode::BadNumber;
        QTest::newRow("NaN time") << header + "nan,1,2,3,0\n" << ErrorCode::BadNumber;
        QTest::newRow("huge") << header + "0,1e300,2,3,0\n" << ErrorCode::OutOfRange;
        QTest::newRow("more than a metre") << header + "0,1,2,-1000.1,0\n" << ErrorCode::OutOfRange;
        QTest::newRow("drill 2") << header + "0,1,2,3,2\n" << ErrorCode::OutOfRange;
        QTest::newRow("drill a half") << header + "0,1,2,3,0.5\n" << ErrorCode::OutOfRange;
        QTest::newRow("time back") << header + "1,1,2,3,0\n0.5,1,2,3,0\n" << ErrorCode::BadStructure;
        QTest::newRow("time stands") << header + "1,1,2,3,0\n1,1,2,3,0\n" << ErrorCode::BadStructure;
        QTest::newRow("time below a double's step") << header + "1e17,1,2,3,0\n100000000000000001,1,2,3,0\n"
                                                    << ErrorCode::BadStructure;
        QTest::newRow("longer than a day") << header + "0,1,2,3,0\n86401,1,2,3,0\n" << ErrorCode::OutOfRange;
        QTest::newRow("infinitely long") << header + "-1.7e308,1,2,3,0\n1.7e308,1,2,3,0\n" << ErrorCode::OutOfRange;
        QTest::newRow("binary") << QByteArray("\x7F"
                                              "ELF\0\0\1\2",
                                              8)
                                << ErrorCode::WrongKind;
        QTest::newRow("binary after a header") << header + QByteArray("0,1,2,3,0\n\0\0\0", 14) << ErrorCode::WrongKind;
        QTest::newRow("semicolons") << QByteArray("t_s;x_mm;y_mm;z_mm;drill\n0;1;2;3;0\n") << ErrorCode::BadStructure;
    }

    void refuses()
    {
        QFETCH(QByteArray, text);
        QFETCH(ErrorCode, code);
        const auto path = parseDevicePath({text.constData(), static_cast<std::size_t>(text.size())}, true);
        QVERIFY(support::isRefused(path, code));
        QVERIFY2(isASentence(path.error().detail), path.error().detail.c_str());
    }

    void namesTheLine()
    {
        for (const char* lineEnd : {"\r", "\r\n", "\n"}) {
            QByteArray text = QByteArray::fromStdString(kHeader) + "0,1,2,3,0\n\n1,1,2,3,0\n2,1,bad,3,0\n";
            QVERIFY(support::isRefused(parseDevicePath(text.replace("\n", lineEnd).toStdString(), true),
                                       "Line 5 of the device path: 'bad' in column y_mm is not a number."));
        }
    }

    void strangeBytesAreNotEchoed()
    {
        const auto path = parseDevicePath(kHeader + "0,1,\x1B[31m\xFF\xFE,3,0\n", true);
        QVERIFY(!path);
        QVERIFY(isASentence(path.error().detail));
        const auto longCell = parseDevicePath(kHeader + "0,1," + std::string(100000, 'x') + ",3,0\n", true);
        QVERIFY(!longCell);
        QVERIFY(longCell.error().detail.size() < 200);
    }

    void drillColumnMayBeMissingWhenNotNeeded()
    {
        const auto path = parseDevicePath("t_s,x_mm,y_mm,z_mm\n0,1,2,3\n", false);
        QVERIFY(path);
        QCOMPARE(path->points[0].drill, false);
        // If the column is there, it is read and checked.
        QVERIFY(!parseDevicePath(kHeader + "0,1,2,3,x\n", false));
    }

    void refusesWhatIsNoFile()
    {
        const QTemporaryDir folder;
        const auto missing = recording::readDevicePath(folder.filePath("none.csv").toStdString(), true);
        QVERIFY(support::isRefused(missing, ErrorCode::FileMissing));
        const auto directory = recording::readDevicePath(folder.path().toStdString(), true);
        QVERIFY(support::isRefused(directory, ErrorCode::FileUnreadable));
        support::write(folder.filePath("empty.csv"), {});
        const auto nothing = recording::readDevicePath(folder.filePath("empty.csv").toStdString(), true);
        QVERIFY(support::isRefused(nothing, ErrorCode::FileEmpty));
        for (const auto& error : {missing.error(), directory.error(), nothing.error()})
            QVERIFY2(isASentence(error.detail), error.detail.c_str());
    }

    void readsAFile()
    {
        const QTemporaryDir folder;
        const QString name = folder.filePath("a path with blanks.csv");
        std::string text = kHeader;
        for (int n = 0; n < 20000; ++n)
            text += QByteArray::number(n * 0.001, 'f', 3).toStdString() + ",1,2,3,0\n";
        support::write(name, text);
        const auto path = recording::readDevicePath(name.toStdString(), true);
        QVERIFY(path);
        QCOMPARE(path->points.size(), 20000U);
        QCOMPARE(path->ticks(1000.0), 20000U);
    }

    void blocksOfAFileMayEndAnywhere()
    {
        // The file is read in blocks. First cells of growing length move every part of a line across the block
        // boundaries.
        const QTemporaryDir folder;
        for (const char* lineEnd : {"\n", "\r\n", "\r"}) {
            for (int shift = 0; shift < 30; ++shift) {
                QByteArray text = "note,t_s,x_mm,y_mm,z_mm,drill\n" + QByteArray(shift, 'n') + ",-1,1,2,3,0\n";
                for (int n = 0; n < 6000; ++n)
                    text += "," + QByteArray::number(n * 0.001, 'f', 3) + ",1,2,3,0\n";
                text += "last,bad,1,2,3,0\n";
                support::write(folder.filePath("path.csv"), text.replace("\n", lineEnd).toStdString());
                QVERIFY(support::isRefused(recording::readDevicePath(folder.filePath("path.csv").toStdString(), true),
                                           "Line 6003 of the device path: 'bad' in column t_s"));
            }
        }
    }

    void dayIsTheLimit()
    {
        const auto day = parseDevicePath(kHeader + "100,1,2,3,0\n86500,1,2,3,0\n", true);
        QVERIFY(day);
        QCOMPARE(day->ticks(1000.0), 86400001U);
        recording::PathCursor cursor(*day);
        QCOMPARE(cursor.at(86400.0).tipMm, glm::dvec3(1.0, 2.0, 3.0));
    }

    void interpolatesAtAnyRate_data() { support::rows<double>("rateHz", {250.0, 333.0, 1000.0, 1024.0, 4000.0}); }

    void interpolatesAtAnyRate()
    {
        QFETCH(double, rateHz);
        // A path at uneven times. The slow method searches the segment for each time.
        recording::DevicePath path;
        for (int n = 0; n < 200; ++n) {
            const double t = 7.0 + 0.01 * n + 0.004 * std::sin(n);
            path.points.push_back({t, {std::sin(t), 2.0 * t, -0.1 * n}, n % 3 == 0});
        }
        recording::PathCursor cursor(path);
        const double start = path.points.front().timeS;
        for (std::uint64_t tick = 0; tick < path.ticks(rateHz); ++tick) {
            const double t = static_cast<double>(tick) / rateHz;
            const recording::PathPoint at = cursor.at(t);
            std::size_t k = 0;
            while (k + 2 < path.points.size() && path.points[k + 1].timeS <= start + t)
                ++k;
            const auto& a = path.points[k];
            const auto& b = path.points[k + 1];
            const double share = (start + t - a.timeS) / (b.timeS - a.timeS);
            for (int axis = 0; axis < 3; ++axis)
                QVERIFY(std::abs(at.tipMm[axis] - (a.tipMm[axis] * (1.0 - share) + b.tipMm[axis] * share)) < 1.0e-12);
            if (share < 1.0)
                QCOMPARE(at.drill, a.drill);
        }
    }

    void endsAreHeld()
    {
        const auto path = parseDevicePath(kHeader + "5,1,2,3,1\n6,4,5,6,0\n", true).value();
        recording::PathCursor cursor(path);
        for (const double early : {-3.0, 0.0})
            QCOMPARE(cursor.at(early).tipMm, glm::dvec3(1.0, 2.0, 3.0));
        for (const double late : {1.0, 50.0})
            QCOMPARE(cursor.at(late).tipMm, glm::dvec3(4.0, 5.0, 6.0));
        QCOMPARE(cursor.at(50.0).drill, false);
        const auto one = parseDevicePath(kHeader + "5,1,2,3,1\n", true).value();
        QCOMPARE(one.ticks(1000.0), 1U);
        recording::PathCursor lone(one);
        QCOMPARE(lone.at(2.0).tipMm, glm::dvec3(1.0, 2.0, 3.0));
    }

    void drillHoldsUntilTheNextPoint()
    {
        const auto path = parseDevicePath(kHeader + "0,0,0,0,1\n1,0,0,0,0\n2,0,0,0,1\n", true).value();
        recording::PathCursor cursor(path);
        QCOMPARE(cursor.at(0.999).drill, true);
        QCOMPARE(cursor.at(1.0).drill, false);
        QCOMPARE(cursor.at(1.999).drill, false);
        QCOMPARE(cursor.at(2.0).drill, true);
    }

    void ticksCountBothEnds()
    {
        struct Span
        {
            double seconds;
            double rateHz;
            std::uint64_t ticks;
        };
        // Durations: a second; tenths, whose times are rounded; other rates; part of a period. The times begin at an
        // arbitrary value, as in a file.
        for (const Span& span : {Span{1.0, 1000.0, 1001}, Span{0.1, 1000.0, 101}, Span{0.3, 1000.0, 301},
                                 Span{0.7, 250.0, 176}, Span{0.7, 4000.0, 2801}, Span{0.0105, 1000.0, 11}}) {
            recording::DevicePath path;
            path.points.push_back({0.1, {}, false});
            path.points.push_back({0.1 + span.seconds, {}, false});
            QCOMPARE(path.ticks(span.rateHz), span.ticks);
        }
    }

    void corpusOfTheFuzzerIsHarmless() { QVERIFY(support::forEachSeed("path", fuzz::exercisePath)); }
};

CUSP_TEST(TestDevicePath)
#include "tst_device_path.moc"
