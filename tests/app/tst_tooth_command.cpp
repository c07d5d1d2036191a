// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "tests/support/Program.h"
#include "tests/support/Solids.h"
#include "tests/support/ToothMaps.h"

using support::Ending;
using support::runCusp;

/// Runs `cusp tooth` as a user does: in its own process, without a display, with separate stdout and stderr.
class TestToothCommand : public QObject
{
    Q_OBJECT

private slots:
    void jsonHasTheKeysOfTheDesign()
    {
        const Ending ending = runCusp({"tooth", "36", "--json"});
        expectDone(ending);
        QCOMPARE(ending.error, QByteArray());
        const QJsonObject report = ending.json();
        for (const char* key : {"triangles", "closed", "mesh_volume_mm3", "model_volume_mm3", "undercut_mm3",
                                "bounds_mm", "unit", "up", "grid", "cell_mm", "layers_mm3", "warnings", "load_ms"})
            QVERIFY2(report.contains(key), key);
        QCOMPARE(report["closed"].toBool(), true);
        QCOMPARE(report["grid"].toInt(), 150);
        for (const char* key : {"caries", "enamel", "dentin", "pulp"})
            QVERIFY2(report["layers_mm3"].toObject()[key].toDouble() > 0.0, key);
    }

    void aToothLiesAsItIsTold()
    {
        const QStringList laid{"tooth", "33", "--lies", "buccal", "--site", "cervical"};
        const QJsonObject report = runCusp(laid + QStringList{"--json"}).json();
        QCOMPARE(report["lies"].toString(), QString("buccal"));
        QCOMPARE(report["tilt_deg"].toDouble(), 90.0);
        QVERIFY(report["layers_mm3"].toObject()["caries"].toDouble() > 0.1);
        QVERIFY(runCusp(laid + QStringList{"--tilt", "70"}).out.contains("buccal, tilted by 70.0 degrees"));
        QVERIFY(!runCusp({"tooth", "33", "--json"}).json().contains("lies"));
        for (const QStringList& wrong : {QStringList{"33", "--lies", "left"},
                                         {"33", "--tilt", "45"},
                                         {"33", "--site", "cervical"},
                                         {"33", "--lies", "buccal", "--tilt", "91"},
                                         {"block:line", "--lies", "+x"},
                                         {"33", "--site", "root"}})
            expectRefusal(runCusp(QStringList{"tooth"} + wrong), {}, 2);
    }

    void textReportSaysWhatWasGuessed()
    {
        const QString file = write("cap.stl", support::asBinaryStl(support::sphereCap(0.5F, 0.5F, 40, 10)));
        const Ending ending = runCusp({"tooth", file});
        expectDone(ending);
        QVERIFY(ending.out.contains("cm (guessed"));
        QVERIFY(ending.out.contains("cut off flat"));
        QVERIFY(ending.out.contains("--unit"));
    }

    void overridesAreObeyed()
    {
        const QString file = write("box.obj", support::asObj(support::box(1.0F, 0.9F, 0.8F)));
        const QStringList common{"tooth", file, "--json"};
        const QJsonObject report = runCusp(common + QStringList{"--unit", "12.5", "--up", "-y", "--fdi", "24", "--grid",
                                                                "64", "--caries", "none", "--layers", "2011"})
                                       .json();
        QCOMPARE(report["unit"].toString(), QString("12.5"));
        QCOMPARE(report["up"].toString(), QString("-y"));
        QCOMPARE(report["fdi"].toInt(), 24);
        QCOMPARE(report["grid"].toInt(), 64);
        QCOMPARE(report["layers_mm3"].toObject()["caries"].toDouble(), 0.0);
        QVERIFY(std::abs(report["mesh_volume_mm3"].toDouble() / (0.72 * 12.5 * 12.5 * 12.5) - 1.0) < 1e-6);
        const QJsonArray size = report["bounds_mm"].toObject()["size"].toArray();
        QVERIFY(std::abs(size.at(2).toDouble() - 0.9 * 12.5) < 1e-4);
    }

