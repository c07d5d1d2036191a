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

/// The state of the window that decides, together with PracticeState, which actions are enabled.
struct WindowFacts
{
    bool isInRoom = false;
    bool isAtXray = false;
    bool isAtLessons = false;
    bool isInEditor = false;
    bool isSchoolPage = false;  ///< the page shows data from the database
    bool isAtLogin = false;
    bool mayLeaveLogin = false;
    bool isBusy = false;
    bool isViewUsable = false;  ///< OpenGL is available
    bool isTrial = false;       ///< a block is shown to try a preset on
    bool isBlindfolded = false;
    bool mayEdit = false;  ///< the user may change lessons
    bool canLead = false;  ///< the device can guide a hand
    bool hasBeside = false;
    bool canEditorUndo = false;
    bool canEditorRedo = false;
};

/// Enables the actions that have an effect now, and shows the actions of a replay only during a replay.
void enableActions(kit::Actions& actions, const practice::ViewMenu& viewMenu, const PracticeState& state,
                   const WindowFacts& facts);

}  // namespace ui::window
