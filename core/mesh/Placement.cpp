// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/Placement.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace core::mesh {
namespace {

constexpr std::array<std::pair<std::string_view, Axis>, 6> kAxisNames{{{"+x", Axis::PlusX},
                                                                       {"-x", Axis::MinusX},
                                                                       {"+y", Axis::PlusY},
                                                                       {"-y", Axis::MinusY},
                                                                       {"+z", Axis::PlusZ},
                                                                       {"-z", Axis::MinusZ}}};

// A human tooth with its roots is 18 to 32 mm long, a crown 5 to 14 mm wide (reference values of Wheeler). The limits
// span a decade around that, so that mm, cm and m neither overlap nor leave a gap.
constexpr double kLeastSizeMm = 4.0;
constexpr double kMostSizeMm = 40.0;
// If a person gave the unit, these limits of a height map apply; outside the limits above there is only a warning.
// Empty columns are stored as 1e6.
constexpr double kLeastGivenMm = 0.5;
constexpr double kMostGivenMm = 100.0;
constexpr double kMostCoordinateMm = 1.0e4;
// Depth below the highest point at which the outline of the crown is taken: crowns are 6.5 to 11 mm high.
constexpr double kCrownDepthMm = 8.0;

std::string inWords(double value)
{
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 4).ptr;
    return {text.data(), end};
}

double largest(const glm::dvec3& v)
{
    return std::max({v.x, v.y, v.z});
}

LengthUnit guessUnit(double size, std::string& reason, std::vector<std::string>& warnings)
{
    const std::array<LengthUnit, 3> known{{{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}}};
    for (const LengthUnit& unit : known) {
        const double sizeMm = size * unit.mmPerUnit;
        if (sizeMm < kLeastSizeMm || sizeMm >= kMostSizeMm)
            continue;
        reason = "guessed: the longest side of " + inWords(size) + " units is a tooth's size in " + unit.name;
        if (unit.name != "mm")
            warnings.push_back("the file states no unit and " + unit.name + " was guessed (" + inWords(unit.mmPerUnit) +
                               " mm a unit, longest side " + inWords(sizeMm) + " mm); give --unit if you know better");
        return unit;
    }
    if (size >= kMostSizeMm && size < kMostGivenMm) {
        reason = "guessed: " + inWords(size) + " units are too large for a tooth in mm and far too large in cm or m";
        warnings.push_back("mm was guessed, and then the longest side of " + inWords(size) +
                           " mm is more than a tooth has; give --unit, or cut one tooth out of the scan");
        return known[0];
    }
    LengthUnit fitted{"", 20.0 / size};
    fitted.name = inWords(fitted.mmPerUnit);
    reason =
        "guessed: " + inWords(size) + " units is no tooth's size in mm, cm or m, so the longest side was made 20 mm";
    warnings.push_back("the unit is unknown: " + inWords(size) +
                       " units is no tooth's size in mm, cm or m, so the longest side was made 20 mm; give --unit");
    return fitted;
}

/// Returns the area of the faces within `depth` of one end of the axis, projected on the axis. If the end narrows
/// steadily, that is the cross-section at that depth, whatever the direction of the faces: large for a crown, small for
/// roots.
double endArea(const TriangleMesh& mesh, const MeshFacts& facts, int axis, double sign, double depth)
{
    double sum = 0.0;
    const double end = sign > 0.0 ? facts.high[axis] : facts.low[axis];
    for (const auto& t : mesh.triangles) {
        const glm::dvec3 a(mesh.vertices[t[0]]);
        const glm::dvec3 b(mesh.vertices[t[1]]);
        const glm::dvec3 c(mesh.vertices[t[2]]);
        if (std::abs((a[axis] + b[axis] + c[axis]) / 3.0 - end) <= depth)
            sum += 0.5 * std::abs(glm::cross(b - a, c - a)[axis]);
    }
    return sum;
}

Axis axisOf(int axis, double sign)
{
    return static_cast<Axis>(2 * axis + (sign > 0.0 ? 0 : 1));
}

std::string fileAxis(int axis)
{
    return std::string(1, static_cast<char>('x' + axis));
}

Axis guessUp(const TriangleMesh& mesh, const MeshFacts& facts, std::string& reason, std::vector<std::string>& warnings)
{
    const glm::dvec3 size = facts.high - facts.low;
    // 1. An open scan: the sum of the area vectors of the faces points away from the opening.
    const glm::dvec3 v = facts.areaVector;
    int axis = std::abs(v.x) > std::abs(v.y) ? 0 : 1;
    axis = std::abs(v.z) > std::abs(v[axis]) ? 2 : axis;
    if (!facts.closed && std::abs(v[axis]) > 0.15 * facts.area) {
        const Axis up = axisOf(axis, v[axis]);
        reason = "guessed: the scan is open and its opening looks the other way";
        return up;
    }
    // 2. A model with a flat cut: the flat side is at the bottom.
    int flatSides = 0;
    Axis flatUp = Axis::PlusZ;
    for (int k = 0; k < 3; ++k)
        for (const double sign : {1.0, -1.0}) {
            const double outline = size.x * size.y * size.z / std::max(size[k], std::numeric_limits<double>::min());
            if (endArea(mesh, facts, k, sign, 0.005 * size[k]) > 0.3 * outline) {
                ++flatSides;
                flatUp = axisOf(k, -sign);
            }
        }
    if (flatSides == 1) {
        reason = "guessed: the model is cut off flat on the other side";
        return flatUp;
    }
    // 3. A whole tooth is longest along its axis, and the crown is the end that narrows less.
    axis = size.x > size.y ? 0 : 1;
    axis = size.z >= size[axis] ? 2 : axis;
    const double next = std::max(size[(axis + 1) % 3], size[(axis + 2) % 3]);
    if (size[axis] > 1.15 * next) {
        const double plus = endArea(mesh, facts, axis, 1.0, 0.25 * size[axis]);
        const double minus = endArea(mesh, facts, axis, -1.0, 0.25 * size[axis]);
        if (plus > 1.15 * minus || minus > 1.15 * plus) {
            reason = "guessed: the mesh is longest along " + fileAxis(axis) +
                     " and that end is the wider one, as a crown is (" +
                     inWords(100.0 * std::max(plus, minus) / (plus + minus)) + " % of both ends' outline)";
            return axisOf(axis, plus - minus);
        }
    }
    reason = "assumed: the shape does not show where the crown is";
    warnings.emplace_back("the shape does not show where the crown is, so +z of the file was taken; give --up if it is "
                          "another");
    return Axis::PlusZ;
}

