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

/// As parse(), and explains a wrong value of --wait.
[[nodiscard]] std::optional<int> parseFalcon(QCommandLineParser& parser, const QStringList& arguments,
                                             const QString& usage);

/// A Falcon as the commands use it: opened with the options of the command line, and played by this thread in place of
/// the servo. Says on stderr what it waits for.
class FalconSession
{
public:
    /// Errors: those of the calibration file.
    [[nodiscard]] static core::Result<std::unique_ptr<FalconSession>> open(const QCommandLineParser& parser);

    /// Waits until the device has come to a stage, or a later one. Errors: what the device reports when the time of
    /// --wait is over, or at once if it cannot be used as it is.
    [[nodiscard]] core::Status waitFor(core::session::DeviceStage stage);

    /// Returns an error if the device is not at a stage, or a later one, any more.
    [[nodiscard]] core::Status stillAt(core::session::DeviceStage stage) const;

    /// Plays the servo for a time. Stops early if the function returns false, the device is lost or the user presses
    /// Ctrl+C.
    /// @param beat  gets the position, tooth frame, and the seconds since the last call; returns the force
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
