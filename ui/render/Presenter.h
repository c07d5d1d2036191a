// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include <QColor>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <QString>

#include "ui/render/ToothRenderer.h"

namespace ui::render {

/// The stereo mode: off; red and cyan glasses, either in colour with little ghosting (after Dubois 2001) or in grey
/// with the least ghosting; or two halves of one picture for a display that separates them.
enum class Stereo : std::uint8_t { Off, RedCyan, RedCyanGrey, SideBySide, TopBottom };

/// Returns a colour as it appears in a picture for both eyes, for content painted over such a picture.
[[nodiscard]] QColor seenAs(const QColor& colour, Stereo stereo);

/// Returns the id that is stored with an attempt: "flat", "red-cyan" ...
[[nodiscard]] const char* idOf(Stereo stereo);

/// The stereo mode and the flips of the picture.
struct Presentation
{
    Stereo stereo = Stereo::Off;
    double apart = 0.04;         ///< distance of the two eyes, relative to the distance to the focus
    double convergence = 1.0;    ///< distance of the plane of the screen, relative to the distance to the focus
    bool flipLeftRight = false;  ///< for a half-silvered mirror over the hand
    bool flipUpDown = false;     ///< for a screen mounted upside down above the hand
    bool operator==(const Presentation&) const = default;
    [[nodiscard]] bool isPlain() const { return stereo == Stereo::Off && !flipLeftRight && !flipUpDown; }
};

/// Draws a scene as the user's Presentation requires. The context of initialize() must be current in every call,
/// including the destructor.
class Presenter : private QOpenGLFunctions_3_3_Core
{
public:
    /// Compiles the shader. Returns false if the driver rejects it, and writes the cause to `reason`.
    [[nodiscard]] bool initialize(QString& reason);

    /// Draws into the whole viewport of the bound framebuffer.
    /// @param focusMm  distance from the eye to the point it looks at
    /// @param samples  per pixel of intermediate pictures, for anti-aliasing
    void draw(ToothRenderer& renderer, const Scene& scene, const Presentation& how, double focusMm, int samples);

    /// Returns the scene as one of two eyes sees it: -1 the left, 1 the right.
    [[nodiscard]] static Scene seenBy(int eye, const Scene& scene, const Presentation& how, double focusMm);

private:
    struct Pictures
    {
        std::unique_ptr<QOpenGLFramebufferObject> drawn;     ///< with several samples per pixel
        std::unique_ptr<QOpenGLFramebufferObject> resolved;  ///< with one, for reading
    };

    QOpenGLShaderProgram m_program;
    QOpenGLVertexArrayObject m_nothing;
    std::array<Pictures, 2> m_eyes;
    int m_samples = 0;
};

}  // namespace ui::render
