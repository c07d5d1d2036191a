// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/Placement.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "core/mesh/PrincipalAxes.h"
#include "core/mesh/TextScanner.h"

namespace core::mesh {
namespace {

constexpr std::array<std::string_view, 6> kAxisNames{"+x", "-x", "+y", "-y", "+z", "-z"};

// A human tooth with its roots is 18 to 32 mm long, a crown 5 to 14 mm wide (reference values of Wheeler). The limits
// span a decade around that, so that mm, cm and m neither overlap nor leave a gap. Inches overlap with cm;
// suitsInches() decides between the two.
constexpr double kLeastSizeMm = 4.0;
constexpr double kMostSizeMm = 40.0;
constexpr double kLeastCentimetresMm = 8.0;
constexpr double kLeastWidthMm = 5.0;
constexpr double kMostWidthMm = 15.0;
constexpr double kMmPerInch = 25.4;
// A direction that deviates from all axes of the file by more than this is not taken for an axis: sin(20 degrees).
constexpr double kAskew = 0.342;
// A mesh is long if it is so much longer than wide along its principal axes, and its surface is spread so much more.
constexpr double kLongShape = 1.3;
constexpr double kLongSpread = 1.1;
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

/// The longest and the second longest side of the box around a mesh.
struct Sides
{
    double longest = 0.0;
    double second = 0.0;

