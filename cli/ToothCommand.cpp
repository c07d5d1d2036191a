// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Commands.h"
#include "cli/parts/Arguments.h"
#include "core/base/WholeFile.h"
#include "core/mesh/ObjWriter.h"
#include "core/teeth/Laid.h"
#include "core/teeth/ToothBuilder.h"

namespace cli {
namespace {

using core::teeth::ToothReport;
using core::terrain::Material;

constexpr std::pair<Material, const char*> kMaterials[] = {
    {Material::Caries, "caries"}, {Material::Enamel, "enamel"}, {Material::Dentin, "dentin"}, {Material::Pulp, "pulp"}};

double volumeOf(const ToothReport& report, Material material)
{
    return report.layersMm3[static_cast<std::size_t>(material)];
}

QString upOf(const ToothReport& report)
{
    return QString::fromStdString(report.placement.up.name);
}

/// Returns the side that faces the bur.
QString sideOf(const ToothReport& report)
{
    const bool isGenerated = report.source == std::to_string(report.fdi);
    return QString::fromStdString(std::string(core::teeth::nameOf(report.lying, isGenerated ? report.fdi : 0)));
}

QJsonArray toJson(const glm::dvec3& v)
{
    return {v.x, v.y, v.z};
}

/// Returns the report as JSON. Tools rely on the keys: never rename or remove one; new keys may be added.
QJsonObject toJson(const ToothReport& report)
{
    QJsonObject layers;
    for (const auto& [material, name] : kMaterials)
        layers[QLatin1String(name)] = volumeOf(report, material);
    QJsonObject stages;
    for (const auto& [name, ms] : report.stagesMs)
        stages[QString::fromStdString(name)] = ms;
    const auto count = [](std::size_t n) { return static_cast<qint64>(n); };
    QJsonObject object{
        {QStringLiteral("source"), QString::fromStdString(report.source)},
        {QStringLiteral("fdi"), report.fdi},
        {QStringLiteral("triangles"), count(report.triangles)},
        {QStringLiteral("vertices"), count(report.vertices)},
        {QStringLiteral("closed"), report.closed},
        {QStringLiteral("oriented"), report.oriented},
        {QStringLiteral("manifold"), report.nonManifoldEdges == 0},
        {QStringLiteral("boundary_edges"), count(report.boundaryEdges)},
        {QStringLiteral("nonmanifold_edges"), count(report.nonManifoldEdges)},
        {QStringLiteral("flipped_edges"), count(report.flippedEdges)},
        {QStringLiteral("zero_area_faces"), count(report.zeroAreaFaces)},
        {QStringLiteral("duplicate_faces"), count(report.duplicateFaces)},
        {QStringLiteral("shells"), count(report.shells)},
        {QStringLiteral("shells_inside"), count(report.shellsInside)},
        {QStringLiteral("shells_inside_out"), count(report.shellsInsideOut)},
        {QStringLiteral("mesh_area_mm2"), report.meshAreaMm2},
        {QStringLiteral("mesh_volume_mm3"), report.meshVolumeMm3},
        {QStringLiteral("model_volume_mm3"), report.modelVolumeMm3},
        {QStringLiteral("undercut_mm3"), report.undercutMm3 ? QJsonValue(*report.undercutMm3) : QJsonValue()},
        {QStringLiteral("bounds_mm"), QJsonObject{{QStringLiteral("min"), toJson(report.lowMm)},
                                                  {QStringLiteral("max"), toJson(report.highMm)},
                                                  {QStringLiteral("size"), toJson(report.highMm - report.lowMm)}}},
        {QStringLiteral("unit"), QString::fromStdString(report.placement.unit.name)},
        {QStringLiteral("mm_per_unit"), report.placement.unit.mmPerUnit},
        {QStringLiteral("unit_reason"), QString::fromStdString(report.placement.unitReason)},
        {QStringLiteral("up"), upOf(report)},
        {QStringLiteral("up_reason"), QString::fromStdString(report.placement.upReason)},
        {QStringLiteral("grid"), report.gridSide},
        {QStringLiteral("cell_mm"), report.cellMm},
        {QStringLiteral("sewn_cells"), count(report.sewnCells)},
        {QStringLiteral("layers_mm3"), layers},
        {QStringLiteral("warnings"), toJsonArray(report.warnings)},
        {QStringLiteral("load_ms"), report.loadMs},
        {QStringLiteral("load_cpu_ms"), report.loadCpuMs},
        {QStringLiteral("stages_ms"), stages},
    };
    if (!report.lying.isUpright()) {
        object.insert(QStringLiteral("lies"), sideOf(report));
        object.insert(QStringLiteral("tilt_deg"), report.lying.tiltDeg);
    }
    return object;
}

QString kindOf(const ToothReport& report)
{
    const QString closed = report.closed ? QStringLiteral("closed") : QStringLiteral("not closed");
    const QString shells = report.shells == 1 ? QStringLiteral("one shell")
                                              : QStringLiteral("%1 shells").arg(static_cast<qint64>(report.shells));
    return closed + QStringLiteral(", ") + shells;
}

QString toText(const ToothReport& report)
{
    const auto number = [](double value, int decimals) {
        const QString digits = QString::number(value, 'f', decimals);
        return digits.toDouble() == 0.0 ? QString::number(0.0, 'f', decimals) : digits;  // no "-0.000"
    };
    const auto& placement = report.placement;
    const glm::dvec3 size = report.highMm - report.lowMm;
    QString text = QString::fromStdString(report.source) + u'\n';
    const auto line = [&](const char* key, const QString& value) {
        text += QStringLiteral("  %1 %2\n").arg(QLatin1String(key), -8).arg(value);
    };
    line("mesh", QStringLiteral("%1 triangles, %2 vertices, %3")
                     .arg(static_cast<qint64>(report.triangles))
                     .arg(static_cast<qint64>(report.vertices))
                     .arg(kindOf(report)));
    line("unit", QStringLiteral("%1 (%2)").arg(QString::fromStdString(placement.unit.name),
                                               QString::fromStdString(placement.unitReason)));
    line("up", QStringLiteral("%1 (%2)").arg(upOf(report), QString::fromStdString(placement.upReason)));
    if (!report.lying.isUpright())
        line("lies", QStringLiteral("%1, tilted by %2 degrees").arg(sideOf(report), number(report.lying.tiltDeg, 1)));
    line("bounds", QStringLiteral("%1 x %2 x %3 mm").arg(number(size.x, 2), number(size.y, 2), number(size.z, 2)));
    line("grid", QStringLiteral("%1 x %1 nodes, cell %2 mm, %3 cells sewn at the rim")
                     .arg(report.gridSide)
                     .arg(number(report.cellMm, 4))
                     .arg(static_cast<qint64>(report.sewnCells)));
    line("volume", QStringLiteral("mesh %1, model %2, undercut lost %3 mm3")
                       .arg(number(report.meshVolumeMm3, 3), number(report.modelVolumeMm3, 3),
                            report.undercutMm3 ? number(*report.undercutMm3, 3) : QStringLiteral("unknown")));
    QStringList layers;
    for (const auto& [material, name] : kMaterials)
        layers += QStringLiteral("%1 %2").arg(QLatin1String(name), number(volumeOf(report, material), 2));
    line("layers", layers.join(QStringLiteral(", ")) + QStringLiteral(" mm3"));
    QStringList stages;
    for (const auto& [name, ms] : report.stagesMs)
        stages += QStringLiteral("%1 %2").arg(QString::fromStdString(name), number(ms, 1));
    line("time", QStringLiteral("%1 ms, of the processor %2 (%3)")
                     .arg(number(report.loadMs, 1), number(report.loadCpuMs, 1), stages.join(QStringLiteral(", "))));
    for (const std::string& warning : report.warnings)
        line("warning", QString::fromStdString(warning));
    return text;
}

core::Status exportObj(const core::teeth::BuiltTooth& tooth, const QString& path)
{
    const std::string comment = "Tooth " + tooth.report.source + ", seed " + std::to_string(tooth.anatomy->seed) +
                                ", written by Cusp. Unit mm, +z occlusal.";
    return core::mesh::writeObj(path.toStdString(), tooth.mesh, comment);
}

}  // namespace

int toothCommand(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Reads a mesh (OBJ, STL, PLY) or makes one of our teeth, and says what it is and what the model makes of it."));
    parser.addPositionalArgument(
        QStringLiteral("FILE|FDI"),
        QStringLiteral("A mesh file, the number of a tooth (21-28, 31-38) or a practice block such as block:line."));
    addToothOptions(parser);
    parser.addOption({QStringLiteral("export"), QStringLiteral("Writes the mesh in the tooth frame, in mm."),
                      QStringLiteral("FILE.obj")});
    addJson(parser);
    const QString usage = QStringLiteral("cusp tooth FILE|FDI [OPTIONS]");
    if (const auto code = parse(parser, arguments, usage))
        return *code;
    const QString named = parser.positionalArguments().value(0);
    if (parser.positionalArguments().size() != 1 || named.trimmed().isEmpty())
        return wrongUsage(QStringLiteral("one mesh file or tooth number is wanted; usage: ") + usage);
    const auto source = core::teeth::parseSource(named.toStdString());
    const auto options = toothOptions(parser, source);
    if (!options)
        return wrongUsage(QString::fromStdString(options.error().detail));

    const QString exported = parser.value(QStringLiteral("export"));
    if (parser.isSet(QStringLiteral("export")) && !exported.endsWith(QStringLiteral(".obj"), Qt::CaseInsensitive))
        return wrongUsage(QStringLiteral("--export writes an OBJ file; give it a name that ends in .obj"));
    if (!exported.isEmpty() && core::isSameFile(exported.toStdString(), named.toStdString()))
        return wrongUsage(QStringLiteral("--export would overwrite the mesh that is read; name another file"));

    const auto tooth = core::teeth::buildTooth(source, *options);
    if (!tooth)
        return failed(tooth.error());
    if (!exported.isEmpty())
        if (const core::Status written = exportObj(*tooth, exported); !written)
            return failed(written.error());
    if (parser.isSet(QStringLiteral("json")))
        printJson(toJson(tooth->report));
    else
        printText(toText(tooth->report));
    return kDone;
}

}  // namespace cli
