// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <QOpenGLFramebufferObject>
#include <QRect>

#include "ui/render/Look.h"

namespace ui::render {

/// Everything that decides how tooth and room look while nothing is cut.
struct StillView
{
    glm::dmat4 eyeFromTooth{1.0};
    glm::dmat4 clipFromEye{1.0};
    glm::dvec4 clipPlane{0.0};
    glm::vec3 towardsLight{0.0F};
    Look look;
    std::uint64_t surfaces = 0;  ///< a number of its own for each tooth and each set of neighbours
    bool operator==(const StillView&) const = default;
};

/// Tooth and room as they were last drawn, colours and depths, for an eye that rests: a software driver copies them in
/// a tenth of the time in which it draws them. The context that was current at the first use must be current in every
/// call, the destructor included.
class StillPicture
{
public:
    /// Of this size and view, or nothing is kept in it.
    [[nodiscard]] bool holds(QSize size, const StillView& view) const;
    /// Makes room for a picture; its content is then the caller's to draw into framebuffer().
    void take(QSize size, const StillView& view);
    /// This part of it, pixels from the lower left, no longer holds.
    void spoil(const QRect& part) { m_spoilt = m_spoilt.united(part); }
    /// What no longer holds, and forgets it.
    [[nodiscard]] QRect takeSpoilt();
    [[nodiscard]] GLuint framebuffer() const { return m_pixels->handle(); }
    [[nodiscard]] const std::optional<StillView>& view() const { return m_view; }
    [[nodiscard]] QSize size() const { return m_pixels ? m_pixels->size() : QSize(); }

private:
    std::unique_ptr<QOpenGLFramebufferObject> m_pixels;
    std::optional<StillView> m_view;
    QRect m_spoilt;
};

}  // namespace ui::render