glm::dvec3 turned(Axis up, const glm::dvec3& p)
{
    switch (up) {
    case Axis::PlusX:
        return {-p.z, p.y, p.x};
    case Axis::MinusX:
        return {p.z, p.y, -p.x};
    case Axis::PlusY:
        return {p.x, -p.z, p.y};
    case Axis::MinusY:
        return {p.x, p.z, -p.y};
    case Axis::PlusZ:
        return p;
    case Axis::MinusZ:
        return {p.x, -p.y, -p.z};
    }
    return p;
}

/// Returns the middle of the box around the crown, seen from above, at the height of its highest point.
glm::dvec3 crownOrigin(const TriangleMesh& mesh, const Placement& placement)
{
    double highest = -std::numeric_limits<double>::max();
    for (const glm::vec3& vertex : mesh.vertices)
        highest = std::max(highest, toothFromFile(placement, vertex).z);
    glm::dvec2 low(std::numeric_limits<double>::max());
    glm::dvec2 high = -low;
    for (const glm::vec3& vertex : mesh.vertices)
        if (const glm::dvec3 p = toothFromFile(placement, vertex); p.z >= highest - kCrownDepthMm) {
            low = glm::min(low, glm::dvec2(p));
            high = glm::max(high, glm::dvec2(p));
        }
    return {(low + high) * 0.5, highest};
}

}  // namespace

std::string_view nameOf(Axis axis)
{
    return kAxisNames[static_cast<std::size_t>(axis)].first;
}

Result<Axis> parseAxis(std::string_view text)
{
    for (const auto& [name, axis] : kAxisNames)
        if (text == name || (name.starts_with('+') && text == name.substr(1)))
            return axis;
    return unexpected(ErrorCode::UnknownName,
                      "the direction \"" + std::string(text) + "\" is unknown; give one of +x, -x, +y, -y, +z, -z");
}

Result<LengthUnit> parseUnit(std::string_view text)
{
    if (text == "mm" || text == "cm" || text == "m")
        return LengthUnit{std::string(text), text == "mm" ? 1.0 : text == "cm" ? 10.0 : 1000.0};
    double value = 0.0;
    const auto [stop, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc() || stop != text.data() + text.size() || text.empty() || !std::isfinite(value) ||
        !(value > 0.0))
        return unexpected(ErrorCode::UnknownName, "the unit \"" + std::string(text) +
                                                      "\" is unknown; give mm, cm, m or the millimetres in one unit");
    return LengthUnit{std::string(text), value};
}

Result<Placement> findPlacement(const TriangleMesh& mesh, const MeshFacts& facts, const PlacementOptions& options)
{
    Placement placement;
    const double size = largest(facts.high - facts.low);
    if (options.keepFrame) {
        placement.unitReason = placement.upReason = "the file's own frame was kept";
    } else {
        placement.unitReason = placement.upReason = "given";
        placement.unit = options.unit ? *options.unit : guessUnit(size, placement.unitReason, placement.warnings);
        placement.unitDoubtful = !placement.warnings.empty();
        const std::size_t before = placement.warnings.size();
        placement.up = options.up ? *options.up : guessUp(mesh, facts, placement.upReason, placement.warnings);
        placement.upDoubtful = placement.warnings.size() > before;
    }
    const double sizeMm = size * placement.unit.mmPerUnit;
    if (!(sizeMm >= kLeastGivenMm && sizeMm <= kMostGivenMm))
        return unexpected(ErrorCode::OutOfRange, "its longest side is " + inWords(sizeMm) + " mm (" + inWords(size) +
                                                     " units of " + inWords(placement.unit.mmPerUnit) +
                                                     " mm), which is no tooth; give another --unit");
    if ((options.keepFrame || options.unit) && (sizeMm < kLeastSizeMm || sizeMm >= kMostSizeMm))
        placement.warnings.push_back(
            "its longest side is " + inWords(sizeMm) + " mm, " + (sizeMm < kLeastSizeMm ? "less" : "more") +
            " than a tooth has; " +
            (options.keepFrame ? "leave out --frame file if it is not in mm" : "check the --unit that was given"));
    if (!options.keepFrame)
        placement.originMm = crownOrigin(mesh, placement);
    else if (largest(glm::max(facts.high, -facts.low)) > kMostCoordinateMm)
        return unexpected(ErrorCode::OutOfRange, "it lies more than 10 m from its own origin; move it there, or leave "
                                                 "out --frame file");
    return placement;
}

glm::dvec3 toothFromFile(const Placement& placement, const glm::dvec3& pointInFile)
{
    return turned(placement.up, pointInFile) * placement.unit.mmPerUnit - placement.originMm;
}

void moveToToothFrame(TriangleMesh& mesh, const Placement& placement)
{
    for (glm::vec3& vertex : mesh.vertices)
        vertex = glm::vec3(toothFromFile(placement, vertex));
}

}  // namespace core::mesh
