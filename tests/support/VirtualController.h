// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <SDL.h>

namespace support {

/// A virtual joystick or gamepad of SDL, for a program that reads real ones. SDL's joysticks must be initialised.
class VirtualController
{
public:
    VirtualController(const char* name, SDL_JoystickType type, Uint16 axes, Uint16 buttons)
    {
        SDL_VirtualJoystickDesc made{};
        made.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
        made.type = static_cast<Uint16>(type);
        made.naxes = axes;
        made.nbuttons = buttons;
        made.name = name;
        SDL_LockJoysticks();
        const int index = SDL_JoystickAttachVirtualEx(&made);
        m_instance = SDL_JoystickGetDeviceInstanceID(index);
        m_joystick = SDL_JoystickOpen(index);
        SDL_UnlockJoysticks();
    }
    ~VirtualController() { unplug(); }
    VirtualController(const VirtualController&) = delete;
    VirtualController& operator=(const VirtualController&) = delete;

    [[nodiscard]] bool isMade() const { return m_joystick != nullptr; }
    [[nodiscard]] int instance() const { return m_instance; }
    /// @param reading  -1 to 1, like the raw axis of a joystick
    void setAxis(int axis, double reading)
    {
        SDL_JoystickSetVirtualAxis(m_joystick, axis, static_cast<Sint16>(reading * 32767.0));
    }
    void setButton(int button, bool isDown)
    {
        SDL_JoystickSetVirtualButton(m_joystick, button, isDown ? Uint8{1} : Uint8{0});
    }
    void unplug()
    {
        if (m_joystick == nullptr)
            return;
        SDL_LockJoysticks();
        for (int index = 0; index < SDL_NumJoysticks(); ++index)
            if (SDL_JoystickGetDeviceInstanceID(index) == m_instance) {
                SDL_JoystickDetachVirtual(index);
                break;
            }
        SDL_JoystickClose(m_joystick);
        SDL_UnlockJoysticks();
        m_joystick = nullptr;
    }

private:
    SDL_Joystick* m_joystick = nullptr;
    SDL_JoystickID m_instance = -1;
};

}  // namespace support
