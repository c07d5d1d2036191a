// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include <QOpenGLShaderProgram>
#include <QString>

namespace ui::render {

/// Compiles and links a program from two of our shaders; a context must be current. False when the driver refuses one;
/// `reason` then says which and why.
/// @param vertex, fragment  file names without their ending
[[nodiscard]] bool buildProgram(QOpenGLShaderProgram& program, const char* vertex, const char* fragment,
                                QString& reason);

/// Sets a uniform of three floats in a program that is bound.
inline void setVector(QOpenGLShaderProgram& program, const char* name, glm::vec3 v)
{
    program.setUniformValue(name, v.x, v.y, v.z);
}

}  // namespace ui::render
