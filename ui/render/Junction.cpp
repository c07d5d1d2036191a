// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/Junction.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace ui::render {
namespace {

constexpr float kAloneMm = 0.5F;      ///< thickness of enamel below a column in a tooth without dentin
constexpr float kLeastMm = 0.06F;     ///< least difference on either side of the line: avoids specks on level ground
constexpr float kBlurMm = 0.35F;      ///< along the line
constexpr float kKeepsToLine = 4.0F;  ///< distance from the line over which the junction follows it, nodes
constexpr float kSteepestMm = 0.4F;  ///< height between a crossing's two columns at which its weight falls to a quarter
constexpr int kRounds = 5;

/// A crossing between a column with dentin and one without.
struct Crossing
{
    glm::vec2 node;
    float low;
    float high;
    float heightMm;
};

float squareTo(const Crossing& crossing, glm::vec2 node)
{
    const glm::vec2 to = crossing.node - node;
    return glm::dot(to, to);
}

/// Returns the weighted mean height of the line near a node.
float heightAt(const std::vector<Crossing>& line, glm::vec2 node, float blurNodes, float nearest2)
{
    float sum = 0.0F;
    float weights = 0.0F;
    for (const Crossing& crossing : line) {
        const float further = (squareTo(crossing, node) - nearest2) / (2.0F * blurNodes * blurNodes);
        if (further > 12.0F)
            continue;
        const float apart = kSteepestMm + crossing.high - crossing.low;
        const float weight = std::exp(-further) / (apart * apart);
        sum += weight * crossing.heightMm;
        weights += weight;
    }
    return sum / weights;
}

}  // namespace

std::vector<float> drawnJunction(const core::terrain::Grid& lattice, const std::vector<float>& tops,
                                 const std::vector<float>& bottoms, std::vector<float> junction)
{
    const int side = lattice.side;
    const float blurNodes = kBlurMm / static_cast<float>(lattice.cellMm);
    const auto isSolid = [&](std::size_t k) { return tops[k] > bottoms[k]; };
    std::vector<Crossing> line;
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const std::size_t k = lattice.index(i, j);
            if (!isSolid(k) || junction[k] > bottoms[k])
                continue;
            constexpr std::array<std::array<int, 2>, 4> kSteps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
            for (const auto& [di, dj] : kSteps) {
                if (!lattice.contains(i + di, j + dj))
                    continue;
                const std::size_t n = lattice.index(i + di, j + dj);
                if (!isSolid(n) || junction[n] <= bottoms[n])
                    continue;
                const float high = std::max(bottoms[n], bottoms[k]);
                line.push_back(
                    {glm::vec2(i, j) + 0.5F * glm::vec2(di, dj), bottoms[n], high, 0.5F * (bottoms[n] + high)});
            }
        }
    }
    // Smooths the line as far as possible while it stays between the two columns of each crossing.
    std::vector<float> even(line.size());
    for (int round = 0; round < kRounds; ++round) {
        for (std::size_t c = 0; c < line.size(); ++c)
            even[c] = heightAt(line, line[c].node, blurNodes, 0.0F);
        for (std::size_t c = 0; c < line.size(); ++c)
            line[c].heightMm = std::clamp(even[c], line[c].low, line[c].high);
    }
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const std::size_t k = lattice.index(i, j);
            if (!isSolid(k))
                continue;
            const bool isAlone = junction[k] <= bottoms[k];
            float nearest2 = 1.0e9F;
            for (const Crossing& crossing : line)
                nearest2 = std::min(nearest2, squareTo(crossing, {i, j}));
            const float keeps = glm::smoothstep(kKeepsToLine, 1.0F, std::sqrt(nearest2));
            if (line.empty()) {
                if (isAlone)
                    junction[k] = bottoms[k] - kAloneMm;
            } else if (isAlone) {
                junction[k] = std::min(heightAt(line, {i, j}, blurNodes, nearest2), bottoms[k] - kLeastMm);
            } else if (keeps > 0.0F) {
                const float height = heightAt(line, {i, j}, blurNodes, nearest2);
                junction[k] = std::max(glm::mix(junction[k], height, keeps), bottoms[k] + kLeastMm);
            }
        }
    }
    return junction;
}

}  // namespace ui::render
