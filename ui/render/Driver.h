// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QSurfaceFormat>

namespace ui::render {

/// What our widgets draw with: OpenGL 3.3 core, depth, four samples a pixel.
[[nodiscard]] QSurfaceFormat wantedFormat();

/// What this computer draws with. Asked once: it cannot change while we run.
struct Driver
{
    bool hasOpenGl33 = false;
    QString name;             ///< as it calls itself
    bool isSoftware = false;  ///< every sample of every pixel costs processor time
};
[[nodiscard]] const Driver& driver();

}  // namespace ui::render
