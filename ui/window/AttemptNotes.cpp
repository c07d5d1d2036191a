// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/AttemptNotes.h"

#include <QAction>

#include "ui/console/WatchPanel.h"
#include "ui/kit/Actions.h"
#include "ui/practice/ViewMenu.h"
#include "ui/tooth/ToothView.h"
#include "ui/window/Navigation.h"

namespace ui::window {

void AttemptNotes::update()
{
    if (m_state.isReplaying || m_state.tooth == nullptr)
        return;
    noteAids();
    noteRest();
    m_sights.look(m_view.camera(), m_state.ownGeneration, m_view.hand().isPushing());
}

/// Returns bits of core::servo::Aid. A checked action that the lesson does not allow is not in use.
std::uint8_t AttemptNotes::aidsInUse() const
{
    using namespace core::servo;
    const auto inUse = [](bool used, Aid aid) { return static_cast<std::uint8_t>(used ? aid : 0); };
    const lessons::Aids& aids = m_state.aids;
    const bool showsPanel = m_actions.panel->isChecked() && !(m_state.assignment && m_state.assignment->exercise);
    const bool showsColours = m_actions.depthColours->isChecked() || m_actions.idealColours->isChecked();
    const bool showsIdeal =
        m_actions.idealColours->isChecked() || m_actions.section->isChecked() || m_actions.outline->isChecked();
    return static_cast<std::uint8_t>(
        inUse(m_actions.section->isChecked(), kSectionAid) |
        inUse(aids.depthGauge && (showsPanel || m_watch.names().contains(QStringLiteral("live.depth"))),
              kDepthGaugeAid) |
        inUse(m_navigation.isAt(m_xray), kRadiographAid) | inUse(aids.heatMap && showsColours, kHeatMapAid) |
        inUse(aids.mirror && m_actions.mirror->isChecked(), kMirrorAid) |
        inUse(aids.burColour && m_state.ideal != nullptr && m_viewMenu.settings().showsMargin, kBurColourAid) |
        inUse(aids.fixture && m_actions.fixture->isChecked(), kFixtureAid) |
        inUse(aids.ideal && m_state.ideal != nullptr && showsIdeal, kIdealAid));
}

void AttemptNotes::noteAids()
{
    const std::pair now(m_state.ownGeneration, aidsInUse());
    if (m_notedAids != now && m_links.commands.tryPush(core::session::SetAids{now.second}))
        m_notedAids = now;
}

/// Notes the begin and end of pauses. In practice, time on another page, including the login page, is not part of the
/// attempt. During an exam it is.
void AttemptNotes::noteRest()
{
    const bool rests = !m_navigation.isInRoom() && !m_state.isExam();
    const bool isNoted = m_notedRest.first == m_state.ownGeneration && m_notedRest.second;
    if (rests != isNoted &&
        m_links.commands.tryPush(core::session::AddNote{rests ? core::servo::kRestNote : core::servo::kWorkNote}))
        m_notedRest = {m_state.ownGeneration, rests};
}

}  // namespace ui::window
