// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/admin/AdminWords.h"

#include <array>
#include <utility>

#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>

namespace ui::admin {
namespace {

constexpr std::array kActions{
    std::pair{"login", QT_TRANSLATE_NOOP("Admin", "logged in")},
    std::pair{"logout", QT_TRANSLATE_NOOP("Admin", "logged out")},
    std::pair{"login.failed", QT_TRANSLATE_NOOP("Admin", "a login failed")},
    std::pair{"password.code", QT_TRANSLATE_NOOP("Admin", "used a one-time code")},
    std::pair{"password.change", QT_TRANSLATE_NOOP("Admin", "changed the password")},
    std::pair{"password.reset", QT_TRANSLATE_NOOP("Admin", "reset a password")},
    std::pair{"person.add", QT_TRANSLATE_NOOP("Admin", "entered a person")},
    std::pair{"person.change", QT_TRANSLATE_NOOP("Admin", "changed a person")},
    std::pair{"class.add", QT_TRANSLATE_NOOP("Admin", "added a class")},
    std::pair{"class.rename", QT_TRANSLATE_NOOP("Admin", "renamed a class")},
    std::pair{"class.enrol", QT_TRANSLATE_NOOP("Admin", "put somebody into a class")},
    std::pair{"class.leave", QT_TRANSLATE_NOOP("Admin", "took somebody out of a class")},
    std::pair{"lesson.assign", QT_TRANSLATE_NOOP("Admin", "gave a lesson to a class")},
    std::pair{"lesson.unassign", QT_TRANSLATE_NOOP("Admin", "took a lesson back")},
    std::pair{"attempt.add", QT_TRANSLATE_NOOP("Admin", "an attempt was kept")},
    std::pair{"exam.begin", QT_TRANSLATE_NOOP("Admin", "began an exam")},
    std::pair{"attempt.comment", QT_TRANSLATE_NOOP("Admin", "commented on an attempt")},
    std::pair{"attempt.override", QT_TRANSLATE_NOOP("Admin", "gave another score")},
    std::pair{"preset.add", QT_TRANSLATE_NOOP("Admin", "kept a hardness preset")},
    std::pair{"setting.change", QT_TRANSLATE_NOOP("Admin", "changed a setting")},
    std::pair{"audit.broken", QT_TRANSLATE_NOOP("Admin", "found the audit changed")},
    std::pair{"backup.made", QT_TRANSLATE_NOOP("Admin", "made a backup")},
    std::pair{"backup.restored", QT_TRANSLATE_NOOP("Admin", "a backup was restored")},
    std::pair{"attempts.export", QT_TRANSLATE_NOOP("Admin", "exported attempts")},
    std::pair{"school.copy", QT_TRANSLATE_NOOP("Admin", "copied the school into another database")},
};

/// As much of "attempt:8614f873a47d..." as tells it from others.
constexpr qsizetype kObjectLetters = 40;

/// "person:1f..." is told by name, and so is "name:2e...", with which somebody tried to log in.
QString named(const QString& what, const NamesByUid& names)
{
    const auto found = names.find(what.section(u':', 1).toStdString());
    const bool isTyped = what.startsWith(QStringLiteral("name:"));
    if (found != names.end() && (isTyped || what.startsWith(QStringLiteral("person:"))))
        return found->second;
    return isTyped ? QCoreApplication::translate("Admin", "a name that nobody has") : what;
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
    return named(QString::fromStdString(row.object), names).left(kObjectLetters);
}

QString detailWords(const database::AuditRow& row, const NamesByUid& names)
{
    const QJsonObject noted = QJsonDocument::fromJson(QByteArray::fromStdString(row.detail)).object();
    QStringList words;
    for (auto it = noted.begin(); it != noted.end(); ++it) {
        if (row.action == "person.change" && it.key() == u"names_digest")
            words << QCoreApplication::translate("Admin", "another name");
        if (it.key().endsWith(QStringLiteral("digest")) || it.value().isNull() || it.value() == QString())
            continue;
        const QString value = it.value().isBool() ? QString() : it.value().toVariant().toString();
        const auto person = names.find(value.toStdString());
        words << (it.key() + u' ' + (person == names.end() ? value : person->second)).trimmed();
    }
    return words.join(QStringLiteral(", "));
}

}  // namespace ui::admin
