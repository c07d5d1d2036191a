// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/LessonReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>

#include "core/drilling/Bur.h"
#include "core/grading/MeasureTable.h"
#include "core/mesh/Placement.h"
#include "core/preparation/CapturedIdeal.h"
#include "core/preparation/ToothDesign.h"
#include "core/teeth/ToothTable.h"
#include "core/terrain/Grid.h"
#include "lessons/Assignment.h"
#include "lessons/JsonKeys.h"

namespace lessons {
namespace {

constexpr int kMostFiles = 8;
constexpr qint64 kLargestScanBytes = qint64{1} << 30;
constexpr int kMostSteps = 40;
constexpr int kMostPointsToTouch = 40;
constexpr double kFarthestPointMm = 30.0;
constexpr double kMostPoints = 100.0;
constexpr qint64 kLargestSeed = qint64{1} << 53;
constexpr int kNewestVersion = 1'000'000;
const QString kShipped = QStringLiteral(":/lessons/");
const char* const kBasedOn = "based_on";

const QStringList kTasks{QStringLiteral("remove_decay"), QStringLiteral("cut_ideal"),  QStringLiteral("trace_shape"),
                         QStringLiteral("touch_points"), QStringLiteral("hold_force"), QStringLiteral("tell_layers")};
const QStringList kSides{QStringLiteral("over"), QStringLiteral("under"), QStringLiteral("both")};
const QStringList kVerdicts{QStringLiteral("sum_of_errors"), QStringLiteral("worst_error")};

/// Puts one object over another: what is null goes, objects are merged, everything else is replaced (RFC 7386).
QJsonObject merged(QJsonObject base, const QJsonObject& over)
{
    for (auto entry = over.begin(); entry != over.end(); ++entry) {
        if (entry.value().isNull())
            base.remove(entry.key());
        else if (entry.value().isObject() && base.value(entry.key()).isObject())
            base.insert(entry.key(), merged(base.value(entry.key()).toObject(), entry.value().toObject()));
        else
            base.insert(entry.key(), entry.value());
    }
    return base;
}

QString sizeWords(qint64 bytes)
{
    return bytes >= 1024 * 1024 ? QStringLiteral("%1 MB").arg(static_cast<double>(bytes) / (1024.0 * 1024.0), 0, 'f', 1)
                                : QStringLiteral("%1 bytes").arg(bytes);
}

/// Gathers a lesson or a rubric from its files, and the faults on the way.
class Files
{
public:
    explicit Files(std::vector<Fault>& faults) : m_faults(faults) {}

    /// The object of a file with all that it is based on; nothing (and a fault) if any of it cannot be read.
    std::optional<QJsonObject> gather(const QString& file) { return gather(file, {}, {}); }
    /// The same of an object that would stand there.
    std::optional<QJsonObject> underlaid(const QJsonObject& object, const QString& file)
    {
        return underlaid(object, file, QStringList{file});
    }
    /// All that was read or found so far, but what we ship.
    [[nodiscard]] const QStringList& uses() const { return m_uses; }
    void note(const QString& file)
    {
        if (!file.startsWith(kShipped) && !m_uses.contains(file))
            m_uses << file;
    }

    /// Where a name in `file` leads: beside it, or to what we ship. Empty (and a fault) if it may not be named.
    QString find(const QString& file, const QString& key, const QString& name)
    {
        if (!isNameBeside(name)) {
            say(file, key,
                QStringLiteral("\"%1\" leads out of the lesson's folder; name a file beside it").arg(name.left(80)));
            return {};
        }
        const QString beside = QFileInfo(file).dir().filePath(name);
        return QFileInfo::exists(beside) || file.startsWith(kShipped) || !QFileInfo::exists(kShipped + name)
                   ? beside
                   : kShipped + name;
    }

    void say(const QString& file, const QString& key, const QString& what)
    {
        m_faults.push_back({file, key, what, true});
    }

private:
    std::optional<QJsonObject> gather(const QString& file, const QString& namedIn, QStringList way)
    {
        const auto complain = [&](const QString& what) {
            if (namedIn.isEmpty())
                say(file, {}, what);
            else
                say(namedIn, QLatin1String(kBasedOn), QStringLiteral("%1: %2").arg(QFileInfo(file).fileName(), what));
            return std::nullopt;
        };
        if (way.contains(file))
            return complain(QStringLiteral("is based on itself by way of %1").arg(QFileInfo(way.back()).fileName()));
        if (way.size() >= kMostFiles)
            return complain(QStringLiteral("more than %1 files are based on one another").arg(kMostFiles));
        way << file;
        note(file);
        const auto object = read(file, complain);
        return object ? underlaid(*object, file, way) : std::nullopt;
    }

