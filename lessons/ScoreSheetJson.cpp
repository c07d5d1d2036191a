// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/ScoreSheetJson.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/grading/MeasureTable.h"

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

std::optional<Side> sideOf(const QString& name)
{
    for (const Side side : {Side::Over, Side::Under, Side::Both})
        if (nameOf(side) == name)
            return side;
    return std::nullopt;
}

/// Reads required keys and records whether all were present.
class Keys
{
public:
    explicit Keys(QJsonObject object) : m_object(std::move(object)) {}

    [[nodiscard]] bool areThere() const { return m_areThere; }
    [[nodiscard]] QJsonValue value(QLatin1String key) const { return m_object.value(key); }
    double number(QLatin1String key) { return need(key, QJsonValue::Double).toDouble(); }
    int count(QLatin1String key) { return need(key, QJsonValue::Double).toInt(); }
    bool flag(QLatin1String key) { return need(key, QJsonValue::Bool).toBool(); }
    QString words(QLatin1String key) { return need(key, QJsonValue::String).toString(); }
    std::string utf8(QLatin1String key) { return words(key).toStdString(); }
    LocalText localText(QLatin1String key)
    {
        LocalText text;
        const QJsonObject object = need(key, QJsonValue::Object).toObject();
        for (auto word = object.begin(); word != object.end(); ++word)
            text[word.key().toStdString()] = word.value().toString().toStdString();
        return text;
    }
    QJsonArray list(QLatin1String key) { return need(key, QJsonValue::Array).toArray(); }
    /// Returns a number; empty if the value is null.
    std::optional<double> measure(QLatin1String key)
    {
        const QJsonValue value = m_object.value(key);
        m_areThere = m_areThere && (value.isDouble() || value.isNull());
        return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
    }
    void refuse() { m_areThere = false; }

private:
    QJsonValue need(QLatin1String key, QJsonValue::Type type)
    {
        QJsonValue value = m_object.value(key);
        m_areThere = m_areThere && value.type() == type;
        return value;
    }

    QJsonObject m_object;
    bool m_areThere = true;
};

/// Returns the unit of a measure, because a sheet does not contain units.
std::string unitOf(const std::string& measure)
{
    const auto known = core::grading::findMeasure(measure);
    return known ? std::string(known->unit) : std::string();
}

std::optional<Criterion> criterionIn(const QJsonObject& object)
{
    Keys line(object);
    Criterion criterion;
    criterion.id = line.utf8(QLatin1String("id"));
    criterion.title = line.localText(QLatin1String("title"));
    criterion.measure = line.utf8(QLatin1String("measure"));
    criterion.unit = line.utf8(QLatin1String("unit"));
    criterion.measured = line.measure(QLatin1String("measured"));
    if (const auto side = sideOf(line.words(QLatin1String("side"))))
        criterion.side = *side;
    else
        line.refuse();
    criterion.target = line.number(QLatin1String("target"));
    criterion.tolerance = line.number(QLatin1String("tolerance"));
    criterion.span = line.number(QLatin1String("span"));
    criterion.critical = line.flag(QLatin1String("critical"));
    criterion.weightTenths = line.count(QLatin1String("weight_tenths"));
    criterion.error = line.number(QLatin1String("error"));
    criterion.share = line.number(QLatin1String("share"));
    criterion.lostTenths = line.count(QLatin1String("lost_tenths"));
    if (!line.value(QLatin1String("cap_tenths")).isUndefined())
        criterion.capTenths = line.count(QLatin1String("cap_tenths"));
    if (!line.areThere())
        return std::nullopt;
    const QJsonValue condition = line.value(QLatin1String("once"));
    if (condition.isUndefined())
        return criterion;
    Keys once(condition.toObject());
    const std::string measure = once.utf8(QLatin1String("measure"));
    criterion.once = Once{measure, unitOf(measure), once.number(QLatin1String("reaches"))};
    criterion.onceMeasured = once.measure(QLatin1String("measured"));
    criterion.isTooEarly = once.flag(QLatin1String("too_early"));
    return once.areThere() ? std::optional(criterion) : std::nullopt;
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
        if (criterion.capTenths != 0)
            line.insert(QStringLiteral("cap_tenths"), criterion.capTenths);
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

std::optional<ScoreSheet> sheetIn(std::string_view json)
{
    const QByteArray bytes(json.data(), static_cast<qsizetype>(json.size()));
    Keys keys(QJsonDocument::fromJson(bytes).object());
    if (keys.count(QLatin1String("format")) != kFormat)
        return std::nullopt;
    ScoreSheet sheet;
    sheet.rubricId = keys.utf8(QLatin1String("rubric"));
    sheet.rubricVersion = keys.count(QLatin1String("rubric_version"));
    sheet.rubricHash = keys.utf8(QLatin1String("rubric_hash"));
    sheet.rubricTitle = keys.localText(QLatin1String("rubric_title"));
    sheet.verdict = keys.words(QLatin1String("verdict")) == QLatin1String("sum_of_errors") ? Verdict::SumOfErrors
                                                                                           : Verdict::WorstError;
    for (const QJsonValue line : keys.list(QLatin1String("criteria"))) {
        auto criterion = criterionIn(line.toObject());
        if (!criterion)
            return std::nullopt;
        sheet.criteria.push_back(std::move(*criterion));
    }
    sheet.totalTenths = keys.count(QLatin1String("total_tenths"));
    sheet.passMarkTenths = keys.count(QLatin1String("pass_mark_tenths"));
    return keys.areThere() ? std::optional(sheet) : std::nullopt;
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
