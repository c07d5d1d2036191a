// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <QByteArray>
#include <QDataStream>
#include <QIODevice>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/tracking/CameraModel.h"
#include "core/tracking/Picture.h"
#include "core/tracking/Pose.h"
#include "core/tracking/TagCells.h"

/// Pictures of printed sheets as seen by a known camera, and the file formats that hold them.
namespace support {

/// Renders pictures of a flat print by ray casting with nine rays per pixel.
class PrintCamera
{
public:
    explicit PrintCamera(const core::tracking::CameraModel& model) : m_model(model)
    {
        for (int y = 0; y < model.height * kSide; ++y)
            for (int x = 0; x < model.width * kSide; ++x)
                m_directions.push_back(model.directionOf((glm::dvec2(x, y) + 0.5) / static_cast<double>(kSide)));
    }

    /// @param greyAt  grey level of the print at a place of its own frame, in mm: x right, y down, 0 in the middle
    template <class Print>
    [[nodiscard]] core::tracking::Picture take(const core::tracking::Pose& pose, Print&& greyAt) const
    {
        core::tracking::Picture picture;
        picture.width = m_model.width;
        picture.height = m_model.height;
        const glm::dvec3 normal = pose.rotation[2];
        const double offset = glm::dot(pose.positionMm, normal);
        const auto across = static_cast<std::size_t>(m_model.width) * kSide;
        for (std::size_t y = 0; y < static_cast<std::size_t>(m_model.height); ++y) {
            for (std::size_t x = 0; x < static_cast<std::size_t>(m_model.width); ++x) {
                double sum = 0.0;
                for (std::size_t n = 0; n < kSide * kSide; ++n) {
                    const glm::dvec3 ray(m_directions[(y * kSide + n / kSide) * across + x * kSide + n % kSide], 1.0);
                    const glm::dvec3 hit = ray * (offset / glm::dot(ray, normal)) - pose.positionMm;
                    sum += greyAt(glm::dvec2(glm::transpose(pose.rotation) * hit));
                }
                picture.pixels.push_back(static_cast<std::uint8_t>(std::lround(sum / (kSide * kSide))));
            }
        }
        return picture;
    }

private:
    static constexpr int kSide = 3;
    core::tracking::CameraModel m_model;
    std::vector<glm::dvec2> m_directions;
};

inline constexpr double kInk = 25.0;
inline constexpr double kPaper = 215.0;
inline constexpr double kBackground = 110.0;

/// A tag with its white border on a grey background.
struct TagPrint
{
    core::tracking::TagCells cells;
    double edgeMm = 50.0;

    double operator()(const glm::dvec2& mm) const
    {
        using core::tracking::kCellsASide;
        const glm::dvec2 cell = mm * (core::tracking::kEdgeCells / edgeMm) + 0.5 * kCellsASide;
        if (cell.x < 0.0 || cell.y < 0.0 || cell.x >= kCellsASide || cell.y >= kCellsASide)
            return kBackground;
        return cells.at(static_cast<std::size_t>(cell.y) * kCellsASide + static_cast<std::size_t>(cell.x)) ? kPaper
                                                                                                           : kInk;
    }
};

/// The board for calibration: 10 x 7 squares on white paper.
struct BoardPrint
{
    double operator()(const glm::dvec2& mm) const
    {
        constexpr double kSquareMm = 25.0;
        const glm::dvec2 square = mm / kSquareMm + glm::dvec2(5.0, 3.5);
        if (square.x < -1.0 || square.y < -1.0 || square.x >= 11.0 || square.y >= 8.0)
            return kBackground;
        if (square.x < 0.0 || square.y < 0.0 || square.x >= 10.0 || square.y >= 7.0)
            return kPaper;
        return (static_cast<int>(square.x) + static_cast<int>(square.y)) % 2 == 0 ? kInk : kPaper;
    }
};

[[nodiscard]] inline QByteArray pgmOf(const core::tracking::Picture& picture)
{
    return "P5\n" + QByteArray::number(picture.width) + ' ' + QByteArray::number(picture.height) + "\n255\n" +
           QByteArray(reinterpret_cast<const char*>(picture.pixels.data()),
                      static_cast<qsizetype>(picture.pixels.size()));
}

/// An uncompressed AVI file of 30 pictures a second: the header and the pictures. The width is a multiple of 4.
class Avi
{
public:
    Avi(int width, int height, int pictures) : m_width(width), m_height(height)
    {
        const int size = width * height * 3;
        const QByteArray main = numbers({33'333, size * 30, 0, 0, pictures, 0, 1, size, width, height, 0, 0, 0, 0});
        const QByteArray stream = "vidsDIB " + numbers({0, 0, 0, 1, 30, 0, pictures, size, -1, 0, 0, 0});
        const QByteArray format = numbers({40, width, height, 1 | 24 << 16, 0, size, 0, 0, 0, 0});
        const QByteArray lists =
            list("hdrl", chunk("avih", main) + list("strl", chunk("strh", stream) + chunk("strf", format)));
        const int movie = 4 + pictures * (size + 8);
        m_header = "RIFF" + numbers({4 + static_cast<int>(lists.size()) + 8 + movie}) + "AVI " + lists + "LIST" +
                   numbers({movie}) + "movi";
    }

    [[nodiscard]] const QByteArray& header() const { return m_header; }
    [[nodiscard]] QByteArray picture(const core::tracking::Picture& picture) const
    {
        QByteArray rows;
        for (int y = m_height - 1; y >= 0; --y)  // AVI stores the lowest row first
            for (int x = 0; x < m_width; ++x)
                rows.append(3, static_cast<char>(picture.pixels[static_cast<std::size_t>(y * m_width + x)]));
        return chunk("00db", rows);
    }

private:
    static QByteArray numbers(const QList<int>& values)
    {
        QByteArray bytes;
        QDataStream stream(&bytes, QIODevice::WriteOnly);
        stream.setByteOrder(QDataStream::LittleEndian);
        for (const int value : values)
            stream << static_cast<qint32>(value);
        return bytes;
    }
    static QByteArray chunk(const char* name, const QByteArray& bytes)
    {
        return name + numbers({static_cast<int>(bytes.size())}) + bytes;
    }
    static QByteArray list(const char* name, const QByteArray& bytes) { return chunk("LIST", name + bytes); }

    int m_width;
    int m_height;
    QByteArray m_header;
};

}  // namespace support