    [[nodiscard]] bool fit(const LengthUnit& unit) const
    {
        const double longestMm = longest * unit.mmPerUnit;
        return longestMm >= kLeastSizeMm && longestMm < kMostSizeMm;
    }
};

Sides sidesOf(const glm::dvec3& size)
{
    std::array<double, 3> sides{size.x, size.y, size.z};
    std::sort(sides.begin(), sides.end());
    return {sides[2], sides[1]};
}

/// Returns whether inches suit a mesh better than centimetres. A tooth in inches has the length of a crown in
/// centimetres, so that the width decides: it would be less than that of a tooth in cm, or more in inches.
bool suitsInches(const Sides& sides)
{
    if (!sides.fit({"in", kMmPerInch}) || sides.second * kMmPerInch > kMostWidthMm)
        return false;
    return sides.longest * 10.0 < kLeastCentimetresMm || sides.second * 10.0 < kLeastWidthMm;
}

LengthUnit guessUnit(const Sides& sides, std::string& reason, std::vector<std::string>& warnings)
{
    const double size = sides.longest;
    const std::array<LengthUnit, 4> known{{{"mm", 1.0}, {"cm", 10.0}, {"in", kMmPerInch}, {"m", 1000.0}}};
    const bool isInches = suitsInches(sides);
    for (const LengthUnit& unit : known) {
        if (!sides.fit(unit) || (unit.name == "cm" && isInches))
            continue;
        reason = "guessed: the longest side of " + inWords(size) + " units is a tooth's size in " +
                 (unit.name == "in" ? "inches" : unit.name);
        if (unit.name == "mm")
            return unit;
        std::string rival;
        if (unit.name == "cm" && sides.fit(known[2]))
            rival = ", as inches it would be " + inWords(size * kMmPerInch) + " mm";
        else if (unit.name == "in" && sides.fit(known[1]))
            rival = ", as cm it would be " + inWords(size * 10.0) + " mm";
        warnings.push_back("the file states no unit and " + (unit.name == "in" ? "inches were" : unit.name + " was") +
                           " guessed (" + inWords(unit.mmPerUnit) + " mm a unit, longest side " +
                           inWords(size * unit.mmPerUnit) + " mm" + rival + "); give --unit if you know better");
        return unit;
    }
    if (size >= kMostSizeMm && size < kMostGivenMm) {
        reason =
            "guessed: " + inWords(size) + " units are too large for a tooth in mm and far too large in cm, in or m";
        warnings.push_back("mm was guessed, and then the longest side of " + inWords(size) +
                           " mm is more than a tooth has; give --unit, or cut one tooth out of the scan");
        return known[0];
    }
    LengthUnit fitted{"", 20.0 / size};
    fitted.name = inWords(fitted.mmPerUnit);
    reason = "guessed: " + inWords(size) +
             " units is no tooth's size in mm, cm, in or m, so the longest side was made 20 mm";
    warnings.push_back("the unit is unknown: " + inWords(size) +
                       " units is no tooth's size in mm, cm, in or m, so the longest side was made 20 mm; give --unit");
    return fitted;
}

/// Returns the area of the faces within `depth` of one end of the axis, projected on the axis. If the end narrows
/// steadily, that is the cross-section at that depth, whatever the direction of the faces: large for a crown, small for
/// roots.
/// @param axis   a unit vector
/// @param end    where the mesh ends along it
double endArea(const TriangleMesh& mesh, const glm::dvec3& axis, double end, double depth)
{
    double sum = 0.0;
    for (const auto& t : mesh.triangles) {
        const glm::dvec3 a(mesh.vertices[t[0]]);
        const glm::dvec3 b(mesh.vertices[t[1]]);
        const glm::dvec3 c(mesh.vertices[t[2]]);
        if (std::abs(glm::dot(axis, a + b + c) / 3.0 - end) <= depth)
            sum += 0.5 * std::abs(glm::dot(axis, glm::cross(b - a, c - a)));
    }
    return sum;
}

UpDirection axisOf(int axis, double sign)
{
    UpDirection up;
    up.name = kAxisNames[static_cast<std::size_t>(2 * axis + (sign > 0.0 ? 0 : 1))];
    up.inFile = glm::dvec3(0.0);
    up.inFile[axis] = sign > 0.0 ? 1.0 : -1.0;
    return up;
}

std::string fileAxis(int axis)
{
    return std::string(1, static_cast<char>('x' + axis));
}

int largestAxis(const glm::dvec3& v)
{
    const int axis = std::abs(v.x) > std::abs(v.y) ? 0 : 1;
    return std::abs(v.z) > std::abs(v[axis]) ? 2 : axis;
}

/// @param v  of any length but 0
UpDirection directionOf(const glm::dvec3& v)
{
    const glm::dvec3 unit = glm::normalize(v);
    return {inWords(unit.x) + ',' + inWords(unit.y) + ',' + inWords(unit.z), unit};
}

bool isAskew(const glm::dvec3& v)
{
    const glm::dvec3 unit = glm::normalize(v);
    const double along = unit[largestAxis(unit)];
    return 1.0 - along * along > kAskew * kAskew;
}

std::string askewWords(const UpDirection& up)
{
    return "the tooth lies askew to the axes of the file and was turned so that " + up.name +
           " of the file is up; give --up if you know better";
}

/// Returns where a mesh begins and ends along a unit vector.
std::pair<double, double> extentAlong(const TriangleMesh& mesh, const glm::dvec3& axis)
{
    double low = std::numeric_limits<double>::max();
    double high = -low;
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle) {
            const double place = glm::dot(axis, glm::dvec3(mesh.vertices[corner]));
            low = std::min(low, place);
            high = std::max(high, place);
        }
    return {low, high};
}

/// Returns the direction of the crown of a long mesh whose long axis lies askew; empty for any other mesh.
std::optional<UpDirection> askewUp(const TriangleMesh& mesh, std::string& reason)
{
    const PrincipalAxes principal = principalAxes(mesh);
    const glm::dvec3 axis = principal.axes[0];
    if (!(principal.spread.x > kLongSpread * principal.spread.y) || !isAskew(axis))
        return std::nullopt;
    const auto [low, high] = extentAlong(mesh, axis);
    for (const glm::dvec3& across : {principal.axes[1], principal.axes[2]})
        if (const auto [from, to] = extentAlong(mesh, across); high - low < kLongShape * (to - from))
            return std::nullopt;
    const double plus = endArea(mesh, axis, high, 0.25 * (high - low));
    const double minus = endArea(mesh, axis, low, 0.25 * (high - low));
    UpDirection up = directionOf(plus >= minus ? axis : -axis);
    reason = "guessed: the mesh is longest along " + up.name + " and that end is the wider one, as a crown is (" +
             inWords(100.0 * std::max(plus, minus) / (plus + minus)) + " % of both ends' outline)";
    return up;
}

UpDirection guessUp(const TriangleMesh& mesh, const MeshFacts& facts, std::string& reason,
                    std::vector<std::string>& warnings)
{
    const glm::dvec3 size = facts.high - facts.low;
    const auto endOf = [&facts](int axis, double sign) { return sign > 0.0 ? facts.high[axis] : facts.low[axis]; };
    const auto along = [](int axis) { return axisOf(axis, 1.0).inFile; };
    // 1. An open scan: the area vectors of the faces add up to a vector that points away from the opening.
    const glm::dvec3 v = facts.areaVector;
    int axis = largestAxis(v);
    if (!facts.closed && std::abs(v[axis]) > 0.15 * facts.area) {
        reason = "guessed: the scan is open and its opening looks the other way";
        if (!isAskew(v))
            return axisOf(axis, v[axis]);
        UpDirection up = directionOf(v);
        warnings.push_back(askewWords(up));
        return up;
    }
    // 2. A model with a flat cut: the flat side is at the bottom.
    int flatSides = 0;
    UpDirection flatUp;
    for (int k = 0; k < 3; ++k)
        for (const double sign : {1.0, -1.0}) {
            const double outline = size.x * size.y * size.z / std::max(size[k], std::numeric_limits<double>::min());
            if (endArea(mesh, along(k), endOf(k, sign), 0.005 * size[k]) > 0.3 * outline) {
                ++flatSides;
                flatUp = axisOf(k, -sign);
            }
        }
    if (flatSides == 1) {
        reason = "guessed: the model is cut off flat on the other side";
        return flatUp;
    }
    // 3. A whole tooth is longest along its axis, and the crown is the end that narrows less.
    if (const auto up = askewUp(mesh, reason)) {
        warnings.push_back(askewWords(*up));
        return *up;
    }
    axis = size.x > size.y ? 0 : 1;
    axis = size.z >= size[axis] ? 2 : axis;
    const double next = std::max(size[(axis + 1) % 3], size[(axis + 2) % 3]);
    if (size[axis] > 1.15 * next) {
        const double plus = endArea(mesh, along(axis), endOf(axis, 1.0), 0.25 * size[axis]);
        const double minus = endArea(mesh, along(axis), endOf(axis, -1.0), 0.25 * size[axis]);
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
    return {};
}

/// Turns a vector of the file so that the axis of the file that is nearest to `up` becomes +z.
glm::dvec3 turnedByAxis(const glm::dvec3& up, const glm::dvec3& p)
{
    const int axis = largestAxis(up);
    const double sign = up[axis] > 0.0 ? 1.0 : -1.0;
    if (axis == 0)
        return {-sign * p.z, p.y, sign * p.x};
    if (axis == 1)
        return {p.x, -sign * p.z, sign * p.y};
    return {p.x, sign * p.y, sign * p.z};
}

/// Turns a vector of the file into the tooth frame.
glm::dvec3 turned(const glm::dvec3& up, const glm::dvec3& p)
{
    const glm::dvec3 nearly = turnedByAxis(up, p);
    const glm::dvec3 from = turnedByAxis(up, up);
    if (from.z == 1.0)
        return nearly;
    // The shortest turn of `from` to +z, by Rodrigues' formula. It is less than 55 degrees.
    const glm::dvec3 axis(from.y, -from.x, 0.0);  // from x (0, 0, 1)
    return from.z * nearly + glm::cross(axis, nearly) + axis * (glm::dot(axis, nearly) / (1.0 + from.z));
}

/// Returns the middle of the box around the crown, seen from above, at the height of its highest point.
glm::dvec3 crownOrigin(const TriangleMesh& mesh, const Placement& placement, const glm::dvec3& originInFile)
{
    double highest = -std::numeric_limits<double>::max();
    for (const glm::vec3& vertex : mesh.vertices)
        highest = std::max(highest, toothFromFile(placement, originInFile + glm::dvec3(vertex)).z);
    glm::dvec2 low(std::numeric_limits<double>::max());
    glm::dvec2 high = -low;
    for (const glm::vec3& vertex : mesh.vertices)
        if (const glm::dvec3 p = toothFromFile(placement, originInFile + glm::dvec3(vertex));
            p.z >= highest - kCrownDepthMm) {
            low = glm::min(low, glm::dvec2(p));
            high = glm::max(high, glm::dvec2(p));
        }
    return {(low + high) * 0.5, highest};
}

tl::unexpected<Error> unknownDirection(std::string_view text)
{
    return unexpected(ErrorCode::UnknownName,
                      "the direction \"" + std::string(text) +
                          "\" is unknown; give one of +x, -x, +y, -y, +z, -z, or three numbers such as 1,0,1");
}

}  // namespace

Result<UpDirection> parseUp(std::string_view text)
{
    for (std::size_t k = 0; k < kAxisNames.size(); ++k)
        if (text == kAxisNames[k] || (k % 2 == 0 && text == kAxisNames[k].substr(1)))
            return axisOf(static_cast<int>(k / 2), k % 2 == 0 ? 1.0 : -1.0);
    glm::dvec3 v(0.0);
    std::string_view rest = text;
    for (int k = 0; k < 3; ++k) {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        const auto number = finiteNumber(rest.substr(0, comma));
        if (!number || (comma == rest.size()) != (k == 2))
            return unknownDirection(text);
        v[k] = *number;
        rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
    if (!(largest(glm::abs(v)) > 1e-9))
        return unknownDirection(text);
    UpDirection up = directionOf(v / largest(glm::abs(v)));
    up.name = text;
    return up;
}

Result<LengthUnit> parseUnit(std::string_view text)
{
    for (const LengthUnit& unit :
         {LengthUnit{"mm", 1.0}, LengthUnit{"cm", 10.0}, LengthUnit{"m", 1000.0}, LengthUnit{"in", kMmPerInch}})
        if (equalsIgnoringCase(text, unit.name))
            return unit;
    for (const std::string_view inches : {"inch", "inches"})
        if (equalsIgnoringCase(text, inches))
            return LengthUnit{"in", kMmPerInch};
    double value = 0.0;
    const auto [stop, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc() || stop != text.data() + text.size() || text.empty() || !std::isfinite(value) ||
        !(value > 0.0))
        return unexpected(ErrorCode::UnknownName,
                          "the unit \"" + std::string(text) +
                              "\" is unknown; give mm, cm, m, in or the millimetres in one unit");
    return LengthUnit{std::string(text), value};
}

Result<Placement> findPlacement(const TriangleMesh& mesh, const MeshFacts& facts, const PlacementOptions& options,
                                const glm::dvec3& originInFile)
{
    Placement placement;
    const double size = largest(facts.high - facts.low);
    if (options.keepFrame) {
        placement.unitReason = placement.upReason = "the file's own frame was kept";
    } else {
        placement.unitReason = placement.upReason = "given";
        placement.unit = options.unit
                             ? *options.unit
                             : guessUnit(sidesOf(facts.high - facts.low), placement.unitReason, placement.warnings);
        placement.unitDoubtful = !placement.warnings.empty();
        const std::size_t before = placement.warnings.size();
        placement.up = options.up ? *options.up : guessUp(mesh, facts, placement.upReason, placement.warnings);
        placement.isTurned = !options.up && isAskew(placement.up.inFile);
        placement.upDoubtful = !placement.isTurned && placement.warnings.size() > before;
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
        placement.originMm = crownOrigin(mesh, placement, originInFile);
    else if (largest(glm::max(originInFile + facts.high, -originInFile - facts.low)) > kMostCoordinateMm)
        return unexpected(ErrorCode::OutOfRange, "it lies more than 10 m from its own origin; move it there, or leave "
                                                 "out --frame file");
    return placement;
}

glm::dvec3 toothFromFile(const Placement& placement, const glm::dvec3& pointInFile)
{
    return turned(placement.up.inFile, pointInFile) * placement.unit.mmPerUnit - placement.originMm;
}

void moveToToothFrame(TriangleMesh& mesh, const Placement& placement, const glm::dvec3& originInFile)
{
    for (glm::vec3& vertex : mesh.vertices)
        vertex = glm::vec3(toothFromFile(placement, originInFile + glm::dvec3(vertex)));
}

}  // namespace core::mesh
