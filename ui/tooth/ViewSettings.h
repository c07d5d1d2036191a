// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/render/Look.h"
#include "ui/render/Presenter.h"

namespace ui::tooth {

/// The user's choices about the view, stored between runs.
struct ViewSettings
{
    render::Look look;
    render::Presentation presentation;
    bool showsHand = false;        ///< a faint bur where the hand holds it
    bool showsMargin = false;      ///< the bur's colour shows its distance to tissue that must be preserved
    bool showsMirror = false;      ///< the dental mirror
    bool showsNeighbours = false;  ///< the neighbouring teeth and their gum
    bool movesLittle = false;      ///< reduced motion: no animations
    bool operator==(const ViewSettings&) const = default;
};

}  // namespace ui::tooth
