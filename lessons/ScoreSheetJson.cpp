// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/ScoreSheetJson.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace lessons {
namespace {

using core::ErrorCode;

constexpr int kFormat = 1;

/// Takes typed values out of one object and keeps the first thing that was wrong.
class Reader
{
public:
    Reader(const QJsonObject& object, std::string where) : m_object(object), m_where(std::move(where)) {}

    std::string text(const char* key)
    {
        const QJsonValue value = m_object.value(QLatin1String(key));
        if (!value.isString())
            complain(key, "a text");
        return value.toString().toStdString();
    }
    double number(const char* key)
    {
        const QJsonValue value = m_object.value(QLatin1String(key));
        if (!value.isDouble())
            complain(key, "a number");
        return value.toDouble();
    }
    int whole(const char* key, int low, int high)
    {
        const double value = number(key);
        if (value != std::floor(value) || value < low || value > high) {
            complain(key, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
            return low;
        }
        return static_cast<int>(value);
    }
    bool truth(const char* key)
    {
        const QJsonValue value = m_object.value(QLatin1String(key));
        if (!value.isBool())
            complain(key, "true or false");
        return value.toBool();
    }
    void complain(const char* key, const std::string& expected)
    {
        if (!m_wrong)
            m_wrong = "score sheet: " + m_where + key + " must be " + expected;
    }
    [[nodiscard]] const std::optional<std::string>& wrong() const { return m_wrong; }

private:
    const QJsonObject& m_object;
    std::string m_where;
    std::optional<std::string> m_wrong;
};

QString text(const std::string& utf8)
{
    return QString::fromStdString(utf8);
}

core::Result<Criterion> criterionFrom(const QJsonValue& value, const std::string& where)
{
    const QJsonObject object = value.toObject();
    Reader read(object, where);
    Criterion criterion;
    criterion.id = read.text("id");
    criterion.measured = read.number("measured");
    criterion.unit = read.text("unit");
    criterion.free = read.number("free");
    const std::string rule = read.text("rule");
    criterion.rule = rule == "once" ? PointRule::Once : PointRule::PerUnit;
    if (rule != "once" && rule != "per_unit")
        read.complain("rule", "\"per_unit\" or \"once\"");
    criterion.pointsPerUnit = read.number("points_per_unit");
    criterion.maxPoints = read.whole("max_points", 0, 100);
    criterion.critical = read.truth("critical");
    criterion.pointsLost = read.whole("points_lost", 0, 100);
    if (!read.wrong() && criterion.pointsLost != pointsLostBy(criterion))
        read.complain("points_lost", "what its own numbers give, " + std::to_string(pointsLostBy(criterion)));
    if (read.wrong())
        return core::unexpected(ErrorCode::BadStructure, *read.wrong());
    return criterion;
}

}  // namespace

QByteArray toJson(const ScoreSheet& sheet)
{
    QJsonArray criteria;
    for (const Criterion& criterion : sheet.criteria)
        criteria.append(QJsonObject{
            {"id", text(criterion.id)},
            {"measured", criterion.measured},
            {"unit", text(criterion.unit)},
            {"free", criterion.free},
            {"rule", criterion.rule == PointRule::Once ? "once" : "per_unit"},
            {"points_per_unit", criterion.pointsPerUnit},
            {"max_points", criterion.maxPoints},
            {"critical", criterion.critical},
            {"points_lost", criterion.pointsLost},
        });
    const QJsonObject object{
        {"format", kFormat},    {"rubric", text(sheet.rubricId)}, {"rubric_version", sheet.rubricVersion},
        {"criteria", criteria}, {"total", sheet.total},           {"pass_mark", sheet.passMark},
    };
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

core::Result<ScoreSheet> scoreSheetFromJson(const QByteArray& json)
{
    QJsonParseError parsed;
    const QJsonDocument document = QJsonDocument::fromJson(json, &parsed);
    if (parsed.error != QJsonParseError::NoError)
        return core::unexpected(ErrorCode::WrongKind, "score sheet: not JSON at byte " + std::to_string(parsed.offset) +
                                                          ", " + parsed.errorString().toStdString());
    if (!document.isObject())
        return core::unexpected(ErrorCode::WrongKind, "score sheet: the JSON is not an object");
    const QJsonObject object = document.object();
    Reader read(object, "");
    const int format = read.whole("format", 1, 1'000'000);
    if (!read.wrong() && format > kFormat)
        return core::unexpected(ErrorCode::NewerVersion,
                                "score sheet: format " + std::to_string(format) +
                                    " was written by a later program; this one reads format 1");
    ScoreSheet sheet;
    sheet.rubricId = read.text("rubric");
    sheet.rubricVersion = read.whole("rubric_version", 0, 1'000'000);
    sheet.total = read.whole("total", 0, 100);
    sheet.passMark = read.whole("pass_mark", 0, 100);
    const QJsonValue criteria = object.value("criteria");
    if (!criteria.isArray())
        read.complain("criteria", "a list");
    if (read.wrong())
        return core::unexpected(ErrorCode::BadStructure, *read.wrong());
    for (const auto& value : criteria.toArray()) {
        auto criterion = criterionFrom(value, "criteria[" + std::to_string(sheet.criteria.size()) + "].");
        if (!criterion)
            return tl::unexpected(criterion.error());
        sheet.criteria.push_back(std::move(*criterion));
    }
    if (sheet.total != std::max(0, 100 - sheet.pointsLost()))
        return core::unexpected(ErrorCode::BadStructure, "score sheet: total is " + std::to_string(sheet.total) +
                                                             " but 100 less " + std::to_string(sheet.pointsLost()) +
                                                             " points lost is not that");
    return sheet;
}

}  // namespace lessons
