// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include <QJsonArray>
#include <QJsonObject>
#include <QSet>
#include <QString>
#include <QStringList>

#include "lessons/LocalText.h"
#include "lessons/ValidationIssue.h"

namespace lessons {

/// The keys of one JSON object, read one by one: each value is checked as it is taken, everything wrong is collected,
/// and keys that nobody asked for are named at the end. So a teacher sees all faults of a file at once.
class JsonKeys
{
public:
    /// @param path    where the object stands in its file: "rubric.criteria[2]"; empty at the top
    /// @param faults  must outlive this
    JsonKeys(QJsonObject object, QString file, QString path, std::vector<ValidationIssue>& faults);

    [[nodiscard]] bool has(const char* key);
    /// A number within [low, high], or a fault and nothing. `unit` is for the sentence.
    [[nodiscard]] std::optional<double> number(const char* key, double low, double high, const char* unit);
    [[nodiscard]] double number(const char* key, double low, double high, const char* unit, double otherwise);
    [[nodiscard]] qint64 whole(const char* key, qint64 low, qint64 high, qint64 otherwise);
    [[nodiscard]] bool flag(const char* key, bool otherwise);
    /// UTF-8, at most `longest` characters; empty if missing.
    [[nodiscard]] std::string text(const char* key, qsizetype longest = 200);
    /// As text(); a character that cannot be seen, or turns the direction of what follows, is a fault.
    [[nodiscard]] std::string visibleText(const char* key, qsizetype longest);
    /// As text(); a missing or empty one is a fault.
    [[nodiscard]] std::string neededText(const char* key, qsizetype longest = 200);
    /// {"en": "...", "de": "..."}, or a plain text for all languages.
    [[nodiscard]] LocalText local(const char* key, bool isNeeded);
    [[nodiscard]] QStringList names(const char* key);
    /// The object at `key`, if there is one; something else there is a fault.
    [[nodiscard]] std::optional<JsonKeys> object(const char* key);
    /// Calls `each` for the objects of the list at `key`, at most `most` of them.
    void objects(const char* key, int most, const std::function<void(JsonKeys&)>& each);
    /// The place of `value` in `known`, or a fault that lists them, and -1. -1 without a fault if the key is missing.
    [[nodiscard]] int choice(const char* key, const QStringList& known);
    /// A list of 1 to `most` places [x, y], mm, each coordinate within [-far, far]; a fault names the place.
    [[nodiscard]] std::vector<glm::dvec2> places(const char* key, int most, double far);

    /// Warns of every key that was not asked for, with the nearest that was.
    void nameTheRest();
    void fault(const char* key, core::LocalizableText what, bool grave = true);
    [[nodiscard]] QString pathOf(const QString& key) const;

private:
    [[nodiscard]] QJsonValue take(const char* key);
    void refuseHidden(const QString& text, const char* key);
    [[nodiscard]] LocalText localOf(const QJsonValue& value, const char* key);

    QJsonObject m_object;
    QString m_file;
    QString m_path;
    std::vector<ValidationIssue>* m_faults;
    QSet<QString> m_asked;
};

}  // namespace lessons