    std::optional<QJsonObject> underlaid(const QJsonObject& object, const QString& file, const QStringList& way)
    {
        if (!object.contains(QLatin1String(kBasedOn)))
            return object;
        const QJsonValue base = object.value(QLatin1String(kBasedOn));
        const QString baseFile = find(file, QLatin1String(kBasedOn), base.toString());
        if (baseFile.isEmpty())
            return std::nullopt;
        const auto under = gather(baseFile, file, way);
        if (!under)
            return std::nullopt;
        QJsonObject whole = merged(*under, object);
        whole.remove(QLatin1String(kBasedOn));
        return whole;
    }

    template <class Complain>
    std::optional<QJsonObject> read(const QString& name, Complain complain)
    {
        QFile file(name);
        if (!QFileInfo::exists(name))
            return complain(QStringLiteral("there is no such file"));
        if (QFileInfo(name).isDir() || !file.open(QIODevice::ReadOnly))
            return complain(QStringLiteral("cannot be read (%1)")
                                .arg(QFileInfo(name).isDir() ? QStringLiteral("it is a folder") : file.errorString()));
        if (file.size() > kLargestLessonBytes)
            return complain(QStringLiteral("has %1; a lesson has at most %2")
                                .arg(sizeWords(file.size()), sizeWords(kLargestLessonBytes)));
        const QByteArray bytes = file.read(kLargestLessonBytes + 1);
        if (bytes.isEmpty())
            return complain(QStringLiteral("is empty"));
        return parse(bytes, complain);
    }

public:
    template <class Complain>
    static std::optional<QJsonObject> parse(QByteArray bytes, Complain complain)
    {
        if (bytes.size() > kLargestLessonBytes)
            return complain(QStringLiteral("has %1; a lesson has at most %2")
                                .arg(sizeWords(bytes.size()), sizeWords(kLargestLessonBytes)));
        if (bytes.startsWith("\xEF\xBB\xBF"))
            bytes.remove(0, 3);
        QJsonParseError error;
        const QJsonDocument document = QJsonDocument::fromJson(bytes, &error);
        if (document.isNull()) {
            const auto before = bytes.left(error.offset);
            return complain(QStringLiteral("is not JSON: line %1, column %2: %3")
                                .arg(before.count('\n') + 1)
                                .arg(error.offset - before.lastIndexOf('\n'))
                                .arg(error.errorString()));
        }
        if (!document.isObject())
            return complain(QStringLiteral("must be one JSON object in braces"));
        return document.object();
    }

private:
    std::vector<Fault>& m_faults;
    QStringList m_uses;
};

bool checkFormat(JsonKeys& keys)
{
    if (!keys.has("format")) {
        keys.fault("format", QStringLiteral("is missing; write \"format\": %1").arg(kLessonFormat));
        return false;
    }
    const qint64 format = keys.whole("format", 1, kNewestVersion, 0);
    if (format > kLessonFormat)
        keys.fault("format",
                   QStringLiteral("is %1, from a newer Cusp; this one reads %2. Update Cusp to give this lesson")
                       .arg(format)
                       .arg(kLessonFormat));
    return format == kLessonFormat;
}

void takeId(JsonKeys& keys, std::string& id)
{
    static const QRegularExpression kPattern(QStringLiteral("^[a-z0-9][a-z0-9_-]{0,63}$"));
    id = keys.neededText("id", 64);
    if (!id.empty() && !kPattern.match(QString::fromStdString(id)).hasMatch())
        keys.fault("id", QStringLiteral(
                             "may hold small letters, digits, '-' and '_' only, and begins with a letter or digit"));
}

/// Tenths of a point; a weight such as 12.25 is a fault, for points are given to a tenth.
int takeTenths(JsonKeys& keys, const char* key, int otherwise)
{
    const auto points = keys.number(key, 0.0, kMostPoints, "points");
    if (!points)
        return otherwise;
    const double tenths = *points * 10.0;
    if (std::abs(tenths - std::round(tenths)) > 1.0e-9)
        keys.fault(key, QStringLiteral("is %1; points are given to a tenth").arg(*points));
    return static_cast<int>(std::lround(tenths));
}

/// The id of a measure that exists, with its unit.
std::string takeMeasure(JsonKeys& keys, const char* key, std::string* unit)
{
    std::string id = keys.neededText(key, 80);
    if (id.empty())
        return id;
    const auto measure = core::grading::findMeasure(id);
    if (!measure)
        keys.fault(key, QStringLiteral("\"%1\" is no measure; \"cusp lesson measures\" lists them")
                            .arg(QString::fromStdString(id)));
    else if (unit != nullptr)
        *unit = std::string(measure->unit);
    return id;
}

CriterionRule takeCriterion(JsonKeys& keys)
{
    CriterionRule rule;
    takeId(keys, rule.id);
    rule.title = keys.local("title", false);
    rule.measure = takeMeasure(keys, "measure", &rule.unit);
    rule.side = static_cast<Side>(std::max(0, keys.choice("side", kSides)));
    rule.target = keys.number("target", -kLargestRubricNumber, kLargestRubricNumber, rule.unit.c_str(), 0.0);
    rule.tolerance = keys.number("tolerance", 0.0, kLargestRubricNumber, rule.unit.c_str(), 0.0);
    rule.critical = keys.flag("critical", false);
    rule.span = keys.number("span", 0.0, kLargestRubricNumber, rule.unit.c_str(), 0.0);
    if (auto allowance = keys.object("allowance")) {
        rule.allowance = Allowance{takeMeasure(*allowance, "measure", nullptr),
                                   allowance->number("each", 0.0, kLargestRubricNumber, "", 0.0)};
        allowance->nameTheRest();
    }
    if (!rule.critical && !keys.has("weight"))
        keys.fault("weight", QStringLiteral("is missing"));
    rule.weightTenths = takeTenths(keys, "weight", 0);
    keys.nameTheRest();
    return rule;
}

Rubric takeRubric(JsonKeys& keys, bool isOnItsOwn, const QJsonObject& object)
{
    Rubric rubric;
    if (isOnItsOwn && !checkFormat(keys))
        return rubric;
    static_cast<void>(keys.has("format"));
    takeId(keys, rubric.id);
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
    return rubric;
}

bool anyGrave(const std::vector<Fault>& faults)
{
    return std::any_of(faults.begin(), faults.end(), [](const Fault& fault) { return fault.grave; });
}

/// The rubric named or written in a lesson, as an object with nothing left to look up.
std::optional<QJsonObject> rubricObject(const QJsonValue& value, const QString& file, Files& files)
{
    if (value.isObject())
        return value.toObject();
    if (!value.isString()) {
        files.say(
            file, QStringLiteral("rubric"),
            QStringLiteral("is missing; name one that is shipped (\"decay_removal\"), a file beside the lesson, or "
                           "write it out"));
        return std::nullopt;
    }
    const QString name = value.toString();
    const QString found = name.endsWith(QStringLiteral(".json")) ? files.find(file, QStringLiteral("rubric"), name)
                                                                 : kShipped + name + QStringLiteral(".rubric.json");
    if (found.isEmpty())
        return std::nullopt;
    if (!QFileInfo::exists(found)) {
        files.say(file, QStringLiteral("rubric"), QStringLiteral("there is no rubric \"%1\"").arg(name.left(80)));
        return std::nullopt;
    }
    return files.gather(found);
}

/// SHA-256 of a file beside the lesson; empty, and a fault, if it cannot be read.
std::string hashOf(const QString& path, JsonKeys& keys, const char* key)
{
    QFile file(path);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    if (path.isEmpty() || !QFileInfo::exists(path)) {
        keys.fault(key, QStringLiteral("there is no file \"%1\" beside the lesson").arg(QFileInfo(path).fileName()));
        return {};
    }
    if (QFileInfo(path).size() > kLargestScanBytes || !file.open(QIODevice::ReadOnly) || !hash.addData(&file)) {
        keys.fault(key, QStringLiteral("\"%1\" cannot be read").arg(QFileInfo(path).fileName()));
        return {};
    }
    return hash.result().toHex().toStdString();
}

/// Turns the whole object of a lesson into a Lesson.
class LessonMaker
{
public:
    /// @param folder  where the lesson's other files lie; null for a text that stands on its own
    LessonMaker(const QJsonObject& whole, const QString& file, Files* files, std::vector<Fault>& faults)
        : m_whole(whole), m_file(file), m_files(files), m_faults(faults), m_keys(whole, file, {}, faults)
    {}

