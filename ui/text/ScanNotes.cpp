// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/ScanNotes.h"

#include <algorithm>

#include <QCoreApplication>

#include "ui/text/Texts.h"

namespace ui::text {

QStringList scanNotes(const core::teeth::ToothReport& report)
{
    const auto n = [](std::size_t count) { return static_cast<int>(count); };
    QStringList notes;
    const core::mesh::Placement& placement = report.placement;
    const glm::dvec3 size = report.highMm - report.lowMm;
    const QString longest = number(std::max({size.x, size.y, size.z}), 1);
    if (placement.unitDoubtful && placement.unit.name == "mm")
        notes << QCoreApplication::translate("Scan", "Taken as millimetres the scan is %1 mm long, more than a tooth.")
                     .arg(longest);
    else if (placement.unitDoubtful && placement.unit.name == "cm")
        notes << QCoreApplication::translate("Scan", "The file names no unit. As centimetres it is %1 mm long, so "
                                                     "centimetres were taken.")
                     .arg(longest);
    else if (placement.unitDoubtful && placement.unit.name == "in")
        notes << QCoreApplication::translate("Scan", "The file names no unit. As inches it is %1 mm long, so inches "
                                                     "were taken.")
                     .arg(longest);
    else if (placement.unitDoubtful && placement.unit.name == "m")
        notes << QCoreApplication::translate("Scan", "The file names no unit. As metres it is %1 mm long, so metres "
                                                     "were taken.")
                     .arg(longest);
    else if (placement.unitDoubtful)
        notes << QCoreApplication::translate("Scan",
                                             "In no usual unit has the scan the size of a tooth, so it was made "
                                             "%1 mm long.")
                     .arg(longest);
    if (placement.isTurned)
        notes << QCoreApplication::translate("Scan", "The tooth lay askew in the file and was turned upright. If it is "
                                                     "not upright now, export it with the crown along +z.");
    if (placement.upDoubtful)
        notes << QCoreApplication::translate("Scan", "The shape does not show where the crown is. If the tooth lies "
                                                     "on its side, export it with the crown along +z.");
    if (report.boundaryEdges > 0)
        notes << QCoreApplication::translate("Scan", "The scan has openings; they were closed.");
    if (report.zeroAreaFaces > 0)
        notes << QCoreApplication::translate("Scan", "%n triangle(s) without an area were left out.", nullptr,
                                             n(report.zeroAreaFaces));
    if (report.duplicateFaces > 0)
        notes << QCoreApplication::translate("Scan", "%n triangle(s) are there twice.", nullptr,
                                             n(report.duplicateFaces));
    if (report.nonManifoldEdges > 0)
        notes << QCoreApplication::translate("Scan", "At %n edge(s) more than two triangles meet.", nullptr,
                                             n(report.nonManifoldEdges));
    if (report.flippedEdges > 0)
        notes << QCoreApplication::translate("Scan",
                                             "At %n edge(s) neighbouring triangles disagree which side is outside.",
                                             nullptr, n(report.flippedEdges));
    if (report.shellsInsideOut > 0)
        notes << QCoreApplication::translate("Scan", "The scan was inside out and has been turned.");
    if (report.shells > 1)
        notes << QCoreApplication::translate("Scan", "The scan has %n separate part(s); the outermost surface counts.",
                                             nullptr, n(report.shells));
    return notes;
}

}  // namespace ui::text
