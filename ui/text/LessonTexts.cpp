// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/LessonTexts.h"

#include <cmath>
#include <functional>
#include <map>
#include <string_view>
#include <variant>

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>
#include <QtMath>

#include "core/teeth/Laid.h"
#include "core/terrain/Lying.h"
#include "lessons/IdealFromRecordings.h"
#include "ui/text/PeopleTexts.h"
#include "ui/text/Texts.h"

namespace ui::text {

using ::lessons::Lesson;
using ::lessons::Task;

namespace {

// Names that core gives to the sizes of an ideal and of a block, for translators.
[[maybe_unused]] constexpr const char* kFieldNames[] = {
    QT_TRANSLATE_NOOP("Field", "width of the isthmus"),
    QT_TRANSLATE_NOOP("Field", "depth of the pulpal floor"),
    QT_TRANSLATE_NOOP("Field", "width of the dovetail"),
    QT_TRANSLATE_NOOP("Field", "extension into the grooves"),
    QT_TRANSLATE_NOOP("Field", "marginal ridge that is left"),
    QT_TRANSLATE_NOOP("Field", "ridge across the tooth that is left on each side"),
    QT_TRANSLATE_NOOP("Field", "divergence of the end walls"),
    QT_TRANSLATE_NOOP("Field", "radius of the bur"),
    QT_TRANSLATE_NOOP("Field", "radius between floor and wall"),
    QT_TRANSLATE_NOOP("Field", "floor along the junction"),
    QT_TRANSLATE_NOOP("Field", "depth of the floor in dentin"),
    QT_TRANSLATE_NOOP("Field", "depth of the gingival floor"),
    QT_TRANSLATE_NOOP("Field", "depth of the axial wall"),
    QT_TRANSLATE_NOOP("Field", "width of the box"),
    QT_TRANSLATE_NOOP("Field", "lean of the access walls"),
    QT_TRANSLATE_NOOP("Field", "margin around the chamber"),
    QT_TRANSLATE_NOOP("Field", "occlusal reduction"),
    QT_TRANSLATE_NOOP("Field", "reduction of the functional cusps"),
    QT_TRANSLATE_NOOP("Field", "block's side"),
    QT_TRANSLATE_NOOP("Field", "block's height"),
    QT_TRANSLATE_NOOP("Field", "thickness of the enamel layer"),
    QT_TRANSLATE_NOOP("Field", "width of the channel"),
    QT_TRANSLATE_NOOP("Field", "depth of the channel"),
    QT_TRANSLATE_NOOP("Field", "length of the shape"),
    QT_TRANSLATE_NOOP("Field", "flare of the dovetail"),
    QT_TRANSLATE_NOOP("Field", "number of steps"),
    QT_TRANSLATE_NOOP("Field", "radius of inner corners")};

QString dayWords(const QDateTime& due, const QDateTime& now)
{
    return dueShort(due.toUTC().toString(Qt::ISODate).toStdString(), now);
}

}  // namespace

QString fieldName(const char* name)
{
    return text::capitalised(QCoreApplication::translate("Field", name));
}

QString fieldUnit(const char* unit)
{
    return qstrcmp(unit, "degrees") == 0 ? QStringLiteral("°") : QString::fromLatin1(unit);
}

QString said(const ::lessons::LocalText& text)
{
    return QString::fromStdString(::lessons::inLanguage(text, QLocale().name().toStdString()));
}

QString begunElsewhereWords()
{
    return QCoreApplication::translate(
        "Lesson",
        "Your last attempt at this exam was started in another window. The work in this window does not count.");
}

QString noExpertWords(const Lesson* lesson, bool isExamRunning)
{
    if (isExamRunning || (lesson != nullptr && lesson->exam))
        return QCoreApplication::translate("Lesson", "In an exam, the expert's attempt is not shown.");
    return lesson == nullptr
               ? QCoreApplication::translate("Lesson", "Only lessons have an expert's attempt. Press F2 to choose one.")
               : QCoreApplication::translate("Lesson", "This exercise has no expert's attempt.");
}

QString usedUpWords()
{
    return QCoreApplication::translate("Lesson",
                                       "You have no attempts left at this lesson. Your teacher can give you more.");
}

QString groupName(const Lesson& lesson)
{
    if (lesson.exam)
        return QCoreApplication::translate("Lesson", "Exams");
    if (!lesson.course.empty())
        return said(lesson.course);
    switch (lesson.task) {
    case Task::TraceShape:
        return QCoreApplication::translate("Lesson", "Practice block");
    case Task::CutIdeal:
        return QCoreApplication::translate("Lesson", "Ideal preparations");
    case Task::TouchPoints:
    case Task::HoldForce:
    case Task::TellLayers:
        return QCoreApplication::translate("Lesson", "The first minutes");
    case Task::RemoveDecay:
        break;
    }
    return QCoreApplication::translate("Lesson", "Removing decay");
}

std::pair<int, std::string> groupPlace(const Lesson& lesson)
{
    constexpr int kCourses = 2;
    constexpr int kExams = 5;
    if (lesson.exam)
        return {kExams, {}};
    if (!lesson.course.empty())
        return {kCourses, ::lessons::inLanguage(lesson.course, "en")};
    switch (lesson.task) {
    case Task::TouchPoints:
    case Task::HoldForce:
    case Task::TellLayers:
        return {0, {}};
    case Task::TraceShape:
        return {1, {}};
    case Task::RemoveDecay:
        return {3, {}};
    case Task::CutIdeal:
        break;
    }
    return {4, {}};
}

QString toothWords(const Lesson& lesson)
{
    if (const auto* made = std::get_if<::lessons::MadeTooth>(&lesson.tooth))
        return QStringLiteral("%1 (%2)").arg(text::capitalised(text::toothName(made->fdi))).arg(made->fdi);
    if (std::holds_alternative<::lessons::Block>(lesson.tooth))
        return QCoreApplication::translate("Lesson", "Practice block");
    return QFileInfo(QString::fromStdString(std::get<::lessons::Scan>(lesson.tooth).file)).fileName();
}

QString lyingWords(const Lesson& lesson)
{
    const auto* const made = std::get_if<::lessons::MadeTooth>(&lesson.tooth);
    const auto* const scan = std::get_if<::lessons::Scan>(&lesson.tooth);
    const core::terrain::Lying lying = made != nullptr   ? made->lying
                                       : scan != nullptr ? scan->lying
                                                         : core::terrain::Lying{};
    if (lying.isUpright())
        return {};
    const std::string_view side = core::teeth::nameOf(lying, made != nullptr ? made->fdi : 0);
    if (side == "mesial")
        return QCoreApplication::translate("Lesson", "mesial side towards the bur");
    if (side == "distal")
        return QCoreApplication::translate("Lesson", "distal side towards the bur");
    if (side == "buccal")
        return QCoreApplication::translate("Lesson", "buccal side towards the bur");
    if (side == "lingual")
        return QCoreApplication::translate("Lesson", "lingual side towards the bur");
    //: %1: a direction of a scan, such as "+x"
    return QCoreApplication::translate("Lesson", "%1 towards the bur")
        .arg(QString::fromLatin1(side.data(), static_cast<qsizetype>(side.size())));
}

QString shortTooth(const QString& words, const QFontMetrics& metrics, int widthPx)
{
    const qsizetype at = words.lastIndexOf(QStringLiteral(" ("));
    const QString number = at < 0 ? QString() : words.mid(at);
    const QString kind = at < 0 ? words : words.left(at);
    return metrics.elidedText(kind, Qt::ElideRight, widthPx - metrics.horizontalAdvance(number)) + number;
}

QString burWords(const Lesson& lesson)
{
    if (lesson.burs.empty())
        return QCoreApplication::translate("Lesson", "any");
    QStringList names;
    for (const std::string& bur : lesson.burs)
        names << text::burName(bur);
    return names.join(QStringLiteral("; "));
}

namespace {

/// Returns the names of the aids that are allowed, or of those that are not.
QStringList aidNames(const ::lessons::Aids& aids, bool areAllowed)
{
    QStringList names;
    const auto add = [&](bool allowed, const char* name) {
        if (allowed == areAllowed)
            names << QCoreApplication::translate("Lesson", name);
    };
    add(aids.section, QT_TRANSLATE_NOOP("Lesson", "section"));
    add(aids.depthGauge, QT_TRANSLATE_NOOP("Lesson", "depth gauge"));
    add(aids.radiograph, QT_TRANSLATE_NOOP("Lesson", "X-ray"));
    add(aids.heatMap, QT_TRANSLATE_NOOP("Lesson", "depth colours"));
    add(aids.mirror, QT_TRANSLATE_NOOP("Lesson", "mirror"));
    add(aids.ideal, QT_TRANSLATE_NOOP("Lesson", "ideal preparation"));
    add(aids.burColour, QT_TRANSLATE_NOOP("Lesson", "bur that changes colour"));
    add(aids.fixture, QT_TRANSLATE_NOOP("Lesson", "guided hand"));
    add(aids.depthStop, QT_TRANSLATE_NOOP("Lesson", "depth stop"));
    return names;
}

}  // namespace

QStringList lockedAids(const ::lessons::Aids& aids)
{
    return aidNames(aids, false);
}

QString aidWords(const ::lessons::Aids& aids)
{
    const QStringList names = aidNames(aids, true);
    if (aids == ::lessons::Aids{})
        return QCoreApplication::translate("Lesson", "all");
    return names.isEmpty() ? QCoreApplication::translate("Lesson", "none") : names.join(QStringLiteral(", "));
}

QString timeWords(const Lesson& lesson)
{
    return lesson.minutes > 0.0
               ? QCoreApplication::translate("Lesson", "%1 min").arg(QLocale().toString(lesson.minutes))
               : QCoreApplication::translate("Lesson", "no limit");
}

QString titleOf(const ::lessons::CriterionRule& rule)
{
    ::lessons::Criterion line;
    line.title = rule.title;
    line.measure = rule.measure;
    return text::criterionName(line);
}

QString ruleWords(const ::lessons::CriterionRule& rule)
{
    const QString unit = text::unitName(rule.unit);
    const auto figure = [&](double value) {
        return (QLocale().toString(value, 'g', 4) + (unit == u"°" ? QString() : QStringLiteral(" ")) + unit).trimmed();
    };
    const bool isUnder = rule.side == ::lessons::Side::Under;
    const double free = isUnder ? rule.target - rule.tolerance : rule.target + rule.tolerance;
    const double end = isUnder ? free - rule.span : free + rule.span;
    QString words;
    if (rule.side == ::lessons::Side::Both)
        //: %1: a target; %2: how far off it one may be at no cost
        words = QCoreApplication::translate("Lesson", "%1 ± %2 costs nothing")
                    .arg(figure(rule.target), figure(rule.tolerance));
    else
        words = (isUnder ? QCoreApplication::translate("Lesson", "%1 or more costs nothing")
                         : QCoreApplication::translate("Lesson", "Up to %1 costs nothing"))
                    .arg(figure(free));
    if (rule.allowance)
        words += QCoreApplication::translate("Lesson", " (more, where the decay is larger)");
    if (rule.once)
        //: %1: what has to be done before points are earned: "50 % of the decay is removed"
        words += QCoreApplication::translate("Lesson", " as soon as %1").arg(text::onceWords(*rule.once));
    words += QStringLiteral("; ");
    if (rule.capTenths > 0)
        //: %1: points of a score
        return words + QCoreApplication::translate("Lesson", "beyond it the score is limited to %1 points")
                           .arg(text::points(rule.capTenths));
    if (rule.critical)
        return words + QCoreApplication::translate("Lesson", "beyond it the attempt fails");
    const QString points = text::points(rule.weightTenths);
    if (rule.span <= 0.0)
        return words + QCoreApplication::translate("Lesson", "beyond it all %1 points are lost").arg(points);
    if (rule.side == ::lessons::Side::Both)
        return words + QCoreApplication::translate("Lesson", "%1 off, all %2 points are lost")
                           .arg(figure(rule.tolerance + rule.span), points);
    return words + (isUnder ? QCoreApplication::translate("Lesson", "at %1 all %2 points are lost")
                            : QCoreApplication::translate("Lesson", "from %1 on all %2 points are lost"))
                       .arg(figure(end), points);
}

QString freeWords(const ::lessons::Rubric& rubric)
{
    constexpr double kNone = -1.0;
    constexpr double kWallMm = 1.5;
    const auto figure = [](double value) { return QLocale().toString(value, 'g', 3); };
    const auto tolerances = ::lessons::tolerancesOf(rubric, {kNone, kNone, kNone, kNone});
    QStringList words;
    if (tolerances.outlineMm >= 0.0)
        words
            << QCoreApplication::translate("Lesson", "outline %1 mm to either side").arg(figure(tolerances.outlineMm));
    if (tolerances.depthMm >= 0.0)
        words << QCoreApplication::translate("Lesson", "floor %1 mm up or down").arg(figure(tolerances.depthMm));
    if (tolerances.wallDeg >= 0.0)
        words << QCoreApplication::translate("Lesson", "walls %1°, that is %2 mm over 1.5 mm of depth")
                     .arg(figure(tolerances.wallDeg),
                          figure(kWallMm * std::tan(qDegreesToRadians(tolerances.wallDeg))));
    if (tolerances.floorMm >= 0.0)
        words << QCoreApplication::translate("Lesson", "floor even to %1 mm").arg(figure(tolerances.floorMm));
    return words.join(QStringLiteral("; "));
}

QString dueDayWords(const QDateTime& due, const QDateTime& now)
{
    return QCoreApplication::translate("Lesson", "due %1").arg(dayWords(due, now));
}

QString dueWords(const QDateTime& due, const QDateTime& now)
{
    const QLocale locale;
    const QDate day = due.toLocalTime().date();
    const auto days = static_cast<int>(now.toLocalTime().date().daysTo(day));
    if (due < now)
        return days == 0 ? QCoreApplication::translate("Lesson", "due since %1")
                               .arg(locale.toString(due.toLocalTime().time(), QLocale::ShortFormat))
                         //: %1: the day it was due, "17 Nov"
                         : QCoreApplication::translate("Lesson", "%1, %n day(s) late", nullptr, -days)
                               .arg(dayWords(due, now));
    if (days == 0)
        return QCoreApplication::translate("Lesson", "due today %1")
            .arg(locale.toString(due.toLocalTime().time(), QLocale::ShortFormat));
    if (days == 1)
        return QCoreApplication::translate("Lesson", "due tomorrow");
    if (days < 7)
        //: %1: a day of the week, or a date
        return QCoreApplication::translate("Lesson", "due %1").arg(locale.dayName(day.dayOfWeek()));
    return QCoreApplication::translate("Lesson", "due %1").arg(locale.toString(day, QLocale::ShortFormat));
}

QStringList criteriaWords(const ::lessons::Rubric& rubric)
{
    QStringList lines;
    std::map<int, QStringList, std::greater<>> limits;  // by points, the least serious first
    for (const ::lessons::CriterionRule& rule : rubric.criteria) {
        if (rule.critical)
            limits[rule.capTenths] << titleOf(rule);
        else
            //: %1 is a criterion, %2 what it may cost
            lines << QCoreApplication::translate("Lesson", "%1: %2 points")
                         .arg(titleOf(rule), text::points(rule.weightTenths));
    }
    for (const auto& [tenths, names] : limits) {
        const QString named = names.join(QStringLiteral("; "));
        lines << (tenths > 0
                      //: %1: points of a score; %2: serious errors, with semicolons between
                      ? QCoreApplication::translate("Lesson", "At most %1 points: %2").arg(text::points(tenths), named)
                      //: %1: serious errors, with semicolons between
                      : QCoreApplication::translate("Lesson", "Fails the attempt: %1").arg(named));
    }
    return lines;
}

}  // namespace ui::text