    Lesson make()
    {
        Lesson lesson;
        static_cast<void>(m_keys.has("$schema"));  // editors look there
        if (!checkFormat(m_keys))
            return lesson;
        takeId(m_keys, lesson.id);
        lesson.version = static_cast<int>(m_keys.whole("version", 1, kNewestVersion, 1));
        lesson.title = m_keys.local("title", true);
        lesson.goal = m_keys.local("goal", true);
        lesson.notModelled = m_keys.local("not_modelled", false);
        if (!m_keys.has("task"))
            m_keys.fault("task", QStringLiteral("is missing; there are %1").arg(kTasks.join(QStringLiteral(", "))));
        lesson.task = static_cast<Task>(std::max(0, m_keys.choice("task", kTasks)));
        takeTooth(lesson);
        lesson.gridSide = static_cast<int>(m_keys.whole("grid", core::terrain::kMinGridSide,
                                                        core::terrain::kMaxGridSide, core::terrain::kDefaultGridSide));
        takeWork(lesson);
        takeTools(lesson);
        takeRules(lesson);
        takeExpert(lesson);
        m_keys.objects("steps", kMostSteps, [&](JsonKeys& step) {
            lesson.steps.push_back({step.local("text", true), step.local("hint", false)});
            step.nameTheRest();
        });
        lesson.minutes = m_keys.number("minutes", 0.0, 600.0, "minutes", 0.0);
        lesson.exam = m_keys.flag("exam", false);
        if (auto rubric = m_keys.object("rubric")) {
            lesson.rubric = takeRubric(*rubric, false, m_whole.value(QStringLiteral("rubric")).toObject());
            if (!anyGrave(m_faults))
                if (const auto sound = check(lesson.rubric); !sound)
                    m_keys.fault("rubric", QString::fromStdString(sound.error().detail));
        } else {
            m_keys.fault("rubric", QStringLiteral("is missing"));
        }
        m_keys.nameTheRest();
        checkWhole(lesson);
        lesson.json = QJsonDocument(m_whole).toJson(QJsonDocument::Compact).toStdString();
        if (lesson.json.size() > static_cast<std::size_t>(kLargestLessonBytes))
            m_keys.fault("",
                         QStringLiteral("has %1 with all that it names; a recording takes at most %2 along. Shorten "
                                        "its texts")
                             .arg(sizeWords(static_cast<qint64>(lesson.json.size())), sizeWords(kLargestLessonBytes)));
        lesson.hash = QCryptographicHash::hash(QByteArray::fromStdString(lesson.json), QCryptographicHash::Sha256)
                          .toHex()
                          .toStdString();
        return lesson;
    }

private:
    void takeTooth(Lesson& lesson)
    {
        auto tooth = m_keys.object("tooth");
        if (!tooth) {
            m_keys.fault("tooth", QStringLiteral("is missing; write {\"fdi\": 36}, {\"block\": \"line\"} or "
                                                 "{\"scan\": \"tooth.stl\"}"));
            return;
        }
        const int named = (tooth->has("block") ? 1 : 0) + (tooth->has("scan") ? 1 : 0);
        if (named > 1 || (named == 0 && !tooth->has("fdi")))
            tooth->fault("", QStringLiteral("must name one of \"fdi\", \"block\" and \"scan\""));
        else if (tooth->has("block"))
            lesson.tooth = takeBlock(*tooth);
        else if (tooth->has("scan"))
            lesson.tooth = takeScan(*tooth);
        else
            lesson.tooth = MadeTooth{fdiOf(*tooth), seedOf(*tooth)};
        tooth->nameTheRest();
    }

