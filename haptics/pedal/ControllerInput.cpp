// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/pedal/ControllerInput.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace haptics {
namespace {

using namespace core::session;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kBeat{4};
constexpr std::chrono::milliseconds kIdleBeat{100};  ///< while no controller is plugged in
constexpr double kLongestBeatS = 0.05;

/// Treats a button as an axis with two positions.
constexpr core::settings::PedalSettings kButtonShape{0.0, 1.0};

}  // namespace

ControllerInput::ControllerInput(FootPedal& pedal, Open open) : m_pedal(pedal), m_open(std::move(open)) {}

ControllerInput::~ControllerInput()
{
    stop();
}

void ControllerInput::start()
{
    if (m_thread.joinable())
        return;
    m_isStopping = false;
    m_thread = std::thread([this] { run(); });
}

void ControllerInput::stop()
{
    if (!m_thread.joinable())
        return;
    {
        const std::lock_guard lock(m_mutex);
        m_isStopping = true;
    }
    m_wake.notify_all();
    m_thread.join();
    m_pedal.set(0);
}

void ControllerInput::setPedal(const PedalSource& source)
{
    const std::lock_guard lock(m_mutex);
    m_wanted = source;
}

ControllerReport ControllerInput::report() const
{
    const std::lock_guard lock(m_mutex);
    return m_report;
}

void ControllerInput::run()
{
    m_now = {};
    m_instance = -1;
    auto port = m_open();
    if (!port) {
        m_now.error = port.error();
        publish();
        return;
    }
    auto before = Clock::now();
    while (!m_isStopping) {
        const std::vector<Controller> was = std::exchange(m_now.controllers, {});
        (*port)->read(m_now.controllers);
        const auto now = Clock::now();
        const double seconds = std::min(kLongestBeatS, std::chrono::duration<double>(now - before).count());
        before = now;
        countPresses(was);
        takeSource();
        followPedal(seconds);
        publish();
        std::unique_lock lock(m_mutex);
        m_wake.wait_for(lock, m_now.controllers.empty() ? kIdleBeat : kBeat, [this] { return m_isStopping.load(); });
    }
    m_now.controllers.clear();
    publish();
}

void ControllerInput::takeSource()
{
    PedalSource wanted;
    {
        const std::lock_guard lock(m_mutex);
        wanted = m_wanted;
    }
    if (wanted == m_source)
        return;
    m_source = std::move(wanted);
    m_instance = -1;
    m_now.pedal = PedalStage::NotChosen;
}

void ControllerInput::countPresses(const std::vector<Controller>& before)
{
    for (Controller& controller : m_now.controllers) {
        const auto was = std::find_if(before.begin(), before.end(),
                                      [&](const Controller& one) { return one.instance == controller.instance; });
        for (std::size_t button = 0; button < controller.presses.size(); ++button) {
            const bool isKnown = was != before.end() && button < was->presses.size();
            controller.presses[button] = isKnown ? was->presses[button] : 0;
            // If a button is already down when its controller is plugged in, that does not count as a press.
            if (isKnown && controller.isHeld(button) && !was->isHeld(button))
                ++controller.presses[button];
        }
    }
}

/// Reads the speed of the chosen pedal. Of two equal pedals, the one that was plugged in first counts until it is
/// unplugged.
void ControllerInput::followPedal(double seconds)
{
    const auto& all = m_now.controllers;
    const auto find = [&](const auto& fits) { return std::find_if(all.begin(), all.end(), fits); };
    auto pedal = find([this](const Controller& one) { return one.instance == m_instance; });
    if (m_instance < 0 || pedal == all.end()) {
        m_pedal.set(0);
        if (std::exchange(m_instance, -1) >= 0)
            ++m_now.unplugged;
        pedal = find([this](const Controller& one) { return !m_source.guid.empty() && one.guid == m_source.guid; });
        if (pedal != all.end()) {
            m_instance = pedal->instance;
            m_shape = PedalShape(m_source.shape);
            m_buttonShape = PedalShape(kButtonShape);
        }
    }
    m_now.percent = pedal == all.end() ? 0 : percentOf(*pedal, seconds);
    m_pedal.set(m_now.percent);
    if (m_source.guid.empty())
        m_now.pedal = PedalStage::NotChosen;
    else if (m_instance < 0)
        m_now.pedal = PedalStage::Missing;
    else
        m_now.pedal = hasRested() ? PedalStage::Ready : PedalStage::WaitsForRest;
}

bool ControllerInput::hasRested() const
{
    return m_source.axis >= 0 ? m_shape.hasRested() : m_buttonShape.hasRested();
}

int ControllerInput::percentOf(const Controller& pedal, double seconds)
{
    int percent = 0;
    if (const auto axis = static_cast<std::size_t>(m_source.axis); m_source.axis >= 0 && axis < pedal.axes.size())
        percent = m_shape.update(static_cast<double>(pedal.axes[axis]), seconds);
    if (const auto button = static_cast<std::size_t>(m_source.button);
        m_source.button >= 0 && button < pedal.presses.size())
        percent = std::max(percent, m_buttonShape.update(pedal.isHeld(button) ? 1.0 : 0.0, seconds));
    return percent;
}

void ControllerInput::publish()
{
    const std::lock_guard lock(m_mutex);
    m_report = m_now;
}

}  // namespace haptics
