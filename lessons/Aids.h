// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace lessons {

/// The aids that a lesson allows. All of them by default; the shipped exams allow none.
struct Aids
{
    bool section = true;     ///< the live cross-section through the bur
    bool depthGauge = true;  ///< depth and dentin left over the pulp, as figures
    bool radiograph = true;  ///< the X-ray pictures before and now
    bool heatMap = true;     ///< colours of depth on the tooth
    bool mirror = true;      ///< the dental mirror
    bool ideal = true;       ///< the ideal preparation, in section and colours
    bool burColour = true;   ///< the bur coloured by what is left to the limit
    bool fixture = true;     ///< a force that resists leaving the outline of the ideal
    bool depthStop = true;   ///< the depth stop of a mouse: as depthGauge in practice, only if named in an exam

    [[nodiscard]] static constexpr Aids none()
    {
        return {false, false, false, false, false, false, false, false, false};
    }
    bool operator==(const Aids&) const = default;
};

}  // namespace lessons