    static Block takeBlock(JsonKeys& keys)
    {
        Block block{keys.neededText("block", 40), {}, {}};
        if (keys.has("seed"))
            block.seed = seedOf(keys);
        if (auto sizes = keys.object("sizes"))
            block.sizes = sizes->allNumbers(-1000.0, 1000.0);
        if (const auto design = designOf(block); !design)
            keys.fault("block", QString::fromStdString(design.error().detail));
        return block;
    }

    static std::uint64_t seedOf(JsonKeys& keys)
    {
        return static_cast<std::uint64_t>(keys.whole("seed", 0, kLargestSeed, 0));
    }

    static int fdiOf(JsonKeys& keys)
    {
        const int fdi = static_cast<int>(keys.whole("fdi", 11, 48, 0));
        if (fdi != 0 && !core::teeth::findToothSizes(fdi))
            keys.fault("fdi",
                       QStringLiteral("there is no tooth %1 here; those of the left are made: 21 to 28 and 31 to 38")
                           .arg(fdi));
        return fdi;
    }

    Scan takeScan(JsonKeys& keys)
    {
        Scan scan;
        const QString name = QString::fromStdString(keys.neededText("scan"));
        scan.unit = keys.text("unit", 20);
        scan.up = keys.text("up", 4);
        scan.fdi = static_cast<int>(keys.whole("fdi", 11, 48, 0));
        if (!scan.unit.empty() && !core::mesh::parseUnit(scan.unit))
            keys.fault("unit", QStringLiteral("\"%1\" is no unit; write mm, cm, m or the millimetres of one unit")
                                   .arg(QString::fromStdString(scan.unit)));
        if (!scan.up.empty() && !core::mesh::parseAxis(scan.up))
            keys.fault("up", QStringLiteral("\"%1\" is no direction; write +x, -x, +y, -y, +z or -z")
                                 .arg(QString::fromStdString(scan.up)));
        takeFile(keys, "scan", QStringLiteral("tooth"), name, scan.file, scan.hash);
        return scan;
    }

