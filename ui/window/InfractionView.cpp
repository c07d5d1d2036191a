// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/InfractionView.h"

#include <cmath>

#include <QAction>
#include <glm/geometric.hpp>

#include "ui/inside/SectionView.h"
#include "ui/kit/Actions.h"
#include "ui/practice/InfractionCard.h"
#include "ui/tooth/ToothView.h"
#include "ui/window/BurControl.h"
#include "ui/window/PracticeRoom.h"

namespace ui::window {
namespace {

using core::grading::RuleViolation;

/// Returns the direction from a place to the nearest column that must be cut, in radians seen from above; empty if
/// there is none.
std::optional<double> towardsIdeal(const core::terrain::ToothAnatomy& tooth, const std::vector<float>& ideal,
                                   const glm::dvec3& placeMm)
{
    std::optional<glm::dvec2> nearest;
    for (int j = 0; j < tooth.grid.side; ++j)
        for (int i = 0; i < tooth.grid.side; ++i) {
            const std::size_t k = tooth.grid.index(i, j);
            const glm::dvec2 way = tooth.grid.nodeMm(i, j) - glm::dvec2(placeMm);
            if (ideal[k] < tooth.top[k] && (!nearest || glm::dot(way, way) < glm::dot(*nearest, *nearest)))
                nearest = way;
        }
    return nearest ? std::optional(std::atan2(nearest->y, nearest->x)) : std::nullopt;
}

}  // namespace

InfractionView::InfractionView(const PracticeState& state, PracticeRoom& room, kit::Actions& actions,
                               tooth::ToothView& view, BurControl& bur)
    : QObject(&room), m_state(state), m_room(room), m_actions(actions), m_view(view), m_bur(bur),
      m_card(new practice::InfractionCard(&room))
{
    connect(m_card, &practice::InfractionCard::goOnRequested, this, &InfractionView::continueWork);
    connect(m_card, &practice::InfractionCard::takeBackRequested, this, [this] {
        emit takeBackRequested(m_tick);
        continueWork();
    });
}

void InfractionView::continueWork()
{
    m_room.section().setHeld({});
    m_bur.continueAfterBreach();
    m_view.setFocus();
}

void InfractionView::show(const core::grading::Infraction& infraction, bool canTakeBack)
{
    m_tick = infraction.tick;
    m_bur.stopForBreach(m_card->isHidden());
    // A bur that ran in the air has cut nothing that could be shown or undone.
    const bool didHarm = infraction.breach != RuleViolation::BurInAir;
    if (didHarm)
        showPlace(infraction);
    m_card->tell(infraction, canTakeBack && didHarm);
    m_room.setHintVisible(false);
    emit changed();
}

/// Fixes the section at the place of the infraction, in the direction that shows it best.
void InfractionView::showPlace(const core::grading::Infraction& infraction)
{
    m_room.section().setHeld(infraction.placeMm);
    if (infraction.breach == RuleViolation::RidgeCut)
        m_room.section().showAlong(0.0);
    if (infraction.breach == RuleViolation::WrongPlace && m_state.tooth && m_state.ideal)
        if (const auto towards = towardsIdeal(*m_state.tooth, *m_state.ideal, infraction.placeMm))
            m_room.section().showAlong(*towards);
    if (m_state.aids.section && !m_actions.section->isChecked()) {
        m_actions.section->setChecked(true);
        m_room.setSectionVisible(true);
    }
}

bool InfractionView::isShown() const
{
    return m_card->isVisible();
}

void InfractionView::hide()
{
    m_card->hide();
}

void InfractionView::goOn()
{
    m_card->goOn();
}

bool InfractionView::takeBack()
{
    return m_card->takeBack();
}

void InfractionView::setFocus()
{
    m_card->setFocus();
}

void InfractionView::placeIn(const QRect& area, const std::optional<QPointF>& bur)
{
    m_card->placeIn(area, bur);
}

}  // namespace ui::window
