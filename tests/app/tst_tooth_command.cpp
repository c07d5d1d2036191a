// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/Program.h"
#include "tests/support/Solids.h"
#include "tests/support/ToothMaps.h"

using support::Ending;
using support::runCusp;

/// Runs the program as a user does: its own process, no display, stdout and stderr apart.
class TestToothCommand : public QObject
{
    Q_OBJECT

private slots:
    void jsonHasTheKeysOfTheDesign();
    void textReportSaysWhatWasGuessed();
    void overridesAreObeyed();
    void frameOfTheFileIsKept();
    void exportedToothComesBackTheSame();
    void helpAndVersion();
    void helpListsTheOptionsOfTheWindow();
    void aToothWithoutANameIsWrongUsage();
    void windowWithoutADisplaySaysSo();
    void exportKeepsItsInput();
    void nothingIsMinusZero();
    void wrongUsage_data();
    void wrongUsage();
    void badFiles_data();
    void badFiles();
    void tenMillionTriangles_data();
    void tenMillionTriangles();
    void largestMeshFitsInMemory();
    void scanNumbers_data();
    void scanNumbers();

private:
    QString write(const QString& name, const std::string& bytes);

    QTemporaryDir m_folder;
};

QString TestToothCommand::write(const QString& name, const std::string& bytes)
{
    QFile file(m_folder.filePath(name));
    if (!file.open(QIODevice::WriteOnly))
        return {};
    file.write(bytes.data(), static_cast<qint64>(bytes.size()));
    return file.fileName();
}

void TestToothCommand::jsonHasTheKeysOfTheDesign()
{
    const Ending ending = runCusp({QStringLiteral("tooth"), QStringLiteral("36"), QStringLiteral("--json")});
    QCOMPARE(ending.exitCode, 0);
    QCOMPARE(ending.error, QByteArray());
    const QJsonObject report = ending.json();
    for (const char* key : {"triangles", "closed", "mesh_volume_mm3", "model_volume_mm3", "undercut_mm3", "bounds_mm",
                            "unit", "up", "grid", "cell_mm", "layers_mm3", "warnings", "load_ms"})
        QVERIFY2(report.contains(QLatin1String(key)), key);
    QCOMPARE(report[QStringLiteral("closed")].toBool(), true);
    QCOMPARE(report[QStringLiteral("grid")].toInt(), 150);
    for (const char* key : {"caries", "enamel", "dentin", "pulp"})
        QVERIFY2(report[QStringLiteral("layers_mm3")].toObject()[QLatin1String(key)].toDouble() > 0.0, key);
}

void TestToothCommand::textReportSaysWhatWasGuessed()
{
    const QString file = write(QStringLiteral("cap.stl"), support::asBinaryStl(support::sphereCap(0.5F, 0.5F, 40, 10)));
    const Ending ending = runCusp({QStringLiteral("tooth"), file});
    QCOMPARE(ending.exitCode, 0);
    QVERIFY(ending.out.contains("cm (guessed"));
    QVERIFY(ending.out.contains("cut off flat"));
    QVERIFY(ending.out.contains("--unit"));
}