    /// Where a file that the lesson names lies, and its hash, which goes into the lesson's own.
    void takeFile(JsonKeys& keys, const char* key, const QString& parent, const QString& name, std::string& path,
                  std::string& hash)
    {
        if (m_files == nullptr) {
            path = name.toStdString();
            hash = keys.text("content", 64);
            return;
        }
        static_cast<void>(keys.has("content"));
        const QString found = m_files->find(m_file, keys.pathOf(QLatin1String(key)), name);
        if (found.isEmpty())
            return;
        m_files->note(found);
        path = QFileInfo(found).absoluteFilePath().toStdString();
        hash = hashOf(found, keys, key);
        putInto(parent, QStringLiteral("content"), QString::fromStdString(hash));
    }

    void putInto(const QString& parent, const QString& key, const QString& text)
    {
        QJsonObject owner = m_whole.value(parent).toObject();
        owner.insert(key, text);
        m_whole.insert(parent, owner);
    }

    Ideal takeIdeal(JsonKeys& keys)
    {
        Ideal asked;
        const bool isCaptured = keys.has("captured");
        if (isCaptured && (keys.has("kind") || keys.has("sizes")))
            keys.fault(
                "captured",
                QStringLiteral("an ideal is captured, or has a kind and sizes; leave one out (where the lesson is "
                               "based on another, with \"kind\": null, \"sizes\": null)"));
        else if (isCaptured)
            asked.captured = takeCaptured(keys);
        else if (!keys.has("kind"))
            keys.fault("kind", QStringLiteral("is missing; name the preparation, or a file \"captured\""));
        else
            asked.kind = keys.neededText("kind", 40);
        for (const char* const ours : {"content", "data"})
            static_cast<void>(keys.has(ours));
        if (const auto kind = core::preparation::findKind(asked.kind); !kind && !asked.kind.empty())
            keys.fault("kind", QString::fromStdString(kind.error().detail));
        if (auto sizes = keys.object("sizes"))
            asked.sizes = sizes->allNumbers(-1000.0, 1000.0);
        keys.nameTheRest();
        return asked;
    }

