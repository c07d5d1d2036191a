// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/RubricReader.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QCryptographicHash>
#include <QFileInfo>
#include <QJsonDocument>
#include <QRegularExpression>

#include "core/grading/MeasureTable.h"

namespace lessons {
namespace {

constexpr double kMostPoints = 100.0;
constexpr int kNewestVersion = 1'000'000;
const QStringList kSides{QStringLiteral("over"), QStringLiteral("under"), QStringLiteral("both")};
const QStringList kVerdicts{QStringLiteral("sum_of_errors"), QStringLiteral("worst_error")};

QString shippedFile(const QString& id)
{
    return QLatin1String(kShippedFolder) + id + QStringLiteral(".rubric.json");
}

/// Reads tenths of a point. A weight such as 12.25 is a fault, because points have one decimal.
int takeTenths(JsonKeys& keys, const char* key, int otherwise)
{
    const auto points = keys.number(key, 0.0, kMostPoints, "points");
    if (!points)
        return otherwise;
    const double tenths = *points * 10.0;
    if (std::abs(tenths - std::round(tenths)) > 1.0e-9)
        keys.fault(key, {QT_TRANSLATE_NOOP("Fault", "is %1; points are given to a tenth"), {noted(*points)}});
    return static_cast<int>(std::lround(tenths));
}

/// Reads the id of an existing measure and sets its unit.
std::string takeMeasure(JsonKeys& keys, const char* key, std::string* unit)
{
    std::string id = keys.neededText(key, 80);
    if (id.empty())
        return id;
    const auto measure = core::grading::findMeasure(id);
    if (!measure)
        keys.fault(key, {QT_TRANSLATE_NOOP("Fault", "\"%1\" is no measure; \"cusp lesson measures\" lists them"),
                         {core::noted(id)}});
    else if (unit != nullptr)
        *unit = std::string(measure->unit);
    return id;
}

CriterionRule takeCriterion(JsonKeys& keys)
{
    CriterionRule rule;
    rule.id = takeId(keys);
    rule.title = keys.local("title", false);
    rule.measure = takeMeasure(keys, "measure", &rule.unit);
    rule.side = static_cast<Side>(std::max(0, keys.choice("side", kSides)));
    rule.target = keys.number("target", -kLargestRubricNumber, kLargestRubricNumber, rule.unit.c_str(), 0.0);
    rule.tolerance = keys.number("tolerance", 0.0, kLargestRubricNumber, rule.unit.c_str(), 0.0);
    rule.critical = keys.flag("critical", false);
    if (keys.has("caps_at")) {
        rule.capTenths = takeTenths(keys, "caps_at", 1);  // the default 1 avoids a second fault if the key is refused
        if (rule.critical)
            keys.fault("caps_at", {QT_TRANSLATE_NOOP("Fault", "a critical criterion leaves no points; give one of the "
                                                              "two")});
        else if (rule.capTenths == 0)
            keys.fault("caps_at", {QT_TRANSLATE_NOOP("Fault", "must be at least 0.1 points; an error that leaves none "
                                                              "is \"critical\"")});
        rule.critical = true;
    }
    rule.span = keys.number("span", 0.0, kLargestRubricNumber, rule.unit.c_str(), 0.0);
    if (auto allowance = keys.object("allowance")) {
        if (!allowance->has("each"))
            allowance->fault("each", {QT_TRANSLATE_NOOP("Fault", "is missing")});
        rule.allowance = Allowance{takeMeasure(*allowance, "measure", nullptr),
                                   allowance->number("each", 0.0, kLargestRubricNumber, "", 0.0)};
        allowance->nameTheRest();
    }
    if (auto once = keys.object("once")) {
        rule.once.emplace();
        rule.once->measure = takeMeasure(*once, "measure", &rule.once->unit);
        if (!once->has("reaches"))
            once->fault("reaches", {QT_TRANSLATE_NOOP("Fault", "is missing")});
        rule.once->reaches =
            once->number("reaches", -kLargestRubricNumber, kLargestRubricNumber, rule.once->unit.c_str(), 0.0);
        once->nameTheRest();
    }
    if (!rule.critical && !keys.has("weight"))
        keys.fault("weight", {QT_TRANSLATE_NOOP("Fault", "is missing")});
    rule.weightTenths = takeTenths(keys, "weight", 0);
    keys.nameTheRest();
    return rule;
}

}  // namespace

std::string takeId(JsonKeys& keys)
{
    static const QRegularExpression kPattern(QStringLiteral("^[a-z0-9][a-z0-9_-]{0,63}$"));
    std::string id = keys.neededText("id", 64);
    if (!id.empty() && !kPattern.match(QString::fromStdString(id)).hasMatch())
        keys.fault("id",
                   {QT_TRANSLATE_NOOP("Fault", "may hold small letters, digits, '-' and '_' only, and begins with a "
                                               "letter or digit")});
    return id;
}

std::optional<Gathered> gatherRubric(const QJsonValue& value, const QString& file, JsonFiles& files)
{
    const auto complain = [&](core::LocalizableText what) {
        files.say(file, QStringLiteral("rubric"), std::move(what));
        return std::nullopt;
    };
    if (value.isObject())
        return files.underlaid(value.toObject(), file);
    if (!value.isString())
        return complain(
            {QT_TRANSLATE_NOOP("Fault", "is missing; name one that is shipped (\"decay_removal\"), a file beside the "
                                        "lesson, or write it out")});
    const QString name = value.toString();
    const QString found =
        name.endsWith(QStringLiteral(".json")) ? files.find(file, QStringLiteral("rubric"), name) : shippedFile(name);
    if (found.isEmpty())
        return std::nullopt;
    if (!QFileInfo::exists(found))
        return complain({QT_TRANSLATE_NOOP("Fault", "there is no rubric \"%1\""), {noted(name.left(80))}});
    return files.gather(found);
}

Rubric rubricFrom(const QJsonObject& object, const QString& file, const QString& path,
                  std::vector<ValidationIssue>& faults)
{
    std::vector<ValidationIssue> found;
    JsonKeys keys(object, file, path, found);
    Rubric rubric;
    static_cast<void>(keys.has("format"));  // present in a file of its own
    rubric.id = takeId(keys);
    rubric.version = static_cast<int>(keys.whole("version", 1, kNewestVersion, 1));
    rubric.title = keys.local("title", true);
    rubric.verdict = static_cast<Verdict>(std::max(0, keys.choice("verdict", kVerdicts)));
    rubric.passMarkTenths = takeTenths(keys, "pass_mark", rubric.passMarkTenths);
    keys.objects("criteria", static_cast<int>(kMostCriteria),
                 [&](JsonKeys& item) { rubric.criteria.push_back(takeCriterion(item)); });
    keys.nameTheRest();
    rubric.hash =
        QCryptographicHash::hash(QJsonDocument(object).toJson(QJsonDocument::Compact), QCryptographicHash::Sha256)
            .toHex()
            .toStdString();
    if (!anyGrave(found))
        if (const auto sound = check(rubric); !sound)
            keys.fault("", core::wordsOf(sound.error()));
    faults.insert(faults.end(), found.begin(), found.end());
    return rubric;
}

core::Result<Rubric> shippedRubric(const QString& id)
{
    const QString file = shippedFile(id);
    std::vector<ValidationIssue> faults;
    JsonFiles files(faults);
    if (const auto gathered = files.gather(file)) {
        Rubric rubric = rubricFrom(gathered->whole, file, {}, faults);
        if (!anyGrave(faults))
            return rubric;
    }
    const auto grave =
        std::find_if(faults.begin(), faults.end(), [](const ValidationIssue& fault) { return fault.grave; });
    return core::unexpected(core::ErrorCode::BadStructure, grave->sentence().toStdString());
}

}  // namespace lessons
