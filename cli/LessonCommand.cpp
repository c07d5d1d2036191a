// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>

#include "cli/Commands.h"
#include "cli/parts/Arguments.h"
#include "cli/parts/LessonParts.h"
#include "core/bur/Reach.h"
#include "core/recording/Recording.h"
#include "lessons/Assignment.h"
#include "lessons/LessonCatalog.h"

namespace cli {
namespace {

constexpr std::size_t kShownHash = 12;

QString english(const lessons::LocalText& text)
{
    return printable(QString::fromStdString(lessons::inLanguage(text, "en")));
}

QString taskName(lessons::Task task)
{
    static constexpr std::array kNames{"remove_decay", "cut_ideal",  "trace_shape",
                                       "touch_points", "hold_force", "tell_layers"};
    return QLatin1String(kNames[static_cast<std::size_t>(task)]);
}

QString toothWords(const lessons::Lesson& lesson)
{
    if (const auto* made = std::get_if<lessons::MadeTooth>(&lesson.tooth))
        return QString::number(made->fdi);
    if (const auto* block = std::get_if<lessons::Block>(&lesson.tooth))
        return QStringLiteral("block:") + QString::fromStdString(block->shape);
    return QFileInfo(QString::fromStdString(std::get<lessons::Scan>(lesson.tooth).file)).fileName();
}

QJsonObject toJson(const lessons::ReadLesson& read)
{
    QJsonArray faults;
    for (const lessons::ValidationIssue& fault : read.faults)
        faults.append(
            QJsonObject{{"file", fault.file}, {"key", fault.key}, {"what", fault.english()}, {"grave", fault.grave}});
    QJsonObject object{{"file", read.file}, {"sound", read.lesson.has_value()}, {"faults", faults}};
    if (read.lesson) {
        object.insert("id", QString::fromStdString(read.lesson->id));
        object.insert("version", read.lesson->version);
        object.insert("title", english(read.lesson->title));
        object.insert("task", taskName(read.lesson->task));
        object.insert("tooth", toothWords(*read.lesson));
        object.insert("exam", read.lesson->exam);
        object.insert("hash", QString::fromStdString(read.lesson->hash));
        object.insert("rubric", QString::fromStdString(read.lesson->rubric.id));
        object.insert("rubric_hash", QString::fromStdString(read.lesson->rubric.hash));
    }
    return object;
}

void addFolder(QCommandLineParser& parser)
{
    parser.addOption({QStringLiteral("folder"),
                      QStringLiteral("The teacher's lessons; the user's own folder if not given."),
                      QStringLiteral("FOLDER")});
}

QString folderOf(const QCommandLineParser& parser)
{
    return parser.isSet(QStringLiteral("folder")) ? parser.value(QStringLiteral("folder")) : lessons::teachersFolder();
}

int listLessons(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Lists the lessons that are shipped and those of a teacher's folder."));
    addFolder(parser);
    addJson(parser);
    if (const auto code = parse(parser, arguments, QStringLiteral("cusp lesson list [--folder FOLDER] [--json]")))
        return *code;
    if (const auto code = refuseWords(parser))
        return *code;
    if (parser.isSet(QStringLiteral("folder")) && !QDir(parser.value(QStringLiteral("folder"))).exists())
        return failed({core::ErrorCode::FileMissing,
                       "there is no folder " + parser.value(QStringLiteral("folder")).toStdString()});
    const auto entries = lessons::readCatalog(folderOf(parser));
    QJsonArray list;
    QString text;
    for (const lessons::CatalogEntry& entry : entries) {
        QJsonObject object = toJson(entry.read);
        object.insert("shipped", entry.isShipped);
        list.append(object);
        if (const auto& lesson = entry.read.lesson) {
            text += QStringLiteral("%1 %2 %3 %4%5\n")
                        .arg(QString::fromStdString(lesson->id), -28)
                        .arg(taskName(lesson->task), -13)
                        .arg(toothWords(*lesson), -16)
                        .arg(english(lesson->title),
                             entry.isShipped ? QString()
                                             : QStringLiteral("  (") + QFileInfo(entry.read.file).fileName() + u')');
        }
        for (const lessons::ValidationIssue& fault : entry.read.faults)
            text += QStringLiteral("%1: %2\n")
                        .arg(fault.grave ? QStringLiteral("not given") : QStringLiteral("note"),
                             printable(fault.sentence()));
    }
    if (parser.isSet(QStringLiteral("json")))
        printJson({{"lessons", list}});
    else
        printText(text);
    return kDone;
}

/// Returns the tooth cut to the ideal, as far as a bur can reach.
core::terrain::Tooth cutTo(const std::vector<float>& ideal, const lessons::Assignment& assignment)
{
    const core::terrain::ToothAnatomy& anatomy = *assignment.anatomy;
    const auto lowest = static_cast<float>(core::bur::lowestTipMm(anatomy));
    std::vector<float> top = ideal;
    for (std::size_t k = 0; k < top.size(); ++k) {
        if (!(top[k] < anatomy.top[k]))
            continue;
        top[k] = std::min(anatomy.top[k], std::max(top[k], lowest));
        if (!(top[k] > anatomy.bottom[k]))
            top[k] = core::terrain::kEmptyTop;
    }
    return core::terrain::restored(assignment.anatomy, std::move(top));
}

/// Returns whether a measure is about the process of the attempt, which is unknown here.
bool isOfTheWay(const std::string& measure)
{
    const auto known = core::grading::findMeasure(measure);
    return known && core::grading::isOfProcess(*known) && !core::grading::isOfExercise(*known);
}

/// Returns the points that a perfect cut of the ideal would lose. Empty if it loses none, and for an exercise, which
/// has no cut.
QString lostByTheIdeal(const lessons::Assignment& assignment)
{
    const core::grading::IdealTop ideal = assignment.shownIdeal();
    if (ideal == nullptr)
        return {};
    const auto marked = lessons::mark(assignment, cutTo(*ideal, assignment), lessons::Conduct{});
    if (!marked)
        return {};
    int lost = 0;
    QStringList costly;
    for (const lessons::Criterion& line : marked->sheet.criteria) {
        if (line.lostTenths == 0 || isOfTheWay(line.measure))
            continue;
        lost += line.lostTenths;
        costly << QString::fromStdString(line.id) +
                      (line.measured ? QString() : QStringLiteral(" (cannot be measured here)"));
    }
    if (costly.isEmpty())
        return {};
    return QStringLiteral("who cuts exactly what is asked for gets %1 of 100 points, because of %2")
        .arg(0.1 * (lessons::kFullTenths - lost), 0, 'f', 1)
        .arg(costly.join(QStringLiteral(", ")));
}

int checkLessons(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Reads lessons as the window would, builds what they ask for and says everything that is wrong with them. Ends "
        "with 1 if one of them cannot be given."));
    parser.addPositionalArgument(QStringLiteral("FILE|ID"),
                                 QStringLiteral("A lesson's file or id; several may be named."));
    addJson(parser);
    const QString usage = QStringLiteral("cusp lesson check FILE|ID ... [--json]");
    if (const auto code = parse(parser, arguments, usage))
        return *code;
    if (parser.positionalArguments().isEmpty())
        return wrongUsage(QStringLiteral("name a lesson; usage: ") + usage);
    bool isSound = true;
    QJsonArray list;
    QString text;
    for (const QString& named : parser.positionalArguments()) {
        const auto found = lessons::lessonFile(named);
        const QString file = found ? *found : named;
        lessons::ReadLesson read = lessons::readLesson(file);
        if (read.lesson) {
            const auto assigned = lessons::assign(*read.lesson);
            if (!assigned) {
                read.faults.push_back({file, {}, core::wordsOf(assigned.error()), true});
                read.lesson.reset();
            } else if (const QString what = lostByTheIdeal(assigned->assignment); !what.isEmpty()) {
                read.faults.push_back({file, QStringLiteral("rubric"), lessons::noted(what), false});
            }
            if (assigned && read.lesson->expert) {
                // The lesson is usable without the expert's recording.
                if (const auto expert = lessons::readExpert(assigned->assignment); !expert)
                    read.faults.push_back(
                        {file, QStringLiteral("expert.recording"), core::wordsOf(expert.error()), false});
            }
        }
        isSound = isSound && read.lesson;
        list.append(toJson(read));
        for (const lessons::ValidationIssue& fault : read.faults)
            text += printable(fault.sentence()) + u'\n';
        if (read.lesson)
            text += QStringLiteral("%1 is sound: %2, version %3, content %4\n")
                        .arg(QFileInfo(file).fileName(), QString::fromStdString(read.lesson->id))
                        .arg(read.lesson->version)
                        .arg(QString::fromStdString(read.lesson->hash.substr(0, kShownHash)));
    }
    if (parser.isSet(QStringLiteral("json")))
        printJson({{"lessons", list}});
    else
        printText(text, isSound ? stdout : stderr);
    return isSound ? kDone : kFailed;
}

