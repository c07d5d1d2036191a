// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/ToothGenerator.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/Rng.h"
#include "core/teeth/AnteriorCrown.h"
#include "core/teeth/MeshBuilder.h"
#include "core/teeth/Roots.h"
#include "core/teeth/ToothTable.h"

namespace core::teeth {
namespace {

/// Returns a random value with the mean and deviation of the table, limited to two standard deviations. Teeth beyond
/// that are rare and look wrong in a trainer.
double draw(Rng& rng, double mean, double deviation)
{
    return mean + deviation * std::clamp(rng.normal(), -2.0, 2.0);
}

/// Sizes and form have their own random streams, so that either can be drawn without the other.
constexpr std::uint64_t kSizesStream = 1;
constexpr std::uint64_t kFormStream = 2;

Rng seeded(int fdi, std::uint64_t seed, std::uint64_t stream)
{
    Rng mixer(seed);
    return Rng(mixer.next() + 1000U * static_cast<std::uint64_t>(fdi) + stream);
}

/// Draws slow waves that bend grooves and ridges away from the lines of the design.
std::vector<OcclusalField::Wave> drawWander(Rng& rng)
{
    std::vector<OcclusalField::Wave> waves;
    for (const double waveMm : {5.5, 3.6, 2.6, 1.9}) {
        const double angle = rng.uniform(0.0, 2.0 * std::numbers::pi);
        const double wave = 2.0 * std::numbers::pi / waveMm;
        const glm::dvec2 along{std::cos(angle), std::sin(angle)};
        // A transverse wave bends lines and preserves areas.
        waves.push_back(
            {along * wave, rng.uniform(0.0, 2.0 * std::numbers::pi), glm::dvec2{-along.y, along.x} * (0.035 * waveMm)});
    }
    return waves;
}

void varyDesign(AnteriorDesign& design, Rng& rng)
{
    for (Curve* curve : {&design.mesialX, &design.distalX, &design.labialY, &design.lingualY})
        for (double& value : *curve)
            value += 0.04 * std::clamp(rng.normal(), -2.0, 2.0);
    for (double* depth :
         {&design.fossaMm, &design.lingualRidgeMm, &design.labialRidgeMm, &design.labialGrooveMm, &design.pitMm})
        *depth *= draw(rng, 1.0, 0.2);
    for (double& height : design.edgeZ)
        height *= draw(rng, 1.0, 0.1);
}

/// Returns the largest deviation of a lobe's height from its mean. It preserves the order of the cusps by height, which
/// is the same in all people.
double mostHeightChangeMm(const std::vector<Lobe>& lobes, const Lobe& lobe)
{
    double most = 0.2;
    if (lobe.cusp != Cusp::None)
        for (const Lobe& other : lobes)
            if (other.cusp != Cusp::None && other.cusp != lobe.cusp)
                most = std::min(most, 0.25 * std::abs(other.z - lobe.z));
    return most;
}

void varyDesign(PosteriorDesign& design, Rng& rng)
{
    const std::vector<Lobe> mean = design.lobes;
    for (Lobe& lobe : design.lobes) {
        const double most = mostHeightChangeMm(mean, lobe);
        lobe.x = draw(rng, lobe.x, 0.15);
        lobe.y = draw(rng, lobe.y, 0.12);
        lobe.z += std::clamp(draw(rng, 0.0, 0.1), -most, most);
        lobe.turnDeg = draw(rng, lobe.turnDeg, 4.0);
        for (double* slope : {&lobe.slopeMesial, &lobe.slopeDistal, &lobe.slopeBuccal, &lobe.slopeLingual})
            *slope *= draw(rng, 1.0, 0.06);
    }
    for (double& radius : design.outline)
        radius *= draw(rng, 1.0, 0.012);
    design.fissureMm *= draw(rng, 1.0, 0.15);
}

/// Maps millimetres of the design to those of the drawn tooth.
struct Move
{
    glm::dvec3 origin{0.0};
    glm::dvec3 scale{1.0};
};

Move moveOf(std::span<const glm::dvec3> crown, const ToothSizes& mean, const ToothSizes& drawn)
{
    glm::dvec3 low{1.0e9};
    glm::dvec3 high{-1.0e9};
    for (const glm::dvec3& p : crown) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
        }
    }
    return {{0.5 * (low.x + high.x), 0.5 * (low.y + high.y), high.z},
            {drawn.crownWidthMm / (high.x - low.x), drawn.crownDepthMm / (high.y - low.y),
             drawn.crownHeightMm / mean.crownHeightMm}};
}

/// Maps millimetres of the design to those of the drawn tooth. Returns the finished mesh in the tooth frame.
mesh::TriangleMesh place(MeshBuilder& builder, std::size_t crownVertices, const ToothSizes& mean,
                         const ToothSizes& drawn)
{
    const Move move = moveOf(std::span(builder.points()).first(crownVertices), mean, drawn);
    for (glm::dvec3& p : builder.points())
        p = (p - move.origin) * move.scale;
    return builder.finish(buccalSign(mean.fdi));
}

