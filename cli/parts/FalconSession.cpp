// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/parts/FalconSession.h"

#include <thread>
#include <utility>

#include "app/devices/FalconCalibration.h"
#include "app/devices/StopForces.h"
#include "cli/parts/Arguments.h"
#include "cli/parts/StopSignal.h"

namespace cli {
namespace {

using namespace std::chrono_literals;
using core::session::DeviceStage;
using Clock = std::chrono::steady_clock;

constexpr qint64 kLongestWaitS = 3600;
constexpr auto kPeriod = 1ms;
constexpr auto kLook = 20ms;

/// Returns what the user has to do at this stage; empty if they have to do nothing.
QString toDo(const core::session::DeviceReport& report)
{
    switch (report.stage) {
    case DeviceStage::LoadingFirmware:
        return QStringLiteral("Loading the firmware …");
    case DeviceStage::Homing:
        return QStringLiteral("Pull the grip out of the device as far as it goes, then push it straight in.");
    case DeviceStage::Silent:
        return QStringLiteral("The Falcon does not answer.");
    case DeviceStage::Absent:
    case DeviceStage::Unavailable:
    case DeviceStage::NeedsFirmware:
    case DeviceStage::Ready:
        break;
    }
    return QString::fromStdString(report.error.detail);  // the device is missing, and the command waits for it
}

std::string notReached(const core::session::DeviceReport& report, qint64 seconds)
{
    const QString what = report.stage == DeviceStage::Absent   ? QString::fromStdString(report.error.detail)
                         : report.stage == DeviceStage::Homing ? QStringLiteral("The Falcon was not homed.")
                                                               : QStringLiteral("The Falcon is not ready.");
    return QStringLiteral("%1 Waited %2 s; --wait waits longer.")
        .arg(what.isEmpty() ? QStringLiteral("The Falcon does not answer.") : what)
        .arg(seconds)
        .toStdString();
}

}  // namespace

void addFalconOptions(QCommandLineParser& parser)
{
    const auto option = [&](const char* name, const char* help, const char* value, const char* usual = "") {
        parser.addOption({QLatin1String(name), QLatin1String(help), QLatin1String(value), QLatin1String(usual)});
    };
    option("serial", "The Falcon with this serial number; the first that can be opened if not given.", "NUMBER");
    option("firmware", "The file with the Falcon's firmware, for one that was just switched on.", "FILE");
    option("calibration", "A file that \"cusp falcon calibrate\" wrote; that of this computer if not given.", "FILE");
    option("wait", "How long to wait for the Falcon or for the hand, in seconds; 60 if not given.", "S", "60");
}

std::optional<int> parseFalcon(QCommandLineParser& parser, const QStringList& arguments, const QString& usage)
{
    if (const auto code = parse(parser, arguments, usage))
        return code;
    if (const auto patience = wholeNumber(parser, QStringLiteral("wait"), 0, kLongestWaitS); !patience)
        return wrongUsage(QString::fromStdString(patience.error().detail));
    return std::nullopt;
}

core::Result<std::unique_ptr<FalconSession>> FalconSession::open(const QCommandLineParser& parser)
{
    haptics::falcon::FalconDevice::Options options;
    options.serial = parser.value(QStringLiteral("serial")).toStdString();
    const QString file = parser.value(QStringLiteral("calibration"));
    core::Status why;
    const auto calibration = file.isEmpty() ? app::stationsFalconCalibration(&why) : app::readFalconCalibration(file);
    if (!calibration)
        return tl::unexpected(calibration.error());
    if (!why)  // `calibrate` measures it again
        warn({why.error().detail + ". The usual values are used."});
    options.calibration = *calibration;
    std::unique_ptr<FalconSession> session(
        new FalconSession(std::move(options), std::chrono::seconds(parser.value(QStringLiteral("wait")).toLongLong())));
    app::stopForcesOnSignals();
    session->m_device.setFirmware(parser.value(QStringLiteral("firmware")).toStdString());
    session->m_device.start();
    return session;
}

FalconSession::FalconSession(haptics::falcon::FalconDevice::Options options, std::chrono::seconds patience)
    : m_calibration(options.calibration), m_device(std::move(options)), m_patience(patience)
{}

core::Status FalconSession::waitFor(DeviceStage stage)
{
    const auto until = Clock::now() + m_patience;
    QString said;
    for (;;) {
        const auto report = m_device.report();
        if (report.stage >= stage && report.stage != DeviceStage::Silent)
            return {};
        const QString words = toDo(report);
        if (report.stage == DeviceStage::NeedsFirmware)
            return core::unexpected(core::ErrorCode::FileMissing, words.toStdString() + " (--firmware FILE)");
        if (report.stage == DeviceStage::Unavailable)
            return tl::unexpected(report.error);
        if (Clock::now() >= until || StopSignal::hasCome())
            return core::unexpected(core::ErrorCode::ConnectionLost, notReached(report, m_patience.count()));
        if (!words.isEmpty() && words != std::exchange(said, words))
            warn({words.toStdString()});
        std::this_thread::sleep_for(kLook);
    }
}

core::Status FalconSession::stillAt(DeviceStage stage) const
{
    const auto report = m_device.report();
    if (report.stage >= stage && report.stage != DeviceStage::Silent)
        return {};
    return core::unexpected(core::ErrorCode::ConnectionLost,
                            "The Falcon was lost meanwhile. Check its USB cable and its mains adapter.");
}

void FalconSession::play(std::chrono::milliseconds time,
                         const std::function<std::optional<glm::dvec3>(const haptics::DeviceSample&, double)>& beat)
{
    auto last = Clock::now();
    for (const auto until = last + time; Clock::now() < until && !StopSignal::hasCome();) {
        const haptics::DeviceSample sample = m_device.exchange(glm::dvec3(0.0));
        const auto now = Clock::now();
        const double seconds = std::chrono::duration<double>(now - std::exchange(last, now)).count();
        const auto forceN = beat(sample, seconds);
        if (!forceN)
            break;
        m_device.give(*forceN);
        static_cast<void>(m_device.waitForReading(now + kPeriod));
    }
    m_device.give(glm::dvec3(0.0));
}

QString stageName(DeviceStage stage)
{
    switch (stage) {
    case DeviceStage::Absent:
        return QStringLiteral("absent");
    case DeviceStage::Unavailable:
        return QStringLiteral("unavailable");
    case DeviceStage::NeedsFirmware:
        return QStringLiteral("needs firmware");
    case DeviceStage::LoadingFirmware:
        return QStringLiteral("loading firmware");
    case DeviceStage::Homing:
        return QStringLiteral("not homed");
    case DeviceStage::Ready:
        return QStringLiteral("ready");
    case DeviceStage::Silent:
        return QStringLiteral("silent");
    }
    return {};
}

QJsonObject toJson(const core::session::ExchangeFigures& figures)
{
    return {{QStringLiteral("requests"), static_cast<qint64>(figures.requests)},
            {QStringLiteral("answers"), static_cast<qint64>(figures.answers)},
            {QStringLiteral("lost"), static_cast<qint64>(figures.lost)},
            {QStringLiteral("rejected"), static_cast<qint64>(figures.rejected)},
            {QStringLiteral("rate_hz"), figures.rateHz},
            {QStringLiteral("round_trip_us"),
             QJsonObject{{QStringLiteral("p50"), figures.roundTripUs}, {QStringLiteral("p99"), figures.slowTripUs}}}};
}

QString toText(const core::session::ExchangeFigures& figures)
{
    return QStringLiteral(
               "%1 exchanges a second, round trip %2 us (p50), %3 us (p99); %4 requests, %5 lost, %6 answers "
               "rejected")
        .arg(figures.rateHz, 0, 'f', 0)
        .arg(figures.roundTripUs, 0, 'f', 0)
        .arg(figures.slowTripUs, 0, 'f', 0)
        .arg(figures.requests)
        .arg(figures.lost)
        .arg(figures.rejected);
}

}  // namespace cli
