// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/JsonKeys.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <QJsonArray>

namespace lessons {
namespace {

constexpr qsizetype kLongestText = 4000;
constexpr qsizetype kMostLanguages = 40;
constexpr qsizetype kMostNames = 40;
/// Largest number of letters in which a misspelled key may differ from a known one.
constexpr int kSlip = 3;

/// Returns a number for a message. Whole numbers, such as versions, have all their digits.
core::LocalizableText written(double number)
{
    constexpr double kWrittenOut = 1.0e15;
    const bool isWhole = number == std::floor(number) && std::abs(number) < kWrittenOut;
    return isWhole ? noted(QString::number(number, 'f', 0)) : noted(number);
}

/// Returns the edit distance of two words (Levenshtein).
int lettersApart(const QString& a, const QString& b)
{
    std::vector<int> row(static_cast<std::size_t>(b.size()) + 1);
    std::iota(row.begin(), row.end(), 0);
    for (qsizetype i = 0; i < a.size(); ++i) {
        int corner = row[0]++;
        for (qsizetype j = 0; j < b.size(); ++j) {
            const auto at = static_cast<std::size_t>(j);
            const int changed = corner + (a[i] == b[j] ? 0 : 1);
            corner = row[at + 1];
            row[at + 1] = std::min({changed, corner + 1, row[at] + 1});
        }
    }
    return row.back();
}

/// Returns the number of letters. Outside the first plane of Unicode, as in rare kanji, a letter has two code units.
qsizetype lettersIn(const QString& text)
{
    return text.toUcs4().size();
}

core::LocalizableText kindOf(const QJsonValue& value)
{
    switch (value.type()) {
    case QJsonValue::Bool:
        return {QT_TRANSLATE_NOOP("Fault", "true or false")};
    case QJsonValue::Double:
        return {QT_TRANSLATE_NOOP("Fault", "a number")};
    case QJsonValue::String:
        return {QT_TRANSLATE_NOOP("Fault", "a text")};
    case QJsonValue::Array:
        return {QT_TRANSLATE_NOOP("Fault", "a list")};
    case QJsonValue::Object:
        return {QT_TRANSLATE_NOOP("Fault", "an object")};
    case QJsonValue::Null:
    case QJsonValue::Undefined:
        break;
    }
    return {QT_TRANSLATE_NOOP("Fault", "null")};
}

/// Returns whether a character is invisible: a control character, except line ends and tabs, or one that changes the
/// direction of the text.
bool isHidden(QChar c)
{
    const char16_t code = c.unicode();
    return (c.category() == QChar::Other_Control && c != u'\n' && c != u'\t') || (code >= 0x202A && code <= 0x202E) ||
           (code >= 0x2066 && code <= 0x2069);
}

}  // namespace

JsonKeys::JsonKeys(QJsonObject object, QString file, QString path, std::vector<ValidationIssue>& faults)
    : m_object(std::move(object)), m_file(std::move(file)), m_path(std::move(path)), m_faults(&faults)
{}

QString JsonKeys::pathOf(const QString& key) const
{
    return m_path.isEmpty() ? key : key.isEmpty() ? m_path : m_path + QLatin1Char('.') + key;
}

void JsonKeys::fault(const char* key, core::LocalizableText what, bool grave)
{
    m_faults->push_back({m_file, pathOf(QLatin1String(key)), std::move(what), grave});
}

QJsonValue JsonKeys::take(const char* key)
{
    m_asked.insert(QLatin1String(key));
    return m_object.value(QLatin1String(key));
}

bool JsonKeys::has(const char* key)
{
    return !take(key).isUndefined();
}

std::optional<double> JsonKeys::number(const char* key, double low, double high, const char* unit)
{
    const QJsonValue value = take(key);
    if (value.isUndefined())
        return std::nullopt;
    const bool hasUnit = *unit != '\0';
    if (!value.isDouble()) {
        fault(key,
              hasUnit
                  ? core::LocalizableText{QT_TRANSLATE_NOOP("Fault", "is %1; write a number of %2 without its unit"),
                                          {kindOf(value), {unit}}}
                  : core::LocalizableText{QT_TRANSLATE_NOOP("Fault", "is %1; write a number"), {kindOf(value)}});
        return std::nullopt;
    }
    const double number = value.toDouble();
    if (!std::isfinite(number) || number < low || number > high) {
        fault(key, hasUnit
                       ? core::LocalizableText{QT_TRANSLATE_NOOP("Fault", "is %1, it must lie between %2 and %3 %4"),
                                               {written(number), written(low), written(high), {unit}}}
                       : core::LocalizableText{QT_TRANSLATE_NOOP("Fault", "is %1, it must lie between %2 and %3"),
                                               {written(number), written(low), written(high)}});
        return std::nullopt;
    }
    return number;
}

double JsonKeys::number(const char* key, double low, double high, const char* unit, double otherwise)
{
    return number(key, low, high, unit).value_or(otherwise);
}

qint64 JsonKeys::whole(const char* key, qint64 low, qint64 high, qint64 otherwise)
{
    const auto value = number(key, static_cast<double>(low), static_cast<double>(high), "");
    if (!value)
        return otherwise;
    if (*value != std::floor(*value)) {
        fault(key, {QT_TRANSLATE_NOOP("Fault", "is %1, it must be a whole number"), {written(*value)}});
        return otherwise;
    }
    return static_cast<qint64>(*value);
}

bool JsonKeys::flag(const char* key, bool otherwise)
{
    const QJsonValue value = take(key);
    if (!value.isUndefined() && !value.isBool())
        fault(key, {QT_TRANSLATE_NOOP("Fault", "is %1; write true or false"), {kindOf(value)}});
    return value.toBool(otherwise);
}

std::string JsonKeys::text(const char* key, qsizetype longest)
{
    const QJsonValue value = take(key);
    if (value.isUndefined())
        return {};
    if (!value.isString()) {
        fault(key, {QT_TRANSLATE_NOOP("Fault", "is %1; write a text in quotes"), {kindOf(value)}});
        return {};
    }
    const QString text = value.toString();
    if (const qsizetype letters = lettersIn(text); letters > longest) {
        fault(key,
              {QT_TRANSLATE_NOOP("Fault", "has %1 characters; at most %2 are read"), {noted(letters), noted(longest)}});
        return {};
    }
    return text.toStdString();
}

void JsonKeys::refuseHidden(const QString& text, const char* key)
{
    if (const auto hidden = std::find_if(text.begin(), text.end(), isHidden); hidden != text.end())
        fault(key, {QT_TRANSLATE_NOOP("Fault", "holds the character U+%1, which cannot be seen; leave it out"),
                    {noted(QStringLiteral("%1").arg(static_cast<uint>(hidden->unicode()), 4, 16, QLatin1Char('0')))}});
}

std::string JsonKeys::visibleText(const char* key, qsizetype longest)
{
    std::string found = text(key, longest);
    refuseHidden(QString::fromStdString(found), key);
    return found;
}

std::string JsonKeys::neededText(const char* key, qsizetype longest)
{
    if (take(key).isUndefined() || take(key) == QJsonValue(QString())) {
        fault(key, {QT_TRANSLATE_NOOP("Fault", "is missing")});
        return {};
    }
    return text(key, longest);
}

LocalText JsonKeys::localOf(const QJsonValue& value, const char* key)
{
    LocalText result;
    const auto take = [&](const QString& code, const QString& text) {
        if (const qsizetype letters = lettersIn(text); letters == 0 || letters > kLongestText)
            fault(key, {QT_TRANSLATE_NOOP("Fault", "has %1 characters; it takes 1 to %2"),
                        {noted(letters), noted(kLongestText)}});
        refuseHidden(text, key);
        result.emplace(code.toStdString(), text.toStdString());
    };
    if (value.isString()) {
        take(QStringLiteral("en"), value.toString());
        return result;
    }
    if (!value.isObject()) {
        fault(key, {QT_TRANSLATE_NOOP("Fault", "is %1; write {\"en\": \"...\", \"de\": \"...\"}"), {kindOf(value)}});
        return result;
    }
    const QJsonObject languages = value.toObject();
    if (languages.isEmpty() || languages.size() > kMostLanguages) {
        fault(key, {QT_TRANSLATE_NOOP("Fault", "has texts in %1 languages; it takes 1 to %2"),
                    {noted(languages.size()), noted(kMostLanguages)}});
        return result;
    }
    for (auto language = languages.begin(); language != languages.end(); ++language) {
        const QString code = language.key();
        if (code.size() < 2 || code.size() > 12 || !language.value().isString())
            fault(key,
                  {QT_TRANSLATE_NOOP("Fault", "\"%1\" must be the code of a language (en, de, es, ja) with a text"),
                   {noted(code.left(12))}});
        else
            take(code, language.value().toString());
    }
    return result;
}

LocalText JsonKeys::local(const char* key, bool isNeeded)
{
    const QJsonValue value = take(key);
    if (!value.isUndefined())
        return localOf(value, key);
    if (isNeeded)
        fault(key, {QT_TRANSLATE_NOOP("Fault", "is missing")});
    return {};
}

QStringList JsonKeys::names(const char* key)
{
    const QJsonValue value = take(key);
    if (value.isUndefined())
        return {};
    QStringList found;
    for (const QJsonValue name : value.toArray())
        if (name.isString() && lettersIn(name.toString()) <= kLongestText)
            found << name.toString();
    if (!value.isArray() || found.size() != value.toArray().size() || found.size() > kMostNames) {
        fault(key, {QT_TRANSLATE_NOOP("Fault", "must be a list of at most %1 texts: [\"...\", \"...\"]"),
                    {noted(kMostNames)}});
        return {};
    }
    return found;
}

std::optional<JsonKeys> JsonKeys::object(const char* key)
{
    const QJsonValue value = take(key);
    if (value.isUndefined())
        return std::nullopt;
    if (!value.isObject()) {
        fault(key, {QT_TRANSLATE_NOOP("Fault", "is %1; write an object in braces"), {kindOf(value)}});
        return std::nullopt;
    }
    return JsonKeys(value.toObject(), m_file, pathOf(QLatin1String(key)), *m_faults);
}

void JsonKeys::objects(const char* key, int most, const std::function<void(JsonKeys&)>& each)
{
    const QJsonValue value = take(key);
    if (value.isUndefined())
        return;
    const QJsonArray list = value.toArray();
    if (!value.isArray() || list.size() > most) {
        fault(key, {QT_TRANSLATE_NOOP("Fault", "must be a list of at most %1 objects"), {noted(most)}});
        return;
    }
    for (qsizetype k = 0; k < list.size(); ++k) {
        JsonKeys item(list[k].toObject(), m_file, pathOf(QStringLiteral("%1[%2]").arg(QLatin1String(key)).arg(k)),
                      *m_faults);
        if (!list[k].isObject())
            item.fault("", {QT_TRANSLATE_NOOP("Fault", "is %1; write an object in braces"), {kindOf(list[k])}});
        else
            each(item);
    }
}

int JsonKeys::choice(const char* key, const QStringList& known)
{
    const QJsonValue value = take(key);
    if (value.isUndefined())
        return -1;
    const auto place = known.indexOf(value.toString());
    if (!value.isString() || place < 0)
        fault(key, {QT_TRANSLATE_NOOP("Fault", "\"%1\" is not known; there are %2"),
                    {noted(value.toVariant().toString().left(40)), noted(known.join(QStringLiteral(", ")))}});
    return static_cast<int>(value.isString() ? place : -1);
}

std::vector<glm::dvec2> JsonKeys::places(const char* key, int most, double far)
{
    const QJsonValue value = take(key);
    const QJsonArray list = value.toArray();
    if (list.isEmpty() || list.size() > most) {
        fault(key, {QT_TRANSLATE_NOOP("Fault", "must be a list of 1 to %1 places: [[x, y], ...]"), {noted(most)}});
        return {};
    }
    std::vector<glm::dvec2> places;
    for (qsizetype k = 0; k < list.size(); ++k) {
        const QJsonArray pair = list[k].toArray();
        const bool isPair = pair.size() == 2 && pair[0].isDouble() && pair[1].isDouble();
        const glm::dvec2 place(pair[0].toDouble(), pair[1].toDouble());
        if (isPair && std::abs(place.x) <= far && std::abs(place.y) <= far)
            places.push_back(place);
        else
            fault(qPrintable(QStringLiteral("%1[%2]").arg(QLatin1String(key)).arg(k)),
                  {QT_TRANSLATE_NOOP("Fault", "must be [x, y], two numbers between %1 and %2 mm"),
                   {noted(-far), noted(far)}});
    }
    return places;
}

void JsonKeys::nameTheRest()
{
    for (const QString& key : m_object.keys()) {
        if (m_asked.contains(key))
            continue;
        QString nearest;
        int least = kSlip + 1;
        for (const QString& known : m_asked) {
            if (const int apart = lettersApart(key, known); apart < least && !m_object.contains(known)) {
                least = apart;
                nearest = known;
            }
        }
        core::LocalizableText what{QT_TRANSLATE_NOOP("Fault", "is not a key that is known here, so it is left out")};
        if (!nearest.isEmpty())
            what = {QT_TRANSLATE_NOOP("Fault", "is not a key that is known here; did you mean \"%1\"?"),
                    {noted(nearest)}};
        m_faults->push_back({m_file, pathOf(key.left(60)), std::move(what), false});
    }
}

}  // namespace lessons
