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

/// How two eyes get two pictures: not at all, by red and cyan glasses (in colours of little ghosting after Dubois 2001,
/// or in grey, which ghosts least), or as halves of one picture for a display that parts them.
enum class Stereo : std::uint8_t { Off, RedCyan, RedCyanGrey, SideBySide, TopBottom };

/// A colour of one surface as a picture for both eyes has it: what is painted over such a picture must match it.
[[nodiscard]] QColor seenAs(const QColor& colour, Stereo stereo);

/// "flat", "red-cyan" ...: as an attempt says what it was seen in.
[[nodiscard]] const char* idOf(Stereo stereo);

/// What becomes of a picture on its way to the screen.
struct Presentation
{
    Stereo stereo = Stereo::Off;
    double apart = 0.04;         ///< the two eyes, as a share of the distance to what is looked at
    double convergence = 1.0;    ///< what appears in the plane of the screen, as a share of that distance
    bool flipLeftRight = false;  ///< for a half-silvered mirror over the hand
    bool flipUpDown = false;     ///< for a screen that hangs upside down over it
    bool operator==(const Presentation&) const = default;
    [[nodiscard]] bool isPlain() const { return stereo == Stereo::Off && !flipLeftRight && !flipUpDown; }
};

/// Draws a scene as it is presented. The context given to initialize() must be current in every call, the destructor
/// included.
class Presenter : private QOpenGLFunctions_3_3_Core
{
public:
    /// False when a shader is refused; `reason` then says which.
    [[nodiscard]] bool initialize(QString& reason);

    /// Into the bound framebuffer, whole viewport.
    /// @param focusMm  distance from the eye to what is looked at
    /// @param samples  of each pixel of what is drawn aside, for smooth edges
    void draw(ToothRenderer& renderer, const Scene& scene, const Presentation& how, double focusMm, int samples);

    /// The scene as one of two eyes sees it: -1 the left, 1 the right.
    [[nodiscard]] static Scene seenBy(int eye, const Scene& scene, const Presentation& how, double focusMm);

private:
    struct Pictures
    {
        std::unique_ptr<QOpenGLFramebufferObject> drawn;     ///< of several samples a pixel
        std::unique_ptr<QOpenGLFramebufferObject> resolved;  ///< of one, to be read
    };

    QOpenGLShaderProgram m_program;
    QOpenGLVertexArrayObject m_nothing;
    std::array<Pictures, 2> m_eyes;
    int m_samples = 0;
};

}  // namespace ui::render