void TestToothCommand::overridesAreObeyed()
{
    const QString file = write(QStringLiteral("box.obj"), support::asObj(support::box(1.0F, 0.9F, 0.8F)));
    const QStringList common{QStringLiteral("tooth"), file, QStringLiteral("--json")};
    const QJsonObject report =
        runCusp(common + QStringList{QStringLiteral("--unit"), QStringLiteral("12.5"), QStringLiteral("--up"),
                                     QStringLiteral("-y"), QStringLiteral("--fdi"), QStringLiteral("24"),
                                     QStringLiteral("--grid"), QStringLiteral("64"), QStringLiteral("--caries"),
                                     QStringLiteral("none"), QStringLiteral("--layers"), QStringLiteral("2011")})
            .json();
    QCOMPARE(report[QStringLiteral("unit")].toString(), QStringLiteral("12.5"));
    QCOMPARE(report[QStringLiteral("up")].toString(), QStringLiteral("-y"));
    QCOMPARE(report[QStringLiteral("fdi")].toInt(), 24);
    QCOMPARE(report[QStringLiteral("grid")].toInt(), 64);
    QCOMPARE(report[QStringLiteral("layers_mm3")].toObject()[QStringLiteral("caries")].toDouble(), 0.0);
    QVERIFY(std::abs(report[QStringLiteral("mesh_volume_mm3")].toDouble() / (0.72 * 12.5 * 12.5 * 12.5) - 1.0) < 1e-6);
    const QJsonArray size = report[QStringLiteral("bounds_mm")].toObject()[QStringLiteral("size")].toArray();
    QVERIFY(std::abs(size.at(2).toDouble() - 0.9 * 12.5) < 1e-4);
}

void TestToothCommand::frameOfTheFileIsKept()
{
    const QString file = write(QStringLiteral("box.obj"),
                               support::asObj(support::moved(support::box(8.0F, 9.0F, 7.0F), {30.0F, -4.0F, 2.0F})));
    const QJsonObject report = runCusp({QStringLiteral("tooth"), file, QStringLiteral("--frame"),
                                        QStringLiteral("file"), QStringLiteral("--json")})
                                   .json();
    const QJsonObject bounds = report[QStringLiteral("bounds_mm")].toObject();
    QCOMPARE(bounds[QStringLiteral("min")].toArray(), (QJsonArray{30.0, -4.0, 2.0}));
    QCOMPARE(bounds[QStringLiteral("max")].toArray(), (QJsonArray{38.0, 5.0, 9.0}));
    QVERIFY(std::abs(report[QStringLiteral("model_volume_mm3")].toDouble() / 504.0 - 1.0) < 0.005);
}

void TestToothCommand::exportedToothComesBackTheSame()
{
    const QString file = m_folder.filePath(QStringLiteral("36.obj"));
    const QJsonObject made = runCusp({QStringLiteral("tooth"), QStringLiteral("36"), QStringLiteral("--export"), file,
                                      QStringLiteral("--json")})
                                 .json();
    const QJsonObject read = runCusp({QStringLiteral("tooth"), file, QStringLiteral("--frame"), QStringLiteral("file"),
                                      QStringLiteral("--fdi"), QStringLiteral("36"), QStringLiteral("--json")})
                                 .json();
    QCOMPARE(read[QStringLiteral("triangles")], made[QStringLiteral("triangles")]);
    for (const char* key : {"mesh_volume_mm3", "model_volume_mm3"})
        QVERIFY(std::abs(read[QLatin1String(key)].toDouble() / made[QLatin1String(key)].toDouble() - 1.0) < 1e-5);
    const Ending refused = runCusp(
        {QStringLiteral("tooth"), QStringLiteral("36"), QStringLiteral("--export"), QStringLiteral("/nowhere/36.obj")});
    QCOMPARE(refused.exitCode, 1);
    QCOMPARE(refused.error.count('\n'), 1);
}

void TestToothCommand::helpAndVersion()
{
    for (const QStringList& arguments : {QStringList{QStringLiteral("help")},
                                         {QStringLiteral("--help")},
                                         {QStringLiteral("--version")},
                                         {QStringLiteral("tooth"), QStringLiteral("--help")},
                                         {QStringLiteral("help"), QStringLiteral("tooth")}}) {
        const Ending ending = runCusp(arguments);
        QCOMPARE(ending.exitCode, 0);
        QVERIFY(ending.out.size() > 5);
        QCOMPARE(ending.error, QByteArray());
    }
}

void TestToothCommand::helpListsTheOptionsOfTheWindow()
{
    const Ending ending = runCusp({QStringLiteral("--help")});
    for (const char* option : {"--tooth <FILE|FDI>", "--recording", "--db", "--theme", "--language", "--unit"})
        QVERIFY2(ending.out.contains(option), option);
}

