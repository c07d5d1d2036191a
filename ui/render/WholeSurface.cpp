// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/WholeSurface.h"

#include <array>
#include <mutex>
#include <utility>

namespace ui::render {
namespace {

using AnatomyPointer = std::shared_ptr<const core::terrain::ToothAnatomy>;
using SurfacePointer = std::shared_ptr<const ToothSurface>;

/// The last surfaces, newest first: of the user's tooth, and of one that they view meanwhile.
struct LastSurfaces
{
    std::mutex mutex;
    std::array<SurfacePointer, 2> surfaces;
};

LastSurfaces& lastSurfaces()
{
    static LastSurfaces only;
    return only;
}

SurfacePointer found(const AnatomyPointer& anatomy)
{
    const std::lock_guard lock(lastSurfaces().mutex);
    for (const SurfacePointer& one : lastSurfaces().surfaces)
        if (one && one->anatomyPointer() == anatomy)
            return one;
    return nullptr;
}

SurfacePointer workedOut(const AnatomyPointer& anatomy, glm::vec3 towardsLight)
{
    if (SurfacePointer before = found(anatomy))
        return before;
    auto made = std::make_shared<const ToothSurface>(anatomy, towardsLight);
    const std::lock_guard lock(lastSurfaces().mutex);
    lastSurfaces().surfaces[1] = std::exchange(lastSurfaces().surfaces[0], made);
    return made;
}

}  // namespace

void workOutSurface(const AnatomyPointer& anatomy, glm::vec3 towardsLight)
{
    static_cast<void>(workedOut(anatomy, towardsLight));
}

std::unique_ptr<ToothSurface> wholeSurface(const AnatomyPointer& anatomy, glm::vec3 towardsLight)
{
    auto own = std::make_unique<ToothSurface>(*workedOut(anatomy, towardsLight));
    own->setLight(towardsLight);
    own->refresh();
    return own;
}

}  // namespace ui::render
