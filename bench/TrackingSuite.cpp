// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <deque>
#include <vector>

#include <glm/geometric.hpp>

#include "bench/Contestants.h"
#include "bench/InParallel.h"
#include "bench/Suites.h"
#include "cli/parts/Arguments.h"
#include "core/tracking/HeadFilter.h"
#include "core/tracking/TagTracker.h"
#include "haptics/simulated/Simulation.h"
#include "lab/TagScene.h"

namespace bench {
namespace {

using namespace core::tracking;

constexpr std::array kDistancesMm{300.0, 600.0, 900.0};
constexpr int kPathPictures = 31;
constexpr double kMostYawDeg = 50.0;
constexpr double kTiltedDeg = 15.0;  ///< least tilt at which the angle of a tag is measured
constexpr double kFlipDeg = 5.0;
constexpr double kPictureHz = 30.0;
constexpr int kMostDecimation = 4;
constexpr int kRestPictures = 200;
constexpr int kSettled = 50;  ///< pictures until the filter is at rest
constexpr double kMotionMmPerS = 200.0;
constexpr int kClutterPictures = 2000;
constexpr int kClutterPart = 50;
constexpr int kTimedClutter = 90;
constexpr double kMs = 0.001;  ///< milliseconds in a microsecond

/// Number of steps of the progress.
constexpr int kPathSteps = static_cast<int>(kDistancesMm.size()) * kPathPictures;
constexpr int kSteps = kPathSteps + static_cast<int>(kDistancesMm.size()) + 2;

/// One way to search a picture.
struct Way
{
    int decimation = 2;
    bool usesRegion = true;
    bool refinesEdges = true;

    [[nodiscard]] QString key() const
    {
        return QStringLiteral("%1_%2_dec%3")
            .arg(usesRegion ? QStringLiteral("region") : QStringLiteral("whole"),
                 refinesEdges ? QStringLiteral("refined") : QStringLiteral("coarse"))
            .arg(decimation);
    }
    [[nodiscard]] QString groupName() const
    {
        return (usesRegion ? QStringLiteral("around the tag") : QStringLiteral("whole picture")) +
               (refinesEdges ? QStringLiteral(", edges refined") : QStringLiteral(", edges as found"));
    }
    [[nodiscard]] QString name() const { return groupName() + QStringLiteral(", decimation %1").arg(decimation); }
};

double percentileOf(std::vector<double> values, double share)
{
    if (values.empty())
        return 0.0;
    const auto k = std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())));
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(k), values.end());
    return values[k];
}

/// Errors and times of one way to search.
struct Tally
{
    Way way;
    std::vector<double> cornerPx;
    std::vector<double> lateralMm;
    std::vector<double> depthMm;
    std::vector<double> angleDeg;  ///< of tags tilted by kTiltedDeg or more
    std::vector<double> ms;
    int pictures = 0;
    int lost = 0;
    int flipped = 0;        ///< pictures in which the wrong one of two poses has the smaller error
    int flippedByHead = 0;  ///< pictures in which HeadFilter chose the wrong one of two
};

lab::TagScene sceneOf(const lab::PrintedTag& tag, std::uint64_t seed)
{
    lab::TagScene scene;
    scene.camera = CameraModel::withFieldOfView(1280, 720, CameraModel::kUsualFovDeg);
    scene.tag = tag;
    scene.grain = seed;
    return scene;
}

/// Returns the tag of a head that turns from one side to the other and moves along.
lab::PrintedTag tagOnPath(double distanceMm, int picture)
{
    const double share = 2.0 * picture / (kPathPictures - 1) - 1.0;
    lab::PrintedTag tag;
    tag.pose = lab::facing({0.12 * distanceMm * share, 20.0 * share * share - 30.0, distanceMm + 15.0 * share},
                           kMostYawDeg * share, 3.0, 5.0 * share);
    return tag;
}

/// Searches one picture and compares the result with the truth.
void look(Tally& tally, TagTracker& tracker, HeadFilter& filter, const Picture& picture, const lab::TagScene& scene)
{
    const bool isFollowed = tally.pictures++ % kPathPictures != 0;
    const double before = haptics::threadCpuUs();
    const auto frame = tracker.look(picture.view());
    if (isFollowed)
        tally.ms.push_back(kMs * (haptics::threadCpuUs() - before));
    if (!frame || frame->tags.empty()) {
        ++tally.lost;
        filter.take(std::nullopt, picture.timeS);
        return;
    }
    const PosedTag& tag = frame->tags.front();
    const Head& head = filter.take(tag, picture.timeS);
    const Pose& truth = scene.tag->pose;
    const auto corners = lab::cornersOf(*scene.tag, scene.camera);
    for (std::size_t n = 0; n < corners.size(); ++n)
        tally.cornerPx.push_back(glm::distance(corners.at(n), tag.tag.cornersPx.at(n)));
    const glm::dvec3 apart = tag.pose.positionMm - truth.positionMm;
    tally.lateralMm.push_back(std::hypot(apart.x, apart.y));
    tally.depthMm.push_back(std::abs(apart.z));
    const double angle = angleBetweenDeg(tag.pose.rotation, truth.rotation);
    if (lab::tiltDeg(truth) >= kTiltedDeg)
        tally.angleDeg.push_back(angle);
    tally.flipped += angle > kFlipDeg ? 1 : 0;
    tally.flippedByHead += head.isSeen && angleBetweenDeg(head.raw.rotation, truth.rotation) > kFlipDeg ? 1 : 0;
}