void TestToothCommand::wrongUsage_data()
{
    QTest::addColumn<QString>("line");
    for (const char* line : {"nonsense",
                             "--bogus",
                             "--tooth",
                             "--theme blue",
                             "--theme",
                             "--language xx",
                             "--language de --language en",
                             "--tooth 99",
                             "--tooth 36 --unit mm",
                             "--fdi 26",
                             "--tooth 36 --recording attempt.cusprec",
                             "tooth 36 --export 36.stl",
                             "tooth 36 --export /dev/null",
                             "tooth box.obj --export ./box.obj",
                             "help nonsense",
                             "tooth",
                             "tooth 36 37",
                             "tooth 36 --bogus",
                             "tooth 36 --grid",
                             "tooth 36 --grid 63",
                             "tooth 36 --grid 1025",
                             "tooth 36 --grid ten",
                             "tooth 99",
                             "tooth 36 --grid 64 --grid 128",
                             "tooth 36 --unit mm",
                             "tooth 36 --up +z",
                             "tooth 36 --fdi 36",
                             "tooth 36 --frame tooth",
                             "tooth a.stl --unit inch",
                             "tooth a.stl --up w",
                             "tooth a.stl --fdi 19",
                             "tooth a.stl --fdi 99",
                             "tooth a.stl --frame world",
                             "tooth a.stl --frame file --up +y",
                             "demo --fdi 36",
                             "tooth 36 --seed -1",
                             "tooth 36 --layers 1999",
                             "tooth 36 --caries much",
                             "tooth 36 --extent 1.5",
                             "tooth 36 --extent nan"})
        QTest::newRow(line) << QString::fromLatin1(line);
}

void TestToothCommand::aToothWithoutANameIsWrongUsage()
{
    for (const char* name : {"", "  "}) {
        const Ending ending = runCusp({QStringLiteral("tooth"), QLatin1String(name)});
        QCOMPARE(ending.exitCode, 2);
        QVERIFY2(ending.isOneSentence() && ending.error.contains("usage"), ending.error);
    }
}

void TestToothCommand::windowWithoutADisplaySaysSo()
{
    const Ending ending = runCusp({QStringLiteral("--tooth"), QStringLiteral("36")});
    QCOMPARE(ending.exitCode, 1);
    QVERIFY2(ending.isOneSentence() && ending.error.contains("no display"), ending.error);
}

void TestToothCommand::exportKeepsItsInput()
{
    // A name that leads to the input by another way.
    const std::string bytes = support::asObj(support::box(8.0F, 9.0F, 7.0F));
    const QString file = write(QStringLiteral("input.obj"), bytes);
    QVERIFY(QFile::link(file, m_folder.filePath(QStringLiteral("link.obj"))));
    const Ending ending = runCusp(
        {QStringLiteral("tooth"), file, QStringLiteral("--export"), m_folder.filePath(QStringLiteral("link.obj"))});
    QCOMPARE(ending.exitCode, 2);
    QVERIFY2(ending.isOneSentence() && ending.error.contains("overwrite"), ending.error);
    QFile kept(file);
    QVERIFY(kept.open(QIODevice::ReadOnly));
    QCOMPARE(kept.readAll().toStdString(), bytes);
}

void TestToothCommand::nothingIsMinusZero()
{
    // A solid box in another: model and mesh differ by rounding alone.
    const QString file =
        write(QStringLiteral("two.obj"),
              support::asObj(support::joined(support::box(10.0F, 10.0F, 10.0F),
                                             support::moved(support::box(6.0F, 6.0F, 6.0F), {2.0F, 2.0F, 2.0F}))));
    const Ending ending = runCusp({QStringLiteral("tooth"), file, QStringLiteral("--up"), QStringLiteral("+z")});
    QCOMPARE(ending.exitCode, 0);
    QVERIFY2(ending.out.contains("undercut lost 0.000 mm3"), ending.out);
}

