// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <QElapsedTimer>

#include "core/session/Links.h"
#include "core/session/Sight.h"

namespace ui::tooth {

class Camera;

/// Puts on the recording from where the student looks: once the camera has rested for a moment, and at once when they
/// begin to push. Ui thread.
class SightNotes
{
public:
    /// @param links  must outlive it
    explicit SightNotes(core::session::UiLinks& links) : m_links(links) {}

    /// Call it once a frame while the student works.
    /// @param generation  of the tooth, which has a recording of its own
    void look(const Camera& camera, std::uint64_t generation, bool pushes);

private:
    core::session::UiLinks& m_links;
    std::uint64_t m_generation = 0;
    std::uint64_t m_seen = 0;  ///< the note of the frame before
    std::uint64_t m_told = 0;
    QElapsedTimer m_resting;
};

}  // namespace ui::tooth
