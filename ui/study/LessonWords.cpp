// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/LessonWords.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>

#include "ui/text/Texts.h"

namespace ui::study {

using ::lessons::Lesson;
using ::lessons::Task;

QString said(const ::lessons::LocalText& text)
{
    return QString::fromStdString(::lessons::inLanguage(text, QLocale().name().toStdString()));
}

QString groupName(Task task)
{
    switch (task) {
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

int groupPlace(Task task)
{
    switch (task) {
    case Task::TouchPoints:
    case Task::HoldForce:
    case Task::TellLayers:
        return 0;
    case Task::TraceShape:
        return 1;
    case Task::RemoveDecay:
        return 2;
    case Task::CutIdeal:
        break;
    }
    return 3;
}

QString toothWords(const Lesson& lesson)
{
    if (const auto* made = std::get_if<::lessons::MadeTooth>(&lesson.tooth))
        return QStringLiteral("%1 (%2)").arg(text::capitalised(text::toothName(made->fdi))).arg(made->fdi);
    if (std::holds_alternative<::lessons::Block>(lesson.tooth))
        return QCoreApplication::translate("Lesson", "Practice block");
    return QFileInfo(QString::fromStdString(std::get<::lessons::Scan>(lesson.tooth).file)).fileName();
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

QString aidWords(const ::lessons::Aids& aids)
{
    QStringList names;
    const auto add = [&](bool allowed, const char* name) {
        if (allowed)
            names << QCoreApplication::translate("Lesson", name);
    };
    add(aids.section, QT_TRANSLATE_NOOP("Lesson", "section"));
    add(aids.depthGauge, QT_TRANSLATE_NOOP("Lesson", "depth gauge"));
    add(aids.radiograph, QT_TRANSLATE_NOOP("Lesson", "X-ray"));
    add(aids.heatMap, QT_TRANSLATE_NOOP("Lesson", "colours of depth"));
    add(aids.mirror, QT_TRANSLATE_NOOP("Lesson", "mirror"));
    add(aids.ideal, QT_TRANSLATE_NOOP("Lesson", "ideal preparation"));
    add(aids.burColour, QT_TRANSLATE_NOOP("Lesson", "bur that changes colour"));
    add(aids.fixture, QT_TRANSLATE_NOOP("Lesson", "guided hand"));
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

QStringList criteriaWords(const ::lessons::Rubric& rubric)
{
    QStringList lines;
    for (const ::lessons::CriterionRule& rule : rubric.criteria) {
        ::lessons::Criterion line;
        line.title = rule.title;
        line.measure = rule.measure;
        const QString name = text::criterionName(line);
        lines << (rule.critical
                      //: %1 is a criterion
                      ? QCoreApplication::translate("Lesson", "%1: fails the attempt").arg(name)
                      //: %1 is a criterion, %2 what it may cost
                      : QCoreApplication::translate("Lesson", "%1: %2 points")
                            .arg(name, text::points(rule.weightTenths)));
    }
    return lines;
}

}  // namespace ui::study
