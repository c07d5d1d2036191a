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
    bool showsHand = false;        ///< the place where the hand holds the bur, faintly
    bool showsMargin = false;      ///< the distance of the bur to tissue that must stay, by its colour
    bool showsMirror = false;      ///< the dental mirror
    bool showsNeighbours = false;  ///< the neighbouring teeth and their gum
    bool movesLittle = false;      ///< reduced motion: without animations
    bool operator==(const ViewSettings&) const = default;
};

}  // namespace ui::tooth
