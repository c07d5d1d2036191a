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

/// Reads the keys of a JSON object one by one: checks each value, collects all faults, and at the end warns of unknown
/// keys. So a teacher sees all faults of a file at once.
class JsonKeys
{
public:
    /// @param path    place of the object in its file: "rubric.criteria[2]"; empty at the top
    /// @param faults  must outlive this
    JsonKeys(QJsonObject object, QString file, QString path, std::vector<ValidationIssue>& faults);

    [[nodiscard]] bool has(const char* key);
    /// Returns a number within [low, high]. Empty if the key is missing, or, with a fault, if the value is wrong.
    /// `unit` is part of the message.
    [[nodiscard]] std::optional<double> number(const char* key, double low, double high, const char* unit);
    [[nodiscard]] double number(const char* key, double low, double high, const char* unit, double otherwise);
    [[nodiscard]] qint64 whole(const char* key, qint64 low, qint64 high, qint64 otherwise);
    [[nodiscard]] bool flag(const char* key, bool otherwise);
    /// Returns a text in UTF-8 of at most `longest` characters; empty if missing.
    [[nodiscard]] std::string text(const char* key, qsizetype longest = 200);
    /// Like text(); a character that is invisible or changes the text direction is a fault.
    [[nodiscard]] std::string visibleText(const char* key, qsizetype longest);
    /// Like text(); a missing or empty text is a fault.
    [[nodiscard]] std::string neededText(const char* key, qsizetype longest = 200);
    /// Returns a text by language, {"en": "...", "de": "..."}, or one text for all languages.
    [[nodiscard]] LocalText local(const char* key, bool isNeeded);
    [[nodiscard]] QStringList names(const char* key);
    /// Returns the object at `key`, if there is one; another value is a fault.
    [[nodiscard]] std::optional<JsonKeys> object(const char* key);
    /// Calls `each` for the objects of the list at `key`, for at most `most` of them.
    void objects(const char* key, int most, const std::function<void(JsonKeys&)>& each);
    /// Returns the index of a value in `known`. -1 if the key is missing, or, with a fault that lists them, if the
    /// value is unknown.
    [[nodiscard]] int choice(const char* key, const QStringList& known);
    /// Returns a list of 1 to `most` places [x, y], mm, with coordinates within [-far, far]; a fault names the place.
    [[nodiscard]] std::vector<glm::dvec2> places(const char* key, int most, double far);

    /// Warns of every key that was not read, with the most similar known key.
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
