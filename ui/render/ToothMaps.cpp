// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/ToothMaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <QOpenGLPixelTransferOptions>

namespace ui::render {
bool TileBounds::mayFace(const glm::dvec3& eyeMm) const
{
    constexpr double kRightAngle = 1.5707963267948966;
    const glm::dvec3 low(box.low);
    const glm::dvec3 high(box.high);
    const glm::dvec3 towardsEye = eyeMm - 0.5 * (low + high);
    const double away = glm::length(towardsEye);
    const double radius = 0.5 * glm::length(high - low);
    if (away <= radius)
        return true;
    const double turned = std::acos(std::clamp(glm::dot(glm::dvec3(axis), towardsEye) / away, -1.0, 1.0));
    return turned < kRightAngle + static_cast<double>(spreadRad) + std::asin(radius / away) + 0.01;
}

QRect pixelsOf(const Box& box, const glm::dmat4& clipFromTooth, QSize size)
{
    const QRect all(QPoint(), size);
    glm::dvec2 low(std::numeric_limits<double>::max());
    glm::dvec2 high(std::numeric_limits<double>::lowest());
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 clip = clipFromTooth * glm::dvec4((corner & 1) != 0 ? box.high.x : box.low.x,
                                                           (corner & 2) != 0 ? box.high.y : box.low.y,
                                                           (corner & 4) != 0 ? box.high.z : box.low.z, 1.0);
        // The corner is beside or behind the eye, so the box may be anywhere on the screen.
        if (clip.w < 0.1)
            return all;
        const glm::dvec2 at = glm::dvec2(clip) / clip.w;
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    const auto pixel = [](double clip, int count) {
        return static_cast<int>(std::floor(std::clamp(0.5 + 0.5 * clip, -1.0, 2.0) * count));
    };
    const QPoint first(pixel(low.x, size.width()) - 1, pixel(low.y, size.height()) - 1);
    const QPoint last(pixel(high.x, size.width()) + 1, pixel(high.y, size.height()) + 1);
    return QRect(first, last).intersected(all);
}

ToothMaps::ToothMaps() = default;
ToothMaps::~ToothMaps() = default;

bool ToothMaps::initialize()
{
    if (!initializeOpenGLFunctions())
        return false;
    m_layout.create();
    m_triangles.create();
    return true;
}

void ToothMaps::setSurface(const ToothSurface& surface)
{
    const core::terrain::Grid& lattice = surface.lattice();
    if (!m_lattice || m_lattice->side != lattice.side) {
        const auto make = [&](Map& map, QOpenGLTexture::TextureFormat format, int bytesPerNode) {
            map.texture = std::make_unique<QOpenGLTexture>(QOpenGLTexture::Target2D);
            map.texture->setFormat(format);
            map.texture->setSize(lattice.side, lattice.side);
            map.texture->setMipLevels(1);
            map.texture->allocateStorage();
            map.texture->setMinMagFilters(QOpenGLTexture::Linear, QOpenGLTexture::Linear);
            map.texture->setWrapMode(QOpenGLTexture::ClampToEdge);
            map.bytesPerNode = bytesPerNode;
        };
        make(m_places, QOpenGLTexture::RG32F, 8);
        make(m_tops, QOpenGLTexture::R32F, 4);
        make(m_bottoms, QOpenGLTexture::R32F, 4);
        make(m_topNormals, QOpenGLTexture::RG16_SNorm, 4);
        make(m_bottomNormals, QOpenGLTexture::RG16_SNorm, 4);
        make(m_light, QOpenGLTexture::RGBA8_UNorm, 4);
        make(m_upperLayers, QOpenGLTexture::RGBA32F, 16);
        make(m_lowerLayers, QOpenGLTexture::RGBA32F, 16);
        make(m_ideal, QOpenGLTexture::RG32F, 8);
        make(m_blood, QOpenGLTexture::R8_UNorm, 1);
    }
    m_lattice = lattice;
    m_hasDecayZones = surface.anatomy().hasDecayZones;
    m_tilesPerSide = surface.tilesPerSide();

    const core::terrain::NodeRect all = wholeOf(lattice);
    write(m_upperLayers, surface.upperLayers().data(), QOpenGLTexture::RGBA, QOpenGLTexture::Float32, all);
    write(m_lowerLayers, surface.lowerLayers().data(), QOpenGLTexture::RGBA, QOpenGLTexture::Float32, all);
    writeIdeal(surface);
    const QOpenGLVertexArrayObject::Binder bound(&m_layout);
    m_triangles.bind();
    m_triangles.allocate(surface.indices().data(), static_cast<int>(surface.indices().size() * sizeof(std::uint32_t)));
    m_uploadedBytes += surface.indices().size() * sizeof(std::uint32_t);
    writeHeights(surface, all);
    writeNormals(surface, all);
    writeLight(surface, all);
    writeBlood(surface, all);
    m_tiles.assign(surface.indexCounts().size(), {});
    measureTiles(surface, all);
}

void ToothMaps::writeIdeal(const ToothSurface& surface)
{
    write(m_ideal, surface.ideal().data(), QOpenGLTexture::RG, QOpenGLTexture::Float32, wholeOf(*m_lattice));
}

void ToothMaps::update(const ToothSurface& surface, const ToothSurface::Changes& changes)
{
    if (!m_lattice)
        return;
    if (!changes.heights.isEmpty()) {
        writeHeights(surface, changes.heights);
        measureTiles(surface, changes.heights);
        const QOpenGLVertexArrayObject::Binder bound(&m_layout);
        m_triangles.bind();
        for (const ToothSurface::Stretch& stretch : changes.triangles) {
            const std::size_t bytes = (stretch.end - stretch.begin) * sizeof(std::uint32_t);
            m_triangles.write(static_cast<int>(stretch.begin * sizeof(std::uint32_t)),
                              surface.indices().data() + stretch.begin, static_cast<int>(bytes));
            m_uploadedBytes += bytes;
        }
    }
    if (!changes.normals.isEmpty())
        writeNormals(surface, changes.normals);
    if (!changes.light.isEmpty())
        writeLight(surface, changes.light);
    if (!changes.blood.isEmpty())
        writeBlood(surface, changes.blood);
}

void ToothMaps::write(Map& map, const void* nodes, QOpenGLTexture::PixelFormat format, QOpenGLTexture::PixelType type,
                      const core::terrain::NodeRect& rect)
{
    QOpenGLPixelTransferOptions rows;
    rows.setAlignment(1);
    rows.setRowLength(m_lattice->side);
    const auto first = static_cast<std::ptrdiff_t>(m_lattice->index(rect.beginI, rect.beginJ)) * map.bytesPerNode;
    map.texture->setData(rect.beginI, rect.beginJ, 0, rect.endI - rect.beginI, rect.endJ - rect.beginJ, 1, format, type,
                         static_cast<const std::byte*>(nodes) + first, &rows);
    m_uploadedBytes += static_cast<std::uint64_t>(rect.endI - rect.beginI) *
                       static_cast<std::uint64_t>(rect.endJ - rect.beginJ) *
                       static_cast<std::uint64_t>(map.bytesPerNode);
}

void ToothMaps::writeHeights(const ToothSurface& surface, const core::terrain::NodeRect& rect)
{
    write(m_places, surface.places().data(), QOpenGLTexture::RG, QOpenGLTexture::Float32, rect);
    write(m_tops, surface.tops().data(), QOpenGLTexture::Red, QOpenGLTexture::Float32, rect);
    write(m_bottoms, surface.bottoms().data(), QOpenGLTexture::Red, QOpenGLTexture::Float32, rect);
    m_shownTops.resize(m_lattice->count());
    for (int j = rect.beginJ; j < rect.endJ; ++j) {
        const auto first = static_cast<std::ptrdiff_t>(m_lattice->index(rect.beginI, j));
        std::copy_n(surface.tops().begin() + first, rect.endI - rect.beginI, m_shownTops.begin() + first);
    }
}

void ToothMaps::writeNormals(const ToothSurface& surface, const core::terrain::NodeRect& rect)
{
    write(m_topNormals, surface.topNormals().data(), QOpenGLTexture::RG, QOpenGLTexture::Int16, rect);
    write(m_bottomNormals, surface.bottomNormals().data(), QOpenGLTexture::RG, QOpenGLTexture::Int16, rect);
}

void ToothMaps::writeLight(const ToothSurface& surface, const core::terrain::NodeRect& rect)
{
    write(m_light, surface.light().data(), QOpenGLTexture::RGBA, QOpenGLTexture::UInt8, rect);
}

void ToothMaps::writeBlood(const ToothSurface& surface, const core::terrain::NodeRect& rect)
{
    write(m_blood, surface.blood().data(), QOpenGLTexture::Red, QOpenGLTexture::UInt8, rect);
}

TileBounds ToothMaps::boundsOf(const ToothSurface& surface, std::size_t tile, Side side)
{
    const bool upper = side == Side::Upper;
    const std::uint32_t* corners = surface.indices().data() + tile * ToothSurface::kTileIndices;
    const int count = surface.indexCounts()[tile];
    constexpr float kMost = std::numeric_limits<float>::max();
    TileBounds bounds{{glm::vec3(kMost), glm::vec3(-kMost)}};
    std::array<glm::vec3, ToothSurface::kTileIndices / 3> normals{};
    std::size_t found = 0;
    glm::vec3 sum(0.0F);
    for (int k = 0; k < count; k += 3) {
        std::array<glm::vec3, 3> at{};
        for (int c = 0; c < 3; ++c) {
            const std::uint32_t node = corners[k + c];
            at[static_cast<std::size_t>(c)] =
                glm::vec3(surface.places()[node], (upper ? surface.tops() : surface.bottoms())[node]);
            bounds.box = {glm::min(bounds.box.low, at[static_cast<std::size_t>(c)]),
                          glm::max(bounds.box.high, at[static_cast<std::size_t>(c)])};
        }
        const glm::vec3 across = glm::cross(at[1] - at[0], at[2] - at[0]) * (upper ? 1.0F : -1.0F);
        if (const float area = glm::length(across); area > 0.0F) {
            normals[found] = across / area;
            sum += normals[found++];
        }
    }
    if (const float length = glm::length(sum); length > 0.0F) {
        bounds.axis = sum / length;
        float nearest = 1.0F;
        for (std::size_t k = 0; k < found; ++k)
            nearest = std::min(nearest, glm::dot(bounds.axis, normals[k]));
        bounds.spreadRad = std::acos(std::clamp(nearest, -1.0F, 1.0F));
    }
    return bounds;
}

/// Computes the index counts and bounds of the tiles that a rectangle of nodes touches.
void ToothMaps::measureTiles(const ToothSurface& surface, const core::terrain::NodeRect& rect)
{
    constexpr int kCells = ToothSurface::kTileCells;
    const int lastX = std::min((rect.endI - 1) / kCells, m_tilesPerSide - 1);
    const int lastY = std::min((rect.endJ - 1) / kCells, m_tilesPerSide - 1);
    for (int y = std::max(0, rect.beginJ - 1) / kCells; y <= lastY; ++y) {
        for (int x = std::max(0, rect.beginI - 1) / kCells; x <= lastX; ++x) {
            const auto index = static_cast<std::size_t>(y * m_tilesPerSide + x);
            Tile& tile = m_tiles[index];
            tile.count = surface.indexCounts()[index];
            tile.mostCount = std::max(tile.mostCount, tile.count);
            tile.upper = boundsOf(surface, index, Side::Upper);
            tile.lower = boundsOf(surface, index, Side::Lower);
            if (tile.count > 0) {
                tile.lowestMm = std::min(tile.lowestMm, tile.lower.box.low.z);
                tile.highestMm = std::max(tile.highestMm, tile.upper.box.high.z);
            }
        }
    }
}

Box ToothMaps::boxOf(const core::terrain::NodeRect& rect) const
{
    constexpr int kCells = ToothSurface::kTileCells;
    const auto cell = static_cast<float>(m_lattice->cellMm);
    float low = std::numeric_limits<float>::max();
    float high = std::numeric_limits<float>::lowest();
    // Triangles extend to the neighbouring nodes.
    const core::terrain::NodeRect around = grown(rect, 1, *m_lattice);
    for (int j = around.beginJ; j < around.endJ; ++j) {
        for (int i = around.beginI; i < around.endI; ++i) {
            const float top = m_shownTops[m_lattice->index(i, j)];
            low = std::min(low, top);
            high = std::max(high, top);
        }
    }
    // Where a column is removed, its lower surface is removed as well.
    const int lastX = std::min((rect.endI - 1) / kCells, m_tilesPerSide - 1);
    const int lastY = std::min((rect.endJ - 1) / kCells, m_tilesPerSide - 1);
    for (int y = std::max(0, rect.beginJ - 1) / kCells; y <= lastY; ++y) {
        for (int x = std::max(0, rect.beginI - 1) / kCells; x <= lastX; ++x) {
            const Tile& tile = m_tiles[static_cast<std::size_t>(y * m_tilesPerSide + x)];
            if (tile.count < tile.mostCount) {
                low = std::min(low, tile.lowestMm);
                high = std::max(high, tile.highestMm);
            }
        }
    }
    // Nodes are drawn up to half a cell away from their position in the lattice.
    const glm::vec2 first = glm::vec2(m_lattice->nodeMm(rect.beginI, rect.beginJ)) - 1.5F * cell;
    const glm::vec2 last = glm::vec2(m_lattice->nodeMm(rect.endI - 1, rect.endJ - 1)) + 1.5F * cell;
    return {{first, std::min(low, high)}, {last, high}};
}

ToothMaps::Selection ToothMaps::select(Side side, const std::function<bool(const TileBounds&)>& isWanted) const
{
    constexpr int kCells = ToothSurface::kTileCells;
    Selection chosen;
    chosen.side = side;
    for (std::size_t index = 0; index < m_tiles.size(); ++index) {
        const Tile& tile = m_tiles[index];
        if (tile.count == 0 || !isWanted(side == Side::Upper ? tile.upper : tile.lower))
            continue;
        chosen.counts.push_back(tile.count);
        // OpenGL takes an offset into its own buffer as a pointer.
        const std::size_t bytes = index * ToothSurface::kTileIndices * sizeof(std::uint32_t);
        chosen.offsets.push_back(reinterpret_cast<const void*>(bytes));  // NOLINT(performance-no-int-to-ptr)
        const int x = static_cast<int>(index) % m_tilesPerSide;
        const int y = static_cast<int>(index) / m_tilesPerSide;
        chosen.nodes = chosen.nodes.united(QRect(x * kCells, y * kCells, kCells + 1, kCells + 1));
    }
    return chosen;
}

void ToothMaps::bind(QOpenGLShaderProgram& program, Side side)
{
    const bool upper = side == Side::Upper;
    const std::array<std::pair<const char*, Map*>, 8> maps{{{"places", &m_places},
                                                            {"heights", upper ? &m_tops : &m_bottoms},
                                                            {"normals", upper ? &m_topNormals : &m_bottomNormals},
                                                            {"light", &m_light},
                                                            {"upperLayers", &m_upperLayers},
                                                            {"lowerLayers", &m_lowerLayers},
                                                            {"ideal", &m_ideal},
                                                            {"blood", &m_blood}}};
    for (std::size_t unit = 0; unit < maps.size(); ++unit) {
        maps[unit].second->texture->bind(static_cast<uint>(unit));
        program.setUniformValue(maps[unit].first, static_cast<int>(unit));
    }
    glActiveTexture(GL_TEXTURE0);  // as Qt's painter expects
    program.setUniformValue("lattice", static_cast<float>(m_lattice->originMm.x),
                            static_cast<float>(m_lattice->originMm.y), static_cast<float>(1.0 / m_lattice->cellMm));
}

void ToothMaps::draw(const Selection& tiles)
{
    const QOpenGLVertexArrayObject::Binder bound(&m_layout);
    glMultiDrawElements(GL_TRIANGLES, tiles.counts.data(), GL_UNSIGNED_INT, tiles.offsets.data(),
                        static_cast<GLsizei>(tiles.counts.size()));
}

}  // namespace ui::render
