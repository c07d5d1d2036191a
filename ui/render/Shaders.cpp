// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/Shaders.h"

namespace ui::render {

bool buildProgram(QOpenGLShaderProgram& program, const char* vertex, const char* fragment, QString& reason)
{
    const auto file = [](const char* name, const char* ending) {
        return QStringLiteral(":/render/") + QLatin1String(name) + QLatin1String(ending);
    };
    const bool built = program.addShaderFromSourceFile(QOpenGLShader::Vertex, file(vertex, ".vert")) &&
                       program.addShaderFromSourceFile(QOpenGLShader::Fragment, file(fragment, ".frag")) &&
                       program.link();
    if (!built)
        reason = QStringLiteral("shader '%1': %2").arg(QLatin1String(fragment), program.log());
    return built;
}

}  // namespace ui::render
