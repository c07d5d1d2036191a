// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/parts/TrackParts.h"

#include <string>
#include <vector>

#include <QJsonArray>

#include "app/devices/CameraCalibration.h"
#include "cli/parts/Arguments.h"
#include "cli/parts/ExitCode.h"
#include "cli/parts/StopSignal.h"
#include "core/base/Median.h"
#include "core/base/WholeFile.h"
#include "core/tracking/BoardCalibration.h"
#include "core/tracking/TagCells.h"
#include "ui/devices/TagSheet.h"

namespace cli {
namespace {

using core::tracking::BoardCalibration;
using core::tracking::CameraModel;
using core::tracking::Picture;
using core::tracking::PictureSource;
using core::tracking::TagTracker;
using core::tracking::TrackerSettings;

constexpr double kLookEveryS = 0.3;  ///< interval of searches for the board, in a camera or a video
constexpr int kEnoughTags = 30;      ///< pictures with the tag, for a calibration by distance

/// Passes pictures to `look` until it has enough, `look` returns false, or the pictures end. Reports and skips an image
/// that cannot be read. Returns false if a signal ends the program.
template <class Look>
core::Result<bool> forEachPicture(PictureSource& source, qint64 most, Look&& look)
{
    Picture picture;
    for (qint64 n = 0; n < most && !StopSignal::hasCome(); ++n) {
        const auto got = source.next(picture);
        if (!got && got.error().code == core::ErrorCode::WrongKind) {
            warn({got.error().detail});
            continue;
        }
        if (!got)
            return tl::unexpected(got.error());
        if (!*got)
            break;
        const core::Result<bool> goesOn = look(picture);
        if (!goesOn)
            return tl::unexpected(goesOn.error());
        if (!*goesOn)
            break;
    }
    return !StopSignal::hasCome();
}

/// @param figures  additional figures of this kind of calibration
int writeAndSay(const CameraModel& camera, const CalibrationWish& wish, const QJsonObject& figures)
{
    if (const auto sound = camera.check(); !sound)
        return failed(sound.error());
    if (const auto written = app::writeCameraCalibration(wish.file, camera); !written)
        return failed(written.error());
    QJsonObject answer{{QStringLiteral("calibration"), wish.file},
                       {QStringLiteral("width"), camera.width},
                       {QStringLiteral("height"), camera.height},
                       {QStringLiteral("focal_px"), QJsonArray{camera.focalPx.x, camera.focalPx.y}},
                       {QStringLiteral("fov_deg"), camera.fieldOfViewDeg()}};
    for (auto it = figures.begin(); it != figures.end(); ++it)
        answer[it.key()] = it.value();
    if (wish.isJson) {
        printJson(answer);
        return kDone;
    }
    QString text = QStringLiteral("%1 pictures of %2 x %3 pixels: field of view %4 degrees, focal length %5 px")
                       .arg(figures[QStringLiteral("pictures")].toInt())
                       .arg(camera.width)
                       .arg(camera.height)
                       .arg(camera.fieldOfViewDeg(), 0, 'f', 2)
                       .arg(camera.focalPx.x, 0, 'f', 1);
    if (const QJsonValue error = figures[QStringLiteral("error_px")]; error.isDouble())
        text += QStringLiteral(", error %1 px").arg(error.toDouble(), 0, 'f', 2);
    printText(text + QStringLiteral("\nwritten to %1\n").arg(printable(wish.file)));
    return kDone;
}

}  // namespace

int printTagSheet(const QString& file, int id)
{
    const QByteArray pdf = ui::devices::TagSheet(id, core::tracking::cellsOf(id)).pdf();
    const auto written =
        core::writeWhole(file.toStdString(), {pdf.constData(), static_cast<std::size_t>(pdf.size())}, "The sheet");
    if (!written)
        return failed(written.error());
    printText(QStringLiteral("Tag %1, a headband and a board for calibration are in %2. Print it without scaling (100 "
                             "%), and measure its ruler.\n")
                  .arg(QString::number(id), printable(file)));
    return kDone;
}

int calibrateByBoard(PictureSource& source, const CalibrationWish& wish)
{
    const StopSignal stop;
    BoardCalibration calibration;
    double lookAtS = 0.0;
    const auto seen = forEachPicture(source, wish.most, [&](const Picture& picture) -> core::Result<bool> {
        if (picture.name.empty()) {
            if (picture.timeS < lookAtS)
                return true;
            lookAtS = picture.timeS + kLookEveryS;
        }
        const auto look = calibration.take(picture.view());
        if (look == BoardCalibration::Look::OtherSize)
            return core::unexpected(core::ErrorCode::OutOfRange, "The pictures have different sizes; a calibration "
                                                                 "holds for one size.");
        if (look == BoardCalibration::Look::Taken && !wish.isJson)
            printText(QStringLiteral("%1 of at most %2 pictures\n")
                          .arg(calibration.views())
                          .arg(BoardCalibration::kMostViews),
                      stderr);
        return calibration.views() < BoardCalibration::kMostViews;
    });
    if (!seen)
        return failed(seen.error());
    if (!*seen)
        return kFailed;
    const auto found = calibration.solve();
    if (!found)
        return failed(found.error());
    return writeAndSay(
        found->camera, wish,
        {{QStringLiteral("pictures"), calibration.views()}, {QStringLiteral("error_px"), found->errorPx}});
}

int calibrateByDistance(PictureSource& source, const TrackerSettings& settings, double distanceMm,
                        const CalibrationWish& wish)
{
    const StopSignal stop;
    TagTracker tracker(settings);
    std::vector<double> focalPx;
    CameraModel camera;
    const auto seen = forEachPicture(source, wish.most, [&](const Picture& picture) -> core::Result<bool> {
        const auto frame = tracker.look(picture.view());
        if (!frame)
            return tl::unexpected(frame.error());
        if (!focalPx.empty() && (picture.width != camera.width || picture.height != camera.height))
            return core::unexpected(core::ErrorCode::OutOfRange, "The pictures have different sizes; a calibration "
                                                                 "holds for one size.");
        if (!frame->tags.empty()) {
            camera = tracker.camera();
            if (const auto focal = camera.focalAt(frame->tags.front().pose.positionMm, distanceMm))
                focalPx.push_back(*focal);
        }
        return focalPx.size() < kEnoughTags;
    });
    if (!seen)
        return failed(seen.error());
    if (!*seen)
        return kFailed;
    if (focalPx.empty())
        return failed({core::ErrorCode::BadStructure,
                       "Tag " + std::to_string(settings.id.value_or(0)) +
                           " was not found in the pictures. Hold it upright before the camera, in good light."});
    camera.focalPx = glm::dvec2(core::median(focalPx));
    return writeAndSay(camera, wish, {{QStringLiteral("pictures"), static_cast<int>(focalPx.size())}});
}

}  // namespace cli
