// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/TagCells.h"

#include <cstddef>
#include <cstdlib>

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>

namespace core::tracking {

TagCells cellsOf(int id)
{
    TagCells cells;
    cells.fill(true);
    apriltag_family_t* const family = tag36h11_create();
    image_u8_t* const image = apriltag_to_image(family, id);
    for (int y = 0; y < kCellsASide && y < image->height; ++y)
        for (int x = 0; x < kCellsASide && x < image->width; ++x)
            cells.at(static_cast<std::size_t>(y * kCellsASide + x)) = image->buf[y * image->stride + x] != 0;
    // Does the same as image_u8_destroy(), which is in a separate library.
    std::free(image->buf);
    std::free(image);
    tag36h11_destroy(family);
    return cells;
}

}  // namespace core::tracking