    void frameOfTheFileIsKept()
    {
        const QString file =
            write("box.obj", support::asObj(support::moved(support::box(8.0F, 9.0F, 7.0F), {30.0F, -4.0F, 2.0F})));
        const QJsonObject report = runCusp({"tooth", file, "--frame", "file", "--json"}).json();
        const QJsonObject bounds = report["bounds_mm"].toObject();
        QCOMPARE(bounds["min"].toArray(), (QJsonArray{30.0, -4.0, 2.0}));
        QCOMPARE(bounds["max"].toArray(), (QJsonArray{38.0, 5.0, 9.0}));
        QVERIFY(std::abs(report["model_volume_mm3"].toDouble() / 504.0 - 1.0) < 0.005);
    }

    void exportedToothComesBackTheSame()
    {
        const QString file = m_folder.filePath("36.obj");
        const QJsonObject made = runCusp({"tooth", "36", "--export", file, "--json"}).json();
        const QJsonObject read = runCusp({"tooth", file, "--frame", "file", "--fdi", "36", "--json"}).json();
        QCOMPARE(read["triangles"], made["triangles"]);
        for (const char* key : {"mesh_volume_mm3", "model_volume_mm3"})
            QVERIFY(std::abs(read[key].toDouble() / made[key].toDouble() - 1.0) < 1e-5);
        const Ending refused = runCusp({"tooth", "36", "--export", "/nowhere/36.obj"});
        QCOMPARE(refused.exitCode, 1);
        QCOMPARE(refused.error.count('\n'), 1);
    }

    void helpAndVersion()
    {
        for (const QStringList& arguments :
             {QStringList{"help"}, {"--help"}, {"--version"}, {"tooth", "--help"}, {"help", "tooth"}}) {
            const Ending ending = runCusp(arguments);
            expectDone(ending);
            QVERIFY(ending.out.size() > 5);
            QCOMPARE(ending.error, QByteArray());
        }
        const QByteArray help = runCusp({"--help"}).out;
        for (const char* option : {"--tooth <FILE|FDI>", "--recording", "--db", "--theme", "--language", "--unit"})
            QVERIFY2(help.contains(option), option);
    }

    void windowWithoutADisplaySaysSo_data()
    {
        QTest::addColumn<QStringList>("environment");
        QTest::addColumn<QByteArray>("words");
        const auto add = [](const char* name, const QStringList& environment, const char* words) {
            QTest::newRow(name) << environment << QByteArray(words);
        };
        const QString x11 = "DISPLAY=:4711";
        const QString wayland = "WAYLAND_DISPLAY=wayland-4711";
        add("none", {}, "there is no display");
        add("a stale DISPLAY", {x11}, "no X server lets this program in at DISPLAY=:4711");
        add("a DISPLAY that is none", {"DISPLAY=nonsense"}, "at DISPLAY=nonsense");
        add("a stale WAYLAND_DISPLAY", {wayland, "XDG_RUNTIME_DIR=/tmp"}, "at WAYLAND_DISPLAY=wayland-4711");
        add("a file in its place", {"WAYLAND_DISPLAY=/etc/passwd"}, "at WAYLAND_DISPLAY=/etc/passwd");
        add("a name that is too long", {"WAYLAND_DISPLAY=/" + QString(200, u'w')}, "no Wayland server answers");
        add("both stale", {x11, wayland}, "at DISPLAY=:4711, and no Wayland server answers");
        add("a desktop that is gone", {x11, wayland, "XDG_SESSION_TYPE=wayland"}, "DISPLAY=:4711");
        add("X11 asked for", {x11, "QT_QPA_PLATFORM=xcb"}, "DISPLAY=:4711");
        add("Wayland asked for", {wayland, "QT_QPA_PLATFORM=wayland;wayland-egl"}, "WAYLAND_DISPLAY=wayland-4711");
        add("a platform that Qt does not know", {"QT_QPA_PLATFORM=nonsense"}, "there is no display");
        add("no runtime folder", {"WAYLAND_DISPLAY=wayland-4711", "XDG_RUNTIME_DIR=run"},
            "WAYLAND_DISPLAY=wayland-4711");
    }
    void windowWithoutADisplaySaysSo()
    {
        QFETCH(const QStringList, environment);
        QFETCH(const QByteArray, words);
        expectRefusal(runCusp({"--tooth", "36"}, environment), words);
        const Ending wrong = runCusp({"--theme", "blue"}, environment);
        expectRefusal(wrong, "--theme", 2);
    }
    /// The other end of a frozen tunnel accepts a connection and says nothing.
    void aServerThatNeverAnswersIsNoDisplay()
    {
        const int server = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof(address);
        constexpr int kFirstPort = 6000;  // of display 0
        QVERIFY(bind(server, reinterpret_cast<const sockaddr*>(&address), size) == 0 && listen(server, 4) == 0 &&
                getsockname(server, reinterpret_cast<sockaddr*>(&address), &size) == 0);
        const QString display = QString("127.0.0.1:%1").arg(ntohs(address.sin_port) - kFirstPort);
        expectRefusal(runCusp({"--tooth", "36"}, {"DISPLAY=" + display}), "does not answer");
        close(server);
    }
    void platformOfTheCommandLine()
    {
        expectRefusal(runCusp({"--tooth", "36", "-platform", "xcb"}, {"DISPLAY=:4711"}), "platform plugin");
    }

