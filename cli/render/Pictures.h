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

/// The subject of a picture: a whole tooth, a prepared one, or the result of an attempt with the bur at its end; and
/// the ideal.
struct RenderSubject
{
    core::terrain::Tooth tooth;
    std::optional<core::servo::ServoState> bur;
    core::grading::IdealTop ideal;  ///< null: no ideal
};

/// Renders a tooth as requested, for all kinds of pictures except the whole mouth. Needs a display.
/// @param view  as for ui::tooth::goTo()
[[nodiscard]] core::Result<QImage> rendered(const RenderSubject& subject, const RenderWishes& wishes,
                                            const QString& view, QSize size);

/// Renders the whole mouth as the tooth chooser shows it. Needs a display.
/// @param chosenFdi  this tooth is tinted; 0: none
[[nodiscard]] core::Result<QImage> renderedArch(int chosenFdi, QSize size);

/// Writes a PNG file. If that fails, an existing file is unchanged.
[[nodiscard]] core::Status savePng(const QImage& picture, const QString& file);

}  // namespace cli
