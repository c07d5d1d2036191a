// SPDX-License-Identifier: GPL-3.0-or-later
// Runs `cusp track` as a user does: its output, and its errors for bad input.
#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <map>
#include <thread>

#include <QDir>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <fcntl.h>
#include <glm/gtc/matrix_transform.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include "app/devices/CameraCalibration.h"
#include "core/tracking/TagDetector.h"
#include "tests/app/PrintedScene.h"
#include "tests/support/Program.h"

using core::tracking::CameraModel;
using core::tracking::Picture;
using core::tracking::Pose;
using support::Ending;
using support::expectDone;
using support::expectRefusal;
using support::runCusp;

namespace {

constexpr int kPatienceMs = 30'000;
constexpr int kId = 5;
constexpr int kWidth = 320;
constexpr int kHeight = 240;

/// Returns a pose.
/// @param turnDeg  rotation about x, then about y
Pose poseAt(const glm::dvec3& positionMm, const glm::dvec2& turnDeg)
{
    glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), glm::radians(turnDeg.x), glm::dvec3(1.0, 0.0, 0.0));
    turn = glm::rotate(turn, glm::radians(turnDeg.y), glm::dvec3(0.0, 1.0, 0.0));
    return {positionMm, glm::dmat3(turn)};
}

/// Returns the pose of the tag in picture `n`.
Pose tagPose(int n)
{
    return poseAt({-20.0 + 10.0 * n, 5.0, 300.0}, {20.0, 0.0});
}

const Picture& tagPicture(int n)
{
    static std::map<int, Picture> pictures;
    if (const auto known = pictures.find(n); known != pictures.end())
        return known->second;
    static const support::PrintCamera camera(CameraModel::withFieldOfView(kWidth, kHeight, CameraModel::kUsualFovDeg));
    return pictures[n] = camera.take(tagPose(n), support::TagPrint{core::tracking::cellsOf(kId)});
}

QByteArray video(int pictures)
{
    const support::Avi avi(kWidth, kHeight, pictures);
    QByteArray bytes = avi.header();
    for (int n = 0; n < pictures; ++n)
        bytes += avi.picture(tagPicture(n % 4));
    return bytes;
}

QList<QJsonObject> linesOf(const QByteArray& out)
{
    QList<QJsonObject> lines;
    for (const QByteArray& line : out.split('\n'))
        if (!line.isEmpty())
            lines << QJsonDocument::fromJson(line).object();
    return lines;
}

glm::dvec2 pointOf(const QJsonValue& value)
{
    return {value[0].toDouble(), value[1].toDouble()};
}

}  // namespace