    /// The file goes into the text of the lesson, so that a recording can be marked again wherever it is.
    Captured takeCaptured(JsonKeys& keys)
    {
        Captured captured;
        const QString name = QString::fromStdString(keys.neededText("captured"));
        takeFile(keys, "captured", QStringLiteral("ideal"), name, captured.file, captured.hash);
        if (captured.file.empty() || captured.hash.empty())
            return captured;
        if (m_files == nullptr) {
            const QByteArray data = QByteArray::fromStdString(keys.text("data", kLargestLessonBytes));
            captured.bytes = QByteArray::fromBase64(data).toStdString();
        } else {
            QFile file(QString::fromStdString(captured.file));
            if (file.size() > kLargestIdealBytes) {
                keys.fault("captured",
                           QStringLiteral("\"%1\" has %2; a lesson takes at most %3. Capture it on a coarser "
                                          "grid")
                               .arg(name, sizeWords(file.size()), sizeWords(kLargestIdealBytes)));
                return captured;
            }
            const QByteArray bytes = file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
            captured.bytes = bytes.toStdString();
            putInto(QStringLiteral("ideal"), QStringLiteral("data"), QString::fromLatin1(bytes.toBase64()));
        }
        if (const auto ideal = core::preparation::capturedFrom(captured.bytes); !ideal)
            keys.fault("captured",
                       QStringLiteral("\"%1\": %2").arg(name, QString::fromStdString(ideal.error().detail)));
        return captured;
    }

    void takeWork(Lesson& lesson)
    {
        if (auto lesion = m_keys.object("lesion")) {
            lesson.lesion = Lesion{lesion->number("extent", 0.0, 1.0, "", 0.5)};
            lesion->nameTheRest();
        }
        if (auto ideal = m_keys.object("ideal"))
            lesson.ideal = takeIdeal(*ideal);
        if (auto leeway = m_keys.object("leeway")) {
            lesson.leeway = LeewayZone{leeway->number("sides_mm", 0.0, 3.0, "mm", 0.3),
                                       leeway->number("bottom_mm", 0.0, 3.0, "mm", 0.3)};
            leeway->nameTheRest();
        }
        if (auto touch = m_keys.object("touch")) {
            lesson.touch.emplace();
            lesson.touch->pointsMm = touch->places("points", kMostPointsToTouch, kFarthestPointMm);
            lesson.touch->reachMm = touch->number("reach_mm", 0.1, 3.0, "mm", lesson.touch->reachMm);
            touch->nameTheRest();
        }
        if (auto hold = m_keys.object("hold")) {
            lesson.hold.emplace();
            lesson.hold->forceN = hold->number("force_n", 0.2, 5.0, "N", lesson.hold->forceN);
            lesson.hold->withinN = hold->number("within_n", 0.02, 2.0, "N", lesson.hold->withinN);
            lesson.hold->seconds = hold->number("seconds", 1.0, 120.0, "s", lesson.hold->seconds);
            hold->nameTheRest();
        }
    }

    /// "natural", or one of those with other figures for some of its materials.
    void takeHardness(Lesson& lesson)
    {
        if (m_whole.value(QStringLiteral("hardness")).isString()) {
            const std::string name = m_keys.text("hardness");
            if (const auto known = core::settings::findHardnessPreset(name))
                lesson.hardness = *known;
            else
                m_keys.fault("hardness", QString::fromStdString(known.error().detail));
            return;
        }
        auto keys = m_keys.object("hardness");
        if (!keys)
            return;
        const std::string base = keys->has("like") ? keys->text("like") : lesson.hardness.name;
        if (const auto known = core::settings::findHardnessPreset(base))
            lesson.hardness = *known;
        else
            keys->fault("like", QString::fromStdString(known.error().detail));
        lesson.hardness.name = keys->neededText("name", 60);
        static constexpr std::array<const char*, core::terrain::kMaterialCount> kMaterials{"caries", "enamel", "dentin",
                                                                                           "pulp"};
        for (std::size_t m = 0; m < kMaterials.size(); ++m) {
            auto material = keys->object(kMaterials[m]);
            if (!material)
                continue;
            core::settings::MaterialHardness& hardness = lesson.hardness.material[m];
            hardness.rateMm3PerNs =
                material->number("rate_mm3_per_ns", core::settings::kMinRateMm3PerNs, core::settings::kMaxRateMm3PerNs,
                                 "mm³/(N s)", hardness.rateMm3PerNs);
            hardness.thresholdN =
                material->number("threshold_n", 0.0, core::settings::kMaxThresholdN, "N", hardness.thresholdN);
            material->nameTheRest();
        }
        lesson.hardness.axialShare = keys->number("axial_share", 0.01, 1.0, "", lesson.hardness.axialShare);
        keys->nameTheRest();
    }

