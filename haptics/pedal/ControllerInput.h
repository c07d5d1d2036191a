// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "haptics/pedal/ControllerPort.h"
#include "haptics/pedal/FootPedal.h"
#include "haptics/pedal/PedalShape.h"

namespace haptics {

/// Reads foot pedals and gamepads in a thread of its own, 250 times a second while one is plugged in.
///
/// The thread writes the speed that the chosen pedal requests to a FootPedal, which the servo reads. An unplugged pedal
/// requests 0 at once. Call the functions in the ui thread. They return at once, except stop(), which waits for the
/// thread.
class ControllerInput
{
public:
    using Open = std::function<core::Result<std::unique_ptr<ControllerPort>>()>;

    /// @param pedal  must outlive this
    /// @param open   opens the port, in the thread
    explicit ControllerInput(FootPedal& pedal, Open open = openControllerPort);
    /// Calls stop().
    ~ControllerInput();
    ControllerInput(const ControllerInput&) = delete;
    ControllerInput& operator=(const ControllerInput&) = delete;

    void start();
    /// Stops the thread and sets the speed of the pedal to 0.
    void stop();

    /// Chooses the pedal that controls the bur. It counts as released until it has been read at rest.
    void setPedal(const core::session::PedalSource& source);
    [[nodiscard]] core::session::ControllerReport report() const;

private:
    void run();
    void takeSource();
    void countPresses(const std::vector<core::session::Controller>& before);
    void followPedal(double seconds);
    [[nodiscard]] bool hasRested() const;
    [[nodiscard]] int percentOf(const core::session::Controller& pedal, double seconds);
    void publish();

    FootPedal& m_pedal;
    Open m_open;
    mutable std::mutex m_mutex;  ///< guards the three below
    std::condition_variable m_wake;
    core::session::PedalSource m_wanted;
    core::session::ControllerReport m_report;
    std::atomic<bool> m_isStopping{false};

    // Used by the thread.
    core::session::ControllerReport m_now;
    core::session::PedalSource m_source;
    PedalShape m_shape{{}};
    PedalShape m_buttonShape{{}};
    int m_instance = -1;  ///< of the pedal; -1: not plugged in

    std::thread m_thread;  ///< last: it uses the members above
};

}  // namespace haptics
