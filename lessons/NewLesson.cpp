// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/NewLesson.h"

#include <array>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>

#include "core/preparation/CapturedIdeal.h"
#include "core/preparation/ToothDesign.h"
#include "lessons/IdealFromRecordings.h"
#include "lessons/JsonFiles.h"
#include "lessons/LessonCatalog.h"

namespace lessons {
namespace {

constexpr int kUsualTooth = 36;
constexpr double kUsualExtent = 0.5;
constexpr double kUsualMinutes = 10.0;
const QString kShipped = QLatin1String(kShippedFolder);

struct Beginning
{
    const char* task;
    const char* rubric;
    const char* titleEn;
    const char* titleDe;
    const char* titleEs;
    const char* titleJa;
    const char* goalEn;
    const char* goalDe;
    const char* goalEs;
    const char* goalJa;
};
constexpr std::array<Beginning, 3> kBeginnings{
    {{"remove_decay", "decay_removal", "Decay on %1", "Karies an %1", "Caries en %1", "%1のう蝕",
      "Take all of the decay out and spare what is sound; keep the pulp closed.",
      "Entfernen Sie die ganze Karies und schonen Sie, was gesund ist; die Pulpa bleibt geschlossen.",
      "Elimine toda la caries y respete lo que está sano; mantenga cerrada la pulpa.",
      "う蝕をすべて除去し、健全な部分を残してください。歯髄は露出させないでください。"},
     {"cut_ideal", "class1", "Preparation of %1", "Präparation an %1", "Preparación en %1", "%1の窩洞形成",
      "Cut the preparation as shown: outline, depth, walls and floor.",
      "Präparieren Sie wie gezeigt: Umriss, Tiefe, Wände und Boden.",
      "Talle la preparación como se muestra: contorno, profundidad, paredes y piso.",
      "示されたとおりに形成してください：外形、深さ、壁、窩底。"},
     {"trace_shape", "trace_shape", "Practice block: %1", "Übungsblock: %1", "Bloque de práctica: %1",
      "練習ブロック：%1", "Mill the shape to its depth and stay inside its lines.",
      "Fräsen Sie die Form in ihrer Tiefe und bleiben Sie in ihren Linien.",
      "Frese la forma a su profundidad y no salga de sus líneas.",
      "形をその深さまで削り、線の外に出ないでください。"}}};

tl::unexpected<core::Error> refused(const QString& sentence)
{
    return core::unexpected(core::ErrorCode::OutOfRange, sentence.toStdString());
}

std::optional<QJsonObject> objectIn(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return std::nullopt;
    return QJsonDocument::fromJson(file.read(kLargestLessonBytes)).object();
}

/// Returns the file that a lesson is based on, by its name in the folder or of a shipped lesson.
core::Result<QString> baseOf(const QString& from, const QString& folder)
{
    if (isNameBeside(from) && QFileInfo(QDir(folder).filePath(from)).isFile())
        return from;
    for (const CatalogEntry& entry : readCatalog(folder)) {
        if (!entry.read.lesson || QString::fromStdString(entry.read.lesson->id) != from)
            continue;
        const QFileInfo file(entry.read.file);
        if (entry.isShipped || file.absolutePath() == QDir(folder).absolutePath())
            return file.fileName();
    }
    return core::unexpected(core::ErrorCode::UnknownName,
                            QStringLiteral("there is no lesson \"%1\" to begin from; \"cusp lesson list\" names them")
                                .arg(from.left(80))
                                .toStdString());
}

QString toothName(const NewLesson& wishes)
{
    if (!wishes.scan.isEmpty() && !wishes.fdi)
        return QFileInfo(wishes.scan).completeBaseName();
    return wishes.block.isEmpty() ? QString::number(wishes.fdi.value_or(kUsualTooth)) : wishes.block;
}

QJsonObject toothOf(const NewLesson& wishes)
{
    QJsonObject tooth;
    if (!wishes.scan.isEmpty()) {
        tooth.insert(QStringLiteral("scan"), wishes.scan);
        for (const auto& [key, value] : {std::pair("unit", wishes.unit), std::pair("up", wishes.up)})
            if (!value.isEmpty())
                tooth.insert(QLatin1String(key), value);
        if (wishes.fdi)
            tooth.insert(QStringLiteral("fdi"), *wishes.fdi);
        return tooth;
    }
    if (wishes.block.isEmpty())
        tooth.insert(QStringLiteral("fdi"), wishes.fdi.value_or(kUsualTooth));
    else
        tooth.insert(QStringLiteral("block"), wishes.block);
    // Without a seed, the order of a block's layers is drawn for each attempt.
    if (wishes.seed || wishes.block.isEmpty())
        tooth.insert(QStringLiteral("seed"), wishes.seed.value_or(0));
    return tooth;
}

/// Returns the id of the rubric of a Class I. Premolars have thinner ridges than molars.
const char* classOneRubric(int fdi)
{
    return fdi % 10 == 4 || fdi % 10 == 5 ? "class1_premolar" : "class1";
}

/// Returns the ids of the usual ideal for a tooth and of its rubric.
core::Result<std::pair<QString, QString>> kindFor(int fdi)
{
    using core::preparation::Kind;
    for (const auto& [kind, rubric] :
         {std::pair(Kind::ClassOne, classOneRubric(fdi)), std::pair(Kind::Access, "access")})
        if (core::preparation::usualDesign(kind, fdi)) {
            const std::string_view id = core::preparation::kindId(kind);
            return std::pair(QString::fromUtf8(id.data(), static_cast<qsizetype>(id.size())), QLatin1String(rubric));
        }
    return refused(QStringLiteral("no ideal is made for tooth %1; give a captured one, or remove decay").arg(fdi));
}

/// Sets the captured ideal of the lesson, and writes its tolerances into a rubric in the lesson.
core::Status nameCaptured(QJsonObject& object, const QString& captured, const QString& folder, bool isBased)
{
    const QString path = QDir(folder).filePath(captured);
    const auto ideal = core::preparation::readCaptured(std::filesystem::path(path.toStdU16String()));
    if (!ideal)
        return tl::unexpected(ideal.error());
    QJsonObject names{{QStringLiteral("captured"), captured}};
    if (isBased) {
        names.insert(QStringLiteral("kind"), QJsonValue());
        names.insert(QStringLiteral("sizes"), QJsonValue());
    }
    object.insert(QStringLiteral("ideal"), names);
    const QString draft = QDir(folder).filePath(QStringLiteral("draft.lesson.json"));
    const ReadLesson read = readDraft(object, draft);
    if (read.lesson && read.lesson->task != Task::CutIdeal)
        return refused(QStringLiteral("a captured ideal is there to be cut, and this lesson asks for something else; "
                                      "say --task cut_ideal"));
    if (read.lesson)
        object.insert(QStringLiteral("rubric"), withTolerances(ownRubric(*read.lesson), ideal->tolerances));
    return {};
}

/// Writes into `object` the differences from the lesson that it is based on.
core::Status beginFrom(QJsonObject& object, const NewLesson& wishes, const QString& folder)
{
    const auto base = baseOf(wishes.from, folder);
    if (!base)
        return tl::unexpected(base.error());
    object.insert(QStringLiteral("based_on"), *base);
    if (wishes.task) {
        const Beginning& beginning = kBeginnings[static_cast<std::size_t>(*wishes.task)];
        const ReadLesson under = readDraft(object, QDir(folder).filePath(QStringLiteral("draft.lesson.json")));
        if (!under.lesson || under.lesson->task != *wishes.task)
            object.insert(QStringLiteral("rubric"), QLatin1String(beginning.rubric));
        object.insert(QStringLiteral("task"), QLatin1String(beginning.task));
    }
    if (!wishes.scan.isEmpty()) {
        object.insert(QStringLiteral("tooth"), toothOf(wishes));
    } else if (wishes.fdi || wishes.seed || !wishes.block.isEmpty()) {
        QJsonObject tooth;
        if (wishes.fdi)
            tooth.insert(QStringLiteral("fdi"), *wishes.fdi);
        if (wishes.seed)
            tooth.insert(QStringLiteral("seed"), *wishes.seed);
        if (!wishes.block.isEmpty())
            tooth.insert(QStringLiteral("block"), wishes.block);
        object.insert(QStringLiteral("tooth"), tooth);
    }
    if (!wishes.title.isEmpty())
        object.insert(QStringLiteral("title"), wishes.title);
    return {};
}

QJsonObject inFourLanguages(const QString& en, const QString& de, const QString& es, const QString& ja)
{
    return {{"en", en}, {"de", de}, {"es", es}, {"ja", ja}};
}

/// Writes a complete lesson into `object`.
core::Status beginAnew(QJsonObject& object, const NewLesson& wishes)
{
    const Task usual = !wishes.captured.isEmpty() ? Task::CutIdeal
                       : wishes.block.isEmpty()   ? Task::RemoveDecay
                                                  : Task::TraceShape;
    const Task task = wishes.task.value_or(usual);
    if (task == Task::TraceShape && wishes.block.isEmpty())
        return refused(QStringLiteral("a shape is traced in a practice block; name one, such as \"cross\""));
    const Beginning& beginning = kBeginnings[static_cast<std::size_t>(task)];
    QString rubric =
        QLatin1String(task == Task::CutIdeal ? classOneRubric(wishes.fdi.value_or(kUsualTooth)) : beginning.rubric);
    object.insert(QStringLiteral("title"),
                  wishes.title.isEmpty()
                      ? QJsonValue(inFourLanguages(QString::fromUtf8(beginning.titleEn).arg(toothName(wishes)),
                                                   QString::fromUtf8(beginning.titleDe).arg(toothName(wishes)),
                                                   QString::fromUtf8(beginning.titleEs).arg(toothName(wishes)),
                                                   QString::fromUtf8(beginning.titleJa).arg(toothName(wishes))))
                      : QJsonValue(wishes.title));
    object.insert(QStringLiteral("goal"),
                  inFourLanguages(QString::fromUtf8(beginning.goalEn), QString::fromUtf8(beginning.goalDe),
                                  QString::fromUtf8(beginning.goalEs), QString::fromUtf8(beginning.goalJa)));
    object.insert(QStringLiteral("task"), QLatin1String(beginning.task));
    object.insert(QStringLiteral("tooth"), toothOf(wishes));
    if (task == Task::RemoveDecay)
        object.insert(QStringLiteral("lesion"), QJsonObject{{"extent", kUsualExtent}});
    if (task == Task::TraceShape)  // the rubric uses the zones of the leeway
        object.insert(QStringLiteral("leeway"),
                      QJsonObject{{"sides_mm", LeewayZone().sidesMm}, {"bottom_mm", LeewayZone().bottomMm}});
    if (task == Task::CutIdeal && wishes.captured.isEmpty() && !wishes.scan.isEmpty())
        return refused(QStringLiteral("an ideal is made by rule for a tooth of ours only; for a scan give a captured "
                                      "one, or remove decay"));
    if (task == Task::CutIdeal && wishes.captured.isEmpty()) {
        const auto kind = kindFor(wishes.fdi.value_or(kUsualTooth));
        if (!kind)
            return tl::unexpected(kind.error());
        object.insert(QStringLiteral("ideal"), QJsonObject{{"kind", kind->first}});
        rubric = kind->second;
    }
    object.insert(QStringLiteral("minutes"), kUsualMinutes);
    object.insert(QStringLiteral("rubric"), rubric);
    return {};
}

}  // namespace

core::Result<QJsonObject> newLesson(const NewLesson& wishes, const QString& folder)
{
    if (!wishes.block.isEmpty() && wishes.fdi)
        return refused(QStringLiteral("a lesson has a tooth or a practice block, not both"));
    QJsonObject object{
        {QStringLiteral("format"), kLessonFormat}, {QStringLiteral("id"), wishes.id}, {QStringLiteral("version"), 1}};
    const core::Status begun = wishes.from.isEmpty() ? beginAnew(object, wishes) : beginFrom(object, wishes, folder);
    if (!begun)
        return tl::unexpected(begun.error());
    if (!wishes.captured.isEmpty())
        if (core::Status named = nameCaptured(object, wishes.captured, folder, !wishes.from.isEmpty()); !named)
            return tl::unexpected(named.error());
    return object;
}

QJsonObject ownVersion(const ReadLesson& lesson)
{
    if (!lesson.file.startsWith(kShipped))
        return objectIn(lesson.file).value_or(QJsonObject());
    QJsonObject title;
    for (const auto& [language, text] : lesson.lesson->title)
        title.insert(QString::fromStdString(language),
                     QString::fromStdString(text) + (language == "de"   ? QStringLiteral(" (eigene Fassung)")
                                                     : language == "es" ? QStringLiteral(" (versión propia)")
                                                     : language == "ja" ? QStringLiteral("（自分の版）")
                                                                        : QStringLiteral(" (own version)")));
    return {{QStringLiteral("format"), kLessonFormat},
            {QStringLiteral("based_on"), QFileInfo(lesson.file).fileName()},
            {QStringLiteral("id"), QString::fromStdString(lesson.lesson->id) + QStringLiteral("-own")},
            {QStringLiteral("version"), 1},
            {QStringLiteral("title"), title}};
}

QJsonObject ownRubric(const Lesson& lesson)
{
    QJsonObject rubric = QJsonDocument::fromJson(QByteArray::fromStdString(lesson.json))
                             .object()
                             .value(QStringLiteral("rubric"))
                             .toObject();
    const QString id = rubric.value(QStringLiteral("id")).toString();
    if (QFile::exists(kShipped + id + QStringLiteral(".rubric.json")))
        rubric.insert(QStringLiteral("id"), id + QStringLiteral("-own"));
    return rubric;
}

}  // namespace lessons
