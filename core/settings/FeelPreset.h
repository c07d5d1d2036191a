// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>

#include "core/base/NumberField.h"
#include "core/contact/ForceLaw.h"
#include "core/settings/HardnessPreset.h"

namespace core::settings {

/// What a preset knows to be cut. A tooth knows four tissues (terrain::Material); which caries it has, and whether it
/// is a tooth at all or a plastic one, the lesson says (ToothKind).
enum class Substance { SoftCaries, FirmCaries, Enamel, Dentin, Pulp, Plastic };
inline constexpr std::size_t kSubstances = 6;

/// How drilling feels, as a school sets it: how every substance yields, and what turns the distance between hand and
/// bur into a force. A named version of it is never changed; a change is another version.
///
/// The defaults are what is shipped; docs/method.md names their sources.
struct FeelPreset
{
    std::string name = "natural";
    int version = 1;
    std::string notes;
    std::string hash;  ///< SHA-256 of the content, 64 hex digits (lessons/PresetFile); empty: not known

    // As MaterialHardness: mm³/(N s) pushing sideways, and the force up to which nothing comes away, N.
    double softCariesRate = 5.0;
    double softCariesFromN = 0.05;
    double firmCariesRate = 3.2;  ///< between dentin and soft decay (docs/facts/haptics.md, section 8.1)
    double firmCariesFromN = 0.08;
    double enamelRate = 0.7;
    double enamelFromN = 0.15;
    double dentinRate = 2.2;
    double dentinFromN = 0.10;
    double pulpRate = 20.0;
    double pulpFromN = 0.0;
    double plasticRate = 2.5;
    double plasticFromN = 0.12;
    // As HardnessPreset.
    double axialShare = 0.65;
    double flatEndShare = 0.615;
    double fullLoadN = 1.5;

    // As contact::ForceSettings. The rest of those is the device's.
    double stiffnessNPerMm = 2.0;
    double dampingNSPerM = 3.0;
    double fastDampingNSPerM = 30.0;
    double friction = 0.1;
    double clampN = 8.0;
    bool operator==(const FeelPreset&) const = default;
};

/// Every number of a preset with its range, in the order of files and tables: rate and threshold of each substance, the
/// shares along the axis and the full load, the forces. An id's parts are the keys of the file, from the outside in.
[[nodiscard]] std::span<const NumberField<FeelPreset>> feelFields();
[[nodiscard]] const NumberField<FeelPreset>& rateField(Substance substance);
[[nodiscard]] const NumberField<FeelPreset>& thresholdField(Substance substance);
/// How a substance yields.
[[nodiscard]] MaterialHardness hardnessOf(const FeelPreset& preset, Substance substance);

/// How many of feelFields(), from the first on, say how a tooth is cut; the others are forces.
inline constexpr std::size_t kCuttingFields = 2 * kSubstances + 3;

/// The same preset, cut as by Cusp before there were flat ends and full loads: what a file means that says nothing of
/// them.
[[nodiscard]] FeelPreset withoutEndsAndFullLoad(FeelPreset preset);

enum class DecayKind {
    Soft,
    Firm,   ///< discoloured and firm throughout
    Graded  ///< soft above, then leathery, firm at the bottom (terrain::DecayZones)
};

/// What a tooth is made of, as far as its layers do not say it.
struct ToothKind
{
    bool isPlastic = false;  ///< one resin throughout, as a typodont's
    DecayKind decay = DecayKind::Soft;
    bool operator==(const ToothKind&) const = default;
};

/// "natural v3 #1a2b3c4d", "natural v3, changed": what recordings and score sheets call a preset. One without a hash is
/// not what its version says.
[[nodiscard]] std::string labelOf(const FeelPreset& preset);

/// The rows of a preset that such a tooth is cut by, with the preset's label for a name. A preset knows soft and firm
/// decay. Leathery decay lies between: the geometric mean of the two rates, the mean of the two thresholds.
[[nodiscard]] HardnessPreset hardnessFor(const FeelPreset& preset, const ToothKind& tooth);
/// Puts the forces of a preset into a force law and leaves what is the device's.
void putForces(const FeelPreset& preset, contact::ForceSettings& force);

/// What a servo is set to, as far as a preset knows it; the rest as in `base`. The reverse of the two above.
[[nodiscard]] FeelPreset feltAs(FeelPreset base, const HardnessPreset& hardness, const contact::ForceSettings& force,
                                const ToothKind& tooth);

/// OutOfRange or BadNumber naming the first number outside its range.
[[nodiscard]] Status check(const FeelPreset& preset);

}  // namespace core::settings
