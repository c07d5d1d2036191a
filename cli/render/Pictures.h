// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QImage>
#include <QSize>
#include <QString>

#include "cli/render/Wishes.h"
#include "core/base/Result.h"
#include "core/grading/IdealCavity.h"
#include "core/servo/ServoState.h"
#include "core/terrain/Tooth.h"

namespace cli {

/// The subject of a picture: a tooth whole, prepared, or as an attempt left it, with the bur at that time, and the
/// ideal.
struct RenderSubject
{
    core::terrain::Tooth tooth;
    std::optional<core::servo::ServoState> bur;
    core::grading::IdealTop ideal;  ///< null: no ideal
};

/// Renders a tooth as requested, for all kinds of pictures but the mouth. Needs a display.
/// @param view  as for ui::tooth::goTo()
[[nodiscard]] core::Result<QImage> rendered(const RenderSubject& subject, const RenderWishes& wishes,
                                            const QString& view, QSize size);

/// Renders the whole mouth as the tooth chooser shows it. Needs a display.
/// @param chosenFdi  this tooth is tinted; 0: none
[[nodiscard]] core::Result<QImage> renderedArch(int chosenFdi, QSize size);

/// Writes a PNG file. An existing file is unchanged on failure.
[[nodiscard]] core::Status savePng(const QImage& picture, const QString& file);

}  // namespace cli
