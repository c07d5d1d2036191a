// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>

#include "core/session/SessionChannels.h"
#include "ui/tooth/SightNotes.h"
#include "ui/window/PracticeState.h"

namespace ui::console {
class WatchPanel;
}
namespace ui::kit {
class Actions;
}
namespace ui::practice {
class ViewMenu;
}
namespace ui::tooth {
class ToothView;
}

namespace ui::window {

class Navigation;

/// Adds to the recording what the servo does not know: the aids in use, the camera, and the time on other pages.
class AttemptNotes
{
public:
    /// @param links  must outlive the notes
    /// @param xray   the page of the radiograph
    AttemptNotes(core::session::UiChannels& links, const PracticeState& state, const kit::Actions& actions,
                 const practice::ViewMenu& viewMenu, const console::WatchPanel& watch, tooth::ToothView& view,
                 const Navigation& navigation, const QWidget& xray)
        : m_links(links), m_state(state), m_actions(actions), m_viewMenu(viewMenu), m_watch(watch), m_view(view),
          m_navigation(navigation), m_xray(xray)
    {}

    /// Adds what has changed since the last call.
    void update();

private:
    void noteAids();
    void noteRest();
    [[nodiscard]] std::uint8_t aidsInUse() const;

    core::session::UiChannels& m_links;
    const PracticeState& m_state;
    const kit::Actions& m_actions;
    const practice::ViewMenu& m_viewMenu;
    const console::WatchPanel& m_watch;
    tooth::ToothView& m_view;
    const Navigation& m_navigation;
    const QWidget& m_xray;
    tooth::SightNotes m_sights{m_links};
    // Generation of the tooth, and the value that was last added to its recording.
    std::pair<std::uint64_t, std::uint8_t> m_notedAids{};
    std::pair<std::uint64_t, bool> m_notedRest{};
};

}  // namespace ui::window
