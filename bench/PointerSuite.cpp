// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "bench/Contestants.h"
#include "bench/InParallel.h"
#include "bench/MousePerson.h"
#include "bench/Suites.h"
#include "core/bur/Bur.h"
#include "core/teeth/ToothBuilder.h"
#include "lessons/Assignment.h"
#include "lessons/LessonCatalog.h"
#include "ui/tooth/PointerControl.h"

namespace bench {
namespace {

using core::terrain::Material;
using core::terrain::ToothAnatomy;
using Anatomy = std::shared_ptr<const ToothAnatomy>;

constexpr std::size_t kPlunges = 100;
constexpr std::size_t kSeeds = 30;
constexpr double kDepthMm = 1.5;
constexpr double kFeedMmPerS = ui::tooth::PointerControl::kFirstMmPerS;
constexpr double kForceN = ui::tooth::PointerControl::kFirstN;
constexpr glm::dvec2 kScreenPx{900.0, 700.0};  ///< size of the tooth view in a window of 1280 x 800
constexpr double kAboveDeg = 80.0;
constexpr double kHalfSlotMm = 1.2;
constexpr double kSlotPxPerS = 25.0;
constexpr int kSlotPasses = 4;
constexpr double kAheadPx = 25.0;  ///< the hand waits if the bur is farther behind
constexpr double kGivesUpS = 400.0;
constexpr double kLayerMm = 0.3;  ///< step by which the person lowers the depth stop
constexpr double kFirstLayerMm = 0.6;
constexpr double kLooksS = 0.5;      ///< time before the stop is lowered again
constexpr double kOutPercent = 5.0;  ///< a lesion with less decay left counts as removed

ui::tooth::Camera cameraOver(double elevationDeg)
{
    ui::tooth::Camera camera;
    camera.setViewport(kScreenPx);
    camera.setSubject({0.0, 0.0, -2.0}, 7.0);
    camera.set(0.0, elevationDeg, camera.fittingMm());
    return camera;
}

core::Result<Anatomy> soundTooth(int fdi, std::uint64_t seed)
{
    core::teeth::BuildOptions options;
    options.seed = seed;
    options.caries.reset();
    auto built = core::teeth::buildTooth({fdi}, options);
    if (!built)
        return tl::unexpected(built.error());
    return built->anatomy;
}

/// Returns a place near the middle that is not steep and has 0.6 to 1.2 mm of enamel.
glm::dvec3 plungePlace(const ToothAnatomy& anatomy)
{
    const core::terrain::Grid& grid = anatomy.grid;
    glm::dvec3 best(0.0);
    double least = std::numeric_limits<double>::max();
    for (int j = 1; j + 1 < grid.side; ++j)
        for (int i = 1; i + 1 < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            const double enamel = static_cast<double>(anatomy.top[k] - anatomy.layers[k].dej);
            const double rise = std::hypot(anatomy.top[grid.index(i + 1, j)] - anatomy.top[grid.index(i - 1, j)],
                                           anatomy.top[grid.index(i, j + 1)] - anatomy.top[grid.index(i, j - 1)]) /
                                (2.0 * grid.cellMm);
            const glm::dvec2 at = grid.nodeMm(i, j);
            const double cost = glm::length(at) + 3.0 * rise;
            if (!(anatomy.top[k] > anatomy.bottom[k]) || enamel < 0.6 || enamel > 1.2 || cost >= least)
                continue;
            least = cost;
            best = glm::dvec3(at, anatomy.top[k]);
        }
    return best;
}

struct Plunge
{
    double overMm = 0.0;
    double seconds = 0.0;  ///< time from the press to the release
};

/// Presses until the screen shows 1.5 mm, then releases the button.
core::Result<Plunge> plunge(const MouseHand& hand, std::uint64_t seed)
{
    const auto anatomy = soundTooth(36, seed);
    if (!anatomy)
        return tl::unexpected(anatomy.error());
    const glm::dvec3 place = plungePlace(**anatomy);
    const ui::tooth::Camera camera = cameraOver(kAboveDeg);
    Person person(seed);
    double pressedS = -1.0;
    double releasedS = -1.0;
    const auto decide = [&](const Sight& now) {
        const Sight* seen = person.see(now);
        Deed deed{person.aim(camera.pixelOf(place)), false, kDepthMm, false};
        // With the depth stop on, the figure ends just below 1.5 mm.
        const bool isDeep = seen && seen->depthMm.value_or(0.0) >= (hand.stopMm ? kDepthMm - 0.01 : kDepthMm);
        if (pressedS < 0.0 && now.seconds > 0.6)
            pressedS = now.seconds;
        if (pressedS >= 0.0 && releasedS < 0.0 && isDeep)
            releasedS = now.seconds;
        deed.pressed = pressedS >= 0.0 && releasedS < 0.0;
        deed.isDone = releasedS >= 0.0 && now.seconds > releasedS + 0.3;
        return deed;
    };
    const auto doing = work(*anatomy, {}, 1, hand, camera, 60.0, decide);
    if (!doing)
        return tl::unexpected(doing.error());
    return Plunge{doing->deepestMm - kDepthMm, (releasedS < 0.0 ? doing->seconds : releasedS) - pressedS};
}

/// Returns the direction along the fissure: the line through a place whose highest point is lowest.
glm::dvec2 fissureThrough(const ToothAnatomy& anatomy, const glm::dvec3& place)
{
    glm::dvec2 best(1.0, 0.0);
    float least = std::numeric_limits<float>::max();
    for (int degrees = 0; degrees < 180; degrees += 10) {
        const glm::dvec2 way(std::cos(glm::radians(1.0 * degrees)), std::sin(glm::radians(1.0 * degrees)));
        float highest = core::terrain::kEmptyTop;
        for (double along = -kHalfSlotMm - 0.5; along <= kHalfSlotMm + 0.5; along += anatomy.grid.cellMm) {
            const glm::ivec2 at(glm::floor(anatomy.grid.latticeOf(glm::dvec2(place) + way * along) + 0.5));
            if (anatomy.grid.contains(at.x, at.y))
                highest = std::max(highest, anatomy.top[anatomy.grid.index(at.x, at.y)]);
        }
        if (highest < least) {
            least = highest;
            best = way;
        }
    }
    return best;
}

struct Slot
{
    double rmsMm = 0.0;
    double offMm = 0.0;       ///< distance of its mean from the depth stop
    double mostForceN = 0.0;  ///< on the hand
};

/// Goes down to the depth stop, then moves to and fro along the fissure.
core::Result<Slot> slot(const MouseHand& hand, std::uint64_t seed)
{
    const auto anatomy = soundTooth(36, seed);
    if (!anatomy)
        return tl::unexpected(anatomy.error());
    const ui::tooth::Camera camera = cameraOver(kAboveDeg);
    const glm::dvec3 place = plungePlace(**anatomy);
    const glm::dvec2 way = fissureThrough(**anatomy, place);
    const glm::dvec3 from = place - glm::dvec3(way * kHalfSlotMm, 0.0);
    const glm::dvec3 to = place + glm::dvec3(way * kHalfSlotMm, 0.0);
    const double lengthPx = glm::distance(camera.pixelOf(from), camera.pixelOf(to));
    Person person(seed);
    bool isDeep = false;
    double wayPx = 0.0;
    double endedS = -1.0;
    double surfaceMm = 0.0;
    const auto decide = [&](const Sight& now) {
        const Sight* seen = person.see(now);
        const double share = wayPx / lengthPx;
        const double phase = std::fmod(share, 2.0);
        const glm::dvec2 meant = glm::mix(camera.pixelOf(from), camera.pixelOf(to), phase < 1.0 ? phase : 2.0 - phase);
        if (now.depthMm)
            surfaceMm = now.burMm.z + *now.depthMm;
        isDeep = isDeep || (seen && seen->depthMm.value_or(0.0) > kDepthMm - 0.05);
        if (isDeep && seen && glm::distance(seen->burPx, meant) < kAheadPx)
            wayPx += kSlotPxPerS * 0.016;
        if (share >= kSlotPasses && endedS < 0.0)
            endedS = now.seconds;
        return Deed{person.aim(meant), now.seconds > 0.6 && endedS < 0.0, kDepthMm,
                    endedS >= 0.0 && now.seconds > endedS + 0.3};
    };
    const auto doing = work(*anatomy, {}, 1, hand, camera, kGivesUpS, decide);
    if (!doing)
        return tl::unexpected(doing.error());
    // The floor is under the pointer: on the rays through the line, and not straight below it.
    glm::dvec3 middle = place;
    static_cast<void>(
        ui::render::ToothSurface::meetPlane(camera.rayThrough(camera.pixelOf(place)), surfaceMm - kDepthMm, middle));
    const core::terrain::Grid& grid = (*anatomy)->grid;
    double sum = 0.0;
    double squares = 0.0;
    int count = 0;
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i) {
            const glm::dvec2 at = grid.nodeMm(i, j) - glm::dvec2(middle);
            if (std::abs(glm::dot(at, way)) > kHalfSlotMm - 0.2 || std::abs(at.x * way.y - at.y * way.x) > 0.15)
                continue;
            const double high = static_cast<double>(doing->tooth.top[grid.index(i, j)]) - (surfaceMm - kDepthMm);
            sum += high;
            squares += high * high;
            ++count;
        }
    const double mean = sum / count;
    return Slot{std::sqrt(std::max(0.0, squares / count - mean * mean)), std::abs(mean), doing->mostForceN};
}

/// Returns the columns whose decay can be seen: on the floor, or on the wall beside a deeper column.
std::vector<std::size_t> brownColumns(const ToothAnatomy& anatomy, const std::vector<float>& tops)
{
    const core::terrain::Grid& grid = anatomy.grid;
    std::vector<std::size_t> brown;
    for (int j = 1; j + 1 < grid.side; ++j)
        for (int i = 1; i + 1 < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            const core::terrain::ColumnLayers& layers = anatomy.layers[k];
            if (!(tops[k] > anatomy.bottom[k]) || !(layers.cariesRoof > layers.cariesFloor) ||
                tops[k] <= layers.cariesFloor)
                continue;
            bool isSeen = tops[k] <= layers.cariesRoof;
            for (const std::size_t beside : {k - 1, k + 1, grid.index(i, j - 1), grid.index(i, j + 1)})
                isSeen = isSeen || tops[beside] < layers.cariesRoof - 0.05F;
            if (isSeen)
                brown.push_back(k);
        }
    return brown;
}

struct Removal
{
    bool isPulpOpen = false;
    double leftPercent = 100.0;
    double seconds = 0.0;
};

/// Moves the bur over the visible decay, and lowers the depth stop where decay remains. Without a stop, presses only
/// while the tissue under the bur is decay.
core::Result<Removal> removeLesion(int fdi, const MouseHand& hand, std::uint64_t seed)
{
    auto lesson = lessons::lessonNamed(QStringLiteral("decay-%1-moderate").arg(fdi));
    if (!lesson)
        return tl::unexpected(lesson.error());
    if (auto* made = std::get_if<lessons::MadeTooth>(&lesson->tooth))
        made->seed = seed;
    const auto assigned = lessons::assign(*lesson);
    if (!assigned)
        return tl::unexpected(assigned.error());
    const Anatomy& anatomy = assigned->assignment.anatomy;
    const core::terrain::Grid& grid = anatomy->grid;
    const std::size_t bur = lesson->burs.empty() ? 1 : core::bur::findBur(lesson->burs.front()).value_or(1);
    const ui::tooth::Camera camera = cameraOver(kAboveDeg);
    Person person(seed);
    double stopMm = kFirstLayerMm;
    std::optional<glm::dvec3> goal;
    double lookedS = 0.0;
    double loweredS = 0.0;
    double cleanS = 0.0;
    double surfaceMm = std::numeric_limits<double>::lowest();  ///< height from which the shown depth is measured
    std::shared_ptr<const std::vector<float>> lookedAt;
    std::vector<std::size_t> brown;
    const auto placeOf = [&](std::size_t k, const std::vector<float>& tops) {
        return glm::dvec3(grid.nodeMm(k), tops[k]);
    };
    glm::dvec2 meant = kScreenPx / 2.0;
    const auto decide = [&](const Sight& now) {
        const Sight* seen = person.see(now);
        Deed deed{meant, false, stopMm, false};
        if (seen == nullptr)
            return deed;
        if (seen->depthMm)
            surfaceMm = seen->burMm.z + *seen->depthMm;
        if (seen->tops != lookedAt || now.seconds > lookedS + kLooksS) {
            lookedS = now.seconds;
            lookedAt = seen->tops;
            brown = brownColumns(*anatomy, *lookedAt);
            const glm::dvec2 at(seen->burMm);
            goal.reset();
            double least = std::numeric_limits<double>::max();
            for (const std::size_t k : brown) {
                const glm::dvec3 place = placeOf(k, *lookedAt);
                // The ring shows the depth of this layer.
                const bool isReachable = !hand.stopMm || lookedAt->at(k) > surfaceMm - stopMm + 0.05;
                const double far = glm::distance(glm::dvec2(place), at);
                if (isReachable && far < least) {
                    least = far;
                    goal = place;
                }
            }
            if (!goal && !brown.empty() && now.seconds > loweredS + kLooksS &&
                stopMm < ui::tooth::PointerControl::kDeepestMm) {
                stopMm += kLayerMm;
                loweredS = now.seconds;
            }
        }
        cleanS = brown.empty() ? cleanS + 0.016 : 0.0;
        if (goal && glm::distance(meant, camera.pixelOf(*goal)) > 0.5) {
            // The hand moves by 4 pixels a picture at most.
            const glm::dvec2 way = camera.pixelOf(*goal) - meant;
            meant += way * std::min(1.0, 4.0 / glm::length(way));
        }
        const bool isOnGoal = goal && glm::distance(seen->burPx, meant) < kAheadPx;
        const bool isSoundUnder =
            !hand.stopMm && seen->under && *seen->under != Material::Caries && seen->depthMm.value_or(0.0) > 0.3;
        deed = {person.aim(meant), isOnGoal && !isSoundUnder && !brown.empty(), stopMm,
                cleanS > 1.0 || now.seconds > kGivesUpS - 1.0};
        return deed;
    };
    const auto doing = work(anatomy, lessons::servoSettings(&*lesson, {}), bur, hand, camera, kGivesUpS, decide);
    if (!doing)
        return tl::unexpected(doing.error());
    const core::terrain::PerMaterial whole = core::terrain::volumes(core::terrain::Tooth(anatomy));
    const core::terrain::PerMaterial gone = core::terrain::removedVolumes(doing->tooth);
    constexpr auto kCaries = static_cast<std::size_t>(Material::Caries);
    return Removal{gone[static_cast<std::size_t>(Material::Pulp)] > 0.0,
                   100.0 * (whole[kCaries] - gone[kCaries]) / whole[kCaries], doing->seconds};
}

/// Moves the pointer over the tooth at 200 px/s, with jumps between the strokes, button up.
core::Result<double> mostOffRayPx(double elevationDeg)
{
    const auto anatomy = soundTooth(36, 0);
    if (!anatomy)
        return tl::unexpected(anatomy.error());
    const auto decide = [](const Sight& now) {
        const double leap = std::floor(now.seconds / 2.0);
        const double along = std::fmod(now.seconds, 2.0) * 200.0;
        const double x = 250.0 + (std::fmod(leap, 2.0) < 1.0 ? along : 400.0 - along);
        return Deed{{x, 240.0 + 25.0 * std::fmod(leap * 7.0, 10.0)}, false, kDepthMm, now.seconds > 20.0};
    };
    const auto doing = work(*anatomy, {}, 1, {}, cameraOver(elevationDeg), 30.0, decide);
    if (!doing)
        return tl::unexpected(doing.error());
    return doing->mostOffRayPx;
}

/// Runs a trial with each of the seeds 1 to count, two at a time. Returns the first error if there is one.
template <class Trial>
auto forSeeds(std::size_t count, const Trial& trial)
    -> core::Result<std::vector<typename decltype(trial(std::uint64_t{}))::value_type>>
{
    std::vector<decltype(trial(std::uint64_t{}))> tried(count);
    inParallel(
        count, [&](std::size_t k) { tried[k] = trial(k + 1); }, [](std::size_t) {});
    std::vector<typename decltype(trial(std::uint64_t{}))::value_type> results;
    results.reserve(count);
    for (const auto& one : tried) {
        if (!one)
            return tl::unexpected(one.error());
        results.push_back(*one);
    }
    return results;
}

core::Result<std::vector<Plunge>> plunges(const MouseHand& hand, std::size_t count)
{
    return forSeeds(count, [&](std::uint64_t seed) { return plunge(hand, seed); });
}

/// Returns the value that a share of the results does not exceed.
template <class Result>
double percentile(const std::vector<Result>& results, double Result::*value, double share)
{
    std::vector<double> values;
    values.reserve(results.size());
    for (const Result& one : results)
        values.push_back(one.*value);
    std::sort(values.begin(), values.end());
    const auto at = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
    return values[std::clamp<std::size_t>(at, 1, values.size()) - 1];
}

/// Draws the overshoot of a plunge over the time it takes, for each setting of the hand.
core::Status showPace(const Context& context)
{
    struct Way
    {
        const char* name;
        const char* unit;
        std::vector<double> values;
        MouseHand (*handOf)(double value);
    };
    const std::vector<double> feeds{0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.5, 2.0};
    const Way ways[] = {
        {"Feed, depth stop off", "mm/s", feeds,
         [](double feed) {
             return MouseHand{feed, {}, kForceN};
         }},
        {"Feed, depth stop on", "mm/s", feeds,
         [](double feed) {
             return MouseHand{feed, kDepthMm, kForceN};
         }},
        {"Button pushes with a force",
         "N",
         {0.3, 0.6, 1.0, 1.5},
         [](double newtons) {
             return MouseHand{0.0, {}, newtons};
         }},
    };
    ui::charts::Curve curve;
    curve.x = {QStringLiteral("Time to 1.5 mm, s (median)"), 1.0, 30.0};
    curve.x.base = 10.0;
    curve.y = {QStringLiteral("Beyond 1.5 mm, mm (95 of 100 stay below)"), 0.0, 1.5};
    for (const Way& way : ways) {
        ui::charts::Line line = lineOf(QLatin1String(way.name), static_cast<LookIndex>(curve.lines.size()));
        for (const double value : way.values) {
            const auto made = plunges(way.handOf(value), kSeeds);
            if (!made)
                return tl::unexpected(made.error());
            line.dots << pointAt(percentile(*made, &Plunge::seconds, 0.5),
                                 std::max(0.0, percentile(*made, &Plunge::overMm, 0.95)),
                                 QStringLiteral("%1 %2").arg(value).arg(QLatin1String(way.unit)));
        }
        curve.lines << line;
    }
    ui::charts::Chart chart;
    chart.title = QStringLiteral("A person at a mouse drills 1.5 mm deep");
    chart.content = curve;
    context.show({QStringLiteral("pointer-plunge"), chart});
    return {};
}

void add(Figures& figures, const QString& key, const QString& what, double value, const char* unit,
         const char* reach = "")
{
    figures << Figure{QStringLiteral("pointer_") + key, what, value, QLatin1String(unit), QLatin1String(reach)};
}

core::Status addPlunges(Figures& figures)
{
    const auto without = plunges({kFeedMmPerS, {}, kForceN}, kPlunges);
    const auto with = plunges({kFeedMmPerS, kDepthMm, kForceN}, kPlunges);
    const auto rival = plunges({0.0, {}, kForceN}, kPlunges);
    for (const auto* made : {&without, &with, &rival})
        if (!*made)
            return tl::unexpected(made->error());
    add(figures, QStringLiteral("plunge_over_p95_mm"), QStringLiteral("beyond 1.5 mm, depth stop off, 95 of 100"),
        percentile(*without, &Plunge::overMm, 0.95), "mm", "0.25");
    add(figures, QStringLiteral("plunge_median_s"), QStringLiteral("time it takes, half of them"),
        percentile(*without, &Plunge::seconds, 0.5), "s");
    add(figures, QStringLiteral("stop_over_most_mm"), QStringLiteral("beyond 1.5 mm, depth stop on, all"),
        percentile(*with, &Plunge::overMm, 1.0), "mm", "0.05");
    add(figures, QStringLiteral("force_over_p95_mm"), QStringLiteral("beyond 1.5 mm, no feed, 0.6 N, 95 of 100"),
        percentile(*rival, &Plunge::overMm, 0.95), "mm");
    return {};
}

core::Status addSlots(Figures& figures)
{
    const auto cuts = forSeeds(kSeeds, [](std::uint64_t seed) { return slot({}, seed); });
    if (!cuts)
        return tl::unexpected(cuts.error());
    add(figures, QStringLiteral("slot_floor_rms_mm"), QStringLiteral("floor of a slot, from its mean, the worst"),
        percentile(*cuts, &Slot::rmsMm, 1.0), "mm", "0.1");
    add(figures, QStringLiteral("slot_depth_off_mm"), QStringLiteral("its mean depth from 1.5 mm, the worst"),
        percentile(*cuts, &Slot::offMm, 1.0), "mm");
    add(figures, QStringLiteral("slot_force_most_n"),
        QStringLiteral("force while a slot is cut with 0.6 N, the largest"), percentile(*cuts, &Slot::mostForceN, 1.0),
        "N");
    return {};
}

core::Status addLesions(Figures& figures, int fdi)
{
    const auto removals = forSeeds(kSeeds, [&](std::uint64_t seed) { return removeLesion(fdi, {}, seed); });
    if (!removals)
        return tl::unexpected(removals.error());
    const auto opened =
        std::count_if(removals->begin(), removals->end(), [](const Removal& one) { return one.isPulpOpen; });
    const auto out = std::count_if(removals->begin(), removals->end(), [](const Removal& one) {
        return !one.isPulpOpen && one.leftPercent <= kOutPercent;
    });
    add(figures, QStringLiteral("pulp_opened_%1").arg(fdi),
        QStringLiteral("moderate lesion of %1: pulp opened, of 30").arg(fdi), static_cast<double>(opened), "", "1");
    add(figures, QStringLiteral("lesion_out_%1").arg(fdi),
        QStringLiteral("the lesion is out and the pulp closed, of 30"), static_cast<double>(out), "", "29");
    add(figures, QStringLiteral("lesion_median_s_%1").arg(fdi), QStringLiteral("time it takes, half of them"),
        percentile(*removals, &Removal::seconds, 0.5), "s", "60 to 180");
    return {};
}

core::Status addAim(Figures& figures)
{
    double most = 0.0;
    for (const double elevation : {ui::tooth::Camera::kStartElevationDeg, kAboveDeg}) {
        const auto offPx = mostOffRayPx(elevation);
        if (!offPx)
            return tl::unexpected(offPx.error());
        most = std::max(most, *offPx);
    }
    add(figures, QStringLiteral("ray_most_px"), QStringLiteral("bur from pointer, strokes of 200 px/s"), most, "px",
        "1");
    return {};
}

}  // namespace

core::Result<Figures> pointerSuite(const Context& context)
{
    struct Step
    {
        QString what;
        std::function<core::Status(Figures& figures)> run;
    };
    QList<Step> steps{{QStringLiteral("plunges"), addPlunges}, {QStringLiteral("slots"), addSlots}};
    for (const int fdi : {36, 26, 24, 21})
        steps << Step{QStringLiteral("lesions of %1").arg(fdi),
                      [fdi](Figures& figures) { return addLesions(figures, fdi); }};
    steps << Step{QStringLiteral("aim"), addAim};
    if (context.show)
        steps << Step{QStringLiteral("chart"), [&](Figures&) { return showPace(context); }};
    Figures figures;
    for (qsizetype n = 0; n < steps.size(); ++n) {
        context.progress(steps[n].what, static_cast<int>(n), static_cast<int>(steps.size()));
        if (const auto done = steps[n].run(figures); !done)
            return tl::unexpected(done.error());
    }
    return figures;
}

}  // namespace bench
