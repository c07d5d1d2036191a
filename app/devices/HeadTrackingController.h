// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include <QObject>
#include <QTimer>

#include "app/threads/LoopThread.h"
#include "core/tracking/CameraModel.h"
#include "core/tracking/HeadView.h"
#include "core/tracking/TrackerLoop.h"
#include "ui/devices/HeadTrackingSettings.h"
#include "ui/window/MainWindow.h"

namespace app {

/// Runs head tracking while the user has it turned on: starts the tracker in its own thread, turns the view of the
/// tooth with the position of the head, shows the tracker's report on the page of devices and stores the settings. Ui
/// thread.
class HeadTrackingController final : public QObject
{
    Q_OBJECT

public:
    explicit HeadTrackingController(ui::window::MainWindow& window);
    /// Stops the tracker, and detaches the view from it.
    ~HeadTrackingController() override;

    [[nodiscard]] bool isOn() const { return m_settings.isOn; }

private:
    /// A tracker and its thread.
    struct Tracker
    {
        Tracker(core::tracking::TrackerLoop::Open open, const core::tracking::TrackerSettings& settings);
        core::tracking::TrackerLoop loop;
        LoopThread thread;  ///< declared last, because it uses the loop
    };
    void connectPage();
    void turn(bool on);
    void change(const ui::devices::HeadTrackingSettings& settings);
    void readCalibration();
    void restart();
    void showSettings();
    void measureFieldOfView();
    void askWhereToPrint();
    void print(const QString& path);
    void poll();
    void watch();
    void say(const core::tracking::TrackerReport& report);
    [[nodiscard]] core::tracking::Lean leanNow(double seconds, bool touches);

    ui::window::MainWindow& m_window;
    ui::devices::HeadTrackingSettings m_settings;
    std::optional<core::tracking::CameraModel> m_calibration;  ///< read from HeadTrackingSettings::calibration
    std::unique_ptr<Tracker> m_tracker;
    core::tracking::HeadView m_view;
    QTimer m_poll;
    QTimer m_watch;                         ///< checks the tracker, also while the page of devices is closed
    core::tracking::TrackerStage m_said{};  ///< stage that watch() handled last
    int m_withoutTag = 0;                   ///< number of checks in a row without the tag
    int m_polls = 0;
    bool m_isPageOpen = false;
};

}  // namespace app
