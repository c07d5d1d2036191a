// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"
#include "core/mesh/MeshAnalysis.h"
#include "core/mesh/TriangleMesh.h"

/// Conversion from a file's unit and axes to the tooth frame: millimetres, +z occlusal, right-handed, origin at the
/// centre of the crown's outline, at the height of the crown's highest point.
namespace core::mesh {

/// A direction in the file that becomes +z of the tooth frame.
struct UpDirection
{
    std::string name = "+z";           ///< "+x" to "-z", or "0.707,0,0.707"
    glm::dvec3 inFile{0.0, 0.0, 1.0};  ///< of length 1
    bool operator==(const UpDirection&) const = default;
};

/// Parses "+x", "-x", ... ("x" is "+x"), or three numbers such as "1,0,1". UnknownName otherwise.
[[nodiscard]] Result<UpDirection> parseUp(std::string_view text);

struct LengthUnit
{
    std::string name = "mm";  ///< "mm", "cm", "m", "in", or the number of millimetres as given
    double mmPerUnit = 1.0;
    bool operator==(const LengthUnit&) const = default;
};

/// Parses "mm", "cm", "m", "in", or a positive number of millimetres per unit.
[[nodiscard]] Result<LengthUnit> parseUnit(std::string_view text);

struct PlacementOptions
{
    std::optional<LengthUnit> unit;  ///< empty: guessed from the size
    std::optional<UpDirection> up;   ///< empty: guessed from the shape
    bool keepFrame = false;          ///< the file is in mm with +z up, and its origin is kept
};

/// The interpretation of a file. Its x axis stays the tooth's x axis unless it is the crown's direction, then its y
/// axis stays y; the remaining axis makes the frame right-handed. So up +z changes no axis, +y gives (x, -z, y), -y
/// gives (x, z, -y), -z gives (x, -y, -z), +x gives (-z, y, x) and -x gives (z, y, -x). Any other direction is turned
/// the shortest way from the nearest of these six.
struct Placement
{
    LengthUnit unit;
    UpDirection up;
    std::string unitReason;  ///< "given", or why it was guessed
    std::string upReason;
    bool unitDoubtful = false;  ///< guessed, with a warning that says why it may be wrong
    bool upDoubtful = false;    ///< likewise
    bool isTurned = false;      ///< the tooth lay askew to the axes of the file; a warning gives the direction
    glm::dvec3 originMm{0.0};   ///< the tooth frame's origin, in mm along the tooth's axes from the file's origin
    std::vector<std::string> warnings;
};

/// Chooses unit, direction and origin. Error if the size cannot be that of a tooth in the given unit.
/// @param originInFile  the point of the file at which the mesh has its origin, see MeshFile
[[nodiscard]] Result<Placement> findPlacement(const TriangleMesh& mesh, const MeshFacts& facts,
                                              const PlacementOptions& options,
                                              const glm::dvec3& originInFile = glm::dvec3(0.0));

/// Converts a point of the file to the tooth frame, mm.
[[nodiscard]] glm::dvec3 toothFromFile(const Placement& placement, const glm::dvec3& pointInFile);

/// Moves the whole mesh into the tooth frame.
void moveToToothFrame(TriangleMesh& mesh, const Placement& placement, const glm::dvec3& originInFile = glm::dvec3(0.0));

}  // namespace core::mesh
