// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include <QOpenGLShaderProgram>
#include <QString>

namespace ui::render {

/// Compiles and links a program from two of our shaders; a context must be current. Returns false if the driver refuses
/// one, with the shader and the cause in `reason`.
/// @param vertex, fragment  file names without suffix
[[nodiscard]] bool buildProgram(QOpenGLShaderProgram& program, const char* vertex, const char* fragment,
                                QString& reason);

/// Sets a uniform of three floats in a program that is bound.
inline void setVector(QOpenGLShaderProgram& program, const char* name, glm::vec3 v)
{
    program.setUniformValue(name, v.x, v.y, v.z);
}

}  // namespace ui::render
