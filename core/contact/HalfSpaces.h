// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include <glm/vec3.hpp>

namespace core::contact {

/// Up to a few half-spaces normal . x >= offset, and the point of all of them that is nearest to another: the
/// god-object's place among its active planes (Zilles & Salisbury 1995). Servo thread; no allocation.
class HalfSpaces
{
public:
    static constexpr std::size_t kMost = 4;

    void clear() noexcept { m_count = 0; }
    /// One more; the oldest gives way if there are kMost. @param normal  of length 1
    void add(const glm::dvec3& normal, double offset) noexcept;

    /// False if no point lies in all of them.
    [[nodiscard]] bool nearest(const glm::dvec3& to, glm::dvec3& point) const noexcept;

private:
    struct Plane
    {
        glm::dvec3 normal;
        double offset;
    };
    [[nodiscard]] bool holds(const glm::dvec3& point) const noexcept;

    std::array<Plane, kMost> m_planes{};
    std::size_t m_count = 0;
};

}  // namespace core::contact
