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
/// The thread writes the speed that the chosen pedal asks for to a FootPedal, which the servo reads. A pedal that is
/// unplugged asks for none, at once. The functions here are for the ui thread and return at once; only stop() waits for
/// the thread.
class ControllerInput
{
public:
    using Open = std::function<core::Result<std::unique_ptr<ControllerPort>>()>;

    /// @param pedal  must outlive this
    /// @param open   opens the port, in the thread
    explicit ControllerInput(FootPedal& pedal, Open open = openControllerPort);
    /// Stops.
    ~ControllerInput();
    ControllerInput(const ControllerInput&) = delete;
    ControllerInput& operator=(const ControllerInput&) = delete;

    void start();
    /// The pedal asks for no speed any more.
    void stop();

    /// Chooses what runs the bur. The pedal then counts as released until it has been seen at rest.
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

    // Of the thread.
    core::session::ControllerReport m_now;
    core::session::PedalSource m_source;
    PedalShape m_shape{{}};
    PedalShape m_buttonShape{{}};
    int m_instance = -1;  ///< of the pedal; -1: it is not plugged in

    std::thread m_thread;  ///< last: it uses the rest
};

}  // namespace haptics
