// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/ScoreSheetJson.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace lessons {
namespace {

constexpr int kFormat = 2;

QString text(const std::string& utf8)
{
    return QString::fromStdString(utf8);
}

QJsonObject toObject(const LocalText& words)
{
    QJsonObject object;
    for (const auto& [language, word] : words)
        object.insert(text(language), text(word));
    return object;
}

QString nameOf(Side side)
{
    switch (side) {
    case Side::Over:
        return QStringLiteral("over");
    case Side::Under:
        return QStringLiteral("under");
    case Side::Both:
        break;
    }
    return QStringLiteral("both");
}

}  // namespace

QByteArray toJson(const ScoreSheet& sheet, const std::optional<PresetUsed>& preset)
{
    QJsonArray criteria;
    for (const Criterion& criterion : sheet.criteria) {
        QJsonObject line{
            {"id", text(criterion.id)},
            {"title", toObject(criterion.title)},
            {"measure", text(criterion.measure)},
            {"unit", text(criterion.unit)},
            {"measured", criterion.measured ? QJsonValue(*criterion.measured) : QJsonValue()},
            {"side", nameOf(criterion.side)},
            {"target", criterion.target},
            {"tolerance", criterion.tolerance},
            {"span", criterion.span},
            {"critical", criterion.critical},
            {"weight_tenths", criterion.weightTenths},
            {"error", criterion.error},
            {"share", criterion.share},
            {"lost_tenths", criterion.lostTenths},
        };
        if (criterion.once)
            line.insert(QStringLiteral("once"),
                        QJsonObject{
                            {"measure", text(criterion.once->measure)},
                            {"reaches", criterion.once->reaches},
                            {"measured", criterion.onceMeasured ? QJsonValue(*criterion.onceMeasured) : QJsonValue()},
                            {"too_early", criterion.isTooEarly},
                        });
        criteria.append(line);
    }
    QJsonObject object{
        {"format", kFormat},
        {"rubric", text(sheet.rubricId)},
        {"rubric_version", sheet.rubricVersion},
        {"rubric_hash", text(sheet.rubricHash)},
        {"rubric_title", toObject(sheet.rubricTitle)},
        {"verdict", sheet.verdict == Verdict::SumOfErrors ? "sum_of_errors" : "worst_error"},
        {"criteria", criteria},
        {"total_tenths", sheet.totalTenths},
        {"pass_mark_tenths", sheet.passMarkTenths},
        {"passed", sheet.passed()},
    };
    if (preset)
        object.insert(QStringLiteral("preset"), QJsonObject{{"name", preset->name},
                                                            {"version", preset->version},
                                                            {"hash", preset->hash},
                                                            {"changed", preset->isChanged}});
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

Values measuredIn(std::string_view json)
{
    Values values;
    const QByteArray bytes(json.data(), static_cast<qsizetype>(json.size()));
    for (const QJsonValue entry : QJsonDocument::fromJson(bytes).object().value(QStringLiteral("criteria")).toArray()) {
        const QJsonValue measured = entry.toObject().value(QStringLiteral("measured"));
        if (measured.isDouble())
            values.emplace(entry.toObject().value(QStringLiteral("measure")).toString().toStdString(),
                           measured.toDouble());
    }
    return values;
}

}  // namespace lessons
