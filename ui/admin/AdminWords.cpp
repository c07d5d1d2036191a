// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/admin/AdminWords.h"

#include <array>
#include <utility>

#include <QCoreApplication>
#include <QDateTime>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>

#include "core/base/LocalizableText.h"
#include "ui/text/Texts.h"

namespace ui::admin {
namespace {

constexpr std::array kActions{
    std::pair{"login", QT_TRANSLATE_NOOP("Admin", "logged in")},
    std::pair{"logout", QT_TRANSLATE_NOOP("Admin", "logged out")},
    std::pair{"login.failed", QT_TRANSLATE_NOOP("Admin", "a login failed")},
    std::pair{"password.code", QT_TRANSLATE_NOOP("Admin", "used a one-time code")},
    std::pair{"password.change", QT_TRANSLATE_NOOP("Admin", "changed the password")},
    std::pair{"password.reset", QT_TRANSLATE_NOOP("Admin", "reset a password")},
    std::pair{"password.rehash", QT_TRANSLATE_NOOP("Admin", "had the password kept more safely")},
    std::pair{"person.add", QT_TRANSLATE_NOOP("Admin", "entered a person")},
    std::pair{"person.change", QT_TRANSLATE_NOOP("Admin", "changed a person")},
    std::pair{"person.erase", QT_TRANSLATE_NOOP("Admin", "erased a person")},
    std::pair{"class.add", QT_TRANSLATE_NOOP("Admin", "added a class")},
    std::pair{"class.rename", QT_TRANSLATE_NOOP("Admin", "renamed a class")},
    std::pair{"class.enrol", QT_TRANSLATE_NOOP("Admin", "put somebody into a class")},
    std::pair{"class.leave", QT_TRANSLATE_NOOP("Admin", "took somebody out of a class")},
    std::pair{"lesson.assign", QT_TRANSLATE_NOOP("Admin", "gave a lesson to a class")},
    std::pair{"lesson.unassign", QT_TRANSLATE_NOOP("Admin", "took a lesson back")},
    std::pair{"attempt.add", QT_TRANSLATE_NOOP("Admin", "an attempt was kept")},
    std::pair{"attempt.doubt", QT_TRANSLATE_NOOP("Admin", "an attempt was compared with the assigned version")},
    std::pair{"attempt.check", QT_TRANSLATE_NOOP("Admin", "marked an attempt again from its recording")},
    std::pair{"exam.begin", QT_TRANSLATE_NOOP("Admin", "began an exam")},
    std::pair{"attempt.comment", QT_TRANSLATE_NOOP("Admin", "commented on an attempt")},
    std::pair{"attempt.comment.withdraw", QT_TRANSLATE_NOOP("Admin", "took a comment back")},
    std::pair{"attempt.comment.erase", QT_TRANSLATE_NOOP("Admin", "erased a comment")},
    std::pair{"attempt.override.erase", QT_TRANSLATE_NOOP("Admin", "erased the reason for a score")},
    std::pair{"attempt.override", QT_TRANSLATE_NOOP("Admin", "gave another score")},
    std::pair{"preset.add", QT_TRANSLATE_NOOP("Admin", "kept a hardness preset")},
    std::pair{"setting.change", QT_TRANSLATE_NOOP("Admin", "changed a setting")},
    std::pair{"audit.broken", QT_TRANSLATE_NOOP("Admin", "found the audit changed")},
    std::pair{"audit.older", QT_TRANSLATE_NOOP("Admin", "found an older copy in the place of the database")},
    std::pair{"station.join", QT_TRANSLATE_NOOP("Admin", "a computer wrote here for the first time")},
    std::pair{"backup.made", QT_TRANSLATE_NOOP("Admin", "made a backup")},
    std::pair{"backup.restored", QT_TRANSLATE_NOOP("Admin", "a backup was restored")},
    std::pair{"attempts.export", QT_TRANSLATE_NOOP("Admin", "exported attempts")},
    std::pair{"class.export", QT_TRANSLATE_NOOP("Admin", "took out a report of a class")},
    std::pair{"school.copy", QT_TRANSLATE_NOOP("Admin", "copied the school into another database")},
    std::pair{"school.copied", QT_TRANSLATE_NOOP("Admin", "brought the school here from another database")},
};

constexpr std::array kSettings{
    std::pair{"idle.minutes", QT_TRANSLATE_NOOP("Admin", "when a place that was left is locked")},
    std::pair{"password.passes", QT_TRANSLATE_NOOP("Admin", "how long checking a password takes")},
    std::pair{"password.memory", QT_TRANSLATE_NOOP("Admin", "how much memory checking a password takes")},
    // A login with an unknown name is checked against this hash, so that it takes as long as any other.
    std::pair{"password.decoy", QT_TRANSLATE_NOOP("Admin", "how long a login by a name that nobody has takes")},
    std::pair{"preset.in_use", QT_TRANSLATE_NOOP("Admin", "the preset that everybody uses")},
    std::pair{"preset.retired", QT_TRANSLATE_NOOP("Admin", "which presets are retired")},
};

constexpr std::array kKinds{
    std::pair{"attempt:", QT_TRANSLATE_NOOP("Admin", "attempt %1")},
    std::pair{"exam:", QT_TRANSLATE_NOOP("Admin", "exam %1")},
    std::pair{"class:", QT_TRANSLATE_NOOP("Admin", "class %1")},
    std::pair{"person:", QT_TRANSLATE_NOOP("Admin", "person %1")},
    std::pair{"setting:", QT_TRANSLATE_NOOP("Admin", "setting %1")},
    std::pair{"station:", QT_TRANSLATE_NOOP("Admin", "computer with the key %1")},
    std::pair{"table ", QT_TRANSLATE_NOOP("Admin", "table %1")},
    std::pair{"trigger ", QT_TRANSLATE_NOOP("Admin", "trigger %1")},
};

constexpr std::array kWholes{
    std::pair{"attempts", QT_TRANSLATE_NOOP("Admin", "all attempts")},
    std::pair{"school", QT_TRANSLATE_NOOP("Admin", "the school")},
    std::pair{"audit", QT_TRANSLATE_NOOP("Admin", "the audit")},
};

/// Returns the words for a preset entry "my soft v1". The name itself may contain " v".
QString presetWords(const QString& noted)
{
    const qsizetype at = noted.lastIndexOf(QStringLiteral(" v"));
    return QCoreApplication::translate("Admin", "preset %1, version %2").arg(noted.left(at), noted.mid(at + 2));
}

/// Returns the words for "backup-2026-11-20-10.15.00", or for the name that a user gave the backup.
QString backupWords(const QString& noted)
{
    QDateTime made = QDateTime::fromString(noted, QStringLiteral("'backup-'yyyy-MM-dd-HH.mm.ss"));
    made.setTimeSpec(Qt::UTC);
    const QString told =
        made.isValid() ? QLocale().toString(made.toLocalTime(), QLocale::ShortFormat) : u'"' + noted + u'"';
    //: %1: a day and a time, or the name of a file
    return QCoreApplication::translate("Admin", "backup of %1").arg(told);
}

/// Returns the name for "person:1f...", or for "name:2e...", the key of a failed login.
QString named(const QString& what, const NamesByUid& names)
{
    const QString id = what.section(u':', 1);
    const auto found = names.find(id.toStdString());
    if (const auto ofClass = names.find(what.toStdString()); ofClass != names.end())
        return ofClass->second;
    const bool isTyped = what.startsWith(QStringLiteral("name:"));
    if (found != names.end() && (isTyped || what.startsWith(QStringLiteral("person:"))))
        return found->second;
    if (isTyped)
        return QCoreApplication::translate("Admin", "a name that nobody has");
    if (what.startsWith(QStringLiteral("preset:")))
        return presetWords(id);
    if (what.startsWith(QStringLiteral("backup:")))
        return backupWords(id);
    for (const auto& [name, words] : kSettings)
        if (what == QStringLiteral("setting:") + QLatin1String(name))
            return QCoreApplication::translate("Admin", words);
    for (const auto& [whole, words] : kWholes)
        if (what == QLatin1String(whole))
            return QCoreApplication::translate("Admin", words);
    constexpr qsizetype kShownOfKey = 16;
    for (const auto& [kind, words] : kKinds)
        if (what.startsWith(QLatin1String(kind)))
            return QCoreApplication::translate("Admin", words)
                .arg(what.startsWith(QStringLiteral("station:")) ? id.left(kShownOfKey)
                                                                 : what.mid(QLatin1String(kind).size()));
    return what;
}

/// Returns the words for a value of an integrity issue: a time, an action, a lesson, or the object of an action.
QString noted(const QString& value, const NamesByUid& names, const text::LessonTitles& titles)
{
    if (const auto title = titles.find(value); title != titles.end())
        return *title;
    if (QDateTime::fromString(value, Qt::ISODate).isValid())
        return text::when(value.toStdString());
    const QString action = actionWords(value.toStdString());
    return action == value ? named(value, names) : action;
}

/// Returns the words for one detail of an action. For some details the value alone is shown.
QString detailOf(const QString& key, const QJsonValue& noted, const NamesByUid& names, const text::LessonTitles& titles)
{
    constexpr double kTenths = 10.0;
    if (noted.isBool() || key == u"disabled")
        return noted.toBool() ? QCoreApplication::translate("Admin", "disabled")
                              : QCoreApplication::translate("Admin", "enabled");
    const QString value = noted.toVariant().toString();
    if (key == u"role")
        return roleWord(database::roleOf(value.toStdString()).value_or(database::Role::Student));
    if (key == u"lesson")
        return text::lessonTitle(titles, value.toStdString());
    if (key == u"given_tenths")
        return text::number(noted.toDouble() / kTenths, 1);
    if (key == u"due" || key == u"begun")
        return text::when(value.toStdString());
    if (key == u"limit")
        return noted.toInt() > 0 ? QCoreApplication::translate("Admin", "at most %n attempt(s)", nullptr, noted.toInt())
                                 : QCoreApplication::translate("Admin", "as many attempts as one likes");
    const auto person = names.find(value.toStdString());
    return person != names.end() ? person->second : value;
}

}  // namespace

QString roleWord(database::Role role)
{
    switch (role) {
    case database::Role::Guest:
        return QCoreApplication::translate("Admin", "guest");
    case database::Role::Student:
        return QCoreApplication::translate("Admin", "student");
    case database::Role::Instructor:
        return QCoreApplication::translate("Admin", "instructor");
    case database::Role::Admin:
        return QCoreApplication::translate("Admin", "admin");
    }
    return {};
}

QString actionWords(const std::string& action)
{
    for (const auto& [known, words] : kActions)
        if (action == known)
            return QCoreApplication::translate("Admin", words);
    return QString::fromStdString(action);
}

QString actorWords(const database::AuditRow& row, const NamesByUid& names)
{
    if (row.actor.empty())
        return QCoreApplication::translate("Admin", "nobody");
    if (row.actor == "system")
        return QCoreApplication::translate("Admin", "the program");
    const auto found = names.find(row.actor);
    return found == names.end() ? QString::fromStdString(row.actor) : found->second;
}

QString objectWords(const database::AuditRow& row, const NamesByUid& names)
{
    return named(QString::fromStdString(row.object), names);
}

QString detailWords(const database::AuditRow& row, const NamesByUid& names, const text::LessonTitles& titles)
{
    const QJsonObject noted = QJsonDocument::fromJson(QByteArray::fromStdString(row.detail)).object();
    QStringList words;
    for (auto it = noted.begin(); it != noted.end(); ++it) {
        if (row.action == "person.change" && it.key() == u"names_digest")
            words << QCoreApplication::translate("Admin", "another name");
        if (it.key().contains(QStringLiteral("digest")) || it.key() == u"school" || it.value().isNull() ||
            it.value() == QString())
            continue;
        words << detailOf(it.key(), it.value(), names, titles);
    }
    return words.join(QStringLiteral(", "));
}

QString findingWords(const database::IntegrityIssue& finding, const NamesByUid& names, const text::LessonTitles& titles)
{
    std::vector<std::string> values;
    for (const std::string& value : finding.values)
        values.push_back(noted(QString::fromStdString(value), names, titles).toStdString());
    const QString words = QCoreApplication::translate("Finding", finding.words);
    return QString::fromStdString(core::filled(words.toStdString(), values));
}

QString rosterFaultWords(const database::RosterFault& fault)
{
    using Kind = database::RosterFault::Kind;
    const QString value = QString::fromStdString(fault.value);
    switch (fault.kind) {
    case Kind::Fields:
        return QCoreApplication::translate("Admin", "It has more fields than the first line names.");
    case Kind::Username:
        return QCoreApplication::translate(
            "Admin", "It is empty, longer than 64 characters, or has other characters than the letters a to z, digits "
                     "and . _ - @.");
    case Kind::Twice:
        return QCoreApplication::translate("Admin", "It stands in line %1 already.").arg(value);
    case Kind::Name:
        return QCoreApplication::translate("Admin", "It is too long, or has signs that cannot be seen.");
    case Kind::Role:
        return QCoreApplication::translate("Admin", "It is none of student, instructor, admin.");
    case Kind::OtherRole:
        return QCoreApplication::translate("Admin", "Here the role is %1; a class list does not change it.")
            .arg(roleWord(database::roleOf(fault.value).value_or(database::Role::Student)));
    case Kind::Erased:
        return QCoreApplication::translate("Admin", "This person was erased and cannot come back.");
    case Kind::Class:
        return QCoreApplication::translate("Admin", "The name of a class has 1 to 100 characters that can be seen.");
    case Kind::NoUtf8:
        return QCoreApplication::translate("Admin", "From sign %1 of this line on the file is no UTF-8 text. Save it "
                                                    "from the spreadsheet as “CSV UTF-8”.")
            .arg(value);
    case Kind::OpenQuote:
        return QCoreApplication::translate("Admin", "A quotation mark at sign %1 of this line is not closed.")
            .arg(value);
    case Kind::AfterQuote:
        return QCoreApplication::translate("Admin", "At sign %1 of this line words stand behind a closing quotation "
                                                    "mark.")
            .arg(value);
    case Kind::NoSuchColumn:
        if (value.isEmpty())
            return QCoreApplication::translate("Admin", "A class list has no such column. It has username, given_name, "
                                                        "family_name, role and class.");
        //: %1: the name of a column
        return QCoreApplication::translate("Admin", "A class list has no such column. Is it %1?").arg(value);
    case Kind::ColumnTwice:
        return QCoreApplication::translate("Admin", "This column is there twice.");
    case Kind::ColumnMissing:
        return QCoreApplication::translate("Admin", "This column is missing. The first line names the columns.");
    case Kind::Refused:
        break;
    }
    return QString::fromStdString(fault.what);
}

}  // namespace ui::admin
