// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/PracticeState.h"

namespace ui::kit {
class Actions;
}
namespace ui::practice {
class ViewMenu;
}

namespace ui::window {

/// What decides, beside PracticeState, which actions are enabled.
struct WindowFacts
{
    bool isInRoom = false;
    bool isAtXray = false;
    bool isAtLessons = false;
    bool isInEditor = false;
    bool isSchoolPage = false;  ///< the page shows what the database has
    bool isAtLogin = false;
    bool mayLeaveLogin = false;
    bool isBusy = false;
    bool isViewUsable = false;  ///< there is OpenGL
    bool isTrial = false;       ///< a block is shown to try a preset on
    bool isBlindfolded = false;
    bool mayEdit = false;  ///< the user may change lessons
    bool canLead = false;  ///< the device can lead a hand
    bool hasBeside = false;
    bool canEditorUndo = false;
    bool canEditorRedo = false;
};

/// Enables each action where it has an effect, and shows those of a replay during a replay.
void enableActions(kit::Actions& actions, const practice::ViewMenu& viewMenu, const PracticeState& state,
                   const WindowFacts& facts);

}  // namespace ui::window
