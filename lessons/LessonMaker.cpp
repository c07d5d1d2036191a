// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/LessonMaker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>

#include "core/base/NumberField.h"
#include "core/bur/Bur.h"
#include "core/mesh/Placement.h"
#include "core/preparation/AccessOpening.h"
#include "core/preparation/CapturedIdeal.h"
#include "core/preparation/ToothDesign.h"
#include "core/teeth/ToothTable.h"
#include "core/terrain/Grid.h"
#include "lessons/Assignment.h"
#include "lessons/JsonKeys.h"
#include "lessons/PresetFile.h"
#include "lessons/RubricReader.h"

namespace lessons {
namespace {

constexpr qint64 kLargestScanBytes = qint64{1} << 30;
constexpr int kMostSteps = 40;
constexpr int kLongestDirection = 60;  ///< three numbers
constexpr int kMostPointsToTouch = 40;
constexpr double kFarthestPointMm = 30.0;
constexpr qint64 kLargestSeed = qint64{1} << 53;
constexpr int kNewestFormat = 1'000'000;
const QStringList kReached{QStringLiteral("decay_found"), QStringLiteral("junction"), QStringLiteral("decay_removed"),
                           QStringLiteral("depth")};
const QStringList kLandmarks{QStringLiteral("central_pit"),  QStringLiteral("mesial_pit"),
                             QStringLiteral("distal_pit"),   QStringLiteral("mesial_ridge"),
                             QStringLiteral("distal_ridge"), QStringLiteral("ridges_to_keep"),
                             QStringLiteral("ridges_to_cut")};
const QStringList kTasks{QStringLiteral("remove_decay"), QStringLiteral("cut_ideal"),  QStringLiteral("trace_shape"),
                         QStringLiteral("touch_points"), QStringLiteral("hold_force"), QStringLiteral("tell_layers")};

bool checkFormat(JsonKeys& keys)
{
    if (!keys.has("format")) {
        keys.fault("format", {QT_TRANSLATE_NOOP("Fault", "is missing; write \"format\": %1"), {noted(kLessonFormat)}});
        return false;
    }
    const qint64 format = keys.whole("format", 1, kNewestFormat, 0);
    if (format > kLessonFormat)
        keys.fault("format", newerFormat(static_cast<double>(format)));
    return format == kLessonFormat;
}

/// Returns the SHA-256 of a file beside the lesson; empty, with a fault, if it cannot be read.
std::string hashOf(const QString& path, JsonKeys& keys, const char* key)
{
    QFile file(path);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    if (!QFileInfo(path).isFile()) {
        keys.fault(key, {QT_TRANSLATE_NOOP("Fault", "there is no file \"%1\" beside the lesson"),
                         {noted(QFileInfo(path).fileName())}});
        return {};
    }
    if (QFileInfo(path).size() > kLargestScanBytes || !file.open(QIODevice::ReadOnly) || !hash.addData(&file)) {
        keys.fault(key, {QT_TRANSLATE_NOOP("Fault", "\"%1\" cannot be read"), {noted(QFileInfo(path).fileName())}});
        return {};
    }
    return hash.result().toHex().toStdString();
}

constexpr std::array<const char*, core::terrain::kMaterialCount> kMaterials{"caries", "enamel", "dentin", "pulp"};
/// Longest label of a preset: its name with version and hash.
constexpr qsizetype kLongestHardnessName = kLongestPresetName + 90;

/// Builds a Lesson from the merged object.
class LessonMaker
{
public:
    LessonMaker(const QJsonObject& whole, const QString& file, JsonFiles* files, std::vector<ValidationIssue>& faults)
        : m_whole(whole), m_file(file), m_files(files), m_faults(faults), m_keys(whole, file, {}, faults)
    {}

