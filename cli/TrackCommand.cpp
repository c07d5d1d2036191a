// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <optional>
#include <vector>

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryFile>

#include "app/devices/CameraCalibration.h"
#include "cli/Commands.h"
#include "cli/parts/Arguments.h"
#include "cli/parts/StopSignal.h"
#include "cli/parts/TrackParts.h"
#include "core/base/Median.h"
#include "core/tracking/PictureSource.h"
#include "core/tracking/TagTracker.h"

namespace cli {
namespace {

using core::tracking::Picture;
using core::tracking::PictureSource;
using core::tracking::PosedTag;
using core::tracking::TagFrame;
using core::tracking::TagTracker;
using core::tracking::TrackerSettings;
using Clock = std::chrono::steady_clock;

constexpr const char* kTrackUsage =
    "cusp track --camera N | --video FILE | --images DIR | --list | --print FILE [OPTIONS]";
constexpr int kMostCameras = 1000;
constexpr double kMostPictures = 1e9;
constexpr double kNearestMm = 100.0;  ///< nearest tag for the calibration of a camera
constexpr double kFarthestMm = 5000.0;

QJsonArray numbers(const glm::dvec2& value)
{
    return {value.x, value.y};
}

QJsonArray numbers(const glm::dvec3& value)
{
    return {value.x, value.y, value.z};
}

QJsonObject jsonOf(const PosedTag& posed)
{
    QJsonArray corners;
    for (const glm::dvec2& corner : posed.tag.cornersPx)
        corners.append(numbers(corner));
    return {{QStringLiteral("id"), posed.tag.id},
            {QStringLiteral("corners"), corners},
            {QStringLiteral("position_mm"), numbers(posed.pose.positionMm)},
            {QStringLiteral("rotation_deg"), numbers(core::tracking::rotationVectorDeg(posed.pose.rotation))},
            {QStringLiteral("reprojection_px"), posed.reprojectionPx}};
}

/// Prints one object for each picture, each on its own line.
void printFrame(const Picture& picture, const TagFrame& frame, double grabMs)
{
    QJsonArray tags;
    for (const PosedTag& posed : frame.tags)
        tags.append(jsonOf(posed));
    QJsonObject object{{QStringLiteral("tags"), tags},
                       {QStringLiteral("ms"), QJsonObject{{QStringLiteral("grab"), grabMs},
                                                          {QStringLiteral("find"), frame.findMs},
                                                          {QStringLiteral("pose"), frame.poseMs}}}};
    if (picture.name.empty())
        object[QStringLiteral("time_s")] = picture.timeS;
    else
        object[QStringLiteral("file")] = QString::fromStdString(picture.name);
    printText(QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact)) + u'\n');
    std::fflush(stdout);
}

void printFrameText(const Picture& picture, const TagFrame& frame)
{
    const QString when = picture.name.empty() ? QStringLiteral("%1 s").arg(picture.timeS, 0, 'f', 3)
                                              : printable(QString::fromStdString(picture.name));
    QString line = when + u':';
    for (const PosedTag& posed : frame.tags) {
        const glm::dvec3& at = posed.pose.positionMm;
        line += QStringLiteral(" tag %1 at %2 %3 %4 mm (%5 px);")
                    .arg(posed.tag.id)
                    .arg(at.x, 0, 'f', 1)
                    .arg(at.y, 0, 'f', 1)
                    .arg(at.z, 0, 'f', 1)
                    .arg(posed.reprojectionPx, 0, 'f', 2);
    }
    printText((frame.tags.empty() ? line + QStringLiteral(" no tag") : line.chopped(1)) + u'\n');
}

/// Counts and times over all pictures.
class Summary
{
public:
    void take(const TagFrame& frame)
    {
        ++m_pictures;
        if (frame.tags.empty())
            return;
        ++m_found;
        (frame.isWhole ? m_searchMs : m_followMs).push_back(frame.findMs + frame.poseMs);
    }
    [[nodiscard]] int pictures() const { return m_pictures; }
    void print()
    {
        printText(QStringLiteral("%1 pictures, %2 with a tag; milliseconds to find it in the whole picture: %3, around "
                                 "its last place: %4 (medians)\n")
                      .arg(m_pictures)
                      .arg(m_found)
                      .arg(core::median(m_searchMs), 0, 'f', 2)
                      .arg(core::median(m_followMs), 0, 'f', 2),
                  stderr);
    }

private:
    int m_pictures = 0;
    int m_found = 0;
    std::vector<double> m_searchMs;
    std::vector<double> m_followMs;
};