Figure figureOf(const QString& key, const QString& what, double value, const char* unit, const char* reach = "")
{
    return {QStringLiteral("tracking_") + key, what, value, QLatin1String(unit), QLatin1String(reach)};
}

/// Tries all ways to search on a turning head, with their figures and chart.
void addPaths(Figures& figures, const Context& context)
{
    std::vector<Tally> tallies;
    for (const bool usesRegion : {true, false})
        for (const bool refines : {true, false})
            for (int decimation = 1; decimation <= kMostDecimation; ++decimation) {
                Tally tally;
                tally.way = {decimation, usesRegion, refines};
                tallies.push_back(tally);
            }
    std::vector<double> searchMs;
    int done = 0;
    for (const double distanceMm : kDistancesMm) {
        std::deque<TagTracker> trackers;
        std::vector<HeadFilter> filters(tallies.size());
        for (const Tally& tally : tallies) {
            TrackerSettings settings;
            settings.usesRegion = tally.way.usesRegion;
            settings.refinesEdges = tally.way.refinesEdges;
            settings.regionDecimation = tally.way.decimation;
            if (!tally.way.usesRegion)
                settings.searchDecimation = tally.way.decimation;
            trackers.emplace_back(settings);
        }
        for (int n = 0; n < kPathPictures; ++n) {
            context.progress(QStringLiteral("a head that turns at %1 mm").arg(distanceMm), done++, kSteps);
            const lab::TagScene scene = sceneOf(tagOnPath(distanceMm, n), static_cast<std::uint64_t>(done));
            Picture picture = lab::render(scene);
            picture.timeS = 1.0 + n / kPictureHz;
            for (std::size_t k = 0; k < tallies.size(); ++k)
                look(tallies[k], trackers[k], filters[k], picture, scene);
            TagTracker anew({});
            const double before = haptics::threadCpuUs();
            (void)anew.look(picture.view());
            searchMs.push_back(kMs * (haptics::threadCpuUs() - before));
        }
    }

    ui::charts::Curve chart;
    chart.x = {QStringLiteral("CPU time of a picture, pose included, median (ms)"), 0.2, 200.0, false, 10.0};
    chart.y = {QStringLiteral("error of a corner, median (px)"), 0.02, 2.0, false, 10.0};
    chart.limits = {{3.0, true, QStringLiteral("asked of a picture in which the tag is followed")}};
    for (std::size_t k = 0; k < tallies.size(); ++k) {
        const Tally& tally = tallies[k];
        const bool isShipped = tally.way.usesRegion && tally.way.refinesEdges && tally.way.decimation == 2;
        const auto add = [&](const char* key, const char* what, double value, const char* unit, const char* reach) {
            figures << figureOf(tally.way.key() + u'_' + QLatin1String(key),
                                tally.way.name() + QStringLiteral(": ") + QLatin1String(what), value, unit,
                                isShipped ? reach : "");
        };
        const auto percent = [&](int count) { return 100.0 * count / tally.pictures; };
        add("corner_px", "corner, median", percentileOf(tally.cornerPx, 0.5), "px", "");
        add("lateral_mm", "sideways, median", percentileOf(tally.lateralMm, 0.5), "mm", "0.1");
        add("depth_mm", "depth, median", percentileOf(tally.depthMm, 0.5), "mm", "0.5");
        add("angle_deg", "angle, median", percentileOf(tally.angleDeg, 0.5), "deg", "0.3");
        add("p50_ms", "time, median", percentileOf(tally.ms, 0.5), "ms", "3");
        add("p99_ms", "time, p99", percentileOf(tally.ms, 0.99), "ms", "");
        add("lost_percent", "pictures without the tag", percent(tally.lost), "%", "0");
        add("flip_percent", "wrong pose of two", percent(tally.flipped), "%", "");
        add("head_flip_percent", "wrong pose of two, after the filter", percent(tally.flippedByHead), "%", "");
        if (tally.way.decimation == 1)
            chart.lines << lineOf(tally.way.groupName(), static_cast<LookIndex>(chart.lines.size()));
        chart.lines.back().dots << pointAt(percentileOf(tally.ms, 0.5), percentileOf(tally.cornerPx, 0.5),
                                           QString::number(tally.way.decimation));
    }
    figures << figureOf(QStringLiteral("search_p50_ms"), QStringLiteral("search that finds the tag, median"),
                        percentileOf(searchMs, 0.5), "ms", "10")
            << figureOf(QStringLiteral("search_p99_ms"), QStringLiteral("search that finds the tag, p99"),
                        percentileOf(searchMs, 0.99), "ms");
    context.show(
        {QStringLiteral("tracking"),
         {QStringLiteral("Accuracy of a tag's corners against the time to find it"),
          QStringLiteral("Rendered pictures of 1280x720 pixels, noise 2.5 grey levels, before clutter; a tag of "
                         "50 mm at 300, 600 and 900 mm that turns from -50 to 50 degrees.\nBeside each mark is "
                         "its decimation: only every n-th pixel of every n-th row is searched."),
          {},
          chart}});
}

