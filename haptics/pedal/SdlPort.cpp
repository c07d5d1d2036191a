// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include <SDL.h>

#include "haptics/pedal/ControllerPort.h"

namespace haptics {
namespace {

using core::session::Controller;

constexpr Uint32 kSubsystems = SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER;
constexpr float kFullReading = 32767.0F;
constexpr std::size_t kGuidText = 33;

static_assert(static_cast<int>(core::session::kLeftStickX) == SDL_CONTROLLER_AXIS_LEFTX);
static_assert(static_cast<int>(core::session::kRightTrigger) == SDL_CONTROLLER_AXIS_TRIGGERRIGHT);
static_assert(static_cast<int>(core::session::kButtonA) == SDL_CONTROLLER_BUTTON_A);
static_assert(static_cast<int>(core::session::kPadRight) == SDL_CONTROLLER_BUTTON_DPAD_RIGHT);

float readingOf(Sint16 raw)
{
    return std::max(-1.0F, static_cast<float>(raw) / kFullReading);
}

/// Prevents SDL from adding or removing controllers while it exists.
class ControllerLock
{
public:
    ControllerLock() { SDL_LockJoysticks(); }
    ~ControllerLock() { SDL_UnlockJoysticks(); }
    ControllerLock(const ControllerLock&) = delete;
    ControllerLock& operator=(const ControllerLock&) = delete;
};

struct CloseJoystick
{
    void operator()(SDL_Joystick* joystick) const { SDL_JoystickClose(joystick); }
};
struct CloseGamepad
{
    void operator()(SDL_GameController* gamepad) const { SDL_GameControllerClose(gamepad); }
};

/// An open controller.
class Opened
{
public:
    /// @param index  of SDL's list
    explicit Opened(int index)
        : m_gamepad(SDL_IsGameController(index) == SDL_TRUE ? SDL_GameControllerOpen(index) : nullptr),
          m_joystick(SDL_JoystickOpen(index)), m_instance(SDL_JoystickGetDeviceInstanceID(index))
    {}

    [[nodiscard]] SDL_JoystickID instance() const { return m_instance; }
    [[nodiscard]] bool isPluggedIn() const
    {
        return m_joystick && SDL_JoystickGetAttached(m_joystick.get()) == SDL_TRUE;
    }

    [[nodiscard]] Controller read() const
    {
        Controller read;
        std::array<char, kGuidText> guid{};
        SDL_JoystickGetGUIDString(SDL_JoystickGetGUID(m_joystick.get()), guid.data(), static_cast<int>(guid.size()));
        read.guid = guid.data();
        const char* const name = SDL_JoystickName(m_joystick.get());
        read.name = name == nullptr ? "" : name;
        read.instance = m_instance;
        read.isGamepad = m_gamepad != nullptr;
        if (read.isGamepad)
            readGamepad(read);
        else
            readJoystick(read);
        return read;
    }

private:
    void readGamepad(Controller& read) const
    {
        for (std::size_t axis = 0; axis < core::session::kGamepadAxes; ++axis)
            read.axes.push_back(
                readingOf(SDL_GameControllerGetAxis(m_gamepad.get(), static_cast<SDL_GameControllerAxis>(axis))));
        read.presses.resize(core::session::kGamepadButtons);
        for (std::size_t button = 0; button < core::session::kGamepadButtons; ++button)
            if (SDL_GameControllerGetButton(m_gamepad.get(), static_cast<SDL_GameControllerButton>(button)) != 0)
                read.held |= 1U << button;
    }

    void readJoystick(Controller& read) const
    {
        const int axes =
            std::clamp(SDL_JoystickNumAxes(m_joystick.get()), 0, static_cast<int>(core::session::kMostControllerAxes));
        for (int axis = 0; axis < axes; ++axis)
            read.axes.push_back(readingOf(SDL_JoystickGetAxis(m_joystick.get(), axis)));
        const int buttons = std::clamp(SDL_JoystickNumButtons(m_joystick.get()), 0,
                                       static_cast<int>(core::session::kMostControllerButtons));
        read.presses.resize(static_cast<std::size_t>(buttons));
        for (int button = 0; button < buttons; ++button)
            if (SDL_JoystickGetButton(m_joystick.get(), button) != 0)
                read.held |= 1U << static_cast<unsigned>(button);
    }

    std::unique_ptr<SDL_GameController, CloseGamepad> m_gamepad;  ///< null: it is no gamepad
    std::unique_ptr<SDL_Joystick, CloseJoystick> m_joystick;      ///< null: it cannot be opened
    SDL_JoystickID m_instance;
};

class SdlPort final : public ControllerPort
{
public:
    ~SdlPort() override
    {
        m_opened.clear();
        SDL_QuitSubSystem(kSubsystems);
        SDL_TLSCleanup();  // of this thread, which SDL has not created
    }

    void read(std::vector<Controller>& controllers) override
    {
        SDL_JoystickUpdate();
        SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);  // only the state is needed
        const ControllerLock lock;
        std::erase_if(m_opened, [](const Opened& one) { return !one.isPluggedIn(); });
        openNew();
        controllers.clear();
        for (const Opened& one : m_opened)
            controllers.push_back(one.read());
    }

private:
    void openNew()
    {
        for (int index = 0; index < SDL_NumJoysticks(); ++index) {
            const SDL_JoystickID instance = SDL_JoystickGetDeviceInstanceID(index);
            const bool isKnown = std::any_of(m_opened.begin(), m_opened.end(),
                                             [instance](const Opened& one) { return one.instance() == instance; });
            if (isKnown)
                continue;
            if (Opened fresh(index); fresh.isPluggedIn())
                m_opened.push_back(std::move(fresh));
        }
    }

    std::vector<Opened> m_opened;
};

}  // namespace

bool hasControllers() noexcept
{
    return true;
}

core::Result<std::unique_ptr<ControllerPort>> openControllerPort()
{
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");  // SDL has no window here
    SDL_SetHint(SDL_HINT_JOYSTICK_HIDAPI, "0");                   // the kernel's drivers support all pads that we name
    if (SDL_InitSubSystem(kSubsystems) != 0)
        return core::unexpected(
            core::ErrorCode::FileUnreadable,
            core::LocalizableText{
                "Pedals and gamepads cannot be read (%1). The mouse and the keyboard work without them.",
                {core::noted(SDL_GetError())}});
    return std::make_unique<SdlPort>();
}

}  // namespace haptics
