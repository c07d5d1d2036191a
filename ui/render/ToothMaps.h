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

/// Where a tile of a surface is and where it looks.
struct TileBounds
{
    Box box;
    glm::vec3 axis{0.0F, 0.0F, 1.0F};  ///< mean normal of its triangles, unit vector
    float spreadRad = 4.0F;            ///< the furthest of them from it

    /// False only if an eye sees nothing but the backs of its triangles.
    [[nodiscard]] bool mayFace(const glm::dvec3& eyeMm) const;
};

/// The pixels, from the lower left, that a box may cover in a picture of this size.
[[nodiscard]] QRect pixelsOf(const Box& box, const glm::dmat4& clipFromTooth, QSize size);

/// A ToothSurface as OpenGL has it: its maps as textures, its triangles by tiles. The context given to initialize()
/// must be current in every call, the destructor included.
class ToothMaps : private QOpenGLFunctions_3_3_Core
{
public:
    enum class Side : std::uint8_t { Upper, Lower };

    ToothMaps();
    ~ToothMaps() override;

    /// False when the context has no OpenGL 3.3.
    [[nodiscard]] bool initialize();

    /// Uploads a whole surface in place of the one before.
    void setSurface(const ToothSurface& surface);
    /// Uploads what a refresh() of that surface changed, and nothing else.
    void update(const ToothSurface& surface, const ToothSurface::Changes& changes);
    [[nodiscard]] bool isEmpty() const { return !m_lattice; }
    /// Returns whether the decay of the tooth is soft, leathery and firm.
    [[nodiscard]] bool hasDecayZones() const { return m_hasDecayZones; }

    /// Where what is drawn of a rectangle of nodes lies, and, if part of that is gone, where it was.
    [[nodiscard]] Box boxOf(const core::terrain::NodeRect& rect) const;

    /// Tiles of one surface.
    struct Selection
    {
        Side side = Side::Upper;
        std::vector<int> counts;           ///< of their indices
        std::vector<const void*> offsets;  ///< of the first one, bytes
        QRect nodes;                       ///< around all of them, columns and rows of the lattice
    };
    /// Those that are wanted.
    [[nodiscard]] Selection select(Side side, const std::function<bool(const TileBounds&)>& isWanted) const;
    /// Sets the maps of one surface and its lattice in a program that is bound.
    void bind(QOpenGLShaderProgram& program, Side side);
    /// Draws tiles with the program for which bind() was called last: its vertices are lattice nodes, numbered row by
    /// row.
    void draw(const Selection& tiles);
    /// Nodes on a side of the lattice.
    [[nodiscard]] int side() const { return m_lattice ? m_lattice->side : 0; }

    /// Bytes of textures and buffers written so far.
    [[nodiscard]] std::uint64_t uploadedBytes() const { return m_uploadedBytes; }

private:
    struct Map
    {
        std::unique_ptr<QOpenGLTexture> texture;
        int bytesPerNode = 0;
    };
    struct Tile
    {
        int count = 0;  ///< of its indices
        TileBounds upper;
        TileBounds lower;
        // What it has ever been: what is gone must be painted over.
        int mostCount = 0;
        float lowestMm = std::numeric_limits<float>::max();
        float highestMm = std::numeric_limits<float>::lowest();
    };

    void write(Map& map, const void* nodes, QOpenGLTexture::PixelFormat format, QOpenGLTexture::PixelType type,
               const core::terrain::NodeRect& rect);
    void writeHeights(const ToothSurface& surface, const core::terrain::NodeRect& rect);
    void writeNormals(const ToothSurface& surface, const core::terrain::NodeRect& rect);
    void writeLight(const ToothSurface& surface, const core::terrain::NodeRect& rect);
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
    std::optional<core::terrain::Grid> m_lattice;
    bool m_hasDecayZones = false;
    int m_tilesPerSide = 0;
    std::vector<Tile> m_tiles;
    std::vector<float> m_shownTops;  ///< as they were uploaded
    std::uint64_t m_uploadedBytes = 0;
};

}  // namespace ui::render
