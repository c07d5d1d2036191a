// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/JsonFiles.h"

#include <utility>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSet>

namespace lessons {
namespace {

constexpr int kMostFiles = 8;
const QString kBasedOn = QStringLiteral("based_on");
const QString kFormatKey = QStringLiteral("format");
const QString kTitle = QStringLiteral("title");
constexpr const char* kTooLarge = QT_TRANSLATE_NOOP("Fault", "has %1; a lesson has at most %2");

/// Merges one object into another (RFC 7386): null removes a key, objects are merged, any other value replaces the old
/// one.
QJsonObject merged(QJsonObject base, const QJsonObject& over)
{
    for (auto entry = over.begin(); entry != over.end(); ++entry) {
        if (entry.value().isNull())
            base.remove(entry.key());
        else if (entry.value().isObject())
            base.insert(entry.key(), merged(base.value(entry.key()).toObject(), entry.value().toObject()));
        else
            base.insert(entry.key(), entry.value());
    }
    return base;
}

/// Returns the keys that occur twice in an object of a valid JSON text, spelled as in the text. Qt drops one of them
/// without an error.
QStringList keysSaidTwice(const QByteArray& json)
{
    QStringList twice;
    std::vector<QSet<QByteArray>> open;  // keys of each open object or list
    QByteArray text;
    for (qsizetype k = 0; k < json.size(); ++k) {
        const char letter = json[k];
        if (letter == '{' || letter == '[') {
            open.emplace_back();
        } else if (letter == '}' || letter == ']') {
            open.pop_back();
        } else if (letter == ':') {
            if (open.back().contains(text))
                twice << QString::fromUtf8(text);
            open.back().insert(text);
        } else if (letter == '"') {
            const qsizetype begin = k + 1;
            for (++k; json[k] != '"'; ++k)
                k += json[k] == '\\' ? 1 : 0;
            text = json.mid(begin, k - begin);
        }
    }
    return twice;
}

/// Returns Qt's text for an error, always in English.
const char* parseFault(QJsonParseError::ParseError error)
{
    switch (error) {
    case QJsonParseError::UnterminatedObject:
        return QT_TRANSLATE_NOOP("Fault", "unterminated object");
    case QJsonParseError::MissingNameSeparator:
        return QT_TRANSLATE_NOOP("Fault", "missing name separator");
    case QJsonParseError::UnterminatedArray:
        return QT_TRANSLATE_NOOP("Fault", "unterminated array");
    case QJsonParseError::MissingValueSeparator:
        return QT_TRANSLATE_NOOP("Fault", "missing value separator");
    case QJsonParseError::TerminationByNumber:
        return QT_TRANSLATE_NOOP("Fault", "invalid termination by number");
    case QJsonParseError::IllegalNumber:
        return QT_TRANSLATE_NOOP("Fault", "illegal number");
    case QJsonParseError::IllegalEscapeSequence:
        return QT_TRANSLATE_NOOP("Fault", "invalid escape sequence");
    case QJsonParseError::UnterminatedString:
        return QT_TRANSLATE_NOOP("Fault", "unterminated string");
    case QJsonParseError::MissingObject:
        return QT_TRANSLATE_NOOP("Fault", "object is missing after a comma");
    case QJsonParseError::DeepNesting:
        return QT_TRANSLATE_NOOP("Fault", "too deeply nested document");
    case QJsonParseError::DocumentTooLarge:
        return QT_TRANSLATE_NOOP("Fault", "too large document");
    case QJsonParseError::GarbageAtEnd:
        return QT_TRANSLATE_NOOP("Fault", "garbage at the end of the document");
    case QJsonParseError::NoError:
    case QJsonParseError::IllegalUTF8String:  // parseObject() reports it with a remedy
    case QJsonParseError::IllegalValue:
        break;
    }
    return QT_TRANSLATE_NOOP("Fault", "illegal value");
}

/// Returns whether an object contains a key, given by its path ("rubric.criteria[2].weight").
bool has(const QJsonObject& object, const QString& key)
{
    QJsonValue value = object;
    for (const QString& part : key.split(u'.')) {
        value = value.toObject().value(part.section(u'[', 0, 0));
        if (const qsizetype bracket = part.indexOf(u'['); bracket >= 0)
            value = value.toArray().at(part.mid(bracket + 1).chopped(1).toInt());
    }
    return !value.isUndefined();
}

}  // namespace

bool isNameBeside(const QString& name)
{
    return !name.isEmpty() && name.size() < 200 && QDir::isRelativePath(name) && !name.contains(QLatin1Char('\\')) &&
           !name.contains(QChar(u'\0')) && !name.split(QLatin1Char('/')).contains(QStringLiteral("..")) &&
           !name.startsWith(QLatin1Char(':'));
}

core::LocalizableText sizeWords(qint64 bytes)
{
    return bytes >= 1024 * 1024
               ? noted(QStringLiteral("%1 MB").arg(static_cast<double>(bytes) / (1024.0 * 1024.0), 0, 'f', 1))
               : core::LocalizableText{QT_TRANSLATE_NOOP("Fault", "%1 bytes"), {noted(bytes)}};
}

core::LocalizableText newerFormat(double format)
{
    return {QT_TRANSLATE_NOOP("Fault", "is %1, from a newer Cusp; this one reads %2. Update Cusp to give this lesson"),
            {noted(format), noted(kLessonFormat)}};
}

std::optional<QJsonObject> parseObject(QByteArray json, const QString& file, std::vector<ValidationIssue>& faults)
{
    const auto complain = [&](core::LocalizableText what) {
        faults.push_back({file, {}, std::move(what), true});
        return std::nullopt;
    };
    if (json.isEmpty())
        return complain({QT_TRANSLATE_NOOP("Fault", "is empty")});
    if (json.size() > kLargestLessonBytes)
        return complain({kTooLarge, {sizeWords(json.size()), sizeWords(kLargestLessonBytes)}});
    if (json.startsWith("\xFF\xFE") || json.startsWith("\xFE\xFF") || json.left(4).contains('\0'))
        return complain({QT_TRANSLATE_NOOP("Fault", "is written in UTF-16 or UTF-32; save it as UTF-8")});
    if (json.startsWith("\xEF\xBB\xBF"))
        json.remove(0, 3);
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(json, &error);
    if (document.isNull()) {
        const auto before = json.left(error.offset);
        std::vector<core::LocalizableText> values{noted(before.count('\n') + 1),
                                                  noted(error.offset - before.lastIndexOf('\n'))};
        if (error.error == QJsonParseError::IllegalUTF8String)
            return complain(
                {QT_TRANSLATE_NOOP("Fault", "is not JSON: line %1, column %2: invalid UTF8 string; save the "
                                            "file as UTF-8"),
                 std::move(values)});
        values.push_back({parseFault(error.error)});
        return complain({QT_TRANSLATE_NOOP("Fault", "is not JSON: line %1, column %2: %3"), std::move(values)});
    }
    if (!document.isObject())
        return complain({QT_TRANSLATE_NOOP("Fault", "must be one JSON object in braces")});
    if (const QStringList twice = keysSaidTwice(json); !twice.isEmpty()) {
        for (const QString& key : twice)
            faults.push_back(
                {file, key.left(60), {QT_TRANSLATE_NOOP("Fault", "is said twice in one object; leave one out")}, true});
        return std::nullopt;
    }
    return document.object();
}

QString Gathered::fileThatSays(const QString& key) const
{
    for (const auto& [file, object] : parts)
        if (has(object, key))
            return file;
    return parts.front().first;
}

void JsonFiles::note(const QString& file)
{
    if (!file.startsWith(QLatin1String(kShippedFolder)) && !m_uses.contains(file))
        m_uses << file;
}

QString JsonFiles::find(const QString& file, const QString& key, const QString& name)
{
    if (!isNameBeside(name)) {
        say(file, key,
            {QT_TRANSLATE_NOOP("Fault", "\"%1\" leads out of the lesson's folder; name a file beside it"),
             {noted(name.left(80))}});
        return {};
    }
    const QString shipped = QLatin1String(kShippedFolder);
    const QString beside = QFileInfo(file).dir().filePath(name);
    return QFileInfo::exists(beside) || file.startsWith(shipped) || !QFileInfo::exists(shipped + name) ? beside
                                                                                                       : shipped + name;
}

std::optional<Gathered> JsonFiles::gather(const QString& file, const QString& namedIn, QStringList way)
{
    std::vector<ValidationIssue> faults;
    std::optional<QJsonObject> object;
    if (way.contains(file))
        faults.push_back(
            {file,
             {},
             {QT_TRANSLATE_NOOP("Fault", "is based on itself by way of %1"), {noted(QFileInfo(way.back()).fileName())}},
             true});
    else if (way.size() >= kMostFiles)
        faults.push_back(
            {file,
             {},
             {QT_TRANSLATE_NOOP("Fault", "more than %1 files are based on one another"), {noted(kMostFiles)}},
             true});
    else
        object = read(file, faults);
    for (ValidationIssue& fault : faults) {
        // A fault of the whole file has to be fixed by the author of the file that names it.
        if (fault.key.isEmpty() && !namedIn.isEmpty())
            fault = {namedIn, kBasedOn, {"%1: %2", {noted(QFileInfo(file).fileName()), fault.what}}, true};
        m_faults.push_back(std::move(fault));
    }
    way << file;
    return object ? underlaid(*object, file, way) : std::nullopt;
}

std::optional<Gathered> JsonFiles::underlaid(const QJsonObject& object, const QString& file, const QStringList& way)
{
    if (!object.contains(kBasedOn))
        return Gathered{merged({}, object), {{file, object}}};
    if (!object.value(kBasedOn).isString()) {
        say(file, kBasedOn,
            {QT_TRANSLATE_NOOP("Fault", "must be the name of a file beside this one, or of one that is shipped")});
        return std::nullopt;
    }
    const QString baseFile = find(file, kBasedOn, object.value(kBasedOn).toString());
    if (baseFile.isEmpty())
        return std::nullopt;
    auto under = gather(baseFile, file, way);
    if (!under)
        return std::nullopt;
    under->whole.remove(kFormatKey);  // each file has its own
    for (auto& [name, part] : under->parts)
        part.remove(kFormatKey);
    // Otherwise the title of the base would be shown in languages in which the new title is missing.
    if (object.value(kTitle).isObject())
        under->whole.remove(kTitle);
    under->whole = merged(under->whole, object);
    under->whole.remove(kBasedOn);
    under->parts.insert(under->parts.begin(), {file, object});
    return under;
}

std::optional<QJsonObject> JsonFiles::read(const QString& name, std::vector<ValidationIssue>& faults)
{
    note(name);
    const auto complain = [&](core::LocalizableText what) {
        faults.push_back({name, {}, std::move(what), true});
        return std::nullopt;
    };
    const QFileInfo info(name);
    if (!info.exists())
        return complain({QT_TRANSLATE_NOOP("Fault", "does not exist")});
    QFile file(name);
    if (!info.isFile())
        return complain({info.isDir() ? QT_TRANSLATE_NOOP("Fault", "cannot be read (it is a folder)")
                                      : QT_TRANSLATE_NOOP("Fault", "cannot be read (it is no file)")});
    if (!file.open(QIODevice::ReadOnly))
        return complain({QT_TRANSLATE_NOOP("Fault", "cannot be read (%1)"), {noted(file.errorString())}});
    if (file.size() > kLargestLessonBytes)
        return complain({kTooLarge, {sizeWords(file.size()), sizeWords(kLargestLessonBytes)}});
    auto object = parseObject(file.read(kLargestLessonBytes + 1), name, faults);
    if (object && object->value(kFormatKey).toDouble() > kLessonFormat) {
        faults.push_back({name, kFormatKey, newerFormat(object->value(kFormatKey).toDouble()), true});
        return std::nullopt;
    }
    return object;
}

}  // namespace lessons