void TestToothCommand::wrongUsage()
{
    QFETCH(QString, line);
    const Ending ending = runCusp(line.split(u' '));
    QCOMPARE(ending.exitCode, 2);
    QVERIFY2(ending.isOneSentence(), ending.error);
}

void TestToothCommand::badFiles_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("says");
    const auto add = [](const char* row, const char* name, const std::string& bytes, const char* says) {
        QTest::newRow(row) << QString::fromLatin1(name) << QByteArray::fromStdString(bytes)
                           << QString::fromLatin1(says);
    };
    const core::mesh::TriangleMesh box = support::box(8.0F, 8.0F, 8.0F);
    core::mesh::TriangleMesh one = box;
    one.triangles.resize(1);
    core::mesh::TriangleMesh flat = box;
    for (glm::vec3& v : flat.vertices)
        v = {v.x, 0.0F, 0.0F};
    std::string lying = support::asBinaryStl(box);
    lying.replace(80, 4, "\xff\xff\xff\xff");
    std::string infinite = support::asBinaryStl(box);
    infinite.replace(84 + 12, 4, std::string("\x00\x00\x80\x7f", 4));
    add("empty", "a.stl", "", "is empty");
    add("prose as OBJ", "a.obj", "It was a dark and stormy night.\n", "does not look like an OBJ");
    add("prose as STL", "a.stl", "It was a dark and stormy night.\n", "not an STL");
    add("prose as PLY", "a.ply", "It was a dark and stormy night.\n", "not a PLY");
    add("another ending", "a.txt", "v 0 0 0\n", ".obj, .stl or .ply");
    add("truncated STL", "a.stl", support::asBinaryStl(box).substr(0, 400), "cut short");
    add("STL that lies", "a.stl", lying, "states 4294967295 triangles");
    add("infinite", "a.stl", infinite, "not a finite number");
    add("NaN", "a.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", "line 2");
    add("zero area", "a.stl", support::asBinaryStl(flat), "zero area");
    add("one triangle", "a.stl", support::asBinaryStl(one), "1 triangle");
    add("open above", "a.obj",
        support::asObj(one) + "f 1 2 5\nf 2 6 5\nf 3 7 4\nf 4 7 8\nf 1 5 3\nf 3 5 7\nf 2 4 6\nf 4 8 6\nf 2 3 4\n",
        "open where its crown should be");
}

void TestToothCommand::badFiles()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    QFETCH(QString, says);
    const Ending ending = runCusp({QStringLiteral("tooth"), write(name, bytes.toStdString()), QStringLiteral("--up"),
                                   QStringLiteral("+z"), QStringLiteral("--json")});
    QCOMPARE(ending.exitCode, 1);
    QCOMPARE(ending.out, QByteArray());
    QVERIFY2(ending.error.contains(says.toLatin1()), ending.error.constData());
    QCOMPARE(ending.error.count('\n'), 1);
    QVERIFY(ending.error.endsWith(".\n"));
    QVERIFY(ending.peakMiB < 200);
    for (const QString& path : {QStringLiteral("/nowhere/a.obj"), m_folder.path(), QStringLiteral("/dev/null")})
        QCOMPARE(runCusp({QStringLiteral("tooth"), path}).exitCode, 1);
}

void TestToothCommand::tenMillionTriangles_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("binary STL") << QStringLiteral("big.stl");
    QTest::newRow("OBJ") << QStringLiteral("big.obj");
    QTest::newRow("PLY") << QStringLiteral("big.ply");
}