/// @param heightShare  ratio of the drawn crown's height to the mean height
PosteriorCrown drawPosteriorCrown(int fdi, std::uint64_t seed, double heightShare)
{
    Rng rng = seeded(fdi, seed, kFormStream);
    const bool vary = seed != 0;
    PosteriorDesign design = posteriorDesign(fdi, rng, vary);
    if (vary)
        varyDesign(design, rng);
    // The steps between the cusps of a high crown are not larger than those of a low one.
    for (Lobe& lobe : design.lobes)
        if (lobe.cusp != Cusp::None)
            lobe.z /= heightShare;
    std::vector<OcclusalField::Wave> wander = drawWander(rng);
    PosteriorCrown crown(std::move(design), std::move(wander), rng.uniform(0.0, 6.28));
    crown.settleTips();
    return crown;
}

}  // namespace

Result<ToothSizes> drawToothSizes(int fdi, std::uint64_t seed)
{
    auto sizes = findToothSizes(fdi);
    if (!sizes || seed == 0)
        return sizes;
    Rng rng = seeded(fdi, seed, kSizesStream);
    // Large teeth are large in all directions, so half of the variance is shared.
    const double shared = rng.normal();
    const auto drawn = [&](double mean, double deviation) {
        return mean + deviation * std::clamp((shared + rng.normal()) * std::numbers::sqrt2 / 2.0, -2.0, 2.0);
    };
    const double crownHeight = drawn(sizes->crownHeightMm, kCrownHeightSdMm);
    const double crownWidth = drawn(sizes->crownWidthMm, kCrownDiameterSdMm);
    const double crownDepth = drawn(sizes->crownDepthMm, kCrownDiameterSdMm);
    // The neck scales with the width of the crown, and the curve of the CEJ with its height.
    sizes->cervixWidthMm *= crownWidth / sizes->crownWidthMm;
    sizes->cervixDepthMm *= crownDepth / sizes->crownDepthMm;
    sizes->cejCurveMesialMm *= crownHeight / sizes->crownHeightMm;
    sizes->cejCurveDistalMm *= crownHeight / sizes->crownHeightMm;
    sizes->crownHeightMm = crownHeight;
    sizes->crownWidthMm = crownWidth;
    sizes->crownDepthMm = crownDepth;
    sizes->rootLengthMm = drawn(sizes->rootLengthMm, kRootLengthSdMm);
    return sizes;
}

namespace {

Result<CoarseTooth> generate(int fdi, std::uint64_t seed, const MeshDetail& detail)
{
    const auto found = findToothSizes(fdi);
    const auto sizes = drawToothSizes(fdi, seed);
    if (!found || !sizes)
        return tl::unexpected<Error>(sizes.error());
    const ToothSizes& mean = *found;
    const ToothSizes& drawn = *sizes;
    MeshBuilder builder;
    MeshBuilder::Ring cervix;
    RootDesign roots;
    if (fdi % 10 <= 3) {
        Rng rng = seeded(fdi, seed, kFormStream);
        AnteriorDesign design = anteriorDesign(fdi);
        if (seed != 0)
            varyDesign(design, rng);
        roots = design.roots;
        cervix = buildAnteriorCrown(builder, design, mean, detail);
    } else {
        const PosteriorCrown crown = drawPosteriorCrown(fdi, seed, drawn.crownHeightMm / mean.crownHeightMm);
        roots = crown.design().roots;
        cervix = crown.build(builder, mean, detail);
    }
    const std::size_t crownVertices = builder.points().size();
    addRoots(builder, cervix, roots, drawn.rootLengthMm * mean.crownHeightMm / drawn.crownHeightMm, detail);
    return CoarseTooth{place(builder, crownVertices, mean, drawn), crownVertices, cervix};
}

}  // namespace

Result<mesh::TriangleMesh> generateTooth(int fdi, std::uint64_t seed)
{
    return generate(fdi, seed, {}).map([](CoarseTooth&& tooth) { return std::move(tooth.mesh); });
}

Result<PosteriorForm> posteriorForm(int fdi, std::uint64_t seed)
{
    // Callers request the same tooth several times in a row, and its size is known only after its mesh is built.
    thread_local std::optional<PosteriorForm> last;
    thread_local std::pair<int, std::uint64_t> lastOf;
    if (last && lastOf == std::pair(fdi, seed))
        return *last;
    const auto mean = findToothSizes(fdi);
    const auto drawn = drawToothSizes(fdi, seed);
    if (!mean || !drawn)
        return tl::unexpected<Error>(drawn.error());
    if (fdi % 10 <= 3)
        return unexpected(ErrorCode::UnknownName, "tooth " + std::to_string(fdi) + " has no occlusal surface");
    PosteriorForm form{
        drawPosteriorCrown(fdi, seed, drawn->crownHeightMm / mean->crownHeightMm), {}, {}, buccalSign(fdi)};
    MeshBuilder builder;
    static_cast<void>(form.crown.build(builder, *mean, {}));
    const Move move = moveOf(builder.points(), *mean, *drawn);
    form.originMm = move.origin;
    form.scale = move.scale;
    last = form;
    lastOf = {fdi, seed};
    return form;
}

Result<CoarseTooth> generateCoarseTooth(int fdi, const MeshDetail& detail)
{
    return generate(fdi, 0, detail);
}

}  // namespace core::teeth
