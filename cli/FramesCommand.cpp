// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include <QApplication>
#include <QJsonObject>
#include <QOpenGLFunctions>
#include <QOpenGLWidget>

#include "app/threads/Display.h"
#include "app/threads/LoopThread.h"
#include "cli/Commands.h"
#include "cli/parts/Arguments.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "core/session/SessionLoop.h"
#include "core/teeth/ToothBuilder.h"
#include "haptics/ServoLoop.h"
#include "haptics/pointer/PointerDevice.h"
#include "ui/render/Driver.h"
#include "ui/tooth/ToothView.h"

namespace cli {
namespace {

using namespace std::chrono_literals;

constexpr int kTooth = 36;
constexpr int kRounds = 7;
constexpr int kFramesARound = 12;
constexpr int kTicksAFrame = 16;
constexpr int kFramesToSettle = 40;  ///< frames until the hand touches the tooth
constexpr double kPaceMmPerS = 1.5;  ///< speed of a working hand
constexpr double kCircleMm = 1.2;
constexpr double kPushN = 1.0;
constexpr auto kLatencyFor = 4s;
constexpr auto kRest = 200ms;  ///< pause after the camera has moved, until the picture is fine again

double processCpuS()
{
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1.0e-9 * static_cast<double>(time.tv_nsec);
}

std::int64_t nowNs()
{
    return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double quantile(std::vector<double> values, double share)
{
    if (values.empty())
        return 0.0;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
}

/// An empty OpenGL widget, to measure the cost of any such widget.
class EmptyView final : public QOpenGLWidget
{
protected:
    void paintGL() override
    {
        QOpenGLFunctions* gl = context()->functions();
        gl->glClearColor(0.1F, 0.1F, 0.1F, 1.0F);
        gl->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
};

/// Servo and session as in the program, with a hand that circles over the tooth, working or hovering.
struct Work
{
    core::servo::ServoSettings settings;
    core::session::UiChannels links;
    core::servo::ServoChannels servoLinks;
    core::rt::TripleBuffer<core::servo::PointerInput> wish;
    haptics::PointerDevice device{wish, settings.force.stiffnessNPerMm, 1.0e-3};
    core::session::SessionLoop session{servoLinks, links, settings};
    haptics::ServoLoop servo;
    double angle = 0.0;

    explicit Work(std::unique_ptr<core::servo::ServoTick> tick)
        : servo(device, std::move(tick), servoLinks, links.servo, 1ms)
    {}

    void open(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy)
    {
        using namespace core::session;
        using namespace core::servo;
        static_cast<void>(links.commands.tryPush(SetBur{1}));
        static_cast<void>(links.commands.tryPush(SetDrill{true}));
        static_cast<void>(links.commands.tryPush(ReplaceTooth{std::make_unique<core::terrain::Tooth>(anatomy), 1}));
        session.tick(10ms);
    }
    void moveHand(double seconds, bool pushes)
    {
        angle += kPaceMmPerS * seconds / kCircleMm;
        wish.publish({{kCircleMm * std::cos(angle), kCircleMm * std::sin(angle)}, 1.0, pushes, kPushN});
    }
    /// Simulates the time of one frame, in this thread.
    void pass(bool pushes)
    {
        moveHand(1.0e-3 * kTicksAFrame, pushes);
        for (int k = 0; k < kTicksAFrame; ++k)
            servo.tick(1ms);
        session.tick(10ms);
    }
};

/// One view of the tooth.
struct Scene
{
    const char* key;
    const char* name;
    bool pushes;
    bool turns;  ///< the camera circles the tooth
    ui::tooth::ViewSettings settings;
    const char* reach;
};

std::vector<Scene> scenes()
{
    ui::tooth::ViewSettings all;
    all.look.burLight = true;
    all.look.isWet = true;
    all.showsHand = true;
    all.showsMirror = true;
    all.showsNeighbours = true;
    ui::tooth::ViewSettings two = all;
    two.presentation.stereo = ui::render::Stereo::RedCyan;
    return {{"plain", "plain, the bur moves", false, false, {}, "1.5"},
            {"drilling", "plain, the bur cuts", true, false, {}, ""},
            {"turning", "plain, the eye turns", false, true, {}, ""},
            {"effects", "light, wet, hand, mirror, neighbours", false, false, all, "4"},
            {"effects_drilling", "the same, the bur cuts", true, false, all, ""},
            {"stereo", "all that for two eyes", false, false, two, "4"}};
}

struct Cost
{
    double cpuMs = 0.0;
    double wallMs = 0.0;
};

void paintNow(EmptyView& view)
{
    view.repaint();
    QApplication::processEvents();
}

void paintNow(ui::tooth::ToothView& view)
{
    view.redrawNow();
    QApplication::processEvents();
}

/// Paints frames and returns the cost of one, including all work of Qt to show it on the screen.
/// @param shown  signal of a view that has brought a frame to the screen
template <class View, class Signal>
Cost costOf(View& view, Signal shown, const std::function<void()>& before)
{
    int painted = 0;
    const auto counting = QObject::connect(&view, shown, [&painted] { ++painted; });
    const double cpu = processCpuS();
    const std::int64_t wall = nowNs();
    for (int frame = 0; frame < kFramesARound; ++frame) {
        before();
        paintNow(view);
    }
    const Cost cost{1.0e3 * (processCpuS() - cpu) / std::max(1, painted),
                    1.0e-6 * static_cast<double>(nowNs() - wall) / std::max(1, painted)};
    QObject::disconnect(counting);
    return cost;
}

template <class View>
void show(View& view)
{
    view.show();
    for (int k = 0; k < 4; ++k)
        paintNow(view);
}

/// Measures the times from a reading of the device to the frame that shows it, ms, while servo and session run as in
/// the program.
std::vector<double> latencies(Work& work, ui::tooth::ToothView& view)
{
    std::vector<double> found;
    std::int64_t shown = 0;
    const auto counting = QObject::connect(&view, &ui::tooth::ToothView::shown, [&] {
        if (view.drawnMomentNs() == shown)
            return;
        shown = view.drawnMomentNs();
        found.push_back(1.0e-6 * static_cast<double>(nowNs() - shown));
    });
    app::LoopThread servo(work.servo, 1ms, app::LoopThread::Urgency::RealTime);
    app::LoopThread session(work.session, 10ms, app::LoopThread::Urgency::Normal);
    servo.start();
    session.start();
    std::int64_t before = nowNs();
    for (const std::int64_t end = before + std::chrono::nanoseconds(kLatencyFor).count(); before < end;) {
        QApplication::processEvents(QEventLoop::WaitForMoreEvents);
        const std::int64_t now = nowNs();
        work.moveHand(1.0e-9 * static_cast<double>(now - before), true);
        before = now;
    }
    QObject::disconnect(counting);
    return found;
}

core::Result<QJsonObject> measure(QSize size)
{
    auto tick = core::servo::makeServoTick({});
    if (!tick)
        return tl::unexpected(tick.error());
    const auto tooth = core::teeth::buildTooth({kTooth}, {});
    if (!tooth)
        return tl::unexpected(tooth.error());
    const auto work = std::make_unique<Work>(std::move(*tick));
    EmptyView empty;
    ui::tooth::ToothView view(work->links);
    if (!view.isUsable())
        return core::unexpected(core::ErrorCode::FileUnreadable, "this display offers no OpenGL 3.3");
    empty.resize(size);
    view.resize(size);
    view.setTooth(tooth->anatomy, 1);
    view.setDrillOn(true);
    work->open(tooth->anatomy);

    QJsonObject figures;
    figures[QStringLiteral("driver")] = ui::render::driver().name;
    std::vector<double> clears;
    const std::vector<Scene> all = scenes();
    std::vector<std::vector<double>> ratios(all.size());
    std::vector<std::vector<double>> walls(all.size());
    ui::tooth::ToothView::Uploads drilled;
    for (int round = 0; round < kRounds; ++round) {
        show(empty);
        const double clear = costOf(empty, &QOpenGLWidget::frameSwapped, [] {}).cpuMs;
        empty.hide();
        clears.push_back(clear);
        for (std::size_t k = 0; k < all.size(); ++k) {
            const Scene& scene = all[k];
            view.setSettings(scene.settings);
            std::this_thread::sleep_for(kRest);
            for (int pass = 0; pass < kFramesToSettle; ++pass)
                work->pass(scene.pushes);
            show(view);
            const auto before = view.uploads();
            double azimuth = 20.0;
            const Cost cost = costOf(view, &ui::tooth::ToothView::shown, [&] {
                work->pass(scene.pushes);
                if (scene.turns)
                    view.setCamera(azimuth += 2.0, 45.0, view.camera().distanceMm());
            });
            const auto after = view.uploads();
            if (scene.pushes) {
                drilled.bytes += after.bytes - before.bytes;
                drilled.changedBytes += after.changedBytes - before.changedBytes;
                drilled.wholes += after.wholes - before.wholes;
            }
            view.resetCamera();
            view.hide();
            ratios[k].push_back(cost.cpuMs / clear);
            walls[k].push_back(cost.wallMs);
        }
    }
    figures[QStringLiteral("clear_ms")] = quantile(clears, 0.5);
    for (std::size_t k = 0; k < all.size(); ++k) {
        const QLatin1String key(all[k].key);
        figures[key + QStringLiteral("_ratio")] = quantile(ratios[k], 0.5);
        figures[key + QStringLiteral("_per_s")] = 1000.0 / quantile(walls[k], 0.5);
    }
    figures[QStringLiteral("upload_ratio")] =
        static_cast<double>(drilled.bytes) / static_cast<double>(std::max<std::uint64_t>(1, drilled.changedBytes));
    figures[QStringLiteral("upload_wholes")] = drilled.wholes;

    view.setSettings({});
    show(view);
    const std::vector<double> found = latencies(*work, view);
    figures[QStringLiteral("latency_p50_ms")] = quantile(found, 0.5);
    figures[QStringLiteral("latency_p99_ms")] = quantile(found, 0.99);
    figures[QStringLiteral("latency_frames")] = static_cast<double>(found.size());
    return figures;
}

void print(const QJsonObject& figures)
{
    const auto line = [&](const QString& what, const QString& key, const char* unit, const char* reach) {
        printText(QStringLiteral("%1 %2 %3  %4\n")
                      .arg(what, -52)
                      .arg(figures[key].toDouble(), 8, 'f', 2)
                      .arg(QLatin1String(unit), -9)
                      .arg(QLatin1String(reach)));
    };
    printText(QStringLiteral("driver: %1\n").arg(figures[QStringLiteral("driver")].toString()));
    line(QStringLiteral("an empty OpenGL widget"), QStringLiteral("clear_ms"), "ms CPU", "");
    for (const Scene& scene : scenes()) {
        const QLatin1String key(scene.key);
        const QLatin1String name(scene.name);
        line(name, key + QStringLiteral("_ratio"), "times", scene.reach);
        line(name, key + QStringLiteral("_per_s"), "frames/s", "");
    }
    line(QStringLiteral("uploaded over the rectangles that were cut"), QStringLiteral("upload_ratio"), "times", "2");
    line(QStringLiteral("whole uploads while cutting"), QStringLiteral("upload_wholes"), "", "0");
    line(QStringLiteral("from reading the device to the frame, median"), QStringLiteral("latency_p50_ms"), "ms", "");
    line(QStringLiteral("the same, 99th percentile"), QStringLiteral("latency_p99_ms"), "ms", "30");
}

}  // namespace

int framesCommand(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Measures the tooth view on this display, or on one of its own from xvfb-run: the CPU time of a frame over "
        "that "
        "of an empty OpenGL widget, frames a second, what goes to the graphics driver while a bur cuts, and how old "
        "what is seen is."));
    parser.addOption({QStringLiteral("size"), QStringLiteral("Of the view in pixels; 1280x800 if not given."),
                      QStringLiteral("WxH"), QStringLiteral("1280x800")});
    addJson(parser);
    const QString usage = QStringLiteral("cusp frames [--size WxH] [--json]");
    if (const auto code = parse(parser, arguments, usage))
        return *code;
    if (!parser.positionalArguments().isEmpty())
        return wrongUsage(
            QStringLiteral("\"%1\" belongs to no option; usage: ").arg(parser.positionalArguments().front()) + usage);
    const auto size = pictureSize(parser.value(QStringLiteral("size")));
    if (!size)
        return wrongUsage(QStringLiteral("--size wants width x height in pixels, such as 1280x800, each 16 to 8192"));
    if (!app::hasDisplay()) {
        const int exitCode = app::runOnDisplay(QStringList{QStringLiteral("frames")} + arguments, false);
        return exitCode >= 0 ? exitCode
                             : failed({core::ErrorCode::FileUnreadable,
                                       "Frames need a display with OpenGL 3.3, or xvfb-run (Debian package xvfb)"});
    }
    const auto figures = measure(*size);
    if (!figures)
        return failed(figures.error());
    if (parser.isSet(QStringLiteral("json")))
        printJson(*figures);
    else
        print(*figures);
    return kDone;
}

}  // namespace cli
