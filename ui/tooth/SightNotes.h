// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <QElapsedTimer>

#include "core/session/SessionChannels.h"
#include "core/session/Sight.h"

namespace ui::tooth {

class Camera;

/// Records the student's viewpoint: when the camera has rested for a moment, and when the student begins to push. Ui
/// thread.
class SightNotes
{
public:
    /// @param links  must outlive this object
    explicit SightNotes(core::session::UiChannels& links) : m_links(links) {}

    /// Passes the camera. Call once per frame while the student works.
    /// @param generation  of the tooth; each tooth has its own recording
    void look(const Camera& camera, std::uint64_t generation, bool pushes);

private:
    core::session::UiChannels& m_links;
    std::uint64_t m_generation = 0;
    std::uint64_t m_seen = 0;  ///< the viewpoint of the last frame
    std::uint64_t m_told = 0;  ///< the viewpoint recorded last
    QElapsedTimer m_resting;   ///< since m_seen changed
};

}  // namespace ui::tooth