int listCameras()
{
    const auto found = core::tracking::cameras();
    if (found.empty())
        return failed({core::ErrorCode::FileMissing, "No camera is plugged in."});
    for (const auto& camera : found)
        printText(QStringLiteral("%1  %2\n").arg(camera.number).arg(printable(QString::fromStdString(camera.name))));
    return kDone;
}

core::Result<TrackerSettings> settingsFrom(const QCommandLineParser& parser)
{
    TrackerSettings settings;
    const auto number = [&](const char* option, double& value) {
        bool isNumber = true;
        if (parser.isSet(QLatin1String(option)))
            value = parser.value(QLatin1String(option)).toDouble(&isNumber);
        return isNumber ? core::Status{}
                        : core::unexpected(core::ErrorCode::BadNumber, std::string("--") + option + " takes a number");
    };
    if (const auto given = number("tag-size", settings.tagMm); !given)
        return tl::unexpected(given.error());
    if (const auto given = number("fov", settings.fovDeg); !given)
        return tl::unexpected(given.error());
    if (parser.isSet(QStringLiteral("all-ids"))) {
        settings.id.reset();
    } else {
        const auto id = wholeNumber(parser, QStringLiteral("id"), 0, core::tracking::kTagCount - 1);
        if (!id)
            return tl::unexpected(id.error());
        settings.id = static_cast<int>(*id);
    }
    // A file has no time limit for each picture, unlike a camera.
    settings.isThorough = !parser.isSet(QStringLiteral("camera"));
    if (const auto checked = check(settings); !checked)
        return tl::unexpected(checked.error());
    return settings;
}

core::Result<std::unique_ptr<PictureSource>> openSource(const QCommandLineParser& parser, int camera)
{
    if (parser.isSet(QStringLiteral("video")))
        return core::tracking::openVideo(parser.value(QStringLiteral("video")).toStdString());
    if (parser.isSet(QStringLiteral("images")))
        return core::tracking::openFolder(parser.value(QStringLiteral("images")).toStdString());
    return core::tracking::openCamera(camera, {});
}

/// @param most  pictures to read
int track(PictureSource& source, TagTracker& tracker, qint64 most, bool isJson)
{
    const StopSignal stop;
    Summary summary;
    int unread = 0;
    Picture picture;
    for (qint64 n = 0; n < most && !StopSignal::hasCome(); ++n) {
        const auto begun = Clock::now();
        const auto got = source.next(picture);
        const double grabMs = std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
        if (!got) {
            if (got.error().code != core::ErrorCode::WrongKind)
                return failed(got.error());
            warn({got.error().detail});  // one bad image of many
            ++unread;
            continue;
        }
        if (!*got)
            break;
        const auto frame = tracker.look(picture.view());
        if (!frame)
            return failed(frame.error());
        summary.take(*frame);
        if (isJson)
            printFrame(picture, *frame, grabMs);
        else
            printFrameText(picture, *frame);
    }
    if (summary.pictures() == 0 && !StopSignal::hasCome())
        return failed({core::ErrorCode::WrongKind, "No picture could be read."});
    if (!isJson)
        summary.print();
    return unread == 0 ? kDone : kFailed;
}

/// Checks the path before the calibration starts, so that its minutes of work are not lost.
core::Status checkWritable(const QString& path)
{
    const QString folder = QFileInfo(path).absolutePath();
    QDir().mkpath(folder);
    if (QFileInfo(path).isDir() || !QTemporaryFile(folder + QStringLiteral("/calibration-XXXXXX")).open())
        return core::unexpected(core::ErrorCode::FileUnwritable, path.toStdString() + " cannot be written");
    return {};
}

