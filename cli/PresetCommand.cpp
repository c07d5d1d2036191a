// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>

#include "cli/Commands.h"
#include "cli/parts/Arguments.h"
#include "cli/parts/SchoolParts.h"
#include "core/settings/StabilityBound.h"
#include "database/sql/Presets.h"
#include "database/sql/Settings.h"
#include "lessons/PresetShelf.h"

namespace cli {
namespace {

using core::settings::FeelPreset;

/// Returns the bound, N/mm, as shown with two decimals, rounded down.
double shownBound(const core::settings::FeelPreset& preset)
{
    return std::floor(100.0 * core::settings::stabilityBound(preset).stiffnessNPerMm) / 100.0;
}

QJsonObject withBound(const FeelPreset& preset)
{
    QJsonObject object = lessons::toJson(preset);
    object.insert(QStringLiteral("hash"), QString::fromStdString(preset.hash));
    object.insert(QStringLiteral("bound_n_per_mm"), core::settings::stabilityBound(preset).stiffnessNPerMm);
    return object;
}

QJsonArray toJson(const std::vector<lessons::ValidationIssue>& faults)
{
    QJsonArray list;
    for (const lessons::ValidationIssue& fault : faults)
        list.append(
            QJsonObject{{"file", fault.file}, {"key", fault.key}, {"what", fault.english()}, {"grave", fault.grave}});
    return list;
}

QString toText(const std::vector<lessons::ValidationIssue>& faults)
{
    QString text;
    for (const lessons::ValidationIssue& fault : faults)
        text += printable(fault.sentence()) + u'\n';
    return text;
}

void addFolder(QCommandLineParser& parser)
{
    parser.addOption({QStringLiteral("folder"), QStringLiteral("Where they are kept; the user's own if not given."),
                      QStringLiteral("FOLDER")});
}

lessons::PresetFolder shelfOf(const QCommandLineParser& parser)
{
    return lessons::PresetFolder(parser.isSet(QStringLiteral("folder")) ? parser.value(QStringLiteral("folder"))
                                                                        : lessons::presetsFolder());
}

/// The presets of a folder, or of a school.
struct Shelf
{
    std::vector<lessons::ReadPreset> presets;
    std::optional<FeelPreset> inUse{};  ///< of a school
};

core::Result<Shelf> schoolsShelf(const QCommandLineParser& parser)
{
    const auto address = databaseAddress(parser);
    if (!address)
        return tl::unexpected(address.error());
    const auto open = openSchool(*address, Opening::AsItIs);
    if (!open)
        return tl::unexpected(withWayBack(open.error(), *address));
    const auto session = logIn(parser, *open);
    if (!session)
        return tl::unexpected(session.error());
    const auto kept = database::sql::listPresets(*open->school, *session);
    if (!kept)
        return tl::unexpected(kept.error());
    auto settings = database::sql::readSettings(*open->school, *session);
    if (!settings)
        return tl::unexpected(settings.error());
    std::vector<lessons::ReadPreset> read;
    for (const database::sql::KeptPreset& one : *kept)
        read.push_back(lessons::readPresetText(QByteArray::fromStdString(one.json), QString::fromStdString(one.name)));
    Shelf shelf{lessons::shelved(std::move(read))};
    const QStringList retired = QString::fromStdString((*settings)[database::kRetiredPresets]).split(u'\n');
    for (lessons::ReadPreset& one : shelf.presets)
        one.isRetired = one.preset && retired.contains(QString::fromStdString(one.preset->name));
    const auto inUse = lessons::findPreset(shelf.presets, QString::fromStdString((*settings)[database::kPresetInUse]));
    shelf.inUse = inUse ? *inUse : lessons::usualPreset(shelf.presets);
    return shelf;
}

int listPresets(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Lists the hardness presets there are, each in all its versions: "
                                                    "the user's own, or with --as those of a school, of which one is "
                                                    "in use."));
    addFolder(parser);
    addDatabaseOption(parser);
    addPersonOption(parser);
    addJson(parser);
    if (const auto code =
            parse(parser, arguments,
                  QStringLiteral("cusp preset list [--folder FOLDER | --as NAME [--db FILE|URL]] [--json]")))
        return *code;
    if (const auto code = refuseWords(parser))
        return *code;
    const bool isOfSchool = parser.isSet(QStringLiteral("as")) || parser.isSet(QStringLiteral("db"));
    if (isOfSchool && parser.isSet(QStringLiteral("folder")))
        return wrongUsage(QStringLiteral("list the presets of a folder or those of a school, not both at once"));
    if (isOfSchool)
        if (const auto code = refuseNobody(parser))
            return *code;
    const auto shelf = isOfSchool ? schoolsShelf(parser) : Shelf{shelfOf(parser).list()};
    if (!shelf)
        return failed(shelf.error());
    QJsonArray list;
    QString text;
    for (const lessons::ReadPreset& read : shelf->presets) {
        QJsonObject object{{"file", read.file}, {"shipped", read.file.isEmpty()}, {"faults", toJson(read.faults)}};
        if (read.preset) {
            object.insert("name", QString::fromStdString(read.preset->name));
            object.insert("version", read.preset->version);
            object.insert("hash", QString::fromStdString(read.preset->hash));
            const bool isInUse = shelf->inUse && shelf->inUse->hash == read.preset->hash;
            if (isOfSchool) {
                object.insert("in_use", isInUse);
                object.insert("retired", read.isRetired);
            }
            text += QStringLiteral("%1%2%3%4\n")
                        .arg(printable(QString::fromStdString(core::settings::labelOf(*read.preset))),
                             isOfSchool || read.file.isEmpty()
                                 ? QString()
                                 : QStringLiteral("  (") + QFileInfo(read.file).fileName() + u')',
                             isInUse ? QStringLiteral("  (in use)") : QString(),
                             read.isRetired ? QStringLiteral("  (retired)") : QString());
        }
        list.append(object);
        text += toText(read.faults);
    }
    if (parser.isSet(QStringLiteral("json")))
        printJson({{"presets", list}});
    else
        printText(text);
    return kDone;
}