    void takeTools(Lesson& lesson)
    {
        takeHardness(lesson);
        lesson.breakOff = m_keys.flag("breaks_off", lesson.breakOff);
        for (const QString& name : m_keys.names("handpieces")) {
            const auto known = core::settings::findHandpiece(name.toStdString());
            if (!known)
                m_keys.fault("handpieces", QString::fromStdString(known.error().detail));
            else if (std::find(lesson.handpieces.begin(), lesson.handpieces.end(), *known) == lesson.handpieces.end())
                lesson.handpieces.push_back(*known);
        }
        for (const QString& bur : m_keys.names("burs")) {
            if (const auto known = core::drilling::findBur(bur.toStdString()); !known)
                m_keys.fault("burs", QString::fromStdString(known.error().detail));
            lesson.burs.push_back(bur.toStdString());
        }
        const bool isUnseen = lesson.task == Task::TellLayers;
        if (isUnseen || m_keys.has("aids"))
            lesson.aids = Aids::none();
        for (const QString& name : m_keys.names("aids")) {
            if (bool* const aid = aidNamed(lesson.aids, name))
                *aid = true;
            else
                m_keys.fault("aids", QStringLiteral("\"%1\" is no aid; there are section, depth_gauge, radiograph, "
                                                    "heat_map, mirror, ideal, bur_colour, fixture")
                                         .arg(name.left(40)));
        }
    }

    static bool* aidNamed(Aids& aids, const QString& name)
    {
        const std::pair<const char*, bool*> known[] = {
            {"section", &aids.section},      {"depth_gauge", &aids.depthGauge}, {"radiograph", &aids.radiograph},
            {"heat_map", &aids.heatMap},     {"mirror", &aids.mirror},          {"ideal", &aids.ideal},
            {"bur_colour", &aids.burColour}, {"fixture", &aids.fixture}};
        for (const auto& [id, aid] : known)
            if (name == QLatin1String(id))
                return aid;
        return nullptr;
    }

    void takeExpert(Lesson& lesson)
    {
        auto keys = m_keys.object("expert");
        if (!keys)
            return;
        Expert expert;
        const QString name = QString::fromStdString(keys->neededText("recording"));
        takeFile(*keys, "recording", QStringLiteral("expert"), name, expert.file, expert.hash);
        lesson.expert = expert;
        keys->nameTheRest();
    }

    void takeRules(Lesson& lesson)
    {
        auto rules = m_keys.object("rules");
        if (!rules)
            return;
        Rules& set = lesson.rules;
        set.pulpExposed = rules->flag("pulp_exposed", set.pulpExposed);
        set.perforated = rules->flag("perforated", set.perforated);
        set.neighbourHit = rules->flag("neighbour_hit", set.neighbourHit);
        if (set.neighbourHit && !std::holds_alternative<MadeTooth>(lesson.tooth))
            rules->fault("neighbour_hit", QStringLiteral("only a tooth of ours has neighbours; write false"));
        set.depthLimitMm = rules->number("depth_limit_mm", 0.1, 10.0, "mm");
        set.ridgeLimitMm = rules->number("ridge_limit_mm", 0.1, 5.0, "mm");
        set.besideMm = rules->number("beside_mm", 0.0, 10.0, "mm");
        set.forceLimitN = rules->number("force_limit_n", 0.1, 10.0, "N");
        set.airLimitS = rules->number("air_limit_s", 1.0, 600.0, "s");
        rules->nameTheRest();
    }

