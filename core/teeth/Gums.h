// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/teeth/Arch.h"

namespace core::teeth {

/// What the gum must know of a tooth of the left half; heights are z of the jaw frame.
struct GumTooth
{
    const LookMesh* mesh = nullptr;
    glm::dmat4 jawFromTooth{1.0};
    double fromMm = 0.0;  ///< where it begins and ends along the arch: its contacts
    double toMm = 0.0;
    double facialNeckMm = 0.0;  ///< the CEJ in the middle of either side
    double lingualNeckMm = 0.0;
    double papillaMm = 0.0;  ///< tip of the papilla behind it: just below the contact
};

/// Soft tissue of the left half of a jaw, in its jaw frame. Gum and base are parts of one smooth surface.
struct Gums
{
    std::vector<LookMesh> around;  ///< gum of each tooth, from contact to contact; the last goes round the end
    LookMesh base;                 ///< palate, or tongue and floor of the mouth, up to the midline
    LookMesh shell;                ///< closes the jaw where a dentist does not look, from the gum's foot to the midline
};

/// The roots are hidden down to here, z of the jaw frame.
inline constexpr double kGumFootMm = -16.0;

/// Lays gum around the necks: its margin a millimetre above the CEJ, as in health, rising to a papilla between each
/// two teeth, its face over the roots below.
/// @param first  how high the papilla between the central incisors is
[[nodiscard]] Gums makeGums(Jaw jaw, const ArchCurve& curve, std::span<const GumTooth> teeth, double firstPapillaMm);

}  // namespace core::teeth