int checkPresets(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Says what is wrong with hardness presets. Ends with 1 if one of "
                                                    "them cannot be used."));
    parser.addPositionalArgument(QStringLiteral("FILE"), QStringLiteral("A preset's file; several may be named."));
    addJson(parser);
    const QString usage = QStringLiteral("cusp preset check FILE ... [--json]");
    if (const auto code = parse(parser, arguments, usage))
        return *code;
    if (parser.positionalArguments().isEmpty())
        return wrongUsage(QStringLiteral("name a file; usage: ") + usage);
    bool isSound = true;
    QJsonArray list;
    QString text;
    for (const QString& file : parser.positionalArguments()) {
        lessons::ReadPreset read = lessons::readPreset(file);
        if (const auto left = lessons::leftOutFault(read))
            read.faults.push_back(*left);
        isSound = isSound && read.preset;
        QJsonObject object{{"file", file}, {"sound", read.preset.has_value()}, {"faults", toJson(read.faults)}};
        text += toText(read.faults);
        if (read.preset) {
            object.insert(QStringLiteral("preset"), withBound(*read.preset));
            text += QStringLiteral("%1 is sound: %2; held up to %3 N/mm\n")
                        .arg(QFileInfo(file).fileName(),
                             printable(QString::fromStdString(core::settings::labelOf(*read.preset))))
                        .arg(shownBound(*read.preset), 0, 'f', 2);
        }
        list.append(object);
    }
    if (parser.isSet(QStringLiteral("json")))
        printJson({{"presets", list}});
    else
        printText(text, isSound ? stdout : stderr);
    return isSound ? kDone : kFailed;
}

int showPreset(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Shows the numbers of a hardness preset, and up to which stiffness "
                                                    "a light hand is held with it."));
    parser.addPositionalArgument(QStringLiteral("NAME"),
                                 QStringLiteral("Its name, for the newest version; \"NAME v2\" for another."));
    addFolder(parser);
    addJson(parser);
    const QString usage = QStringLiteral("cusp preset show NAME [--folder FOLDER] [--json]");
    if (const auto code = parse(parser, arguments, usage))
        return *code;
    if (parser.positionalArguments().size() != 1)
        return wrongUsage(QStringLiteral("name one preset; usage: ") + usage);
    const auto preset = lessons::findPreset(shelfOf(parser).list(), parser.positionalArguments().front());
    if (!preset)
        return failed(preset.error());
    if (parser.isSet(QStringLiteral("json"))) {
        printJson(withBound(*preset));
        return kDone;
    }
    QString text = printable(QString::fromStdString(core::settings::labelOf(*preset))) + u'\n';
    for (const auto& field : core::settings::feelFields())
        text += QStringLiteral("  %1 %2 %3\n")
                    .arg(QLatin1String(field.id), -28)
                    .arg((*preset).*field.value, 8, 'g', 6)
                    .arg(QString::fromUtf8(field.unit));
    text += QStringLiteral("  %1 %2 N/mm\n").arg(QStringLiteral("held up to"), -28).arg(shownBound(*preset), 8, 'f', 2);
    printText(text);
    return kDone;
}

constexpr std::array kParts{
    CommandPart{"list", "those there are", listPresets},
    CommandPart{"check", "what is wrong with a preset's file", checkPresets},
    CommandPart{"show", "the numbers of one", showPreset},
};

}  // namespace

int presetCommand(const QStringList& arguments)
{
    return runPart(QStringLiteral("preset"), kParts, arguments);
}

}  // namespace cli
