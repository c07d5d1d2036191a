// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace lessons {

/// The aids that a lesson allows. The default is all; the shipped exams allow none.
struct Aids
{
    bool section = true;     ///< the live cross-section through the bur
    bool depthGauge = true;  ///< depth and remaining dentin over the pulp, as figures
    bool radiograph = true;  ///< the radiographs before cutting and now
    bool heatMap = true;     ///< colours of depth on the tooth
    bool mirror = true;      ///< the dental mirror
    bool ideal = true;       ///< the ideal preparation, in section and colours
    bool burColour = true;   ///< the bur coloured by its distance to the limit
    bool fixture = true;     ///< a force that resists leaving the outline of the ideal
    bool depthStop = true;   ///< the depth stop of a mouse: in practice as depthGauge, in an exam only if it is named

    [[nodiscard]] static constexpr Aids none()
    {
        return {false, false, false, false, false, false, false, false, false};
    }
    bool operator==(const Aids&) const = default;
};

}  // namespace lessons