    void exportKeepsItsInput()
    {
        // The output is a link to the input file.
        const std::string bytes = support::asObj(support::box(8.0F, 9.0F, 7.0F));
        const QString file = write("input.obj", bytes);
        QVERIFY(QFile::link(file, m_folder.filePath("link.obj")));
        expectRefusal(runCusp({"tooth", file, "--export", m_folder.filePath("link.obj")}), "overwrite", 2);
        QFile kept(file);
        QVERIFY(kept.open(QIODevice::ReadOnly));
        QCOMPARE(kept.readAll().toStdString(), bytes);
    }

    void nothingIsMinusZero()
    {
        // For a box inside a box, the volumes of model and mesh differ by rounding only.
        const QString file =
            write("two.obj",
                  support::asObj(support::joined(support::box(10.0F, 10.0F, 10.0F),
                                                 support::moved(support::box(6.0F, 6.0F, 6.0F), {2.0F, 2.0F, 2.0F}))));
        const Ending ending = runCusp({"tooth", file, "--up", "+z"});
        expectDone(ending);
        QVERIFY2(ending.out.contains("undercut lost 0.000 mm3"), ending.out);
    }

    void wrongUsage_data()
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
                                 "tooth ",
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
                                 "tooth a.stl --unit feet",
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

    void wrongUsage()
    {
        QFETCH(QString, line);
        expectRefusal(runCusp(line.split(u' ')), {}, 2);
    }

