// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include <QObject>
#include <QPointF>
#include <QRect>

#include "core/grading/RuleChecker.h"
#include "ui/window/PracticeState.h"

namespace ui::kit {
class Actions;
}
namespace ui::practice {
class InfractionCard;
}
namespace ui::tooth {
class ToothView;
}

namespace ui::window {

class BurControl;
class PracticeRoom;

/// Stops the bur when a rule of the lesson is broken in practice, shows the place in the section, and offers to undo
/// the cut.
class InfractionView final : public QObject
{
    Q_OBJECT
public:
    InfractionView(const PracticeState& state, PracticeRoom& room, kit::Actions& actions, tooth::ToothView& view,
                   BurControl& bur);

    /// Stops the bur and shows an infraction.
    /// @param canTakeBack  whether the undo history has a step before the infraction
    void show(const core::grading::Infraction& infraction, bool canTakeBack);
    [[nodiscard]] bool isShown() const;
    void hide();
    /// Continues with the tooth as it is.
    void goOn();
    /// Undoes the cut. Returns false if the card does not offer that.
    [[nodiscard]] bool takeBack();
    void setFocus();
    void placeIn(const QRect& area, const std::optional<QPointF>& bur);

signals:
    /// Emitted when the user requests to undo the cut.
    /// @param tick  tick of the infraction
    void takeBackRequested(std::uint64_t tick);
    /// Emitted when actions and overlays need an update.
    void changed();

private:
    void continueWork();
    void showPlace(const core::grading::Infraction& infraction);

    const PracticeState& m_state;
    PracticeRoom& m_room;
    kit::Actions& m_actions;
    tooth::ToothView& m_view;
    BurControl& m_bur;
    practice::InfractionCard* m_card;
    std::uint64_t m_tick = 0;  ///< tick of the infraction that is shown
};

}  // namespace ui::window
