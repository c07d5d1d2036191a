// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include <QOpenGLShaderProgram>
#include <QString>

namespace ui::render {

/// Compiles and links a program from two of the program's shaders. A context must be current. Returns false if the
/// driver rejects one, and writes the shader and the cause to `reason`.
/// @param vertex, fragment  file names without suffix
[[nodiscard]] bool buildProgram(QOpenGLShaderProgram& program, const char* vertex, const char* fragment,
                                QString& reason);

/// Sets a uniform of three floats. The program must be bound.
inline void setVector(QOpenGLShaderProgram& program, const char* name, glm::vec3 v)
{
    program.setUniformValue(name, v.x, v.y, v.z);
}

}  // namespace ui::render
