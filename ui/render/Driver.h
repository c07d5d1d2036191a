// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QSurfaceFormat>

namespace ui::render {

/// Returns the surface format that the program's widgets use: OpenGL 3.3 core, depth, four samples per pixel.
[[nodiscard]] QSurfaceFormat wantedFormat();

/// The OpenGL driver of this computer. Queried once, because it cannot change while the program runs.
struct Driver
{
    bool hasOpenGl33 = false;
    QString name;             ///< as the driver reports it
    bool isSoftware = false;  ///< every sample of every pixel costs processor time
};
[[nodiscard]] const Driver& driver();

}  // namespace ui::render