struct Calm
{
    double mm = 0.0;
    double deg = 0.0;
    double lagMs = 0.0;
};

/// Returns the noise of a filter for a tag at rest, and its delay for one that moves sideways.
Calm calmOf(const std::vector<PosedTag>& tags, const HeadFilter::Settings& settings, double hz)
{
    HeadFilter rest(settings);
    std::vector<Pose> poses;
    for (std::size_t n = 0; n < tags.size(); ++n) {
        const Head& head = rest.take(tags[n], 1.0 + static_cast<double>(n) / hz);
        if (n >= kSettled)
            poses.push_back(head.pose);
    }
    Calm calm;
    if (poses.empty())
        return calm;
    const auto count = static_cast<double>(poses.size());
    glm::dvec3 mean(0.0);
    for (const Pose& pose : poses)
        mean += pose.positionMm / count;
    for (std::size_t n = 0; n < poses.size(); ++n) {
        const glm::dvec3 apart = poses[n].positionMm - mean;
        // Two independent poses differ by the square root of two times the jitter.
        const double deg = angleBetweenDeg(poses[n].rotation, poses[(n + poses.size() / 2) % poses.size()].rotation);
        calm.mm += glm::dot(apart, apart) / count;
        calm.deg += 0.5 * deg * deg / count;
    }
    calm.mm = std::sqrt(calm.mm);
    calm.deg = std::sqrt(calm.deg);

    HeadFilter motion(settings);
    int late = 0;
    for (int n = 0; n < static_cast<int>(2.0 * hz); ++n) {
        PosedTag tag = tags[static_cast<std::size_t>(n) % tags.size()];
        const glm::dvec3 way(kMotionMmPerS * n / hz, 0.0, 0.0);
        tag.pose.positionMm += way;
        tag.other.positionMm += way;
        const Head& head = motion.take(tag, 1.0 + n / hz);
        if (n < static_cast<int>(hz))
            continue;
        calm.lagMs += 1000.0 * (tag.pose.positionMm.x - head.pose.positionMm.x) / kMotionMmPerS;
        ++late;
    }
    calm.lagMs /= std::max(1, late);
    return calm;
}

std::vector<PosedTag> tagAtRest(double distanceMm)
{
    lab::PrintedTag printed;
    printed.pose = lab::facing({30.0, -20.0, distanceMm}, 5.0, 20.0, 4.0);
    TagTracker tracker({});
    std::vector<PosedTag> tags;
    for (int n = 0; n < kRestPictures; ++n) {
        const auto frame = tracker.look(lab::render(sceneOf(printed, static_cast<std::uint64_t>(n + 1))).view());
        if (frame && !frame->tags.empty())
            tags.push_back(frame->tags.front());
    }
    return tags;
}