int listMeasures(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Lists what can be measured of an attempt, for the criteria of a rubric."));
    addJson(parser);
    if (const auto code = parse(parser, arguments, QStringLiteral("cusp lesson measures [--json]")))
        return *code;
    if (const auto code = refuseWords(parser))
        return *code;
    QJsonArray list;
    QString text;
    for (const core::grading::MeasureInfo& measure : core::grading::measureTable()) {
        const auto words = [](std::string_view part) {
            return QString::fromUtf8(part.data(), static_cast<qsizetype>(part.size()));
        };
        list.append(QJsonObject{{"id", words(measure.id)},
                                {"unit", words(measure.unit)},
                                {"definition", words(measure.definition)},
                                {"source", words(measure.source)}});
        text += QStringLiteral("%1 %2 %3 [%4]\n")
                    .arg(words(measure.id), -32)
                    .arg(words(measure.unit), -8)
                    .arg(words(measure.definition), words(measure.source));
    }
    if (parser.isSet(QStringLiteral("json")))
        printJson({{"measures", list}});
    else
        printText(text);
    return kDone;
}

constexpr std::array kParts{
    CommandPart{"list", "the lessons there are", listLessons},
    CommandPart{"check", "what is wrong with lessons", checkLessons},
    CommandPart{"new", "writes a lesson to begin with", newLessonPart},
    CommandPart{"preview", "draws what a lesson asks for", previewLessonPart},
    CommandPart{"capture", "makes an ideal of recordings", captureLessonPart},
    CommandPart{"pack", "puts lessons and all they need into one file", packLessonsPart},
    CommandPart{"unpack", "takes them out again", unpackLessonsPart},
    CommandPart{"measures", "what a rubric can judge", listMeasures},
};

}  // namespace

int lessonCommand(const QStringList& arguments)
{
    return runPart(QStringLiteral("lesson"), kParts, arguments);
}

}  // namespace cli
