// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include <QCommandLineParser>
#include <QJsonObject>

#include "core/base/Result.h"
#include "haptics/falcon/FalconDevice.h"

namespace cli {

/// Adds --serial, --firmware, --calibration and --wait.
void addFalconOptions(QCommandLineParser& parser);

/// Calls parse(), and explains a wrong value of --wait.
[[nodiscard]] std::optional<int> parseFalcon(QCommandLineParser& parser, const QStringList& arguments,
                                             const QString& usage);

/// A Falcon for the commands: opened with the options of the command line, and driven by this thread instead of the
/// servo. Shows on stderr what it waits for.
class FalconSession
{
public:
    /// Opens the device. Errors: those of the calibration file.
    [[nodiscard]] static core::Result<std::unique_ptr<FalconSession>> open(const QCommandLineParser& parser);

    /// Waits until the device has reached a stage, or a later one. Errors: what the device reports when the time of
    /// --wait is over, or at once if it is not usable.
    [[nodiscard]] core::Status waitFor(core::session::DeviceStage stage);

    /// Returns an error if the device is no longer at a stage or a later one.
    [[nodiscard]] core::Status stillAt(core::session::DeviceStage stage) const;

    /// Acts as the servo for a time. Stops early if the function returns empty, the device is lost or the user presses
    /// Ctrl+C.
    /// @param beat  receives the position, tooth frame, and the seconds since the last call; returns the force, N
    void play(std::chrono::milliseconds time,
              const std::function<std::optional<glm::dvec3>(const haptics::DeviceSample&, double)>& beat);

    [[nodiscard]] core::session::DeviceReport report() const { return m_device.report(); }
    [[nodiscard]] const haptics::falcon::Calibration& calibration() const { return m_calibration; }

private:
    FalconSession(haptics::falcon::FalconDevice::Options options, std::chrono::seconds patience);

    haptics::falcon::Calibration m_calibration;
    haptics::falcon::FalconDevice m_device;
    std::chrono::seconds m_patience;
};

[[nodiscard]] QString stageName(core::session::DeviceStage stage);
[[nodiscard]] QJsonObject toJson(const core::session::ExchangeFigures& figures);
[[nodiscard]] QString toText(const core::session::ExchangeFigures& figures);

}  // namespace cli
