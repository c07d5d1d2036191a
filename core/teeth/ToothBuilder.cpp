// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/ToothBuilder.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <time.h>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "core/mesh/Clip.h"
#include "core/mesh/Holes.h"
#include "core/mesh/MeshAnalysis.h"
#include "core/mesh/MeshReader.h"
#include "core/mesh/Weld.h"
#include "core/teeth/TissueFigures.h"
#include "core/teeth/ToothGenerator.h"
#include "core/terrain/Rasteriser.h"
#include "core/terrain/Rim.h"

namespace core::teeth {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double threadCpuMs()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1.0e3 + static_cast<double>(time.tv_nsec) * 1.0e-6;
}

/// Returns "1 hole" or "3 holes".
std::string counted(std::size_t count, const char* one, const char* many)
{
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// Least width of a tooth, mm: a narrower one has too few columns.
constexpr double kLeastWidthMm = 0.2;
/// Length of the root that remains when a tooth is laid on a side.
constexpr double kRootKeptMm = 3.0;
/// Largest share of the tooth's outline for which the patch of a hole gives no warning.
constexpr double kSmallHole = 0.05;

class Builder
{
public:
    Builder(const ToothSource& source, const BuildOptions& options) : m_source(source), m_options(options) {}

    Result<BuiltTooth> build()
    {
        const auto start = Clock::now();
        const double cpuStart = threadCpuMs();
        m_lap = start;
        const bool fromFile = std::holds_alternative<std::filesystem::path>(m_source.what);
        m_block = std::get_if<BlockDesign>(&m_source.what);
        m_report.source = nameOfSource();
        const auto make = m_block != nullptr ? &Builder::shapeBlock : &Builder::generate;
        for (const auto step : {&Builder::checkOptions, fromFile ? &Builder::readFile : make, &Builder::judge,
                                fromFile ? &Builder::place : &Builder::keepFrame, &Builder::closeHoles,
                                &Builder::layDown, &Builder::rasterise, &Builder::layTissues})
            if (Status status = (this->*step)(); !status)
                return tl::unexpected(std::move(status).error());
        auto anatomy = std::make_shared<const terrain::ToothAnatomy>(std::move(m_anatomy));
        m_report.loadMs = millisecondsSince(start);
        m_report.loadCpuMs = threadCpuMs() - cpuStart;
        m_report.layersMm3 = terrain::volumes(terrain::Tooth(anatomy));
        return BuiltTooth{std::move(anatomy), std::move(m_mesh), std::move(m_report)};
    }

private:
    [[nodiscard]] std::string nameOfSource() const
    {
        if (const int* fdi = std::get_if<int>(&m_source.what))
            return std::to_string(*fdi);
        if (m_block != nullptr)
            return blockName(m_block->shape);
        return std::get<std::filesystem::path>(m_source.what).string();
    }

    /// Returns an error with the name of the source: "scan.stl: what is wrong".
    [[nodiscard]] tl::unexpected<Error> failure(ErrorCode code, const std::string& what) const
    {
        return unexpected(code, m_report.source + ": " + what);
    }

    void endStage(const char* name)
    {
        m_report.stagesMs.emplace_back(name, millisecondsSince(m_lap));
        m_lap = Clock::now();
    }

    Status checkOptions()
    {
        if (m_options.gridSide < terrain::kMinGridSide || m_options.gridSide > terrain::kMaxGridSide)
            return unexpected(ErrorCode::OutOfRange, "a grid of " + std::to_string(m_options.gridSide) +
                                                         " nodes a side is out of range; choose " +
                                                         std::to_string(terrain::kMinGridSide) + " to " +
                                                         std::to_string(terrain::kMaxGridSide));
        if (!m_options.lying.isSound() || (m_block != nullptr && !m_options.lying.isUpright()))
            return unexpected(ErrorCode::OutOfRange, "a tooth lies on a side by 5 to 90 degrees, and a block on none");
        if (!(m_options.cariesExtent >= 0.0 && m_options.cariesExtent <= 1.0))
            return unexpected(ErrorCode::OutOfRange, "the extent of caries must be a number from 0 to 1");
        return {};
    }

    Status generate()
    {
        m_anatomy.fdi = std::get<int>(m_source.what);
        auto mesh = generateTooth(m_anatomy.fdi, m_options.seed);
        if (!mesh)
            return tl::unexpected(std::move(mesh).error());
        m_mesh = std::move(*mesh);
        endStage("generate");
        return {};
    }

    Status shapeBlock()
    {
        if (Status fits = validate(*m_block); !fits)
            return failure(fits.error().code, fits.error().detail);
        m_mesh = blockMesh(*m_block);
        endStage("generate");
        return {};
    }

    Status readFile()
    {
        m_anatomy.fdi = m_options.fdi;
        // A misspelt name of a block is an error. It is not used as a file name.
        if (const auto block = findBlock(m_report.source); block && !*block)
            return tl::unexpected(block->error());
        auto file = mesh::readMesh(std::get<std::filesystem::path>(m_source.what));
        if (!file)
            return tl::unexpected(std::move(file).error());
        m_mesh = std::move(file->mesh);
        m_originInFile = file->originInFile;
        m_report.warnings = std::move(file->warnings);
        endStage("read");
        return {};
    }

    Status judge()
    {
        mesh::weldByPosition(m_mesh);
        m_facts = mesh::analyse(m_mesh);
        if (m_facts.shells.empty() || m_facts.area == 0.0)
            return failure(ErrorCode::NoTriangles, "every one of its faces has zero area (" +
                                                       std::to_string(m_facts.triangles) + "); export the mesh again");
        if (m_facts.triangles < 4)
            return failure(ErrorCode::NoTriangles, "its surface has " + std::to_string(m_facts.triangles) +
                                                       (m_facts.triangles == 1 ? " triangle" : " triangles") +
                                                       ", too few to enclose anything; export the whole tooth");
        if (m_facts.openEdges.size() > m_facts.triangles)
            return failure(ErrorCode::BadStructure,
                           "its faces do not hang together: " + std::to_string(m_facts.openEdges.size()) +
                               " edges have a face on one side only; export it as one "
                               "connected surface");
        m_report.triangles = m_facts.triangles;
        m_report.vertices = m_facts.vertices;
        m_report.closed = m_facts.closed;
        m_report.oriented = m_facts.oriented;
        m_report.boundaryEdges = m_facts.boundaryEdges;
        m_report.nonManifoldEdges = m_facts.nonManifoldEdges;
        m_report.flippedEdges = m_facts.flippedEdges;
        m_report.zeroAreaFaces = m_facts.zeroAreaFaces;
        m_report.duplicateFaces = m_facts.duplicateFaces;
        m_report.shells = m_facts.shells.size();
        m_report.shellsInside = static_cast<std::size_t>(
            std::count_if(m_facts.shells.begin(), m_facts.shells.end(), [](const auto& s) { return s.inside; }));
        m_report.shellsInsideOut = mesh::turnOutwards(m_mesh, m_facts);
        warnAboutMesh();
        endStage("analyse");
        return {};
    }

    void warnAboutMesh()
    {
        const auto warn = [&](std::size_t count, const char* one, const char* many, const char* rest) {
            if (count > 0)
                m_report.warnings.push_back(counted(count, one, many) + rest);
        };
        warn(m_report.zeroAreaFaces, "face has zero area and was", "faces have zero area and were", " passed over");
        warn(m_report.duplicateFaces, "face is", "faces are", " there twice");
        warn(m_report.nonManifoldEdges, "edge belongs", "edges belong",
             " to three or more faces: the mesh is not a manifold, so its volume means little");
        warn(
            m_report.flippedEdges, "edge has", "edges have",
            " faces that disagree which side is outside, so the mesh volume means little; the height maps do not mind");
        if (m_report.shells == 1 && m_report.shellsInsideOut == 1)
            m_report.warnings.emplace_back("the mesh was inside out and has been turned");
        else
            warn(m_report.shellsInsideOut, "of the shells was inside out and has",
                 "of the shells were inside out and have", " been turned");
        if (m_report.shells > 1)
            m_report.warnings.push_back("the mesh has " + std::to_string(m_report.shells) + " separate shells" +
                                        nesting() + "; the model keeps the outermost surface and is solid");
        if (m_report.oriented && !enclosedVolume())
            m_report.warnings.emplace_back("the shells may overlap, so the mesh volume may count places twice and what "
                                           "the undercuts hold is unknown");
    }

    /// Returns ", none of them inside another", or an empty text if that is unknown.
    [[nodiscard]] std::string nesting() const
    {
        if (m_report.shells > mesh::kMostNestedShells)
            return {};
        const std::string inside = m_report.shellsInside == 0   ? "none"
                                   : m_report.shellsInside == 1 ? "one"
                                                                : std::to_string(m_report.shellsInside);
        return ", " + inside + " of them inside another";
    }

    Status keepFrame()
    {
        m_report.placement.unitReason = m_report.placement.upReason = "generated in the tooth frame";
        return measureBounds();
    }

    Status place()
    {
        auto placement = mesh::findPlacement(m_mesh, m_facts, m_options.placement, m_originInFile);
        if (!placement)
            return failure(placement.error().code, placement.error().detail);
        m_report.placement = std::move(*placement);
        m_mmPerUnit = m_report.placement.unit.mmPerUnit;
        m_report.warnings.insert(m_report.warnings.end(), m_report.placement.warnings.begin(),
                                 m_report.placement.warnings.end());
        mesh::moveToToothFrame(m_mesh, m_report.placement, m_originInFile);
        return measureBounds();
    }

    Status measureBounds()
    {
        m_report.lowMm = glm::dvec3(std::numeric_limits<double>::max());
        m_report.highMm = -m_report.lowMm;
        for (const glm::vec3& vertex : m_mesh.vertices) {
            m_report.lowMm = glm::min(m_report.lowMm, glm::dvec3(vertex));
            m_report.highMm = glm::max(m_report.highMm, glm::dvec3(vertex));
        }
        const double scale = m_mmPerUnit;
        m_report.meshAreaMm2 = m_facts.area * scale * scale;
        m_report.meshVolumeMm3 = m_facts.volume * scale * scale * scale;
        const glm::dvec3 size = m_report.highMm - m_report.lowMm;
        if (std::max(size.x, size.y) < kLeastWidthMm)
            return failure(ErrorCode::BadStructure, "seen from above the crown it is narrower than 0.2 mm; check --up "
                                                    "and --unit");
        endStage("place");
        return {};
    }

    /// Patches the holes, except large ones that face down. The rasteriser closes those at their lowest point.
    Status closeHoles()
    {
        if (m_facts.openEdges.empty())
            return {};
        const std::vector<mesh::Hole> holes = mesh::findHoles(m_mesh, m_facts);
        const glm::dvec3 size = m_report.highMm - m_report.lowMm;
        std::size_t patched = 0;
        double bottomMm2 = 0.0;
        for (const mesh::Hole& hole : holes) {
            const double area = glm::length(hole.areaVector);
            const bool small = area < kSmallHole * size.x * size.y;
            if (!small && hole.areaVector.z < -0.5 * area && m_options.lying.isUpright()) {
                m_closeAtMm = std::min(m_closeAtMm.value_or(hole.low.z), hole.low.z);
                bottomMm2 -= hole.areaVector.z;
            } else if (!small && hole.areaVector.z > 0.5 * area) {
                return failure(ErrorCode::BadStructure, "the mesh is open where its crown should be, so there is "
                                                        "nothing to drill; check --up or close the mesh");
            } else {
                mesh::patch(m_mesh, hole);
                ++patched;
            }
        }
        m_report.warnings.push_back("the mesh is open (" + counted(m_facts.boundaryEdges, "edge", "edges") + " in " +
                                    counted(holes.size(), "hole", "holes") + "), so its volume means little");
        if (m_closeAtMm)
            m_report.warnings.push_back("the scan is open below and was closed with a flat bottom, " +
                                        std::to_string(std::llround(bottomMm2)) +
                                        " mm2, at its lowest rim, z = " + millimetres(*m_closeAtMm));
        if (patched > 0)
            m_report.warnings.push_back(
                counted(patched, "hole was closed with a flat patch", "holes were closed with flat patches"));
        endStage("close");
        return {};
    }

    /// Turns the tooth onto its side. The upright form is stored, because the tissues are computed from it.
    Status layDown()
    {
        m_report.lying = m_anatomy.lying = m_options.lying;
        if (m_options.lying.isUpright())
            return {};
        if (isHeapOfFaces())
            return heapOfFaces();
        LaidTooth laid;
        laid.own.name = m_report.source;
        laid.own.fdi = m_anatomy.fdi;
        laid.own.seed = m_options.seed;
        laid.own.lying = m_options.lying;
        laid.own.grid =
            terrain::fitGrid(glm::dvec2(m_report.lowMm), glm::dvec2(m_report.highMm), terrain::kDefaultGridSide);
        terrain::HeightMaps maps = terrain::rasterise(m_mesh, laid.own.grid);
        laid.own.top = std::move(maps.top);
        laid.own.bottom = std::move(maps.bottom);
        laid.own.areaMm2 = std::move(maps.areaMm2);
        laid.own.layers = buildLayers(laid.own.grid, laid.own.top, laid.own.bottom, layerOptions());
        if (const auto sizes = drawToothSizes(m_anatomy.fdi, m_options.seed);
            sizes && std::holds_alternative<int>(m_source.what))
            laid.made = *sizes;
        laid.crownHeightMm =
            laid.made ? laid.made->crownHeightMm : figuresFor(m_anatomy.fdi, laid.own.grid, laid.own.top).crownHeight;
        laid.tipMm = m_report.highMm.z;
        laid.cutFromOwn = m_options.lying.cutFromOwn();
        shortenRoots(laid.neckMm() - kRootKeptMm);
        for (glm::vec3& vertex : m_mesh.vertices)
            vertex = glm::vec3(laid.cutFromOwn * glm::dvec3(vertex));
        m_facts = mesh::analyse(m_mesh);
        m_mmPerUnit = 1.0;
        if (Status status = measureBounds(); !status)
            return status;
        const glm::dvec2 middle = 0.5 * (glm::dvec2(m_report.lowMm) + glm::dvec2(m_report.highMm));
        laid.shiftMm = -glm::dvec3(middle, m_report.highMm.z);
        for (glm::vec3& vertex : m_mesh.vertices)
            vertex = glm::vec3(glm::dvec3(vertex) + laid.shiftMm);
        m_report.lowMm += laid.shiftMm;
        m_report.highMm += laid.shiftMm;
        m_laid = std::move(laid);
        endStage("lay");
        return {};
    }

    /// Cuts the roots off at a height, mm of the own frame, and closes the cut.
    void shortenRoots(double heightMm)
    {
        m_mesh = mesh::clippedBelow(m_mesh, heightMm);
        mesh::weldByPosition(m_mesh);
        for (const mesh::Hole& hole : mesh::findHoles(m_mesh, mesh::analyse(m_mesh)))
            mesh::patch(m_mesh, hole);
        // A hollow between roots that part above the cut is now a separate pocket, and is filled.
        const mesh::MeshFacts facts = mesh::analyse(m_mesh);
        std::vector<std::array<std::uint32_t, 3>> kept;
        for (std::size_t k = 0; k < m_mesh.triangles.size(); ++k)
            if (facts.shellOf[k] != mesh::kNoShell && facts.shells[facts.shellOf[k]].volume > 0.0)
                kept.push_back(m_mesh.triangles[k]);
        m_mesh.triangles = std::move(kept);
    }

    [[nodiscard]] tl::unexpected<Error> heapOfFaces() const
    {
        return failure(ErrorCode::BadStructure, "its faces lie over one another thousands of times, so they are no "
                                                "surface; check that it is one tooth");
    }

    /// Returns the volume inside the surface in file units, without counting any space twice. Empty if the shells do
    /// not define a volume.
    [[nodiscard]] std::optional<double> enclosedVolume() const
    {
        if (!m_facts.oriented)
            return std::nullopt;
        double sum = 0.0;
        bool hollow = false;
        bool filledTwice = false;
        for (const mesh::Shell& shell : m_facts.shells) {
            const bool inFull = shell.inside && shell.volume > 0.0;  // material inside material
            filledTwice = filledTwice || inFull;
            hollow = hollow || (shell.inside && !inFull);
            sum += inFull ? 0.0 : shell.volume;
        }
        if ((hollow && filledTwice) || shellsMayOverlap())
            return std::nullopt;
        return sum;
    }

    /// Returns whether the boxes of two shells overlap, of which neither is inside the other.
    [[nodiscard]] bool shellsMayOverlap() const
    {
        const std::vector<mesh::Shell>& shells = m_facts.shells;
        for (std::size_t a = 0; a < shells.size() && shells.size() <= mesh::kMostNestedShells; ++a)
            for (std::size_t b = 0; b < a; ++b)
                if (!shells[a].inside && !shells[b].inside &&
                    glm::all(glm::lessThan(glm::max(shells[a].low, shells[b].low),
                                           glm::min(shells[a].high, shells[b].high))))
                    return true;
        return shells.size() > mesh::kMostNestedShells;
    }

    /// Returns whether rasterising would take too long. The time is proportional to the area of the boxes around the
    /// faces. A usual surface covers its outline a few times, but a fan of thousands of faces around one corner some
    /// hundred times.
    [[nodiscard]] bool isHeapOfFaces() const
    {
        constexpr double kMostCovers = 2'000.0;
        double covered = 0.0;
        for (const auto& t : m_mesh.triangles) {
            const glm::vec2 a(m_mesh.vertices[t[0]]);
            const glm::vec2 b(m_mesh.vertices[t[1]]);
            const glm::vec2 c(m_mesh.vertices[t[2]]);
            const glm::dvec2 size(glm::max(a, glm::max(b, c)) - glm::min(a, glm::min(b, c)));
            covered += size.x * size.y;
        }
        const glm::dvec3 size = m_report.highMm - m_report.lowMm;
        return covered > kMostCovers * size.x * size.y;
    }

    static std::string millimetres(double value)
    {
        const auto hundredths = std::llround(value * 100.0);
        std::string text = std::to_string(std::abs(hundredths) / 100) + "." +
                           std::to_string(100 + std::abs(hundredths) % 100).substr(1);
        return (hundredths < 0 ? "-" : "") + text + " mm";
    }

    Status rasterise()
    {
        if (isHeapOfFaces())
            return heapOfFaces();
        const terrain::Grid grid =
            terrain::fitGrid(glm::dvec2(m_report.lowMm), glm::dvec2(m_report.highMm), m_options.gridSide);
        terrain::HeightMaps maps = terrain::rasterise(m_mesh, grid, m_closeAtMm);
        m_report.gridSide = grid.side;
        m_report.cellMm = grid.cellMm;
        m_report.modelVolumeMm3 = terrain::volumeOf(maps);
        if (m_report.modelVolumeMm3 == 0.0)
            return failure(ErrorCode::BadStructure, "its surface encloses nothing seen from above the crown; check "
                                                    "--up or close the mesh");
        if (const auto enclosed = enclosedVolume())
            m_report.undercutMm3 = m_report.modelVolumeMm3 - *enclosed * std::pow(m_mmPerUnit, 3);
        std::vector<float> sewn;
        m_report.sewnCells = terrain::sewRim(grid, maps.top, maps.bottom, terrain::wholeOf(grid), sewn);
        m_anatomy.grid = grid;
        m_anatomy.top = std::move(maps.top);
        m_anatomy.bottom = std::move(maps.bottom);
        m_anatomy.areaMm2 = std::move(maps.areaMm2);
        endStage("rasterise");
        return {};
    }

    Status layTissues()
    {
        const auto* const file = std::get_if<std::filesystem::path>(&m_source.what);
        m_anatomy.name = file != nullptr ? file->filename().string() : m_report.source;
        m_anatomy.seed = m_options.seed;
        m_anatomy.hasDecayZones = m_options.hasDecayZones;
        m_report.fdi = m_anatomy.fdi;
        if (m_block != nullptr) {
            m_anatomy.layers = blockLayers(*m_block, m_anatomy.grid, m_anatomy.top, m_anatomy.bottom, m_options.seed);
            endStage("layers");
            return {};
        }
        m_anatomy.layers =
            m_laid ? buildLaidLayers(*m_laid, m_anatomy.grid, m_anatomy.top, m_anatomy.bottom, layerOptions())
                   : buildLayers(m_anatomy.grid, m_anatomy.top, m_anatomy.bottom, layerOptions());
        warnAboutPulp();
        endStage("layers");
        if (Status fits = checkSite(m_options.site.value_or(usualSite(m_options.lying)), m_options.lying);
            m_options.caries && !fits)
            return fits;
        if (m_options.caries && m_laid) {
            const LesionSite site = m_options.site.value_or(usualSite(m_options.lying));
            if (Status grown = addLesion(site, m_options.cariesExtent, *m_laid, m_anatomy.grid, m_anatomy.top,
                                         m_anatomy.bottom, m_anatomy.layers);
                !grown)
                return grown;
        } else if (m_options.caries) {
            CariesOptions caries{*m_options.caries, m_options.cariesExtent, m_options.seed, {}, {}};
            std::vector<LesionStop> line;
            if (caries.rule == CariesRule::FissureWalk)
                line = lesionLine();
            caries.line = line;
            addCaries(m_anatomy.grid, m_anatomy.top, m_anatomy.bottom, m_anatomy.layers, caries);
        }
        endStage("caries");
        return {};
    }

    /// Returns the path of the lesion. It must depend on the tooth and not on the grid, so it is always searched on the
    /// usual grid.
    [[nodiscard]] std::vector<LesionStop> lesionLine() const
    {
        if (m_anatomy.grid.side == terrain::kDefaultGridSide)
            return fissureLine(m_anatomy.grid, m_anatomy.top, m_anatomy.bottom, m_anatomy.layers, m_options.seed);
        const terrain::Grid grid =
            terrain::fitGrid(glm::dvec2(m_report.lowMm), glm::dvec2(m_report.highMm), terrain::kDefaultGridSide);
        const terrain::HeightMaps maps = terrain::rasterise(m_mesh, grid, m_closeAtMm);
        return fissureLine(grid, maps.top, maps.bottom, buildLayers(grid, maps.top, maps.bottom, layerOptions()),
                           m_options.seed);
    }

    [[nodiscard]] LayerOptions layerOptions() const { return {m_options.layers, m_anatomy.fdi, m_options.seed}; }

    void warnAboutPulp()
    {
        if (std::any_of(m_anatomy.layers.begin(), m_anatomy.layers.end(),
                        [](const terrain::ColumnLayers& column) { return column.pulpRoof > column.pulpFloor; }))
            return;
        if (m_laid) {
            m_report.warnings.emplace_back("a bur meets no pulp from this side: opening it cannot be judged");
            return;
        }
        const double crownHeight = figuresFor(m_anatomy.fdi, m_anatomy.grid, m_anatomy.top).crownHeight;
        const bool endsEarly = m_report.highMm.z - m_report.lowMm.z < crownHeight;
        m_report.warnings.emplace_back(endsEarly ? "this scan ends above the pulp: opening it cannot be judged"
                                                 : "this tooth has no room for a pulp: opening it cannot be judged");
    }

    const ToothSource& m_source;
    const BuildOptions& m_options;
    const BlockDesign* m_block = nullptr;  ///< null: the tooth is not a block
    Clock::time_point m_lap;
    mesh::TriangleMesh m_mesh;
    glm::dvec3 m_originInFile{0.0};  ///< see mesh::MeshFile
    mesh::MeshFacts m_facts;
    double m_mmPerUnit = 1.0;  ///< of m_facts
    std::optional<double> m_closeAtMm;
    std::optional<LaidTooth> m_laid;
    terrain::ToothAnatomy m_anatomy;
    ToothReport m_report;
};

}  // namespace

ToothSource parseSource(std::string_view text)
{
    int fdi = 0;
    const auto [stop, failure] = std::from_chars(text.data(), text.data() + text.size(), fdi);
    if (failure == std::errc() && stop == text.data() + text.size() && !text.empty())
        return {fdi};
    if (const auto block = findBlock(text); block && *block)
        return {**block};
    return {std::filesystem::path(text)};
}

Result<BuiltTooth> buildTooth(const ToothSource& source, const BuildOptions& options)
{
    return Builder(source, options).build();
}

bool isGenerated(const terrain::ToothAnatomy& anatomy)
{
    // A tooth from a file has the name of the file. A file called "36" cannot be opened: "36" is the generated tooth.
    return anatomy.fdi != 0 && anatomy.name == std::to_string(anatomy.fdi);
}

bool standsInTheArch(const terrain::ToothAnatomy& anatomy)
{
    return isGenerated(anatomy) && anatomy.lying.isUpright();
}

}  // namespace core::teeth