    void badFiles_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("says");
        const auto add = [](const char* row, const char* name, const std::string& bytes, const char* says) {
            QTest::newRow(row) << name << QByteArray::fromStdString(bytes) << says;
        };
        const core::mesh::TriangleMesh box = support::box(8.0F, 8.0F, 8.0F);
        std::string lying = support::asBinaryStl(box);
        lying.replace(80, 4, "\xff\xff\xff\xff");
        core::mesh::TriangleMesh one = box;
        one.triangles.resize(1);
        add("empty", "a.stl", "", "is empty");
        add("prose as OBJ", "a.obj", "It was a dark and stormy night.\n", "does not look like an OBJ");
        add("another ending", "a.txt", "v 0 0 0\n", ".obj, .stl or .ply");
        add("STL that lies", "a.stl", lying.substr(0, lying.size() - 1), "states 4294967295 triangles");
        add("NaN", "a.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", "line 2");
        add("open above", "a.obj",
            support::asObj(one) + "f 1 2 5\nf 2 6 5\nf 3 7 4\nf 4 7 8\nf 1 5 3\nf 3 5 7\nf 2 4 6\nf 4 8 6\nf 2 3 4\n",
            "open where its crown should be");
    }

    /// The tests of core cover all reasons. Here, each bad file ends the command with one sentence.
    void badFiles()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        QFETCH(QString, says);
        const Ending ending = runCusp({"tooth", write(name, bytes.toStdString()), "--up", "+z", "--json"});
        expectRefusal(ending, says.toLatin1());
        QVERIFY(ending.peakMiB < 200);
    }

    void namesOfNoFiles()
    {
        for (const QString& path : QStringList{"/nowhere/a.obj", m_folder.path(), "/dev/null"})
            QCOMPARE(runCusp({"tooth", path}).exitCode, 1);
    }

    void tenMillionTriangles_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("head");
        QTest::addColumn<QByteArray>("triangle");
        const quint32 count = kTriangles;
        QTest::newRow("binary STL") << "big.stl"
                                    << QByteArray(80, ' ') + QByteArray(reinterpret_cast<const char*>(&count), 4)
                                    << QByteArray(50, '\0');
        QTest::newRow("OBJ") << "big.obj" << QByteArray("v 0 0 0\nv 9 0 0\nv 0 9 0\n") << QByteArray("f 1 2 3\n");
        QTest::newRow("PLY") << "big.ply"
                             << QByteArray(
                                    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                                    "property float z\nelement face 10000000\n"
                                    "property list uchar int vertex_indices\nend_header\n0 0 0\n9 0 0\n0 9 0\n")
                             << QByteArray("3 0 1 2\n");
    }

    void tenMillionTriangles()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, head);
        QFETCH(QByteArray, triangle);
        QFile file(m_folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(head);
        const QByteArray thousand = triangle.repeated(1000);
        for (int k = 0; k < kTriangles / 1000; ++k)
            file.write(thousand);
        file.close();
        const Ending ending = runCusp({"tooth", file.fileName()});
        file.remove();
        qInfo("%s: peak %ld MiB", qPrintable(name), ending.peakMiB);
        expectRefusal(ending, "5000000");
        QVERIFY(ending.peakMiB < 2048);
    }

    void largestMeshFitsInMemory()
    {
        // 4.5 million triangles that share no vertices in the file, like a real large scan.
        const core::mesh::TriangleMesh cap = support::sphereCap(6.0F, 6.0F, 3000, 750);
        const QString path = write("large.stl", support::asBinaryStl(cap));
        const Ending ending = runCusp({"tooth", path, "--json"});
        QFile::remove(path);
        expectDone(ending);
        qInfo("%zu triangles: %.0f ms, peak %ld MiB", cap.triangles.size(), ending.json()["load_ms"].toDouble(),
              ending.peakMiB);
        QVERIFY(ending.peakMiB < 2048);
    }

    void scanNumbers_data()
    {
        // The values were computed by an independent program, in file units.
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("triangles");
        QTest::addColumn<double>("volume");
        QTest::addColumn<QString>("up");
        QTest::newRow("36") << "teeth/dundee_36.obj" << 55184 << 0.856816 << "+y";
        QTest::newRow("24") << "teeth/dundee_24.obj" << 52968 << 0.356669 << "-y";
        QTest::newRow("21") << "teeth/dundee_21.obj" << 43000 << 0.371276 << "-y";
    }

    void scanNumbers()
    {
        QFETCH(QString, file);
        QFETCH(int, triangles);
        QFETCH(double, volume);
        QFETCH(QString, up);
        const std::string path = support::sharedData(file.toStdString());
        if (path.empty())
            QSKIP("shared/data is absent");
        const Ending ending = runCusp({"tooth", QString::fromStdString(path), "--json"});
        expectDone(ending);
        const QJsonObject report = ending.json();
        QCOMPARE(report["triangles"].toInt(), triangles);
        QCOMPARE(report["closed"].toBool(), true);
        QCOMPARE(report["unit"].toString(), QString("cm"));
        QCOMPARE(report["up"].toString(), up);
        QVERIFY(std::abs(report["mesh_volume_mm3"].toDouble() / 1000.0 - volume) < 1e-6);
        qInfo("%s: %.1f ms", qPrintable(file), report["load_ms"].toDouble());
    }

private:
    static constexpr int kTriangles = 10'000'000;

    QString write(const QString& name, const std::string& bytes)
    {
        QFile file(m_folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly))
            return {};
        file.write(bytes.data(), static_cast<qint64>(bytes.size()));
        return file.fileName();
    }

    QTemporaryDir m_folder;
};

QTEST_APPLESS_MAIN(TestToothCommand)
#include "tst_tooth_command.moc"
