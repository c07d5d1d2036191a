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

/// Calls parse(), and explains a wrong value of --wait. Returns as parse() does.
[[nodiscard]] std::optional<int> parseFalcon(QCommandLineParser& parser, const QStringList& arguments,
                                             const QString& usage);

/// A Falcon for the commands, opened with the options of the command line. This thread drives it instead of the servo.
/// Prints to stderr what it waits for.
class FalconSession
{
public:
    /// Opens the device. Returns an error if the calibration file is not usable.
    [[nodiscard]] static core::Result<std::unique_ptr<FalconSession>> open(const QCommandLineParser& parser);

    /// Waits until the device has reached a stage, or a later one. Returns the error that the device reports when the
    /// time of --wait is over, or at once if the device is not usable.
    [[nodiscard]] core::Status waitFor(core::session::DeviceStage stage);

    /// Returns an error if the device has fallen back to an earlier stage.
    [[nodiscard]] core::Status stillAt(core::session::DeviceStage stage) const;

    /// Acts as the servo for a time. Ends early if `beat` returns empty, the device is lost or the user presses Ctrl+C.
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
