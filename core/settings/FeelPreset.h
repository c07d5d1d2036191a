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

/// The substances of a preset. A tooth has four tissues (terrain::Material); the lesson decides which caries it has,
/// and whether it is a plastic tooth (ToothKind).
enum class Substance { SoftCaries, FirmCaries, Enamel, Dentin, Pulp, Plastic };
inline constexpr std::size_t kSubstances = 6;

/// The feel of drilling as set by a school: the hardness of each substance, and the parameters of the force law. A
/// named version is never changed; a change makes a new version.
///
/// The defaults are the shipped values; docs/method.md has their sources.
struct FeelPreset
{
    std::string name = "natural";
    int version = 1;
    std::string notes;
    std::string hash;  ///< SHA-256 of the content, 64 hex digits (lessons/PresetFile); empty: unknown

    // As in MaterialHardness: mm³/(N s) when pushing sideways, and the threshold of the force, N.
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
    // As in HardnessPreset.
    double axialShare = 0.65;
    double flatEndShare = 0.615;
    double fullLoadN = 1.5;

    // As in contact::ForceSettings. Its other members belong to the device.
    double stiffnessNPerMm = 2.0;
    double dampingNSPerM = 3.0;
    double fastDampingNSPerM = 30.0;
    double friction = 0.1;
    double clampN = 8.0;
    bool operator==(const FeelPreset&) const = default;
};

/// Returns every number of a preset with its range, in the order of files and tables: rate and threshold of each
/// substance, the shares along the axis and the full load, the forces. The parts of an id are the keys of the file,
/// outermost first.
[[nodiscard]] std::span<const NumberField<FeelPreset>> feelFields();
[[nodiscard]] const NumberField<FeelPreset>& rateField(Substance substance);
[[nodiscard]] const NumberField<FeelPreset>& thresholdField(Substance substance);
/// Returns the hardness of a substance.
[[nodiscard]] MaterialHardness hardnessOf(const FeelPreset& preset, Substance substance);

/// Number of feelFields(), from the first, that concern cutting; the others concern forces.
inline constexpr std::size_t kCuttingFields = 2 * kSubstances + 3;

/// Returns the preset with cutting as in Cusp before flat ends and full loads: the meaning of a file without them.
[[nodiscard]] FeelPreset withoutEndsAndFullLoad(FeelPreset preset);

enum class DecayKind {
    Soft,
    Firm,   ///< discoloured and firm throughout
    Graded  ///< soft at the top, then leathery, firm at the bottom (terrain::DecayZones)
};

/// The properties of a tooth's materials that its layers do not define.
struct ToothKind
{
    bool isPlastic = false;  ///< of one resin throughout, like a typodont's
    DecayKind decay = DecayKind::Soft;
    bool operator==(const ToothKind&) const = default;
};

/// Returns the label of a preset in recordings and score sheets: "natural v3 #1a2b3c4d", or "natural v3, changed"
/// without a hash, because it then differs from its version.
[[nodiscard]] std::string labelOf(const FeelPreset& preset);

/// Returns the hardness of a tooth of this kind, named by the preset's label. A preset has soft and firm decay.
/// Leathery decay is between them: the geometric mean of the two rates, the mean of the two thresholds.
[[nodiscard]] HardnessPreset hardnessFor(const FeelPreset& preset, const ToothKind& tooth);
/// Copies the forces of a preset into a force law; the members that belong to the device stay.
void putForces(const FeelPreset& preset, contact::ForceSettings& force);

/// Returns the preset of a servo's settings, with all other members as in `base`. The inverse of hardnessFor() and
/// putForces().
[[nodiscard]] FeelPreset feltAs(FeelPreset base, const HardnessPreset& hardness, const contact::ForceSettings& force,
                                const ToothKind& tooth);

/// Checks a preset. OutOfRange or BadNumber names the first invalid number.
[[nodiscard]] Status check(const FeelPreset& preset);

}  // namespace core::settings
