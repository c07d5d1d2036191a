// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessoneditor/LessonDraft.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <QDir>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLocale>
#include <QRegularExpression>

#include "core/preparation/BlockPreparation.h"
#include "core/preparation/ToothPreparation.h"
#include "lessons/IdealFromRecordings.h"
#include "lessons/NewLesson.h"
#include "ui/text/LessonTexts.h"

namespace ui::lessoneditor {
namespace {

using ::lessons::Assignment;
using ::lessons::Lesson;

constexpr qsizetype kMostStates = 200;

template <class Design>
std::vector<IdealField> fieldsFrom(std::span<const core::NumberField<Design>> fields, const Design& design)
{
    std::vector<IdealField> made;
    for (const core::NumberField<Design>& field : fields)
        made.push_back({QString::fromLatin1(field.id), text::fieldName(field.name), text::fieldUnit(field.unit),
                        design.*field.value, field.minimum, field.maximum, field.whole});
    return made;
}

/// Returns the kind of an ideal that is computed by rule, or nothing for another ideal.
std::optional<core::preparation::Kind> ruleOf(const Lesson& lesson)
{
    if (lesson.task != ::lessons::Task::CutIdeal || !lesson.ideal || lesson.ideal->captured)
        return std::nullopt;
    const auto kind = core::preparation::findKind(lesson.ideal->kind);
    return kind ? std::optional(*kind) : std::nullopt;
}

/// Returns the usual design with the sizes that the lesson sets.
core::preparation::ToothDesign designOf(const Lesson& lesson, core::preparation::Kind kind,
                                        core::preparation::ToothDesign usual)
{
    const auto fields = core::preparation::fieldsOf(kind);
    for (const auto& [id, value] : lesson.ideal->sizes)
        static_cast<void>(core::setNumber(std::span(fields), usual, id, value));
    return usual;
}

std::vector<IdealField> fieldsOf(const Lesson& lesson, const std::optional<core::preparation::ToothDesign>& usual)
{
    if (lesson.task == ::lessons::Task::TraceShape) {
        const auto design = ::lessons::designOf(std::get<::lessons::Block>(lesson.tooth));
        return design ? fieldsFrom<core::teeth::BlockDesign>(core::teeth::blockFields(), *design)
                      : std::vector<IdealField>();
    }
    const auto kind = ruleOf(lesson);
    if (!kind || !usual)
        return {};
    const auto fields = core::preparation::fieldsOf(*kind);
    return fieldsFrom<core::preparation::ToothDesign>(fields, designOf(lesson, *kind, *usual));
}

/// Parts of the previous draft's evaluation that are still valid.
struct Kept
{
    std::shared_ptr<const core::terrain::ToothAnatomy> anatomy;
    std::optional<core::preparation::ToothDesign> usual;
    bool isSameIdeal = false;
};

Kept keptOf(const EvaluatedDraft* before, const Lesson& lesson)
{
    if (before == nullptr || !before->assignment || !before->assignment->lesson)
        return {};
    const Lesson& old = *before->assignment->lesson;
    if (old.tooth != lesson.tooth || old.gridSide != lesson.gridSide || old.lesion != lesson.lesion)
        return {};
    return {before->assignment->anatomy, ruleOf(old) == ruleOf(lesson) ? before->usual : std::nullopt,
            old.ideal == lesson.ideal && old.task == lesson.task};
}

/// Reads a draft that has no valid rubric. Uses the rubric of the previous draft instead, otherwise that of the base
/// lesson.
std::optional<Lesson> withAnotherRubric(QJsonObject draft, const QString& file, const EvaluatedDraft* before)
{
    const QString key = QStringLiteral("rubric");
    if (before != nullptr && before->assignment) {
        draft.insert(key, ::lessons::ownRubric(*before->assignment->lesson));
        if (const auto read = ::lessons::readDraft(draft, file); read.lesson)
            return *read.lesson;
    }
    draft.remove(key);
    const auto read = ::lessons::readDraft(draft, file);
    return read.lesson ? std::optional(*read.lesson) : std::nullopt;
}

/// Returns the usual sizes of the lesson's preparation on its tooth.
std::optional<core::preparation::ToothDesign> usualOf(const Lesson& lesson)
{
    const auto kind = ruleOf(lesson);
    if (!kind)
        return std::nullopt;
    const auto assigned = ::lessons::assign(lesson);
    if (!assigned)
        return std::nullopt;
    const auto usual = core::preparation::fittedDesign(*kind, *assigned->assignment.anatomy);
    return usual ? std::optional(*usual) : std::nullopt;
}

/// Assigns the lesson as lessons::assign() does, but reuses valid parts of the previous draft.
core::Result<Assignment> assignmentFor(const Lesson& lesson, const Kept& kept, const EvaluatedDraft* before)
{
    if (!kept.anatomy) {
        auto assigned = ::lessons::assign(lesson);
        if (!assigned)
            return tl::unexpected(assigned.error());
        return std::move(assigned->assignment);
    }
    const auto kind = ruleOf(lesson);
    if (!kept.isSameIdeal && !(kind && kept.usual))
        return ::lessons::assignmentOf(kept.anatomy, lesson.json);
    Assignment assignment = *before->assignment;
    assignment.lesson = lesson;
    assignment.rubric = lesson.rubric;
    assignment.leeway.reset();
    if (lesson.leeway)
        assignment.leeway = core::grading::Leeway{lesson.leeway->sidesMm, lesson.leeway->bottomMm};
    if (kept.isSameIdeal)
        return assignment;
    auto ideal = core::preparation::makePreparation(*kind, designOf(lesson, *kind, *kept.usual), *kept.anatomy);
    if (!ideal)
        return tl::unexpected(ideal.error());
    assignment.ideal = std::move(*ideal);
    return assignment;
}

/// Returns an issue for an error that prevents the lesson. It refers to the field that the error's text names, if any.
::lessons::ValidationIssue faultOf(const core::Error& error, const QString& file, const Lesson& lesson)
{
    const QString what = QString::fromStdString(error.detail);
    QString key = QStringLiteral("ideal");
    for (const auto& [id, value] : lesson.ideal ? lesson.ideal->sizes : std::map<std::string, double>())
        if (what.contains(u'(' + QString::fromStdString(id) + u')'))
            key = QStringLiteral("ideal.sizes.") + QString::fromStdString(id);
    return {file, key, core::wordsOf(error), true};
}

/// Returns a criterion's name with one limit in mm replaced by another.
QString withLimit(const QString& name, const QString& language, double before, double now)
{
    const QLocale locale(language);
    const auto shown = [&locale](double number) {
        return locale.toString(number, 'f', QLocale::FloatingPointShortest);
    };
    const QRegularExpression limit(
        QStringLiteral(R"((?<![\d.,])%1(?=\s?mm))").arg(QRegularExpression::escape(shown(before))));
    return QString(name).replace(limit, shown(now));
}

/// Returns the value beyond which a criterion counts as an error.
double limitOf(const QJsonObject& criterion)
{
    const double target = criterion.value(QStringLiteral("target")).toDouble();
    const double tolerance = criterion.value(QStringLiteral("tolerance")).toDouble();
    return criterion.value(QStringLiteral("side")).toString() == QLatin1String("under") ? target - tolerance
                                                                                        : target + tolerance;
}

/// Replaces the limit in a name that is given in one language or several.
QJsonValue withLimit(const QJsonValue& names, double before, double now)
{
    if (names.isString())
        return withLimit(names.toString(), QStringLiteral("en"), before, now);
    QJsonObject all = names.toObject();
    for (const QString& language : all.keys())
        all.insert(language, withLimit(all.value(language).toString(), language, before, now));
    return all;
}

}  // namespace

std::shared_ptr<const EvaluatedDraft> weigh(const QJsonObject& draft, const QString& file,
                                            const std::shared_ptr<const EvaluatedDraft>& before)
{
    QElapsedTimer timer;
    timer.start();
    auto weighed = std::make_shared<EvaluatedDraft>();
    weighed->read = ::lessons::readDraft(draft, file);
    const auto& lesson = weighed->read.lesson;
    if (lesson) {
        const Kept kept = keptOf(before.get(), *lesson);
        weighed->usual = kept.usual;
        auto assignment = assignmentFor(*lesson, kept, before.get());
        if (!assignment) {
            weighed->read.faults.push_back(faultOf(assignment.error(), file, *lesson));
            // Fields stay visible, so that the user can correct their values.
            weighed->fields = fieldsOf(*lesson, weighed->usual);
        } else {
            const core::terrain::ToothAnatomy& anatomy = *assignment->anatomy;
            if (const auto kind = ruleOf(*lesson); kind && !weighed->usual)
                if (const auto usual = core::preparation::fittedDesign(*kind, anatomy))
                    weighed->usual = *usual;
            weighed->fields = fieldsOf(*lesson, weighed->usual);
            const core::grading::IdealTop ideal = assignment->shownIdeal();
            const bool isSame = before && before->assignment && before->assignment->ideal && assignment->ideal &&
                                before->assignment->ideal->top == assignment->ideal->top;
            weighed->above = isSame ? before->above : inside::fromAbove(anatomy, ideal ? *ideal : anatomy.top);
            if (assignment->ideal) {
                core::preparation::Tolerances tolerances{0.0, 0.0, 0.0, 0.0};
                if (assignment->leeway)
                    tolerances = {assignment->leeway->sidesMm, assignment->leeway->bottomMm, 0.0, 0.0};
                tolerances = ::lessons::tolerancesOf(lesson->rubric, tolerances);
                weighed->outlineMm = tolerances.outlineMm;
                weighed->depthMm = tolerances.depthMm;
                for (const ::lessons::CriterionRule& rule : lesson->rubric.criteria)
                    weighed->spanMm = !rule.critical && rule.measure == "outline_p95_mm" ? rule.span : weighed->spanMm;
                weighed->band = core::preparation::toleranceBand(anatomy, *assignment->ideal, tolerances.outlineMm,
                                                                 tolerances.depthMm);
            }
            if (ideal)
                if (const auto marked =
                        ::lessons::mark(*assignment, core::terrain::restored(assignment->anatomy, *ideal)))
                    weighed->itself = marked->sheet;
            weighed->assignment = std::move(*assignment);
        }
    } else if (const auto sound = withAnotherRubric(draft, file, before.get())) {
        // An invalid rubric must not hide the fields of the ideal.
        const auto usual = keptOf(before.get(), *sound).usual;
        weighed->fields = fieldsOf(*sound, usual ? usual : usualOf(*sound));
    }
    weighed->milliseconds = static_cast<double>(timer.nsecsElapsed()) * 1.0e-6;
    return weighed;
}

void LessonDraft::begin(const ::lessons::ReadLesson& lesson, const QString& teachersFolder)
{
    const bool isShipped = lesson.file.startsWith(u':');
    QJsonObject object = ::lessons::ownVersion(lesson);
    m_exists = !isShipped;
    m_isStamped = false;
    m_file = lesson.file;
    if (isShipped) {
        // Finds an id whose file does not exist yet.
        const QString id = object.value(QStringLiteral("id")).toString();
        QString own = id;
        const auto path = [&] { return QDir(teachersFolder).filePath(own + QStringLiteral(".lesson.json")); };
        for (int k = 2; QFileInfo::exists(path()); ++k)
            own = id + QString::number(k);
        object.insert(QStringLiteral("id"), own);
        m_file = path();
    }
    m_states = {object};
    m_at = 0;
    m_lastChange.clear();
    m_saved = object;
    takeWhole(*lesson.lesson);
    m_firstTitles = titles();
    m_areTitlesMadeUp = !m_exists || !object.value(QStringLiteral("title")).isObject();
    m_typedTitles.clear();
}

void LessonDraft::takeWhole(const ::lessons::Lesson& lesson)
{
    m_wholeRubric = ::lessons::ownRubric(lesson);
    m_wholeTitle = {};
    for (const auto& [language, text] : lesson.title)
        m_wholeTitle.insert(QString::fromStdString(language), QString::fromStdString(text));
    m_isBlock = lesson.task == ::lessons::Task::TraceShape;
}

void LessonDraft::goOnWith(const QJsonObject& object, const QJsonObject& saved)
{
    if (m_exists && !saved.isEmpty())
        m_saved = saved;
    change(QStringLiteral("gone on with"), object);
}

void LessonDraft::revert()
{
    m_states = {m_saved};
    m_at = 0;
    m_lastChange.clear();
}

void LessonDraft::openAnew(const ::lessons::ReadLesson& lesson)
{
    m_saved = ::lessons::ownVersion(lesson);
    m_isStamped = false;
    takeWhole(*lesson.lesson);
    m_lastChange.clear();
    change(QStringLiteral("opened anew"), m_saved);
    m_lastChange.clear();
}

bool LessonDraft::isOvertaken() const
{
    ::lessons::ReadLesson now;
    now.file = m_file;
    // Compares the written form: 5 from a file and 5.0 from an input are the same number.
    return m_exists && QFileInfo::exists(m_file) &&
           QJsonDocument(::lessons::ownVersion(now)).toJson() != QJsonDocument(m_saved).toJson();
}

void LessonDraft::change(const QString& what, const QJsonObject& object)
{
    if (object == m_states[m_at])
        return;
    m_states.resize(m_at + 1);
    if (what == m_lastChange && m_at > 0)
        m_states[m_at] = object;
    else
        m_states.push_back(object);
    if (m_states.size() > kMostStates)
        m_states.pop_front();
    m_at = m_states.size() - 1;
    m_lastChange = what;
}

void LessonDraft::undo()
{
    m_at = std::max<qsizetype>(0, m_at - 1);
    m_lastChange.clear();
}

void LessonDraft::redo()
{
    m_at = std::min(m_states.size() - 1, m_at + 1);
    m_lastChange.clear();
}

QJsonObject LessonDraft::titles() const
{
    const QJsonValue own = object().value(QStringLiteral("title"));
    if (own.isString())
        return {{QStringLiteral("en"), own}};
    QJsonObject texts = m_wholeTitle;
    const QJsonObject perLanguage = own.toObject();
    for (auto text = perLanguage.begin(); text != perLanguage.end(); ++text)
        texts.insert(text.key(), text.value());
    return texts;
}

QString LessonDraft::title() const
{
    ::lessons::LocalText texts;
    const QJsonObject title = titles();
    for (auto text = title.begin(); text != title.end(); ++text)
        texts[text.key().toStdString()] = text->toString().toStdString();
    return text::said(texts);
}

QByteArray LessonDraft::stamped()
{
    QJsonObject& now = m_states[m_at];
    const auto versionOf = [](const QJsonObject& one) { return one.value(QStringLiteral("version")).toInt(1); };
    if (m_exists && !std::exchange(m_isStamped, true))
        now.insert(QStringLiteral("version"), std::max(versionOf(now), versionOf(m_saved)) + 1);
    m_exists = true;
    m_isStamped = true;
    m_saved = now;
    m_lastChange.clear();
    return QJsonDocument(now).toJson();
}

void LessonDraft::setTitle(const QString& title, const QString& language)
{
    QJsonObject next = object();
    if (next.value(QStringLiteral("title")).isString()) {
        next.insert(QStringLiteral("title"), title);
    } else {
        QJsonObject texts = titles();
        const QString typedIn = texts.contains(language) ? language : QStringLiteral("en");
        m_typedTitles.insert(typedIn);
        // Titles in other languages that the user has not typed are replaced by this one. They were generated for a new
        // lesson, or copied from the base lesson.
        for (const QString& other : texts.keys())
            if (!m_typedTitles.contains(other) &&
                (m_areTitlesMadeUp || m_firstTitles.value(other) == m_firstTitles.value(typedIn)))
                texts.insert(other, title);
        texts.insert(typedIn, title);
        next.insert(QStringLiteral("title"), texts);
    }
    change(QStringLiteral("title"), next);
}

void LessonDraft::setSize(const QString& id, double value)
{
    QJsonObject next = object();
    const QString owner = m_isBlock ? QStringLiteral("tooth") : QStringLiteral("ideal");
    QJsonObject part = next.value(owner).toObject();
    QJsonObject sizes = part.value(QStringLiteral("sizes")).toObject();
    sizes.insert(id, value);
    part.insert(QStringLiteral("sizes"), sizes);
    next.insert(owner, part);
    change(QStringLiteral("size ") + id, next);
}

void LessonDraft::setCaptured(const QString& name, const std::optional<core::preparation::Tolerances>& tolerances)
{
    QJsonObject next = object();
    const QString key = QStringLiteral("ideal");
    const bool isBased = next.contains(QStringLiteral("based_on"));
    if (name.isEmpty()) {
        // Restores the ideal of the base lesson, or the one that the lesson had when it was opened.
        const QJsonObject before = m_states.front().value(key).toObject();
        const bool wasCaptured = before.contains(QStringLiteral("captured"));
        if (isBased && (wasCaptured || before.isEmpty()))
            next.remove(key);
        else if (wasCaptured || before.isEmpty())
            next.insert(key, QJsonObject{{"kind", "class1"}});
        else
            next.insert(key, before);
    } else {
        QJsonObject ideal{{"captured", name}};
        if (isBased) {
            ideal.insert(QStringLiteral("kind"), QJsonValue());
            ideal.insert(QStringLiteral("sizes"), QJsonValue());
        }
        next.insert(key, ideal);
        if (tolerances)
            next.insert(QStringLiteral("rubric"), ::lessons::withTolerances(rubric(), *tolerances));
    }
    change(QStringLiteral("captured ") + name, next);
}

QJsonObject LessonDraft::rubric() const
{
    const QJsonValue own = object().value(QStringLiteral("rubric"));
    return own.isObject() ? own.toObject() : m_wholeRubric;
}

void LessonDraft::setPassMark(double points)
{
    QJsonObject next = object();
    QJsonObject changed = rubric();
    changed.insert(QStringLiteral("pass_mark"), points);
    next.insert(QStringLiteral("rubric"), changed);
    change(QStringLiteral("pass_mark"), next);
}

void LessonDraft::setCriterion(int index, const char* key, double value)
{
    QJsonObject next = object();
    QJsonObject changed = rubric();
    QJsonArray criteria = changed.value(QStringLiteral("criteria")).toArray();
    if (index < 0 || index >= criteria.size())
        return;
    QJsonObject criterion = criteria[index].toObject();
    const double before = limitOf(criterion);
    criterion.insert(QLatin1String(key), value);
    // The title of a serious error often contains its limit: "Floor more than 1 mm too deep".
    const bool isSerious =
        criterion.value(QStringLiteral("critical")).toBool() || criterion.contains(QStringLiteral("caps_at"));
    if (isSerious && criterion.contains(QStringLiteral("title")))
        criterion.insert(QStringLiteral("title"),
                         withLimit(criterion.value(QStringLiteral("title")), before, limitOf(criterion)));
    criteria[index] = criterion;
    changed.insert(QStringLiteral("criteria"), criteria);
    next.insert(QStringLiteral("rubric"), changed);
    change(QStringLiteral("criterion %1 %2").arg(index).arg(QLatin1String(key)), next);
}

}  // namespace ui::lessoneditor
