// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include <QCommandLineParser>

#include "core/base/Result.h"
#include "ui/render/Look.h"
#include "ui/render/Presenter.h"

namespace cli {

/// What the picture is of.
enum class Picture : std::uint8_t { Tooth, Section, Xray, Bitewing, Arch };

/// What the options ask of the picture, of the look and of the way to the screen.
struct RenderWishes
{
    Picture kind = Picture::Tooth;
    double sectionDeg = 0.0;
    ui::render::Look look;
    ui::render::Presentation presentation;
    bool mirror = false;
    bool neighbours = false;
    bool gizmo = false;
    bool hand = false;      ///< faintly, and an arrow to it where it is outside the picture
    bool leftHand = false;  ///< works
    double beamDeg = 0.0;   ///< of an X-ray picture, from square
    double exposure = 1.0;
    std::string ideal;      ///< preparation, by the name that core/preparation knows; empty: what the tooth asks for
    bool prepared = false;  ///< cut as that ideal says
    bool before = false;    ///< the whole tooth beside what is left of it
};

/// Adds what `cusp render` understands.
void addRenderOptions(QCommandLineParser& parser);

/// What was asked for, with one sentence for what cannot be.
[[nodiscard]] core::Result<RenderWishes> renderWishes(const QCommandLineParser& parser);

}  // namespace cli
