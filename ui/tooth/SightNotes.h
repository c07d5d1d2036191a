// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <QElapsedTimer>

#include "core/session/SessionChannels.h"
#include "core/session/Sight.h"

namespace ui::tooth {

class Camera;

/// Notes in the recording from where the student looks: when the camera has rested for a moment, and as soon as they
/// begin to push. Ui thread.
class SightNotes
{
public:
    /// @param links  must outlive it
    explicit SightNotes(core::session::UiChannels& links) : m_links(links) {}

    /// Takes the camera. Call this once a frame while the student works.
    /// @param generation  of the tooth; each has a recording of its own
    void look(const Camera& camera, std::uint64_t generation, bool pushes);

private:
    core::session::UiChannels& m_links;
    std::uint64_t m_generation = 0;
    std::uint64_t m_seen = 0;  ///< the sight in the last frame, as a note
    std::uint64_t m_told = 0;  ///< the last note in the recording
    QElapsedTimer m_resting;   ///< since m_seen has changed
};

}  // namespace ui::tooth
