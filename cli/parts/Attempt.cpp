// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/parts/Attempt.h"

#include <algorithm>
#include <array>
#include <vector>

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>

#include "core/settings/FeelPreset.h"
#include "lessons/PresetShelf.h"
#include "lessons/ScoreSheetJson.h"

namespace cli {
namespace {

constexpr std::array<const char*, core::terrain::kMaterialCount> kMaterials{"caries", "enamel", "dentin", "pulp"};
constexpr std::size_t kShownHash = 12;  ///< hex digits that distinguish rubrics

QString nameOf(lessons::Moment::Kind kind)
{
    switch (kind) {
    case lessons::Moment::Kind::Stroke:
        return QStringLiteral("stroke");
    case lessons::Moment::Kind::Way:
        return QStringLiteral("way");
    case lessons::Moment::Kind::Never:
        break;
    }
    return QStringLiteral("never");
}

}  // namespace

core::Status takePreset(const QString& nameOrFile, core::servo::ServoSettings& settings)
{
    if (const auto shipped = core::settings::findHardnessPreset(nameOrFile.toStdString())) {
        settings.hardness = *shipped;
        return {};
    }
    core::settings::FeelPreset preset;
    if (QFileInfo::exists(nameOrFile)) {
        const lessons::ReadPreset read = lessons::readPreset(nameOrFile);
        // With a number missing in the file, the simulation would use one that is not in the file.
        if (!read.faults.empty())
            return core::unexpected(
                core::ErrorCode::BadStructure,
                "Hardness preset " + read.faults.front().sentence().toStdString() +
                    "; name natural, typodont or a JSON file, \"cusp simulate --help\" shows what it may hold.");
        preset = *read.preset;
    } else if (auto found = lessons::findPreset(lessons::PresetFolder(lessons::presetsFolder()).list(), nameOrFile)) {
        preset = *found;
    } else {
        return tl::unexpected(found.error());
    }
    settings.hardness = core::settings::hardnessFor(preset, {});
    core::settings::putForces(preset, settings.force);
    return {};
}

QString presetText(const core::recording::Recording& recording)
{
    return QString::fromStdString(recording.settings().hardness.name) +
           (recording.isRetuned() ? QStringLiteral(", changed") : QString());
}

QJsonObject toJson(const core::terrain::PerMaterial& values)
{
    QJsonObject object;
    for (std::size_t m = 0; m < kMaterials.size(); ++m)
        object[QLatin1String(kMaterials[m])] = values[m];
    return object;
}

QJsonObject toJson(const core::grading::Measured& measured)
{
    QJsonObject object;
    for (const core::grading::MeasureInfo& measure : core::grading::measureTable()) {
        const auto value = measure.value(measured);
        object.insert(QString::fromUtf8(measure.id.data(), static_cast<qsizetype>(measure.id.size())),
                      value ? QJsonValue(*value) : QJsonValue());
    }
    object.insert(QStringLiteral("not_measured"),
                  QJsonArray{QStringLiteral("undercuts"), QStringLiteral("walls past 90 degrees")});
    return object;
}

namespace {

QString nameOf(core::grading::RuleViolation breach)
{
    using core::grading::RuleViolation;
    switch (breach) {
    case RuleViolation::PulpExposed:
        return QStringLiteral("pulp_exposed");
    case RuleViolation::Perforated:
        return QStringLiteral("perforated");
    case RuleViolation::TooDeep:
        return QStringLiteral("too_deep");
    case RuleViolation::RidgeCut:
        return QStringLiteral("ridge_cut");
    case RuleViolation::WrongPlace:
        return QStringLiteral("wrong_place");
    case RuleViolation::TooMuchForce:
        return QStringLiteral("too_much_force");
    case RuleViolation::BurInAir:
        return QStringLiteral("bur_in_air");
    case RuleViolation::WrongBur:
        return QStringLiteral("wrong_bur");
    case RuleViolation::NeighbourHit:
        break;
    }
    return QStringLiteral("neighbour_hit");
}

}  // namespace

QJsonArray toJson(const std::vector<core::grading::Infraction>& infractions)
{
    QJsonArray list;
    for (const core::grading::Infraction& infraction : infractions)
        list.append(QJsonObject{{"what", nameOf(infraction.breach)},
                                {"tick", static_cast<qint64>(infraction.tick)},
                                {"at_s", infraction.seconds},
                                {"x_mm", infraction.placeMm.x},
                                {"y_mm", infraction.placeMm.y},
                                {"z_mm", infraction.placeMm.z},
                                {"value", infraction.value},
                                {"limit", infraction.limit}});
    return list;
}

QString toText(const std::vector<core::grading::Infraction>& infractions)
{
    QString text;
    for (const core::grading::Infraction& infraction : infractions)
        text += QStringLiteral("%1 %2 at %3 s\n")
                    .arg(text.isEmpty() ? QStringLiteral("infractions   ") : QString(14, QLatin1Char(' ')))
                    .arg(nameOf(infraction.breach), -15)
                    .arg(infraction.seconds, 0, 'f', 2);
    return text;
}

QJsonObject toJson(const lessons::PointLossTimeline& moments)
{
    QJsonObject object;
    for (std::size_t k = 0; k < moments.ofCriteria.size(); ++k) {
        QJsonArray list;
        for (const lessons::Moment& moment : moments.ofCriteria[k])
            list.append(QJsonObject{{"kind", nameOf(moment.kind)},
                                    {"lost_tenths", moment.lostTenths},
                                    {"tick", static_cast<qint64>(moment.tick)},
                                    {"at_s", moment.seconds},
                                    {"stroke", moment.stroke}});
        object.insert(QString::fromStdString(moments.sheet.criteria[k].id), list);
    }
    return object;
}

QString toText(const lessons::PointLossTimeline& moments)
{
    QString text;
    for (std::size_t k = 0; k < moments.ofCriteria.size(); ++k)
        for (const lessons::Moment& moment : moments.ofCriteria[k]) {
            const QString when =
                moment.kind == lessons::Moment::Kind::Never ? QStringLiteral("never earned")
                : moment.stroke > 0
                    ? QStringLiteral("at %1 s, stroke %2").arg(moment.seconds, 0, 'f', 2).arg(moment.stroke)
                    : QStringLiteral("at %1 s").arg(moment.seconds, 0, 'f', 2);
            text += QStringLiteral("%1 %2 %3 %4\n")
                        .arg(text.isEmpty() ? QStringLiteral("lost          ") : QString(14, QLatin1Char(' ')))
                        .arg(QString::fromStdString(moments.sheet.criteria[k].id), -15)
                        .arg(-0.1 * moment.lostTenths, 6, 'f', 1)
                        .arg(when);
        }
    return text;
}

QJsonObject toJsonObject(const lessons::ScoreSheet& sheet)
{
    return QJsonDocument::fromJson(lessons::toJson(sheet)).object();
}

QJsonObject toJson(const haptics::TickTimes& times)
{
    return {{QStringLiteral("p50"), times.percentileUs(0.5)},
            {QStringLiteral("p99"), times.percentileUs(0.99)},
            {QStringLiteral("p999"), times.percentileUs(0.999)},
            {QStringLiteral("max"), times.longestUs()}};
}

QString hashText(std::uint64_t hash)
{
    return QStringLiteral("%1").arg(hash, 16, 16, QLatin1Char('0'));
}

QString toText(const lessons::ScoreSheet& sheet)
{
    const auto points = [](int tenths) { return QStringLiteral("%1.%2").arg(tenths / 10).arg(tenths % 10); };
    QString text =
        QStringLiteral("score          %1 of 100, %2 (pass mark %3; rubric %4 version %5, %6)\n")
            .arg(points(sheet.totalTenths), sheet.passed() ? QStringLiteral("passed") : QStringLiteral("not passed"),
                 points(sheet.passMarkTenths), QString::fromStdString(sheet.rubricId))
            .arg(sheet.rubricVersion)
            .arg(QString::fromStdString(sheet.rubricHash.substr(0, kShownHash)));
    for (const lessons::Criterion& criterion : sheet.criteria) {
        const QString unit = QString::fromStdString(criterion.unit);
        const QString measured = criterion.measured
                                     ? QStringLiteral("%1 %2").arg(*criterion.measured, 0, 'f', 3).arg(unit)
                                     : QStringLiteral("not measured");
        const QString rule =
            criterion.capTenths > 0 ? QStringLiteral("at most %1 points").arg(points(criterion.capTenths))
            : criterion.critical
                ? QStringLiteral("critical")
                : QStringLiteral("span %1, %2 points").arg(criterion.span).arg(points(criterion.weightTenths));
        const QString once = criterion.isTooEarly ? QStringLiteral(", earned once %1 reaches %2")
                                                        .arg(QString::fromStdString(criterion.once->measure))
                                                        .arg(criterion.once->reaches)
                                                  : QString();
        text += QStringLiteral("  %1 %2 (target %3, tolerance %4, %5%6): lost %7\n")
                    .arg(QString::fromStdString(criterion.id), -14)
                    .arg(measured)
                    .arg(criterion.target)
                    .arg(criterion.tolerance)
                    .arg(rule, once, points(criterion.lostTenths));
    }
    return text + QStringLiteral("not measured   undercuts and walls past 90 degrees: the model is a height field\n");
}

}  // namespace cli