    Lesson make(const QString& rubricFile)
    {
        Lesson lesson;
        static_cast<void>(m_keys.has("$schema"));  // for editors
        if (!checkFormat(m_keys))
            return lesson;
        lesson.id = takeId(m_keys);
        lesson.version = static_cast<int>(m_keys.whole("version", 1, kNewestFormat, 1));
        lesson.title = m_keys.local("title", true);
        lesson.goal = m_keys.local("goal", true);
        lesson.course = m_keys.local("course", false);
        lesson.notModelled = m_keys.local("not_modelled", false);
        if (!m_keys.has("task"))
            m_keys.fault("task", {QT_TRANSLATE_NOOP("Fault", "is missing; there are %1"),
                                  {noted(kTasks.join(QStringLiteral(", ")))}});
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
            if (const int when = step.choice("done_when", kReached); when >= 0)
                lesson.steps.back().doneWhen = static_cast<Reached>(when);
            if (const int mark = step.choice("mark", kLandmarks); mark >= 0)
                lesson.steps.back().mark = static_cast<core::guidance::Landmark>(mark);
            step.nameTheRest();
        });
        lesson.minutes = m_keys.number("minutes", 0.0, 600.0, "minutes", 0.0);
        lesson.exam = m_keys.flag("exam", false);
        lesson.aids.depthStop =
            m_keys.names("aids").contains(QStringLiteral("depth_stop")) || (lesson.aids.depthGauge && !lesson.exam);
        if (!m_keys.has("rubric"))
            m_keys.fault("rubric", {QT_TRANSLATE_NOOP("Fault", "is missing")});
        else if (m_keys.object("rubric"))
            lesson.rubric = rubricFrom(m_whole.value(QStringLiteral("rubric")).toObject(), rubricFile,
                                       rubricFile == m_file ? QStringLiteral("rubric") : QString(), m_faults);
        m_keys.nameTheRest();
        checkWhole(lesson);
        lesson.json = QJsonDocument(m_whole).toJson(QJsonDocument::Compact).toStdString();
        if (lesson.json.size() > static_cast<std::size_t>(kLargestLessonBytes))
            m_keys.fault(
                "", {QT_TRANSLATE_NOOP("Fault", "has %1 with all that it names; a recording takes at most %2 along. "
                                                "Shorten its texts"),
                     {sizeWords(static_cast<qint64>(lesson.json.size())), sizeWords(kLargestLessonBytes)}});
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
            m_keys.fault("tooth", {QT_TRANSLATE_NOOP(
                                      "Fault", "is missing; write {\"fdi\": 36}, {\"block\": \"line\"} or {\"scan\": "
                                               "\"tooth.stl\"}")});
            return;
        }
        const int named = (tooth->has("block") ? 1 : 0) + (tooth->has("scan") ? 1 : 0);
        if (named > 1 || (named == 0 && !tooth->has("fdi")))
            tooth->fault("", {QT_TRANSLATE_NOOP("Fault", "must name one of \"fdi\", \"block\" and \"scan\"")});
        else if (tooth->has("block"))
            lesson.tooth = takeBlock(*tooth);
        else if (tooth->has("scan"))
            lesson.tooth = takeScan(*tooth);
        else
            lesson.tooth = takeMade(*tooth);
        tooth->nameTheRest();
    }

    static MadeTooth takeMade(JsonKeys& keys)
    {
        MadeTooth made{fdiOf(keys), seedOf(keys), {}};
        if (made.fdi != 0)
            made.lying = lyingOf(keys, made.fdi);
        return made;
    }

    /// @param fdi  0 for a scan
    static core::terrain::Lying lyingOf(JsonKeys& keys, int fdi)
    {
        const double tiltDeg = keys.number("tilt_deg", core::terrain::Lying::kLeastTiltDeg,
                                           core::terrain::Lying::kMostTiltDeg, "°", core::terrain::Lying::kMostTiltDeg);
        if (!keys.has("lies")) {
            if (keys.has("tilt_deg"))
                keys.fault("tilt_deg", {QT_TRANSLATE_NOOP("Fault", "is how far the tooth lies on a side; say which in "
                                                                   "\"lies\"")});
            return {};
        }
        const auto lying = core::teeth::findLying(keys.text("lies", 20), tiltDeg, fdi);
        if (!lying)
            keys.fault("lies", core::wordsOf(lying.error()));
        return lying.value_or(core::terrain::Lying{});
    }

    static Block takeBlock(JsonKeys& keys)
    {
        Block block{keys.neededText("block", 40), {}, {}};
        if (keys.has("seed"))
            block.seed = seedOf(keys);
        block.sizes = sizesOf(keys, core::teeth::blockFields());
        if (const auto design = designOf(block); !design)
            keys.fault("block", core::wordsOf(design.error()));
        return block;
    }

    /// Reads the sizes that a lesson sets, each within its range.
    template <class Design>
    static std::map<std::string, double> sizesOf(JsonKeys& owner, std::span<const core::NumberField<Design>> fields)
    {
        std::map<std::string, double> sizes;
        auto keys = owner.object("sizes");
        if (!keys)
            return sizes;
        for (const core::NumberField<Design>& field : fields) {
            const auto value = keys->number(field.id, field.minimum, field.maximum, field.unit);
            if (value && field.whole && *value != std::floor(*value))
                keys->fault(field.id,
                            {QT_TRANSLATE_NOOP("Fault", "is %1, it must be a whole number"), {noted(*value)}});
            else if (value)
                sizes.emplace(field.id, *value);
        }
        keys->nameTheRest();
        return sizes;
    }

    static std::uint64_t seedOf(JsonKeys& keys)
    {
        return static_cast<std::uint64_t>(keys.whole("seed", 0, kLargestSeed, 0));
    }

    static int fdiOf(JsonKeys& keys)
    {
        const int fdi = static_cast<int>(keys.whole("fdi", 11, 48, 0));
        if (fdi != 0 && !core::teeth::findToothSizes(fdi))
            keys.fault("fdi", {QT_TRANSLATE_NOOP("Fault",
                                                 "there is no tooth %1 here; those of the left are made: 21 to 28 and "
                                                 "31 to 38"),
                               {noted(fdi)}});
        return fdi;
    }

    Scan takeScan(JsonKeys& keys)
    {
        Scan scan;
        const QString name = QString::fromStdString(keys.neededText("scan"));
        scan.unit = keys.text("unit", 20);
        scan.up = keys.text("up", kLongestDirection);
        scan.fdi = static_cast<int>(keys.whole("fdi", 11, 48, 0));
        scan.lying = lyingOf(keys, 0);
        if (!scan.unit.empty() && !core::mesh::parseUnit(scan.unit))
            keys.fault("unit", {QT_TRANSLATE_NOOP(
                                    "Fault", "\"%1\" is no unit; write mm, cm, m, in or the millimetres of one unit"),
                                {core::noted(scan.unit)}});
        if (!scan.up.empty() && !core::mesh::parseUp(scan.up))
            keys.fault(
                "up",
                {QT_TRANSLATE_NOOP(
                     "Fault", "\"%1\" is no direction; write +x, -x, +y, -y, +z, -z, or three numbers such as 1,0,1"),
                 {core::noted(scan.up)}});
        takeFile(keys, "scan", QStringLiteral("tooth"), name, scan.file, scan.hash);
        return scan;
    }

    /// Reads the path of a file that the lesson names, and its hash, which becomes part of the lesson's hash.
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
                {QT_TRANSLATE_NOOP("Fault", "an ideal is captured, or has a kind and sizes; leave one out (where the "
                                            "lesson is based on another, with \"kind\": null, \"sizes\": null)")});
        else if (isCaptured)
            asked.captured = takeCaptured(keys);
        else if (!keys.has("kind"))
            keys.fault("kind",
                       {QT_TRANSLATE_NOOP("Fault", "is missing; name the preparation, or a file \"captured\"")});
        else
            asked.kind = keys.neededText("kind", 40);
        for (const char* const ours : {"sizes", "content", "data"})
            static_cast<void>(keys.has(ours));
        if (const auto kind = core::preparation::findKind(asked.kind); kind) {
            const auto fields = core::preparation::fieldsOf(*kind);
            asked.sizes = sizesOf(keys, std::span(fields));
        } else if (!asked.kind.empty()) {
            keys.fault("kind", core::wordsOf(kind.error()));
        }
        keys.nameTheRest();
        return asked;
    }

    /// Reads a captured ideal. Copies its file into the text of the lesson, so that a recording can be graded again on
    /// any computer.
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
                           {QT_TRANSLATE_NOOP("Fault", "\"%1\" has %2; a lesson takes at most %3. Capture it on a "
                                                       "coarser grid"),
                            {noted(name), sizeWords(file.size()), sizeWords(kLargestIdealBytes)}});
                return captured;
            }
            const QByteArray bytes = file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
            captured.bytes = bytes.toStdString();
            putInto(QStringLiteral("ideal"), QStringLiteral("data"), QString::fromLatin1(bytes.toBase64()));
        }
        if (const auto ideal = core::preparation::capturedFrom(captured.bytes); !ideal)
            keys.fault("captured", {"\"%1\": %2", {noted(name), core::wordsOf(ideal.error())}});
        return captured;
    }

    static core::terrain::Lying lyingOf(const Lesson& lesson)
    {
        if (const auto* made = std::get_if<MadeTooth>(&lesson.tooth))
            return made->lying;
        const auto* scan = std::get_if<Scan>(&lesson.tooth);
        return scan != nullptr ? scan->lying : core::terrain::Lying{};
    }

    static Lesion takeLesion(JsonKeys& keys, const core::terrain::Lying& lying)
    {
        Lesion lesion{keys.number("extent", 0.0, 1.0, "", 0.5), {}};
        static const QStringList kSites(std::begin(core::teeth::kLesionSites), std::end(core::teeth::kLesionSites));
        if (const int site = keys.choice("site", kSites); site >= 0) {
            lesion.site = static_cast<core::teeth::LesionSite>(site);
            if (const auto fits = core::teeth::checkSite(*lesion.site, lying); !fits)
                keys.fault("site", core::wordsOf(fits.error()));
        }
        return lesion;
    }

    void takeWork(Lesson& lesson)
    {
        if (auto lesion = m_keys.object("lesion")) {
            lesson.lesion = takeLesion(*lesion, lyingOf(lesson));
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

    /// Reads the file of a preset beside the lesson. Copies its values for this tooth into the text of the lesson, so
    /// that a recording contains them.
    void takePreset(Lesson& lesson, const QString& name)
    {
        const QString path = m_files->find(m_file, QStringLiteral("hardness"), name);
        if (path.isEmpty())
            return;
        m_files->note(path);
        const ReadPreset read = readPreset(path);
        for (ValidationIssue fault : read.faults) {
            fault.file = QFileInfo(path).absoluteFilePath();
            m_faults.push_back(fault);
        }
        if (!read.preset)
            return;
        lesson.hardness = core::settings::hardnessFor(*read.preset, lesson.kind);
        QJsonObject whole{{"name", QString::fromStdString(lesson.hardness->name)},
                          {"axial_share", lesson.hardness->axialShare},
                          {"flat_end_share", lesson.hardness->flatEndShare},
                          {"full_load_n", lesson.hardness->fullLoadN}};
        for (std::size_t m = 0; m < kMaterials.size(); ++m)
            whole.insert(QLatin1String(kMaterials[m]),
                         QJsonObject{{"rate_mm3_per_ns", lesson.hardness->material[m].rateMm3PerNs},
                                     {"threshold_n", lesson.hardness->material[m].thresholdN}});
        m_whole.insert(QStringLiteral("hardness"), whole);
        m_whole.remove(QStringLiteral("caries"));  // this key selects the rows of the preset, which are copied now
        m_whole.remove(QStringLiteral("plastic"));
    }

    void sayThatHardnessHasItsOwnKind()
    {
        m_keys.fault("hardness",
                     {QT_TRANSLATE_NOOP("Fault", "has its own caries and plastic; leave it out, or leave out "
                                                 "\"caries\" and \"plastic\"")});
    }

    /// Reads the hardness: the rows of the school's preset that the lesson selects, "natural", or a named one with
    /// other values for some materials.
    void takeHardness(Lesson& lesson)
    {
        lesson.kind.isPlastic = m_keys.flag("plastic", false);
        lesson.kind.decay = static_cast<core::settings::DecayKind>(std::max(
            0, m_keys.choice("caries", {QStringLiteral("soft"), QStringLiteral("firm"), QStringLiteral("graded")})));
        const QString file = m_whole.value(QStringLiteral("hardness")).toString();
        if (m_files != nullptr && file.endsWith(QStringLiteral(".") + QLatin1String(kPresetSuffix))) {
            static_cast<void>(m_keys.has("hardness"));
            if (lesson.kind.decay == core::settings::DecayKind::Graded)
                sayThatHardnessHasItsOwnKind();
            takePreset(lesson, file);
            return;
        }
        if (m_keys.has("hardness") && !(lesson.kind == core::settings::ToothKind{}))
            sayThatHardnessHasItsOwnKind();
        if (m_whole.value(QStringLiteral("hardness")).isString()) {
            const std::string name = m_keys.text("hardness");
            if (const auto known = core::settings::findHardnessPreset(name))
                lesson.hardness = *known;
            else
                m_keys.fault("hardness", core::wordsOf(known.error()));
            return;
        }
        auto keys = m_keys.object("hardness");
        if (!keys)
            return;
        const std::string base = keys->has("like") ? keys->text("like") : core::settings::HardnessPreset{}.name;
        if (const auto known = core::settings::findHardnessPreset(base))
            lesson.hardness = *known;
        else
            keys->fault("like", core::wordsOf(known.error()));
        if (!lesson.hardness)
            return;
        lesson.hardness->name = keys->neededText("name", kLongestHardnessName);
        for (std::size_t m = 0; m < kMaterials.size(); ++m) {
            auto material = keys->object(kMaterials[m]);
            if (!material)
                continue;
            core::settings::MaterialHardness& hardness = lesson.hardness->material[m];
            hardness.rateMm3PerNs =
                material->number("rate_mm3_per_ns", core::settings::kMinRateMm3PerNs, core::settings::kMaxRateMm3PerNs,
                                 "mm³/(N s)", hardness.rateMm3PerNs);
            hardness.thresholdN =
                material->number("threshold_n", 0.0, core::settings::kMaxThresholdN, "N", hardness.thresholdN);
            material->nameTheRest();
        }
        using core::settings::kMinShare;
        if (keys->has("axial_share"))  // in lessons written before the other two, it applies to every bur and load
            lesson.hardness = core::settings::withoutEndsAndFullLoad(std::move(*lesson.hardness));
        lesson.hardness->axialShare = keys->number("axial_share", kMinShare, 1.0, "", lesson.hardness->axialShare);
        lesson.hardness->flatEndShare =
            keys->number("flat_end_share", kMinShare, 1.0, "", lesson.hardness->flatEndShare);
        lesson.hardness->fullLoadN = keys->number("full_load_n", core::settings::kMinFullLoadN,
                                                  core::settings::kNoFullLoadN, "N", lesson.hardness->fullLoadN);
        keys->nameTheRest();
    }

    void takeTools(Lesson& lesson)
    {
        takeHardness(lesson);
        lesson.breakOff = m_keys.flag("breaks_off", lesson.breakOff);
        for (const QString& name : m_keys.names("handpieces")) {
            const auto known = core::settings::findHandpiece(name.toStdString());
            if (!known)
                m_keys.fault("handpieces", core::wordsOf(known.error()));
            else if (std::find(lesson.handpieces.begin(), lesson.handpieces.end(), *known) == lesson.handpieces.end())
                lesson.handpieces.push_back(*known);
        }
        for (const QString& bur : m_keys.names("burs")) {
            if (const auto known = core::bur::findBur(bur.toStdString()); !known)
                m_keys.fault("burs", core::wordsOf(known.error()));
            lesson.burs.push_back(bur.toStdString());
        }
        const bool isUnseen = lesson.task == Task::TellLayers;
        if (isUnseen || m_keys.has("aids"))
            lesson.aids = Aids::none();
        for (const QString& name : m_keys.names("aids")) {
            if (bool* const aid = aidNamed(lesson.aids, name))
                *aid = true;
            else
                m_keys.fault(
                    "aids", {QT_TRANSLATE_NOOP("Fault", "\"%1\" is no aid; there are section, depth_gauge, radiograph, "
                                                        "heat_map, mirror, ideal, bur_colour, fixture, depth_stop"),
                             {noted(name.left(40))}});
        }
    }

    static bool* aidNamed(Aids& aids, const QString& name)
    {
        const std::pair<const char*, bool*> known[] = {
            {"section", &aids.section},      {"depth_gauge", &aids.depthGauge}, {"radiograph", &aids.radiograph},
            {"heat_map", &aids.heatMap},     {"mirror", &aids.mirror},          {"ideal", &aids.ideal},
            {"bur_colour", &aids.burColour}, {"fixture", &aids.fixture},        {"depth_stop", &aids.depthStop}};
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
            rules->fault("neighbour_hit",
                         {QT_TRANSLATE_NOOP("Fault", "only a tooth of ours has neighbours; write false")});
        const bool isUpright = lyingOf(lesson).isUpright();
        if (set.neighbourHit && !isUpright)
            rules->fault("neighbour_hit", {QT_TRANSLATE_NOOP("Fault", "a tooth that lies on a side has no neighbours; "
                                                                      "write false")});
        set.depthLimitMm = rules->number("depth_limit_mm", 0.1, 10.0, "mm");
        set.ridgeLimitMm = rules->number("ridge_limit_mm", 0.1, 5.0, "mm");
        if (set.ridgeLimitMm && !isUpright)
            rules->fault("ridge_limit_mm", {QT_TRANSLATE_NOOP("Fault", "is about a tooth that stands upright")});
        set.besideMm = rules->number("beside_mm", 0.0, 10.0, "mm");
        set.forceLimitN = rules->number("force_limit_n", 0.1, 10.0, "N");
        set.airLimitS = rules->number("air_limit_s", 1.0, 600.0, "s");
        rules->nameTheRest();
    }

    /// Checks conditions on several keys.
    void checkWhole(const Lesson& lesson)
    {
        const bool isBlock = std::holds_alternative<Block>(lesson.tooth);
        if (lesson.task == Task::RemoveDecay && (isBlock || !lesson.lesion || lesson.lesion->extent <= 0.0))
            m_keys.fault("lesion", {QT_TRANSLATE_NOOP("Fault", "to remove decay there must be some: write \"lesion\": "
                                                               "{\"extent\": 0.5} for a tooth")});
        if (lesson.task == Task::CutIdeal && !lesson.ideal)
            m_keys.fault("ideal", {QT_TRANSLATE_NOOP("Fault", "is missing; it says which preparation is to be cut")});
        else if (lesson.task == Task::CutIdeal)
            checkKind(lesson);
        if (lesson.task == Task::TraceShape && !isBlock)
            m_keys.fault("tooth",
                         {QT_TRANSLATE_NOOP("Fault", "a shape is traced in a block: write {\"block\": \"line\"}")});
        if (lesson.task == Task::TouchPoints && !lesson.touch)
            m_keys.fault("touch",
                         {QT_TRANSLATE_NOOP("Fault", "is missing; it says which points are to be touched: {\"points\": "
                                                     "[[x, y], ...]}")});
        if (lesson.task == Task::HoldForce && !lesson.hold)
            m_keys.fault("hold", {QT_TRANSLATE_NOOP(
                                     "Fault", "is missing; it says which force is to be held: {\"force_n\": 1}")});
        if (lesson.task == Task::TellLayers && (!isBlock || std::get<Block>(lesson.tooth).shape != "layers"))
            m_keys.fault("tooth",
                         {QT_TRANSLATE_NOOP("Fault", "layers are told apart in a block of them: write {\"block\": "
                                                     "\"layers\"}")});
        if (lesson.task == Task::TellLayers && lesson.aids != Aids::none())
            m_keys.fault("aids", {QT_TRANSLATE_NOOP("Fault", "layers are told apart without any; leave the key out")});
    }

    /// Checks that the ideal was captured on this tooth. For a scan, that is checked later, when the scan is read.
    void checkCaptured(const Lesson& lesson, const Captured& captured)
    {
        const auto* const made = std::get_if<MadeTooth>(&lesson.tooth);
        const auto ideal = core::preparation::capturedFrom(captured.bytes);
        if (made == nullptr || !ideal || made->fdi == 0)
            return;
        if (ideal->fdi != made->fdi || ideal->seed != made->seed || ideal->grid.side != lesson.gridSide)
            m_keys.fault("ideal.captured",
                         {QT_TRANSLATE_NOOP(
                              "Fault", "\"%1\" was captured on the tooth '%2' (seed %3, grid %4); name that tooth, "
                                       "seed and grid, or capture it on this one"),
                          {noted(QFileInfo(QString::fromStdString(captured.file)).fileName()),
                           core::noted(ideal->tooth), noted(ideal->seed), noted(ideal->grid.side)}});
    }

    /// Checks that an ideal of this kind can be made on this tooth.
    void checkKind(const Lesson& lesson)
    {
        if (lesson.ideal->captured)
            checkCaptured(lesson, *lesson.ideal->captured);
        const auto kind = core::preparation::findKind(lesson.ideal->kind);
        if (!kind)
            return;
        const auto* const made = std::get_if<MadeTooth>(&lesson.tooth);
        if (made == nullptr)
            m_keys.fault("ideal", {QT_TRANSLATE_NOOP(
                                      "Fault", "is made by rule for a tooth of ours only, \"tooth\": {\"fdi\": 36}; "
                                               "for a scan name a captured one: {\"captured\": "
                                               "\"mine.cuspideal\"}")});
        else if (const bool isLingualAccess = *kind == core::preparation::Kind::Access &&
                                              core::preparation::opensFromLingual(made->lying, made->fdi);
                 !made->lying.isUpright() && !isLingualAccess)
            m_keys.fault("ideal", {QT_TRANSLATE_NOOP("Fault", "this preparation is made for a tooth that stands "
                                                              "upright; leave out \"lies\", or take an ideal from "
                                                              "attempts at this tooth")});
        else if (const auto usual = core::preparation::usualDesign(*kind, made->fdi); !usual && made->fdi != 0)
            m_keys.fault("ideal.kind", core::wordsOf(usual.error()));
    }

    QJsonObject m_whole;
    QString m_file;
    JsonFiles* m_files;
    std::vector<ValidationIssue>& m_faults;
    JsonKeys m_keys;
};

}  // namespace

Lesson lessonFrom(const QJsonObject& whole, const QString& file, const QString& rubricFile, JsonFiles* files,
                  std::vector<ValidationIssue>& faults)
{
    return LessonMaker(whole, file, files, faults).make(rubricFile);
}

}  // namespace lessons
