// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/audio/Audition.h"

namespace core::audio {
namespace {

constexpr double kEnamelFromS = 1.2;
constexpr double kEnamelToS = 2.4;
constexpr double kDentinFromS = 2.8;
constexpr double kDentinToS = 4.0;
constexpr double kStopS = 4.4;
// The sound of a 330 bur that cuts with 1 N.
constexpr float kLoadedShare = 0.85F;
constexpr float kEnamelMm3PerS = 0.4F;
constexpr float kDentinMm3PerS = 1.6F;
constexpr float kContactMmPerS = 5.0F;

}  // namespace

SoundState auditionAt(double seconds) noexcept
{
    SoundState state;
    const bool isEnamel = seconds >= kEnamelFromS && seconds < kEnamelToS;
    const bool isDentin = seconds >= kDentinFromS && seconds < kDentinToS;
    state.turns = seconds >= 0.0 && seconds < kStopS;
    state.spray = state.turns;
    state.suction = state.turns;
    state.isTouching = isEnamel || isDentin;
    state.burRpm = state.turns ? state.freeRpm * (state.isTouching ? kLoadedShare : 1.0F) : 0.0F;
    state.material = seconds < kDentinFromS ? terrain::Material::Enamel : terrain::Material::Dentin;
    state.cutMm3PerS = isEnamel ? kEnamelMm3PerS : isDentin ? kDentinMm3PerS : 0.0F;
    state.contacts = seconds < kEnamelFromS ? 0 : seconds < kDentinFromS ? 1 : 2;
    state.contactMmPerS = kContactMmPerS;
    return state;
}

}  // namespace core::audio