class TestTrackCommand : public QObject
{
    Q_OBJECT

private slots:
    void init();
    void printsAnObjectALine();
    void aVideoIsReadAsImagesAre();
    void photographsGiveTheExpectedTags();
    void wrongUsageIsExplained_data();
    void wrongUsageIsExplained();
    void whatCannotBeReadIsNamed_data();
    void whatCannotBeReadIsNamed();
    void imagesThatAreCutOffArePassedOver();
    void aVideoThatIsCutOffIsReadAsFarAsItGoes();
    void aSignalEndsAnEndlessVideo();
    void aBadCalibrationIsRefused_data();
    void aBadCalibrationIsRefused();
    void calibratesByTheBoard();
    void aBoardThatIsNeverTiltedIsNotEnough();
    void calibratesByTheTagAtADistance();
    void printsTheSheet();

private:
    [[nodiscard]] QString at(const QString& name) const { return m_folder->filePath(name); }
    void write(const QString& name, const QByteArray& bytes) const
    {
        QFile file(at(name));
        QVERIFY(QDir().mkpath(QFileInfo(file).path()) && file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(bytes), bytes.size());
    }
    void writeImages(const QString& folder, int count) const
    {
        for (int n = 0; n < count; ++n)
            write(folder + QStringLiteral("/%1.pgm").arg(n), support::pgmOf(tagPicture(n)));
    }
    /// Writes pictures of the board from many directions.
    void writeBoards(const QString& folder, const CameraModel& camera, double tiltDeg) const
    {
        const support::PrintCamera prints(camera);
        const std::array<glm::dvec2, 10> tilts{
            {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}, {0.5, -0.5}}};
        for (std::size_t n = 0; n < tilts.size(); ++n) {
            const auto k = static_cast<double>(n);
            const Pose pose = poseAt({30.0 * std::cos(k), 20.0 * std::sin(k), 380.0 + 8.0 * k}, tiltDeg * tilts.at(n));
            write(folder + QStringLiteral("/%1.pgm").arg(n), support::pgmOf(prints.take(pose, support::BoardPrint())));
        }
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestTrackCommand::init()
{
    if (!core::tracking::hasTagDetector())
        QSKIP("This program is built without head tracking.");
    m_folder = std::make_unique<QTemporaryDir>();
}

void TestTrackCommand::printsAnObjectALine()
{
    writeImages("images", 3);
    const Ending ending = runCusp({"track", "--images", at("images"), "--id", "5", "--json"});
    expectDone(ending);
    const auto lines = linesOf(ending.out);
    QCOMPARE(lines.size(), 3);
    for (int n = 0; n < 3; ++n) {
        QCOMPARE(lines[n].keys(), QStringList({"file", "ms", "tags"}));
        QCOMPARE(lines[n]["file"].toString(), QStringLiteral("%1.pgm").arg(n));
        QCOMPARE(lines[n]["ms"].toObject().keys(), QStringList({"find", "grab", "pose"}));
        QCOMPARE(lines[n]["tags"].toArray().size(), 1);
        const QJsonObject tag = lines[n]["tags"][0].toObject();
        QCOMPARE(tag.keys(), QStringList({"corners", "id", "position_mm", "reprojection_px", "rotation_deg"}));
        QCOMPARE(tag["id"].toInt(), kId);
        QCOMPARE(tag["corners"].toArray().size(), 4);
        const Pose pose = tagPose(n);
        for (int axis = 0; axis < 3; ++axis)
            QVERIFY(std::abs(tag["position_mm"][axis].toDouble() - pose.positionMm[axis]) < 1.0);
        QVERIFY(std::abs(tag["rotation_deg"][0].toDouble() - 20.0) < 3.0);
        QVERIFY(tag["reprojection_px"].toDouble() < 0.3);
        const CameraModel camera = CameraModel::withFieldOfView(kWidth, kHeight, CameraModel::kUsualFovDeg);
        const glm::dvec2 lowerLeft = camera.pixelOf(pose.positionMm + pose.rotation * glm::dvec3(-25.0, 25.0, 0.0));
        QVERIFY(glm::distance(pointOf(tag["corners"][0]), lowerLeft) < 0.3);
    }
}

void TestTrackCommand::aVideoIsReadAsImagesAre()
{
    writeImages("images", 4);
    write("video.avi", video(4));
    const auto images = linesOf(runCusp({"track", "--images", at("images"), "--id", "5", "--json"}).out);
    const Ending ending = runCusp({"track", "--video", at("video.avi"), "--id", "5", "--json"});
    expectDone(ending);
    const auto pictures = linesOf(ending.out);
    QCOMPARE(pictures.size(), 4);
    for (int n = 0; n < 4; ++n) {
        QCOMPARE(pictures[n].keys(), QStringList({"ms", "tags", "time_s"}));
        QCOMPARE(pictures[n]["tags"], images[n]["tags"]);
        QVERIFY(n == 0 || pictures[n]["time_s"].toDouble() > pictures[n - 1]["time_s"].toDouble());
    }
    QCOMPARE(linesOf(runCusp({"track", "--video", at("video.avi"), "--frames", "2", "--json"}).out).size(), 2);
}

void TestTrackCommand::photographsGiveTheExpectedTags()
{
    const QString folder = QStringLiteral(CUSP_SOURCE_DIR "/../shared/data/apriltag");
    QFile table(folder + "/expected_detections.csv");
    if (!table.open(QIODevice::ReadOnly))
        QSKIP("The photographs are not on this computer.");
    const Ending ending = runCusp({"track", "--images", folder, "--all-ids", "--json"});
    expectDone(ending);
    QMap<QString, QList<QJsonObject>> found;
    for (const QJsonObject& line : linesOf(ending.out))
        for (const QJsonValue tag : line["tags"].toArray())
            found[line["file"].toString()] << tag.toObject();
    int expected = 0;
    const QByteArrayList lines = table.readAll().split('\n');
    for (const QByteArray& line : lines.mid(1)) {
        const QByteArrayList values = line.split(',');
        if (values.size() < 17 || values[1] != "tag36h11")
            continue;
        ++expected;
        QList<QJsonObject>& tags = found[values[0]];
        const auto isIt = [&](const QJsonObject& tag) {
            double worst = 0.0;
            for (int n = 0; n < 4; ++n)
                worst = std::max(worst, glm::distance(pointOf(tag["corners"][n]),
                                                      {values[9 + 2 * n].toDouble(), values[10 + 2 * n].toDouble()}));
            return tag["id"].toInt() == values[4].toInt() && worst < 0.5;
        };
        const auto it = std::find_if(tags.begin(), tags.end(), isIt);
        QVERIFY2(it != tags.end(), line);
        tags.erase(it);
    }
    QVERIFY(expected > 0);
    for (const auto& more : found)
        QVERIFY(more.isEmpty());
}

void TestTrackCommand::wrongUsageIsExplained_data()
{
    QTest::addColumn<QStringList>("words");
    QTest::newRow("no source") << QStringList{};
    QTest::newRow("two sources") << QStringList{"--images", ".", "--video", "x"};
    QTest::newRow("a source without its option") << QStringList{"x.avi"};
    QTest::newRow("a tag of no size") << QStringList{"--images", ".", "--tag-size", "0"};
    QTest::newRow("a size that is no number") << QStringList{"--images", ".", "--tag-size", "nan"};
    QTest::newRow("no such tag") << QStringList{"--images", ".", "--id", "999"};
    QTest::newRow("no field of view") << QStringList{"--images", ".", "--fov", "x"};
    QTest::newRow("a field of view that is none") << QStringList{"--images", ".", "--fov", "180"};
    QTest::newRow("no number of a camera") << QStringList{"--camera", "-1"};
    QTest::newRow("no pictures") << QStringList{"--images", ".", "--frames", "0"};
    QTest::newRow("a distance without --calibrate") << QStringList{"--images", ".", "--at", "500"};
    QTest::newRow("no distance") << QStringList{"--images", ".", "--calibrate", "x", "--at", "0"};
    QTest::newRow("a sheet with a field of view") << QStringList{"--print", "x", "--fov", "60"};
    QTest::newRow("two calibrations") << QStringList{"--images", ".", "--calibrate", "x", "--calibration", "x"};
    QTest::newRow("printing pictures") << QStringList{"--images", ".", "--print", "x"};
}

void TestTrackCommand::wrongUsageIsExplained()
{
    QFETCH(QStringList, words);
    expectRefusal(runCusp(QStringList{"track"} + words), {}, 2);
}

void TestTrackCommand::whatCannotBeReadIsNamed_data()
{
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QByteArray>("sentence");
    QTest::newRow("no camera") << QStringList{"--camera", "987"} << QByteArray("There is no camera 987");
    QTest::newRow("no folder") << QStringList{"--images", "missing"} << QByteArray("There is no folder");
    QTest::newRow("a file as a folder") << QStringList{"--images", "text.avi"} << QByteArray("There is no folder");
    QTest::newRow("an empty folder") << QStringList{"--images", "empty"} << QByteArray("has no images");
    QTest::newRow("no video") << QStringList{"--video", "missing.avi"} << QByteArray("There is no file");
    QTest::newRow("a folder as a video") << QStringList{"--video", "empty"} << QByteArray("is a folder");
    QTest::newRow("a text as a video") << QStringList{"--video", "text.avi"} << QByteArray("is no video");
    QTest::newRow("a text by its name") << QStringList{"--video", "text.txt"} << QByteArray("is no video");
    QTest::newRow("a playlist") << QStringList{"--video", "list.m3u8"} << QByteArray("is no video");
    QTest::newRow("an empty file") << QStringList{"--video", "empty.avi"} << QByteArray("is no video");
    QTest::newRow("noise") << QStringList{"--video", "noise.avi"} << QByteArray("is no video");
    QTest::newRow("an endless file") << QStringList{"--video", "/dev/zero"} << QByteArray("is no video");
    QTest::newRow("no board") << QStringList{"--images", "images", "--calibrate", "out.json"}
                              << QByteArray("board was found at 0 places");
    QTest::newRow("no tag") << QStringList{"--images", "images", "--id", "9", "--calibrate", "out.json", "--at", "300"}
                            << QByteArray("Tag 9 was not found");
}

void TestTrackCommand::whatCannotBeReadIsNamed()
{
    QFETCH(QStringList, words);
    QFETCH(QByteArray, sentence);
    QVERIFY(QDir(m_folder->path()).mkdir("empty"));
    writeImages("images", 2);
    write("text.avi", QByteArray("These are words.\n").repeated(1000));
    write("text.txt", QByteArray("These are words.\n").repeated(1000));
    write("list.m3u8", "#EXTM3U\n#EXTINF:1,\nempty.avi\n");
    write("empty.avi", {});
    QByteArray noise;
    for (unsigned n = 0, value = 1; n < 100'000; ++n, value = value * 1664525U + 1013904223U)
        noise.append(static_cast<char>(value >> 24U));
    write("noise.avi", noise);
    for (QString& word : words)
        if (!word.startsWith('-') && !word.startsWith('/') && word.front().isLetter())
            word = at(word);
    expectRefusal(runCusp(QStringList{"track"} + words), sentence);
    QVERIFY(!QFile::exists(at("out.json")));
}

void TestTrackCommand::imagesThatAreCutOffArePassedOver()
{
    writeImages("images", 2);
    write("images/cut.pgm", support::pgmOf(tagPicture(0)).chopped(20'000));
    const QImage image(tagPicture(0).pixels.data(), kWidth, kHeight, kWidth, QImage::Format_Grayscale8);
    for (const char* name : {"whole.png", "whole.jpg", "whole.bmp"}) {
        QVERIFY(image.save(at(QStringLiteral("images/") + name)));
        QFile file(at(QStringLiteral("images/") + name));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        write(QStringLiteral("images/cut_") + name, bytes.left(bytes.size() / 2));
    }
    write("images/empty.png", {});
    const Ending ending = runCusp({"track", "--images", at("images"), "--id", "5", "--json"});
    QCOMPARE(ending.exitCode, 1);
    QStringList files;
    for (const QJsonObject& line : linesOf(ending.out)) {
        files << line["file"].toString();
        QCOMPARE(line["tags"].toArray().size(), 1);
    }
    QCOMPARE(files, QStringList({"0.pgm", "1.pgm", "whole.bmp", "whole.jpg", "whole.png"}));
    for (const char* name : {"cut.pgm", "cut_whole.png", "cut_whole.jpg", "cut_whole.bmp", "empty.png"})
        QVERIFY2(ending.error.contains(QByteArray(name) + " is no image"), ending.error);
}

void TestTrackCommand::aVideoThatIsCutOffIsReadAsFarAsItGoes()
{
    const QByteArray whole = video(20);
    write("cut.avi", whole.left(whole.size() / 2));
    const Ending ending = runCusp({"track", "--video", at("cut.avi"), "--id", "5", "--json"});
    QCOMPARE(ending.exitCode, 1);
    QVERIFY2(ending.error.contains("ends before its time"), ending.error);
    QVERIFY(linesOf(ending.out).size() >= 9);
}

void TestTrackCommand::aSignalEndsAnEndlessVideo()
{
    const QByteArray pipe = at("pipe").toLocal8Bit();
    QCOMPARE(mkfifo(pipe.constData(), 0600), 0);
    std::signal(SIGPIPE, SIG_IGN);
    const support::Avi avi(kWidth, kHeight, 5000);
    const QByteArray picture = avi.picture(tagPicture(0));
    std::thread writer([&] {
        const int file = open(pipe.constData(), O_WRONLY);
        QByteArray bytes = avi.header();
        while (::write(file, bytes.constData(), static_cast<std::size_t>(bytes.size())) == bytes.size())
            bytes = picture;
        close(file);
    });
    QProcess cusp;
    cusp.start(QStringLiteral(CUSP_BINARY_DIR "/bin/cusp"), {"track", "--video", at("pipe"), "--id", "5", "--json"});
    QByteArray out;
    const auto hasBegun = [&] {
        cusp.waitForReadyRead(10);
        out += cusp.readAllStandardOutput();
        return out.count('\n') > 10;
    };
    QTRY_VERIFY_WITH_TIMEOUT(hasBegun(), kPatienceMs);
    ::kill(static_cast<pid_t>(cusp.processId()), SIGINT);
    const bool hasEnded = cusp.waitForFinished(kPatienceMs);
    cusp.kill();
    writer.join();
    QVERIFY(hasEnded);
    // The program ends by the signal, and its last line is complete.
    QCOMPARE(cusp.exitStatus(), QProcess::CrashExit);
    out += cusp.readAllStandardOutput();
    QVERIFY(out.endsWith("}\n"));
}

void TestTrackCommand::aBadCalibrationIsRefused_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("sentence");
    const auto file = [](const char* width, const char* fx, const char* more = "") {
        return QByteArray(R"({"format":1,"width":)") + width + R"(,"height":240,"fx":)" + fx +
               R"(,"fy":277,"cx":160,"cy":120)" + more + "}";
    };
    QTest::newRow("sound") << file("320", "277") << QByteArray();
    QTest::newRow("sound, with a lens") << file("320", "277", R"(,"distortion":[0,0,0,0,0])") << QByteArray();
    QTest::newRow("empty") << QByteArray() << QByteArray("no calibration");
    QTest::newRow("cut off") << file("320", "277").chopped(10) << QByteArray("no calibration");
    QTest::newRow("a list") << QByteArray("[1,2]") << QByteArray("no calibration");
    QTest::newRow("another format") << file("320", "277").replace("1,", "2,") << QByteArray("no calibration");
    QTest::newRow("huge") << QByteArray(100'000, ' ') << QByteArray("too large");
    QTest::newRow("another size") << file("640", "277") << QByteArray("Calibrate the camera at this size");
    QTest::newRow("a size beyond numbers") << file("1e300", "277") << QByteArray("1 to 16384 pixels");
    QTest::newRow("a size in words") << file("\"320\"", "277") << QByteArray("1 to 16384 pixels");
    QTest::newRow("a focal length of nothing") << file("320", "0") << QByteArray("focal length");
    QTest::newRow("a focal length in words") << file("320", "\"277\"") << QByteArray("not a number");
    QTest::newRow("a lens of two") << file("320", "277", R"(,"distortion":[0,0])") << QByteArray("not a number");
    QTest::newRow("a wild lens") << file("320", "277", R"(,"distortion":[99,0,0,0,0])") << QByteArray("-5 and 5");
}

void TestTrackCommand::aBadCalibrationIsRefused()
{
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, sentence);
    writeImages("images", 1);
    write("camera.json", text);
    const Ending ending = runCusp({"track", "--images", at("images"), "--calibration", at("camera.json"), "--json"});
    if (sentence.isEmpty())
        expectDone(ending);
    else
        expectRefusal(ending, sentence);
}

void TestTrackCommand::calibratesByTheBoard()
{
    CameraModel camera = CameraModel::withFieldOfView(640, 480, 62.0);
    camera.centrePx += glm::dvec2(6.0, -4.0);
    camera.distortion = {-0.12, 0.05, 0.001, -0.0005, 0.0};
    writeBoards("boards", camera, 30.0);
    const QStringList words{"track", "--images", at("boards"), "--calibrate", at("camera.json")};
    const Ending ending = runCusp(words + QStringList{"--json"});
    expectDone(ending);
    QVERIFY(ending.json()["pictures"].toInt() >= 8);
    QVERIFY(ending.json()["error_px"].toDouble() < 0.2);
    const auto found = app::readCameraCalibration(at("camera.json"));
    QVERIFY(found.has_value());
    QVERIFY2(glm::distance(found->focalPx, camera.focalPx) < 0.01 * camera.focalPx.x,
             qPrintable(QString::number(found->focalPx.x)));
    QVERIFY(glm::distance(found->centrePx, camera.centrePx) < 2.0);
    // Compares near the corners, where the distortion is largest.
    for (const glm::dvec2 pixel : {glm::dvec2(60.0, 60.0), glm::dvec2(580.0, 60.0), glm::dvec2(60.0, 420.0)})
        QVERIFY(glm::distance(found->pixelOf({camera.directionOf(pixel), 1.0}), pixel) < 2.0);
    // The file can be read with --calibration.
    expectDone(runCusp({"track", "--images", at("boards"), "--calibration", at("camera.json")}));
    // The error names a path that cannot be written.
    write("file", "x");
    const Ending unwritten = runCusp({"track", "--images", at("boards"), "--calibrate", at("file/x.json"), "--json"});
    QCOMPARE(unwritten.exitCode, 1);
    QVERIFY2(unwritten.isOneSentence(), unwritten.error);
}

void TestTrackCommand::aBoardThatIsNeverTiltedIsNotEnough()
{
    writeBoards("boards", CameraModel::withFieldOfView(640, 480, 62.0), 0.0);
    const Ending ending = runCusp({"track", "--images", at("boards"), "--calibrate", at("camera.json"), "--json"});
    QCOMPARE(ending.exitCode, 1);
    QVERIFY2(ending.isOneSentence(), ending.error);
    QVERIFY(!QFile::exists(at("camera.json")));
}

void TestTrackCommand::calibratesByTheTagAtADistance()
{
    writeImages("images", 4);
    const Ending ending = runCusp({"track", "--images", at("images"), "--id", "5", "--fov", "80", "--at", "301",
                                   "--calibrate", at("camera.json"), "--json"});
    expectDone(ending);
    QCOMPARE(ending.json()["pictures"].toInt(), 4);
    const auto found = app::readCameraCalibration(at("camera.json"));
    QVERIFY(found.has_value());
    QVERIFY2(std::abs(found->fieldOfViewDeg() - CameraModel::kUsualFovDeg) < 0.6,
             qPrintable(QString::number(found->fieldOfViewDeg())));
}

void TestTrackCommand::printsTheSheet()
{
    expectDone(runCusp({"track", "--print", at("sheet.pdf"), "--id", "12"}));
    QFile sheet(at("sheet.pdf"));
    QVERIFY(sheet.open(QIODevice::ReadOnly));
    const QByteArray pdf = sheet.readAll();
    QVERIFY(pdf.startsWith("%PDF") && pdf.trimmed().endsWith("%%EOF"));
    // The options may come in any order.
    expectDone(runCusp({"track", "--id", "12", "--print", at("again.pdf")}));
    expectRefusal(runCusp({"track", "--print", at("sheet.pdf/x.pdf")}));
    expectRefusal(runCusp({"track", "--print", m_folder->path()}));
    expectRefusal(runCusp({"track", "--print", at("x.pdf"), "--id", "587"}), {}, 2);
    QVERIFY(!QFile::exists(at("x.pdf")));
}

QTEST_GUILESS_MAIN(TestTrackCommand)
#include "tst_track_command.moc"
