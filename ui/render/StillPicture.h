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

/// Everything that the picture of tooth and room depends on while nothing is cut.
struct StillView
{
    glm::dmat4 eyeFromTooth{1.0};
    glm::dmat4 clipFromEye{1.0};
    glm::dvec4 clipPlane{0.0};
    glm::vec3 towardsLight{0.0F};
    Look look;
    std::uint64_t surfaces = 0;  ///< changes with each tooth and each set of adjacent teeth
    bool operator==(const StillView&) const = default;
};

/// Stores the last picture of tooth and room, colours and depths, for a camera at rest. A software driver copies it in
/// a tenth of the time of drawing. The context of the first call must be current in every later call, including the
/// destructor.
class StillPicture
{
public:
    /// Returns whether the picture has this size and view.
    [[nodiscard]] bool holds(QSize size, const StillView& view) const;
    /// Prepares a picture of this size and view. The caller must draw it into framebuffer().
    void take(QSize size, const StillView& view);
    /// Marks a part of the picture, in pixels from the lower left, as outdated.
    void spoil(const QRect& part) { m_spoilt = m_spoilt.united(part); }
    /// Returns the outdated part and clears the mark.
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
