// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/tracking/Picture.h"
#include "core/tracking/Tag.h"

namespace core::tracking {

/// Returns whether this program was built with AprilTag and OpenCV. Without them no tag is found.
[[nodiscard]] bool hasTagDetector() noexcept;

/// Finds tags of the family 36h11 in grey pictures, by AprilTag 3. One thread at a time.
class TagDetector
{
public:
    /// @param id  the only tag that is reported; empty: all of the family
    explicit TagDetector(std::optional<int> id);
    ~TagDetector();
    TagDetector(const TagDetector&) = delete;
    TagDetector& operator=(const TagDetector&) = delete;

    /// Rectangle of a picture, pixels.
    struct Region
    {
        int x = 0;
        int y = 0;
        int width = 0;
        int height = 0;
    };
    struct Effort
    {
        /// Only every n-th pixel of every n-th row is searched for squares; the edges of those found are fitted in the
        /// full picture. Finds edges from about 12 n pixels on.
        int decimation = 2;
        bool refinesEdges = true;
    };

    /// Returns the tags within a region, with corners in pixels of the whole picture. Does not find a tag that the
    /// border of the region cuts, nor one whose white border is mostly beyond it.
    [[nodiscard]] std::vector<SeenTag> find(const PictureView& picture, const Region& region, const Effort& effort);
    [[nodiscard]] std::vector<SeenTag> find(const PictureView& picture, const Effort& effort)
    {
        return find(picture, {0, 0, picture.width, picture.height}, effort);
    }

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
    std::optional<int> m_id;
};

}  // namespace core::tracking
