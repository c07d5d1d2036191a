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

enum class Axis { PlusX, MinusX, PlusY, MinusY, PlusZ, MinusZ };

/// Parses "+x", "-x", ... ("x" is "+x"). UnknownName otherwise.
[[nodiscard]] Result<Axis> parseAxis(std::string_view text);
[[nodiscard]] std::string_view nameOf(Axis axis);

struct LengthUnit
{
    std::string name = "mm";  ///< "mm", "cm", "m", or the number of millimetres as given
    double mmPerUnit = 1.0;
    bool operator==(const LengthUnit&) const = default;
};

/// Parses "mm", "cm", "m", or a positive number of millimetres per unit.
[[nodiscard]] Result<LengthUnit> parseUnit(std::string_view text);

struct PlacementOptions
{
    std::optional<LengthUnit> unit;  ///< empty: guessed from the size
    std::optional<Axis> up;          ///< empty: guessed from the shape
    bool keepFrame = false;          ///< the file is in mm with +z up, and its origin is kept
};

/// The interpretation of a file. Its x axis stays the tooth's x axis unless it is the crown's direction, then its y
/// axis stays y; the remaining axis makes the frame right-handed. So up +z changes no axis, +y gives (x, -z, y), -y
/// gives (x, z, -y), -z gives (x, -y, -z), +x gives (-z, y, x) and -x gives (z, y, -x).
struct Placement
{
    LengthUnit unit;
    Axis up = Axis::PlusZ;
    std::string unitReason;  ///< "given", or why it was guessed
    std::string upReason;
    bool unitDoubtful = false;  ///< guessed, with a warning that says why it may be wrong
    bool upDoubtful = false;    ///< likewise
    glm::dvec3 originMm{0.0};   ///< the tooth frame's origin, in mm along the tooth's axes from the file's origin
    std::vector<std::string> warnings;
};

/// Chooses unit, direction and origin. Error if the size cannot be that of a tooth in the given unit.
[[nodiscard]] Result<Placement> findPlacement(const TriangleMesh& mesh, const MeshFacts& facts,
                                              const PlacementOptions& options);

/// Converts a point of the file to the tooth frame, mm.
[[nodiscard]] glm::dvec3 toothFromFile(const Placement& placement, const glm::dvec3& pointInFile);

/// Moves the whole mesh into the tooth frame.
void moveToToothFrame(TriangleMesh& mesh, const Placement& placement);

}  // namespace core::mesh
