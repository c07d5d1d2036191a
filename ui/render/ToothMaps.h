// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <QOpenGLBuffer>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <QOpenGLTexture>
#include <QOpenGLVertexArrayObject>
#include <QRect>

#include "ui/render/ToothSurface.h"

namespace ui::render {

/// A box along the axes of the tooth frame, mm.
struct Box
{
    glm::vec3 low{0.0F};
    glm::vec3 high{0.0F};
};

/// The position and orientation of a tile of a surface.
struct TileBounds
{
    Box box;
    glm::vec3 axis{0.0F, 0.0F, 1.0F};  ///< mean normal of its triangles, unit vector
    float spreadRad = 4.0F;            ///< largest angle of a normal to `axis`

    /// Returns false only if an eye sees nothing but the backs of its triangles.
    [[nodiscard]] bool mayFace(const glm::dvec3& eyeMm) const;
};

/// Returns the pixels, from the lower left, that a box may cover in a picture of this size.
[[nodiscard]] QRect pixelsOf(const Box& box, const glm::dmat4& clipFromTooth, QSize size);

/// The OpenGL data of a ToothSurface: its maps as textures, and its triangles in tiles. The context of initialize()
/// must be current in every call, including the destructor.
class ToothMaps : private QOpenGLFunctions_3_3_Core
{
public:
    enum class Side : std::uint8_t { Upper, Lower };

    ToothMaps();
    ~ToothMaps() override;

    /// Returns false if the context has no OpenGL 3.3.
    [[nodiscard]] bool initialize();

    /// Uploads a whole surface, which replaces the previous one.
    void setSurface(const ToothSurface& surface);
    /// Uploads only the parts that a refresh() of that surface has changed.
    void update(const ToothSurface& surface, const ToothSurface::Changes& changes);
    [[nodiscard]] bool isEmpty() const { return !m_lattice; }
    /// Returns whether the decay of the tooth has soft, leathery and firm zones.
    [[nodiscard]] bool hasDecayZones() const { return m_hasDecayZones; }

    /// Returns the bounding box of a rectangle of nodes as drawn. It includes material that was drawn there before and
    /// has been cut away.
    [[nodiscard]] Box boxOf(const core::terrain::NodeRect& rect) const;

    /// Tiles of one surface.
    struct Selection
    {
        Side side = Side::Upper;
        std::vector<int> counts;           ///< number of indices of each tile
        std::vector<const void*> offsets;  ///< byte offset of the first index of each tile
        QRect nodes;                       ///< bounds of all tiles, columns and rows of the lattice
    };
    /// Returns the tiles that fulfil a condition.
    [[nodiscard]] Selection select(Side side, const std::function<bool(const TileBounds&)>& isWanted) const;
    /// Sets the maps and the lattice of one surface in a bound program.
    void bind(QOpenGLShaderProgram& program, Side side);
    /// Draws tiles with the program of the last bind(). Its vertices are lattice nodes, numbered row by row.
    void draw(const Selection& tiles);
    /// Returns the number of nodes on a side of the lattice.
    [[nodiscard]] int side() const { return m_lattice ? m_lattice->side : 0; }

    /// Returns the number of bytes written to textures and buffers so far.
    [[nodiscard]] std::uint64_t uploadedBytes() const { return m_uploadedBytes; }

private:
    struct Map
    {
        std::unique_ptr<QOpenGLTexture> texture;
        int bytesPerNode = 0;
    };
    struct Tile
    {
        int count = 0;  ///< number of indices
        TileBounds upper;
        TileBounds lower;
        // The largest count so far, because removed parts must be painted over.
        int mostCount = 0;
        float lowestMm = std::numeric_limits<float>::max();
        float highestMm = std::numeric_limits<float>::lowest();
    };

    void write(Map& map, const void* nodes, QOpenGLTexture::PixelFormat format, QOpenGLTexture::PixelType type,
               const core::terrain::NodeRect& rect);
    void writeHeights(const ToothSurface& surface, const core::terrain::NodeRect& rect);
    void writeNormals(const ToothSurface& surface, const core::terrain::NodeRect& rect);
    void writeLight(const ToothSurface& surface, const core::terrain::NodeRect& rect);
    void writeBlood(const ToothSurface& surface, const core::terrain::NodeRect& rect);
    void writeIdeal(const ToothSurface& surface);
    [[nodiscard]] static TileBounds boundsOf(const ToothSurface& surface, std::size_t tile, Side side);
    void measureTiles(const ToothSurface& surface, const core::terrain::NodeRect& rect);

    QOpenGLVertexArrayObject m_layout;
    QOpenGLBuffer m_triangles{QOpenGLBuffer::IndexBuffer};
    Map m_places;
    Map m_tops;
    Map m_bottoms;
    Map m_topNormals;
    Map m_bottomNormals;
    Map m_light;
    Map m_upperLayers;
    Map m_lowerLayers;
    Map m_ideal;
    Map m_blood;
    std::optional<core::terrain::Grid> m_lattice;
    bool m_hasDecayZones = false;
    int m_tilesPerSide = 0;
    std::vector<Tile> m_tiles;
    std::vector<float> m_shownTops;  ///< top heights as last uploaded
    std::uint64_t m_uploadedBytes = 0;
};

}  // namespace ui::render
