// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/TagScene.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "core/base/Rng.h"
#include "core/tracking/TagCells.h"

namespace lab {
namespace {

using core::tracking::CameraModel;
using core::tracking::kCellsASide;
using core::tracking::kEdgeCells;
using core::tracking::Picture;

constexpr float kPaper = 200.0F;
constexpr float kInk = 30.0F;
constexpr float kWall = 120.0F;  ///< behind a tag without clutter
constexpr int kRaysASide = 5;
constexpr int kNormals = 4096;
constexpr double kBlurReach = 4.0;  ///< of the kernel, standard deviations

struct Box
{
    int left = 0;
    int top = 0;
    int right = 0;  ///< one beyond the last column
    int bottom = 0;
};

/// Brightness of each pixel, without noise.
struct Canvas
{
    int width = 0;
    int height = 0;
    std::vector<float> light;

    Canvas(int w, int h, float grey)
        : width(w), height(h), light(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), grey)
    {}
    float& at(int x, int y)
    {
        return light[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
    [[nodiscard]] float clamped(int x, int y) const
    {
        return light[static_cast<std::size_t>(std::clamp(y, 0, height - 1)) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(std::clamp(x, 0, width - 1))];
    }
};

/// Fills a parallelogram around a centre.
void fill(Canvas& canvas, const glm::dvec2& centre, const glm::dvec2& along, const glm::dvec2& across, float grey)
{
    const double area = along.x * across.y - along.y * across.x;
    if (std::abs(area) < 1.0)
        return;
    const glm::dvec2 reach = glm::abs(along) + glm::abs(across);
    const glm::dvec2 high = glm::min(centre + reach, glm::dvec2(canvas.width - 1, canvas.height - 1));
    const glm::ivec2 first(glm::max(glm::floor(centre - reach), glm::dvec2(0.0)));
    for (int y = first.y; y <= static_cast<int>(high.y); ++y)
        for (int x = first.x; x <= static_cast<int>(high.x); ++x) {
            const glm::dvec2 d = glm::dvec2(x, y) - centre;
            if (std::abs(d.x * across.y - d.y * across.x) <= std::abs(area) &&
                std::abs(along.x * d.y - along.y * d.x) <= std::abs(area))
                canvas.at(x, y) = grey;
        }
}

glm::dvec2 turned(double rad, double length)
{
    return length * glm::dvec2(std::cos(rad), std::sin(rad));
}

/// Draws a dark frame with patches, which the search for tags must examine.
void drawPatches(Canvas& canvas, core::Rng& rng, const glm::dvec2& at)
{
    const double turn = rng.uniform(0.0, 3.2);
    const double half = rng.uniform(8.0, 90.0);
    const double slant = turn + rng.uniform(1.2, 1.9);
    const double height = half * rng.uniform(0.6, 1.0);
    fill(canvas, at, turned(turn, half * 1.3), turned(slant, height * 1.3), static_cast<float>(rng.uniform(150, 240)));
    fill(canvas, at, turned(turn, half), turned(slant, height), static_cast<float>(rng.uniform(5, 80)));
    for (int n = rng.below(30); n > 0; --n)
        fill(canvas, at + turned(turn, half * rng.uniform(-0.7, 0.7)) + turned(slant, height * rng.uniform(-0.7, 0.7)),
             turned(turn, half * rng.uniform(0.05, 0.2)), turned(slant, height * rng.uniform(0.05, 0.2)),
             static_cast<float>(rng.uniform(0, 240)));
}

/// Draws short dark strokes in rows, like print.
void drawLetters(Canvas& canvas, core::Rng& rng, const glm::dvec2& at)
{
    const double size = rng.uniform(3.0, 14.0);
    const glm::dvec2 row = turned(rng.uniform(-0.3, 0.3), 1.0);
    const glm::dvec2 down(-row.y, row.x);
    for (int line = 0; line < 5; ++line)
        for (int n = 0; n < 14; ++n) {
            const glm::dvec2 corner = at + row * (size * 1.4 * n) + down * (size * 2.0 * line);
            const double turn = rng.uniform(0.0, 3.2);
            fill(canvas, corner, turned(turn, size * 0.5), turned(turn + 1.57, size * 0.12 + 0.6),
                 static_cast<float>(rng.uniform(10, 70)));
        }
}

void drawClutter(Canvas& canvas, std::uint64_t seed)
{
    core::Rng rng(seed);
    const auto place = [&] { return glm::dvec2(rng.uniform(0.0, canvas.width), rng.uniform(0.0, canvas.height)); };
    const auto grey = [&] { return static_cast<float>(rng.uniform(10.0, 245.0)); };
    for (int n = 0; n < 6; ++n) {  // walls, doors, a table
        const double turn = rng.uniform(-0.2, 0.2);
        fill(canvas, place(), turned(turn, rng.uniform(60, 400)),
             turned(turn + rng.uniform(1.4, 1.7), rng.uniform(60, 300)), grey());
    }
    for (int n = 0; n < 12; ++n)
        drawPatches(canvas, rng, place());
    for (int n = 0; n < 3; ++n)
        drawLetters(canvas, rng, place());
    for (int n = 0; n < 20; ++n) {  // long bars, like shelves and cables
        const double turn = rng.uniform(0.0, 3.2);
        fill(canvas, place(), turned(turn, rng.uniform(20, 200)), turned(turn + 1.57, rng.uniform(0.6, 4.0)), grey());
    }
}

std::vector<float> gauss(double sigma)
{
    const int reach = std::max(1, static_cast<int>(std::ceil(kBlurReach * sigma)));
    std::vector<float> kernel;
    float sum = 0.0F;
    for (int n = -reach; n <= reach; ++n) {
        kernel.push_back(static_cast<float>(std::exp(-0.5 * n * n / std::max(1e-6, sigma * sigma))));
        sum += kernel.back();
    }
    for (float& weight : kernel)
        weight /= sum;
    return kernel;
}

/// Replaces each pixel of a box by the weighted mean of its neighbours in steps of `step`.
void blur(Canvas& canvas, const Box& box, const std::vector<float>& kernel, const glm::ivec2& step)
{
    const Canvas before = canvas;
    const int reach = static_cast<int>(kernel.size()) / 2;
    for (int y = box.top; y < box.bottom; ++y)
        for (int x = box.left; x < box.right; ++x) {
            float sum = 0.0F;
            for (int n = -reach; n <= reach; ++n)
                sum += kernel[static_cast<std::size_t>(n + reach)] * before.clamped(x + n * step.x, y + n * step.y);
            canvas.at(x, y) = sum;
        }
}

/// Replaces each pixel of a box by the mean along a way through it.
void smear(Canvas& canvas, const Box& box, const glm::dvec2& wayPx)
{
    const Canvas before = canvas;
    const int steps = 2 * static_cast<int>(std::ceil(glm::length(wayPx))) + 1;
    for (int y = box.top; y < box.bottom; ++y)
        for (int x = box.left; x < box.right; ++x) {
            double sum = 0.0;
            for (int n = 0; n < steps; ++n) {
                const glm::dvec2 at = glm::dvec2(x, y) + wayPx * ((n + 0.5) / steps - 0.5);
                const glm::dvec2 low = glm::floor(at);
                const glm::dvec2 share = at - low;
                const int left = static_cast<int>(low.x);
                const int top = static_cast<int>(low.y);
                const auto value = [&](int dx, int dy) {
                    return static_cast<double>(before.clamped(left + dx, top + dy));
                };
                sum += glm::mix(glm::mix(value(0, 0), value(1, 0), share.x),
                                glm::mix(value(0, 1), value(1, 1), share.x), share.y);
            }
            canvas.at(x, y) = static_cast<float>(sum / steps);
        }
}

/// A card as met by a ray: print, paper, or nothing.
class Card
{
public:
    explicit Card(const PrintedTag& tag)
        : m_cells(core::tracking::cellsOf(tag.id)), m_cellMm(tag.edgeMm / kEdgeCells),
          m_halfMm(0.5 * kCellsASide * m_cellMm + tag.marginMm), m_toTag(glm::transpose(tag.pose.rotation)),
          m_eye(-(m_toTag * tag.pose.positionMm))
    {}

    /// Adds the brightness that a ray meets to a sum, if it meets the card.
    bool meets(const glm::dvec2& direction, float& sum) const
    {
        const glm::dvec3 ray = m_toTag * glm::dvec3(direction, 1.0);
        if (ray.z <= 0.0)  // it would meet the back of the card
            return false;
        const double far = -m_eye.z / ray.z;
        const double x = m_eye.x + far * ray.x;
        const double y = m_eye.y + far * ray.y;
        if (std::abs(x) > m_halfMm || std::abs(y) > m_halfMm)
            return false;
        const int column = static_cast<int>(std::floor(x / m_cellMm + 0.5 * kCellsASide));
        const int row = static_cast<int>(std::floor(y / m_cellMm + 0.5 * kCellsASide));
        const bool isPaper = column < 0 || row < 0 || column >= kCellsASide || row >= kCellsASide ||
                             m_cells[static_cast<std::size_t>(row * kCellsASide + column)];
        sum += isPaper ? kPaper : kInk;
        return true;
    }
    [[nodiscard]] double halfMm() const { return m_halfMm; }

private:
    core::tracking::TagCells m_cells;
    double m_cellMm;
    double m_halfMm;
    glm::dmat3 m_toTag;
    glm::dvec3 m_eye;
};

std::array<glm::dvec2, 4> squarePx(const core::tracking::Pose& pose, double half, const CameraModel& camera)
{
    const std::array<glm::dvec2, 4> corners{{{-half, half}, {half, half}, {half, -half}, {-half, -half}}};
    std::array<glm::dvec2, 4> seen{};
    for (std::size_t n = 0; n < seen.size(); ++n)
        seen[n] = camera.pixelOf(pose.positionMm + pose.rotation * glm::dvec3(corners[n], 0.0));
    return seen;
}

/// Returns the box of the pixels that a card and its blur reach.
Box boxOf(const PrintedTag& tag, double halfMm, const TagScene& scene)
{
    const auto corners = squarePx(tag.pose, halfMm, scene.camera);
    glm::dvec2 low = corners[0];
    glm::dvec2 high = corners[0];
    for (const glm::dvec2& corner : corners) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    const glm::dvec2 reach = 0.5 * glm::abs(scene.motionPx) + kBlurReach * scene.blurPx + 2.0;
    const auto within = [](double value, int most) { return static_cast<int>(std::clamp<double>(value, 0.0, most)); };
    return {within(std::floor(low.x - reach.x), scene.camera.width),
            within(std::floor(low.y - reach.y), scene.camera.height),
            within(std::ceil(high.x + reach.x), scene.camera.width),
            within(std::ceil(high.y + reach.y), scene.camera.height)};
}

void drawTag(Canvas& canvas, const PrintedTag& tag, const TagScene& scene)
{
    const Card card(tag);
    const Box box = boxOf(tag, card.halfMm(), scene);
    // Directions of the corners of the pixels of two rows: between them they are nearly linear.
    const auto rowOf = [&](int y) {
        std::vector<glm::dvec2> row;
        for (int x = box.left; x <= box.right; ++x)
            row.push_back(scene.camera.directionOf({x, y}));
        return row;
    };
    std::vector<glm::dvec2> above = rowOf(box.top);
    for (int y = box.top; y < box.bottom; ++y) {
        std::vector<glm::dvec2> below = rowOf(y + 1);
        for (int x = box.left; x < box.right; ++x) {
            const auto k = static_cast<std::size_t>(x - box.left);
            float sum = 0.0F;
            int met = 0;
            for (int ray = 0; ray < kRaysASide * kRaysASide; ++ray) {
                const int column = ray % kRaysASide;
                const int row = ray / kRaysASide;
                const double right = (column + 0.5) / kRaysASide;
                const double down = (row + 0.5) / kRaysASide;
                const glm::dvec2 direction =
                    glm::mix(glm::mix(above[k], above[k + 1], right), glm::mix(below[k], below[k + 1], right), down);
                met += card.meets(direction, sum) ? 1 : 0;
            }
            constexpr int kRays = kRaysASide * kRaysASide;
            float& pixel = canvas.at(x, y);
            pixel = (sum + static_cast<float>(kRays - met) * pixel) / kRays;
        }
        above.swap(below);
    }
    if (scene.motionPx != glm::dvec2(0.0))
        smear(canvas, box, scene.motionPx);
    if (scene.blurPx > 0.0) {
        const auto kernel = gauss(scene.blurPx);
        blur(canvas, box, kernel, {1, 0});
        blur(canvas, box, kernel, {0, 1});
    }
}

/// Adds light and noise, and rounds to whole grey levels.
void expose(const Canvas& canvas, const TagScene& scene, Picture& picture)
{
    core::Rng rng(scene.grain);
    std::array<float, kNormals> normals{};
    for (float& normal : normals)
        normal = static_cast<float>(scene.noise * rng.normal());
    std::vector<float> light;
    light.reserve(static_cast<std::size_t>(canvas.width));
    for (int x = 0; x < canvas.width; ++x)
        light.push_back(static_cast<float>(1.0 - scene.lightFall * x / canvas.width));
    std::uint64_t random = 0;
    std::size_t k = 0;
    for (int y = 0; y < canvas.height; ++y)
        for (int x = 0; x < canvas.width; ++x, ++k) {
            random = k % 5 == 0 ? rng.next() : random / kNormals;
            const float grey = canvas.light[k] * light[static_cast<std::size_t>(x)] + normals[random % kNormals];
            picture.pixels[k] = static_cast<std::uint8_t>(std::clamp(grey + 0.5F, 0.0F, 255.0F));
        }
}

}  // namespace

Picture render(const TagScene& scene)
{
    const int width = scene.camera.width;
    const int height = scene.camera.height;
    Canvas canvas(width, height, kWall);
    if (scene.hasClutter)
        drawClutter(canvas, scene.clutter);
    if (scene.tag)
        drawTag(canvas, *scene.tag, scene);
    Picture picture;
    picture.width = width;
    picture.height = height;
    picture.pixels.resize(canvas.light.size());
    expose(canvas, scene, picture);
    return picture;
}

std::array<glm::dvec2, 4> cornersOf(const PrintedTag& tag, const CameraModel& camera)
{
    return squarePx(tag.pose, 0.5 * tag.edgeMm, camera);
}

double edgePxOf(const PrintedTag& tag, const CameraModel& camera)
{
    const auto corners = cornersOf(tag, camera);
    double sum = 0.0;
    for (std::size_t n = 0; n < corners.size(); ++n)
        sum += glm::distance(corners[n], corners[(n + 1) % corners.size()]);
    return sum / static_cast<double>(corners.size());
}

core::tracking::Pose facing(const glm::dvec3& positionMm, double yawDeg, double pitchDeg, double rollDeg)
{
    const glm::dquat yaw = glm::angleAxis(glm::radians(yawDeg), glm::dvec3(0.0, 1.0, 0.0));
    const glm::dquat pitch = glm::angleAxis(glm::radians(pitchDeg), glm::dvec3(1.0, 0.0, 0.0));
    const glm::dquat roll = glm::angleAxis(glm::radians(rollDeg), glm::dvec3(0.0, 0.0, 1.0));
    return {positionMm, glm::mat3_cast(yaw * pitch * roll)};
}

double tiltDeg(const core::tracking::Pose& pose)
{
    const double cosine = glm::dot(pose.rotation[2], glm::normalize(pose.positionMm));
    return glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
}

}  // namespace lab
