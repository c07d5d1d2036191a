// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include <QCommandLineParser>

#include "core/base/Result.h"
#include "ui/render/Look.h"
#include "ui/render/Presenter.h"

namespace cli {

/// The subject of the picture.
enum class Picture : std::uint8_t { Tooth, Section, Xray, Bitewing, Arch };

/// The values of all options of a picture.
struct RenderWishes
{
    Picture kind = Picture::Tooth;
    double sectionDeg = 0.0;
    ui::render::Look look;
    ui::render::Presentation presentation;
    bool mirror = false;
    bool neighbours = false;
    bool gizmo = false;
    bool hand = false;      ///< the hand is shown faintly, with an arrow to it if it is outside the picture
    bool leftHand = false;  ///< the handpiece is in the left hand
    double beamDeg = 0.0;   ///< angle of the beam of an X-ray picture, from perpendicular
    double exposure = 1.0;
    std::string ideal;      ///< id of the preparation (core/preparation); empty: that of the tooth's lesson
    bool prepared = false;  ///< the tooth is cut to that ideal
    bool before = false;    ///< the uncut tooth is shown beside the cut one
};

/// Adds the options of `cusp render`.
void addRenderOptions(QCommandLineParser& parser);

/// Returns the values of these options, or an error of one sentence.
[[nodiscard]] core::Result<RenderWishes> renderWishes(const QCommandLineParser& parser);

}  // namespace cli