void addTrackOptions(QCommandLineParser& parser)
{
    parser.setApplicationDescription(QStringLiteral(
        "Finds a printed tag (AprilTag, family 36h11) in the pictures of a camera, a video or a folder of images, and "
        "says where it is: x to the right, y down, z away from the camera. rotation_deg is a rotation vector: the axis "
        "times the angle; zero if the tag is seen straight on and upright. Corners: lower left, lower right, upper "
        "right, upper left; the centre of the first pixel is at 0.5, 0.5."));
    const auto option = [&](const char* name, const char* words, const char* value, const char* usual = "") {
        parser.addOption({QLatin1String(name), QLatin1String(words), QLatin1String(value), QLatin1String(usual)});
    };
    option("camera", "The camera with this number; --list prints them.", "N");
    option("video", "A video file.", "FILE");
    option("images", "A folder of images (PNG, JPEG, BMP, PGM, TIFF), by name.", "DIR");
    parser.addOption({QStringLiteral("list"), QStringLiteral("Prints the cameras of this computer.")});
    option("id", "The number of the tag, 0 to 586; 0 if not given.", "N", "0");
    parser.addOption({QStringLiteral("all-ids"), QStringLiteral("Reports every tag of the family, not one alone.")});
    option("tag-size", "The edge of the tag's black square in millimetres; 50 if not given.", "MM");
    option("fov", "The horizontal field of view of the camera in degrees; 60 if not given.", "DEG");
    option("calibration", "A calibration of the camera, in place of --fov.", "FILE");
    option("print", "Writes a PDF with the tag in several sizes, a headband and a board for calibration.", "FILE");
    option("calibrate", "Computes the camera's calibration from pictures of the printed board, and writes it.", "FILE");
    option("at", "Calibrates by the tag instead, held at this distance from the camera.", "MM");
    option("frames", "Stops after so many pictures.", "N", "1000000000");
    addJson(parser);
}

}  // namespace

int trackCommand(const QStringList& arguments)
{
    QCommandLineParser parser;
    addTrackOptions(parser);
    if (const auto code = parse(parser, arguments, QLatin1String(kTrackUsage)))
        return *code;
    const auto has = [&](const char* name) { return parser.isSet(QLatin1String(name)); };
    const auto wrong = [](const core::Error& error) { return wrongUsage(QString::fromStdString(error.detail)); };
    int sources = 0;
    for (const char* name : {"camera", "video", "images", "list", "print"})
        sources += has(name) ? 1 : 0;
    if (sources != 1 || !parser.positionalArguments().isEmpty())
        return wrongUsage(QStringLiteral("name one source of pictures; usage: ") + QLatin1String(kTrackUsage));
    if (has("list"))
        return listCameras();
    qint64 camera = 0;
    if (has("camera")) {
        const auto number = wholeNumber(parser, QStringLiteral("camera"), 0, kMostCameras);
        if (!number)
            return wrong(number.error());
        camera = *number;
    }
    const auto most = wholeNumber(parser, QStringLiteral("frames"), 1, static_cast<qint64>(kMostPictures));
    if (!most)
        return wrong(most.error());
    auto settings = settingsFrom(parser);
    if (!settings)
        return wrong(settings.error());
    for (const char* name : {"calibration", "calibrate", "all-ids", "tag-size", "fov", "frames", "json"})
        if (has("print") && has(name))
            return wrongUsage(QStringLiteral("--print writes a sheet, and takes --id alone; leave out --%1")
                                  .arg(QLatin1String(name)));
    if (has("calibrate") && has("calibration"))
        return wrongUsage(QStringLiteral("--calibrate makes a calibration from pictures; leave out --calibration"));
    bool isNumber = true;
    const double distanceMm = has("at") ? parser.value(QStringLiteral("at")).toDouble(&isNumber) : 0.0;
    if (has("at") && !(isNumber && distanceMm >= kNearestMm && distanceMm <= kFarthestMm))
        return wrongUsage(QStringLiteral("--at wants a distance from 100 to 5000 mm"));
    if (has("at") && (!has("calibrate") || !settings->id))
        return wrongUsage(QStringLiteral("--at goes with --calibrate and one tag"));
    if (!core::tracking::hasTagDetector())
        return failed({core::ErrorCode::FileUnreadable,
                       "This program was built without head tracking. Install libapriltag-dev and OpenCV, and build it "
                       "again."});
    if (has("print"))
        return printTagSheet(parser.value(QStringLiteral("print")), settings->id.value_or(0));
    if (has("calibration")) {
        const auto calibration = app::readCameraCalibration(parser.value(QStringLiteral("calibration")));
        if (!calibration)
            return failed(calibration.error());
        settings->calibration = *calibration;
    }
    auto source = openSource(parser, static_cast<int>(camera));
    if (!source)
        return failed(source.error());
    if (has("calibrate")) {
        if (const auto writable = checkWritable(parser.value(QStringLiteral("calibrate"))); !writable)
            return failed(writable.error());
        const CalibrationWish wish{parser.value(QStringLiteral("calibrate")), *most, has("json")};
        return has("at") ? calibrateByDistance(**source, *settings, distanceMm, wish)
                         : calibrateByBoard(**source, wish);
    }
    TagTracker tracker(*settings);
    return track(**source, tracker, *most, has("json"));
}

}  // namespace cli