/// Measures the filter at rest and in motion, with a chart of other settings.
void addFilter(Figures& figures, const Context& context)
{
    constexpr double kChartDistanceMm = 600.0;
    constexpr std::array kLeastHz{0.2, 0.4, 1.0, 2.0};
    constexpr std::array kPerSpeed{0.02, 0.04, 0.07, 0.14};
    ui::charts::Curve chart;
    chart.x = {QStringLiteral("lag at %1 mm/s (ms)").arg(kMotionMmPerS), 3.0, 60.0, false, 2.0};
    chart.y = {QStringLiteral("jitter at rest (mm)"), 0.0, 0.06};
    chart.limits = {{0.05, false, QStringLiteral("asked")}, {20.0, true, QStringLiteral("asked")}};
    int done = kPathSteps;
    for (const double distanceMm : kDistancesMm) {
        context.progress(QStringLiteral("a head at rest at %1 mm").arg(distanceMm), done++, kSteps);
        const std::vector<PosedTag> tags = tagAtRest(distanceMm);
        if (tags.size() < 2 * kSettled)
            continue;
        for (const double hz : {30.0, 60.0}) {
            const Calm calm = calmOf(tags, {}, hz);
            const auto add = [&](const char* key, const char* what, double value, const char* unit, const char* reach) {
                figures << figureOf(
                    QStringLiteral("%1_%2mm_%3hz_%4")
                        .arg(QLatin1String(key))
                        .arg(distanceMm)
                        .arg(hz)
                        .arg(QLatin1String(unit)),
                    QStringLiteral("%1 at %2 mm, %3 Hz").arg(QLatin1String(what)).arg(distanceMm).arg(hz), value, unit,
                    reach);
            };
            add("jitter", "jitter of the place", calm.mm, "mm", "0.05");
            add("jitter", "jitter of the angle", calm.deg, "deg", "0.05");
            add("lag", "lag at 200 mm/s", calm.lagMs, "ms", "20");
        }
        if (distanceMm != kChartDistanceMm)
            continue;
        for (const double least : kLeastHz) {
            chart.lines << lineOf(QStringLiteral("%1 Hz at rest").arg(least),
                                  static_cast<LookIndex>(chart.lines.size()));
            for (const double perSpeed : kPerSpeed) {
                HeadFilter::Settings settings;
                settings.position.leastHz = least;
                settings.position.perSpeed = perSpeed;
                const Calm calm = calmOf(tags, settings, kPictureHz);
                chart.y.high = std::max(chart.y.high, ui::charts::roundEnd(calm.mm));
                chart.lines.back().dots << pointAt(calm.lagMs, calm.mm, QString::number(perSpeed));
            }
        }
    }
    context.show({QStringLiteral("tracking-filter"),
                  {QStringLiteral("Jitter of the head at rest against its lag in motion"),
                   QStringLiteral("One-Euro filter at %1 pictures a second, a tag of 50 mm at %2 mm. Each line has one "
                                  "cutoff at rest;\nbeside each mark is the rise of the cutoff, Hz for each mm/s.")
                       .arg(kPictureHz)
                       .arg(kChartDistanceMm),
                   {},
                   chart}});
}

/// Measures false detections and the search time in pictures without a tag.
void addClutter(Figures& figures, const Context& context)
{
    const auto clutter = [](int n) {
        lab::TagScene scene = sceneOf({}, static_cast<std::uint64_t>(n));
        scene.tag.reset();
        scene.clutter = static_cast<std::uint64_t>(1'000'000 + n);
        return lab::render(scene);
    };
    context.progress(QStringLiteral("clutter, timed"), kSteps - 2, kSteps);
    std::vector<double> ms;
    TagTracker timed({});
    for (int n = 0; n < kTimedClutter; ++n) {
        const Picture picture = clutter(n);
        const double before = haptics::threadCpuUs();
        (void)timed.look(picture.view());
        ms.push_back(kMs * (haptics::threadCpuUs() - before));
    }
    context.progress(QStringLiteral("clutter"), kSteps - 1, kSteps);
    std::atomic<int> found{0};
    inParallel(
        kClutterPictures / kClutterPart,
        [&](std::size_t part) {
            TagTracker tracker({});
            for (int n = 0; n < kClutterPart; ++n) {
                const auto frame =
                    tracker.look(clutter(kTimedClutter + static_cast<int>(part) * kClutterPart + n).view());
                found += frame ? static_cast<int>(frame->tags.size()) : 0;
            }
        },
        [](std::size_t) {});
    figures << figureOf(QStringLiteral("empty_search_p50_ms"), QStringLiteral("search without a tag, median"),
                        percentileOf(ms, 0.5), "ms", "10")
            << figureOf(QStringLiteral("empty_search_p99_ms"), QStringLiteral("search without a tag, p99"),
                        percentileOf(ms, 0.99), "ms")
            << figureOf(QStringLiteral("false_tags"),
                        QStringLiteral("tags in %1 pictures without one").arg(kClutterPictures), found, "", "0");
}

}  // namespace

core::Result<Figures> trackingSuite(const Context& context)
{
    Figures figures;
    if (!hasTagDetector()) {
        cli::printText(
            QStringLiteral("tracking: this program is built without head tracking, so there are no figures\n"), stderr);
        return figures;
    }
    addPaths(figures, context);
    addFilter(figures, context);
    addClutter(figures, context);
    return figures;
}

}  // namespace bench
