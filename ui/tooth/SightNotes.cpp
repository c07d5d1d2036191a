// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tooth/SightNotes.h"

#include <utility>

#include "ui/tooth/Camera.h"

namespace ui::tooth {
namespace {

constexpr int kRestMs = 400;

}  // namespace

void SightNotes::look(const Camera& camera, std::uint64_t generation, bool pushes)
{
    if (std::exchange(m_generation, generation) != generation)
        m_told = 0;
    const std::uint64_t now = core::session::sightNote(camera.sight());
    if (std::exchange(m_seen, now) != now)
        m_resting.start();
    const bool rests = m_resting.isValid() && m_resting.elapsed() >= kRestMs;
    if (now != m_told && (rests || pushes) && m_links.commands.tryPush(core::session::AddNote{now}))
        m_told = now;
}

}  // namespace ui::tooth
