// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "app/devices/StationDevices.h"
#include "haptics/ForceDevice.h"

namespace support {

/// The state of a force device: its report and the position of the hand. A test sets it, and the device in the program
/// reads it.
class DeviceScript
{
public:
    void report(const core::session::DeviceReport& report)
    {
        const std::lock_guard lock(m_mutex);
        m_report = report;
    }
    void stage(core::session::DeviceStage stage)
    {
        const std::lock_guard lock(m_mutex);
        m_report.stage = stage;
    }
    void press(std::size_t button)
    {
        const std::lock_guard lock(m_mutex);
        ++m_report.presses.at(button);
    }
    [[nodiscard]] core::session::DeviceReport now() const
    {
        const std::lock_guard lock(m_mutex);
        return m_report;
    }
    void moveTo(const glm::vec3& tipMm)
    {
        const std::lock_guard lock(m_mutex);
        m_tipMm = tipMm;
    }
    [[nodiscard]] glm::vec3 tip() const
    {
        const std::lock_guard lock(m_mutex);
        return m_tipMm;
    }
    void remember(const core::session::DeviceSetup& setup)
    {
        const std::lock_guard lock(m_mutex);
        m_setup = setup;
    }
    [[nodiscard]] core::session::DeviceSetup setup() const
    {
        const std::lock_guard lock(m_mutex);
        return m_setup;
    }
    void remember(const glm::dvec3& testForceN)
    {
        const std::lock_guard lock(m_mutex);
        m_testForceN = testForceN;
    }
    [[nodiscard]] glm::dvec3 testForce() const
    {
        const std::lock_guard lock(m_mutex);
        return m_testForceN;
    }
    void remember(const std::string& firmware)
    {
        const std::lock_guard lock(m_mutex);
        m_firmware = firmware;
    }
    [[nodiscard]] std::string firmware() const
    {
        const std::lock_guard lock(m_mutex);
        return m_firmware;
    }

    std::atomic<bool> isPedalDown{false};
    std::atomic<bool> isRunning{false};

private:
    mutable std::mutex m_mutex;
    core::session::DeviceReport m_report;
    core::session::DeviceSetup m_setup;
    glm::vec3 m_tipMm{0.0F, 0.0F, 8.0F};
    glm::dvec3 m_testForceN{0.0};
    std::string m_firmware;
};

/// A force device that follows its script.
class ScriptedDevice final : public haptics::ForceDevice
{
public:
    explicit ScriptedDevice(std::shared_ptr<DeviceScript> script) : m_script(std::move(script)) {}
    ~ScriptedDevice() override { m_script->isRunning = false; }

    void start() override { m_script->isRunning = true; }
    void stop() override { m_script->isRunning = false; }
    [[nodiscard]] core::session::DeviceReport report() const override { return m_script->now(); }
    [[nodiscard]] bool isReady() const noexcept override
    {
        return m_script->now().stage == core::session::DeviceStage::Ready;
    }
    void setUp(const core::session::DeviceSetup& setup) override { m_script->remember(setup); }
    void setFirmware(const std::string& path) override { m_script->remember(path); }
    void setTestForce(const glm::dvec3& forceN) override { m_script->remember(forceN); }
    haptics::DeviceSample exchange(const glm::dvec3&) noexcept override
    {
        haptics::DeviceSample sample;
        sample.tipInToothMm = m_script->tip();
        sample.present = isReady();
        sample.pedal = m_script->isPedalDown.load();
        return sample;
    }

private:
    std::shared_ptr<DeviceScript> m_script;
};

/// Returns the entry of a scripted device for the program's list of devices.
inline app::DeviceRow scriptedRow(const std::shared_ptr<DeviceScript>& script)
{
    app::DeviceRow row;
    row.kind.id = QStringLiteral("arm");
    row.kind.name = QStringLiteral("Test Arm");
    row.make = [script] { return std::make_unique<ScriptedDevice>(script); };
    row.checkFirmware = [](const QString& path) {
        ui::devices::FirmwareFile file;
        file.path = path;
        file.sha256 = QString(64, u'a');
        return file;
    };
    return row;
}

}  // namespace support
