// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/teeth/Arch.h"

namespace core::teeth {

/// The data of a tooth of the left half for its gum; heights are z of the jaw frame.
struct GumTooth
{
    const LookMesh* mesh = nullptr;
    glm::dmat4 jawFromTooth{1.0};
    double fromMm = 0.0;  ///< its start and end along the arch: its contacts
    double toMm = 0.0;
    double facialNeckMm = 0.0;  ///< the CEJ in the middle of either side
    double lingualNeckMm = 0.0;
    double papillaMm = 0.0;  ///< tip of the papilla distal of it: just below the contact
};

/// Soft tissue of the left half of a jaw, in its jaw frame. Gum and base are parts of one smooth surface.
struct Gums
{
    std::vector<LookMesh> around;  ///< gum of each tooth, from contact to contact; the last goes around the end
    LookMesh base;                 ///< palate, or tongue and floor of the mouth, up to the midline
    LookMesh shell;                ///< closes the jaw on its hidden side, from the gum's foot to the midline
};

/// Height down to which the roots are hidden, z of the jaw frame.
inline constexpr double kGumFootMm = -16.0;

/// Builds the gum around the necks: its margin a millimetre above the CEJ, as in health, rising to a papilla between
/// each two teeth, its face over the roots below.
/// @param firstPapillaMm  height of the papilla between the central incisors
[[nodiscard]] Gums makeGums(Jaw jaw, const ArchCurve& curve, std::span<const GumTooth> teeth, double firstPapillaMm);

}  // namespace core::teeth
