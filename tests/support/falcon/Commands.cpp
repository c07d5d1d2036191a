// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/falcon/Commands.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace support {
namespace {

using haptics::falcon::Button;

template <typename T>
using Names = std::initializer_list<std::pair<std::string_view, T>>;

template <typename T>
std::optional<T> named(const std::string& word, Names<T> names)
{
    for (const auto& [name, value] : names)
        if (name == word)
            return value;
    return std::nullopt;
}

template <typename T>
std::optional<T> next(std::istringstream& words)
{
    T value{};
    return words >> value ? std::optional<T>(value) : std::nullopt;
}

std::optional<bool> onOff(const std::string& word)
{
    return named<bool>(word, {{"on", true}, {"off", false}});
}

bool boot(EmulatedFalcon& device, std::istringstream& words)
{
    falcon::BootOptions options;
    for (std::string word; words >> word;) {
        if (word == "zero")
            options.leadingZero = true;
        else if (word == "stray")
            options.strayByte = true;
        else if (word == "try")
            words >> options.answersAtTry;
        else if (word == "echo")
            words >> options.wrongEchoAt;
        else
            return false;
    }
    device.setBoot(options);
    return true;
}

bool setHand(EmulatedFalcon& device, const std::string& name)
{
    const auto hand = std::find_if(haptics::kHands.begin(), haptics::kHands.end(),
                                   [&](const haptics::HandFigures& one) { return one.name == name; });
    if (hand == haptics::kHands.end() && name != "none")
        return false;
    device.setHand(hand == haptics::kHands.end() ? std::nullopt : std::optional(*hand));
    return true;
}

bool move(EmulatedFalcon& device, const std::string& what, std::istringstream& words)
{
    glm::dvec3 toMm{};
    if (!(words >> toMm.x >> toMm.y >> toMm.z))
        return false;
    const std::chrono::milliseconds duration(std::lround(1000.0 * next<double>(words).value_or(0.0)));
    if (what == "grip")
        device.moveTo(toMm, duration);
    else
        device.moveTip(toMm, duration);
    return true;
}

bool setButton(EmulatedFalcon& device, const std::string& name, bool down)
{
    const auto button = named<Button>(
        name,
        {{"plus", Button::Plus}, {"forward", Button::Forward}, {"centre", Button::Centre}, {"minus", Button::Minus}});
    if (button)
        device.setButton(*button, down);
    return button.has_value();
}

bool plan(EmulatedFalcon& device, std::istringstream& words)
{
    std::string momentName;
    std::string accidentName;
    int count = 0;
    words >> momentName >> count >> accidentName;
    const auto moment = named<Moment>(momentName, {{"open", Moment::Open},
                                                   {"claim", Moment::Claim},
                                                   {"query", Moment::Query},
                                                   {"autobaud", Moment::Autobaud},
                                                   {"image", Moment::ImageByte},
                                                   {"homing", Moment::Homing},
                                                   {"exchange", Moment::Exchange}});
    const auto accident = named<Accident>(
        accidentName,
        {{"unplug", Accident::Unplug}, {"power", Accident::PowerLoss}, {"replug", Accident::PowerLossWithReplug}});
    if (!moment || !accident || count < 1)
        return false;
    device.plan(*accident, *moment, count);
    return true;
}

void setPower(EmulatedFalcon& device, bool on)
{
    device.setMains(on);
    if (!on)
        device.losePower();
}

}  // namespace

bool Commands::plug(const std::string& serial, const std::string& pace)
{
    if (serial.empty())
        return false;
    m_device = m_bus.find(serial);
    if (m_device != nullptr) {
        m_device->plug();
        return true;
    }
    m_device = &m_bus.plug(serial, pace == "fast" ? falcon::Pace::Fast : falcon::Pace::Real);
    return setHand(*m_device, "medium");
}

bool Commands::obey(const std::string& line)
{
    std::istringstream words(line);
    std::string what;
    if (!(words >> what) || what.front() == '#')
        return true;
    const auto word = [&] { return next<std::string>(words).value_or(std::string()); };
    if (what == "plug") {
        const std::string serial = word();
        return plug(serial, word());
    }
    if (what == "usb") {
        const auto on = onOff(word());
        m_bus.setUsbPresent(on.value_or(true));
        return on.has_value();
    }
    if (m_device == nullptr)
        return false;
    EmulatedFalcon& device = *m_device;
    if (what == "unplug")
        device.unplug();
    else if (what == "deny" || what == "allow")
        device.setDenied(what == "deny");
    else if (what == "busy" || what == "free")
        device.setBusy(what == "busy");
    else if (what == "firmware")
        device.startFirmware();
    else if (what == "boot")
        return boot(device, words);
    else if (what == "hand")
        return setHand(device, word());
    else if (what == "grip" || what == "tip")
        return move(device, what, words);
    else if (what == "press" || what == "release")
        return setButton(device, word(), what == "press");
    else if (what == "at")
        return plan(device, words);
    else if (what == "faults" || what == "scale") {
        const auto number = next<double>(words);
        if (number && what == "faults")
            device.setFaults(*number);
        else if (number)
            device.setCommandsPerNm(*number);
        return number.has_value();
    } else if (what == "mains" || what == "power") {
        const auto on = onOff(word());
        if (on && what == "mains")
            device.setMains(*on);
        else if (on)
            setPower(device, *on);
        return on.has_value();
    } else {
        return false;
    }
    return true;
}

}  // namespace support
