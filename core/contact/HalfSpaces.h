// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include <glm/vec3.hpp>

namespace core::contact {

/// normal . x >= offset, the normal of length 1.
struct HalfSpace
{
    glm::dvec3 normal;
    double offset;
};

/// A few half-spaces, and the point in all of them that is nearest to another point: the god-object's place among its
/// active planes (Zilles & Salisbury 1995). Servo thread; no allocation.
class HalfSpaces
{
public:
    static constexpr std::size_t kMost = 4;

    void clear() noexcept { m_count = 0; }
    /// Adds a half-space; replaces the oldest if there are kMost.
    void add(const HalfSpace& space) noexcept;

    /// Finds the nearest point. Returns false if no point is in all of them.
    [[nodiscard]] bool nearest(const glm::dvec3& to, glm::dvec3& point) const noexcept;

private:
    [[nodiscard]] bool holds(const glm::dvec3& point) const noexcept;

    std::array<HalfSpace, kMost> m_planes{};
    std::size_t m_count = 0;
};

}  // namespace core::contact
