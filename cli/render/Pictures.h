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

/// What is to be drawn: a tooth whole, prepared, or as an attempt left it, where the bur was then, and what it should
/// come to.
struct RenderSubject
{
    core::terrain::Tooth tooth;
    std::optional<core::servo::ServoState> bur;
    core::grading::IdealTop ideal;  ///< null: nothing is asked for
};

/// The picture of a tooth that was wished for, any but that of the mouth. Needs a display.
/// @param view  as ui::tooth::goTo() takes it
[[nodiscard]] core::Result<QImage> rendered(const RenderSubject& subject, const RenderWishes& wishes,
                                            const QString& view, QSize size);

/// The whole mouth as the page shows it on which a tooth is chosen. Needs a display.
/// @param chosenFdi  is tinted; 0: none
[[nodiscard]] core::Result<QImage> renderedArch(int chosenFdi, QSize size);

/// An older file survives any failure.
[[nodiscard]] core::Status savePng(const QImage& picture, const QString& file);

}  // namespace cli
