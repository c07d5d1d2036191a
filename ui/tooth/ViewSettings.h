// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/render/Look.h"
#include "ui/render/Presenter.h"

namespace ui::tooth {

/// What a person chooses about the view, and finds again at the next start.
struct ViewSettings
{
    render::Look look;
    render::Presentation presentation;
    bool showsHand = false;        ///< where the hand holds the bur, faintly
    bool showsMargin = false;      ///< how near the bur is to what is to be kept, by its colour
    bool showsMirror = false;      ///< the dental mirror
    bool showsNeighbours = false;  ///< the teeth beside one of ours, and their gum
    bool movesLittle = false;      ///< reduced motion: what glides otherwise is there at once
    bool operator==(const ViewSettings&) const = default;
};

}  // namespace ui::tooth