void TestToothCommand::tenMillionTriangles()
{
    QFETCH(QString, name);
    constexpr int kCount = 10'000'000;
    QFile file(m_folder.filePath(name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    if (name.endsWith(u"stl")) {
        const std::string record(50, '\0');
        const std::string block = [&] {
            std::string all;
            for (int k = 0; k < 1000; ++k)
                all += record;
            return all;
        }();
        file.write(QByteArray(80, ' '));
        const quint32 count = kCount;
        file.write(reinterpret_cast<const char*>(&count), 4);
        for (int k = 0; k < kCount / 1000; ++k)
            file.write(block.data(), static_cast<qint64>(block.size()));
    } else {
        const bool ply = name.endsWith(u"ply");
        if (ply)
            file.write(
                "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                "element face 10000000\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n9 0 0\n0 9 0\n");
        else
            file.write("v 0 0 0\nv 9 0 0\nv 0 9 0\n");
        const QByteArray block = QByteArray(ply ? "3 0 1 2\n" : "f 1 2 3\n").repeated(1000);
        for (int k = 0; k < kCount / 1000; ++k)
            file.write(block);
    }
    file.close();
    const Ending ending = runCusp({QStringLiteral("tooth"), file.fileName()});
    file.remove();
    qInfo("%s: peak %ld MiB", qPrintable(name), ending.peakMiB);
    QCOMPARE(ending.exitCode, 1);
    QVERIFY2(ending.error.contains("5000000"), ending.error.constData());
    QCOMPARE(ending.error.count('\n'), 1);
    QVERIFY(ending.peakMiB < 2048);
}

void TestToothCommand::largestMeshFitsInMemory()
{
    // 4.5 million triangles, nothing shared in the file: what an honest large scan would be.
    const core::mesh::TriangleMesh cap = support::sphereCap(6.0F, 6.0F, 3000, 750);
    const QString path = write(QStringLiteral("large.stl"), support::asBinaryStl(cap));
    const Ending ending = runCusp({QStringLiteral("tooth"), path, QStringLiteral("--json")});
    QFile::remove(path);
    QCOMPARE(ending.exitCode, 0);
    qInfo("%zu triangles: %.0f ms, peak %ld MiB", cap.triangles.size(),
          ending.json()[QStringLiteral("load_ms")].toDouble(), ending.peakMiB);
    QVERIFY(ending.peakMiB < 2048);
}

void TestToothCommand::scanNumbers_data()
{
    // Figures of shared/tools/meshinfo.py, in file units.
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("triangles");
    QTest::addColumn<double>("volume");
    QTest::addColumn<QString>("up");
    QTest::newRow("36") << QStringLiteral("teeth/dundee_36.obj") << 55184 << 0.856816 << QStringLiteral("+y");
    QTest::newRow("24") << QStringLiteral("teeth/dundee_24.obj") << 52968 << 0.356669 << QStringLiteral("-y");
    QTest::newRow("21") << QStringLiteral("teeth/dundee_21.obj") << 43000 << 0.371276 << QStringLiteral("-y");
}

void TestToothCommand::scanNumbers()
{
    QFETCH(QString, file);
    QFETCH(int, triangles);
    QFETCH(double, volume);
    QFETCH(QString, up);
    const std::string path = support::sharedData(file.toStdString());
    if (path.empty())
        QSKIP("shared/data is absent");
    const Ending ending = runCusp({QStringLiteral("tooth"), QString::fromStdString(path), QStringLiteral("--json")});
    QCOMPARE(ending.exitCode, 0);
    const QJsonObject report = ending.json();
    QCOMPARE(report[QStringLiteral("triangles")].toInt(), triangles);
    QCOMPARE(report[QStringLiteral("closed")].toBool(), true);
    QCOMPARE(report[QStringLiteral("unit")].toString(), QStringLiteral("cm"));
    QCOMPARE(report[QStringLiteral("up")].toString(), up);
    QVERIFY(std::abs(report[QStringLiteral("mesh_volume_mm3")].toDouble() / 1000.0 - volume) < 1e-6);
    qInfo("%s: %.1f ms", qPrintable(file), report[QStringLiteral("load_ms")].toDouble());
}

QTEST_APPLESS_MAIN(TestToothCommand)
#include "tst_tooth_command.moc"