    /// What no single key tells.
    void checkWhole(const Lesson& lesson)
    {
        const bool isBlock = std::holds_alternative<Block>(lesson.tooth);
        if (lesson.task == Task::RemoveDecay && (isBlock || !lesson.lesion || lesson.lesion->extent <= 0.0))
            m_keys.fault("lesion",
                         QStringLiteral("to remove decay there must be some: write \"lesion\": {\"extent\": 0.5} for a "
                                        "tooth"));
        if (lesson.task == Task::CutIdeal && !lesson.ideal)
            m_keys.fault("ideal", QStringLiteral("is missing; it says which preparation is to be cut"));
        if (lesson.task == Task::TraceShape && !isBlock)
            m_keys.fault("tooth", QStringLiteral("a shape is traced in a block: write {\"block\": \"line\"}"));
        if (lesson.task == Task::TouchPoints && !lesson.touch)
            m_keys.fault("touch", QStringLiteral("is missing; it says which points are to be touched: {\"points\": "
                                                 "[[x, y], ...]}"));
        if (lesson.task == Task::HoldForce && !lesson.hold)
            m_keys.fault("hold", QStringLiteral("is missing; it says which force is to be held: {\"force_n\": 1}"));
        if (lesson.task == Task::TellLayers && (!isBlock || std::get<Block>(lesson.tooth).shape != "layers"))
            m_keys.fault("tooth", QStringLiteral("layers are told apart in a block of them: write {\"block\": "
                                                 "\"layers\"}"));
        if (lesson.task == Task::TellLayers && lesson.aids != Aids::none())
            m_keys.fault("aids", QStringLiteral("layers are told apart without any; leave the key out"));
    }

    QJsonObject m_whole;
    QString m_file;
    Files* m_files;
    std::vector<Fault>& m_faults;
    JsonKeys m_keys;
};

}  // namespace

bool isNameBeside(const QString& name)
{
    return !name.isEmpty() && name.size() < 200 && QDir::isRelativePath(name) && !name.contains(QLatin1Char('\\')) &&
           !name.split(QLatin1Char('/')).contains(QStringLiteral("..")) && !name.startsWith(QLatin1Char(':'));
}

QString Fault::sentence() const
{
    const QString where = QFileInfo(file).fileName();
    return (key.isEmpty() ? where + QLatin1Char(' ') : where + QStringLiteral(", ") + key + QStringLiteral(": ")) +
           what;
}

namespace {

void complete(const std::optional<QJsonObject>& gathered, const QString& file, Files& files, ReadLesson& result)
{
    result.uses = files.uses();
    if (!gathered)
        return;
    QJsonObject whole = *gathered;
    const auto rubric = rubricObject(whole.value(QStringLiteral("rubric")), file, files);
    if (!rubric)
        return;
    whole.insert(QStringLiteral("rubric"), *rubric);
    Lesson lesson = LessonMaker(whole, file, &files, result.faults).make();
    result.uses = files.uses();
    if (!anyGrave(result.faults))
        result.lesson = std::move(lesson);
}

}  // namespace

ReadLesson readLesson(const QString& file)
{
    ReadLesson result;
    result.file = file;
    Files files(result.faults);
    complete(files.gather(file), file, files, result);
    return result;
}

ReadLesson readDraft(const QJsonObject& draft, const QString& file)
{
    ReadLesson result;
    result.file = file;
    Files files(result.faults);
    complete(files.underlaid(draft, file), file, files, result);
    return result;
}

ReadLesson readLessonText(const QByteArray& json, const QString& name)
{
    ReadLesson result;
    result.file = name;
    const auto complain = [&](const QString& what) {
        result.faults.push_back({name, {}, what, true});
        return std::nullopt;
    };
    const auto whole = Files::parse(json, complain);
    if (!whole)
        return result;
    Lesson lesson = LessonMaker(*whole, name, nullptr, result.faults).make();
    if (!anyGrave(result.faults))
        result.lesson = std::move(lesson);
    return result;
}

core::Result<Rubric> readRubric(const QString& fileOrId)
{
    const QString file =
        fileOrId.endsWith(QStringLiteral(".json")) ? fileOrId : kShipped + fileOrId + QStringLiteral(".rubric.json");
    std::vector<Fault> faults;
    Files files(faults);
    if (const auto whole = files.gather(file)) {
        JsonKeys keys(*whole, file, {}, faults);
        Rubric rubric = takeRubric(keys, true, *whole);
        if (!anyGrave(faults)) {
            if (auto sound = check(rubric); !sound)
                return tl::unexpected(sound.error());
            return rubric;
        }
    }
    for (const Fault& fault : faults)
        if (fault.grave)
            return core::unexpected(core::ErrorCode::BadStructure, fault.sentence().toStdString());
    return core::unexpected(core::ErrorCode::BadStructure, file.toStdString() + " cannot be read");
}

}  // namespace lessons
