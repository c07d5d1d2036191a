// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/PeopleTexts.h"

#include <QCoreApplication>
#include <QLocale>

#include "ui/text/Texts.h"

namespace ui::text {
namespace {

struct PersonWords
{
    Q_DECLARE_TR_FUNCTIONS(ui::text::PeopleTexts)
};

constexpr qint64 kWeekDays = 7;
constexpr qint64 kMonthsFromDays = 300;  ///< older dates show only month and year

}  // namespace

QString lessonTitle(const LessonTitles& titles, const std::string& lessonId)
{
    if (lessonId.empty())
        return PersonWords::tr("Free practice");
    const QString id = QString::fromStdString(lessonId);
    return titles.value(id, id);
}

QString doubtWords(database::Doubt doubt)
{
    switch (doubt) {
    case database::Doubt::Version:
        return PersonWords::tr("This attempt was made with another version of the lesson than the one that was "
                               "assigned. It is practice and does not count.");
    case database::Doubt::Recording:
        return PersonWords::tr("The recording is missing, damaged or not of this attempt. The score does not count "
                               "until a teacher gives one.");
    case database::Doubt::Score:
        return PersonWords::tr("The recording gives another result than the one that was reported. The score does not "
                               "count until a teacher gives one.");
    case database::Doubt::Start:
        return PersonWords::tr("This exam was not begun as its recording says: its start is missing here, or less time "
                               "has passed since than was worked. The score does not count until a teacher gives one.");
    case database::Doubt::None:
        break;
    }
    return {};
}

QDateTime momentOf(const std::string& utc)
{
    return QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate);
}

std::string endOfDay(QDate day)
{
    return day.endOfDay().toUTC().toString(Qt::ISODate).toStdString();
}

QDate dueDay(const std::string& dueUtc)
{
    return momentOf(dueUtc).toLocalTime().date();
}

QString when(const std::string& utc)
{
    const QDateTime at = momentOf(utc);
    return at.isValid() ? QLocale().toString(at.toLocalTime(), QLocale::ShortFormat) : QString::fromStdString(utc);
}

QString whenShort(const std::string& utc, const QDateTime& now)
{
    const QDateTime at = momentOf(utc);
    if (!at.isValid())
        return {};
    const QDate day = at.toLocalTime().date();
    const qint64 ago = day.daysTo(now.toLocalTime().date());
    if (ago == 0)
        return PersonWords::tr("today");
    if (ago == 1)
        return PersonWords::tr("yesterday");
    if (ago > 1 && ago < kWeekDays)
        return QLocale().dayName(day.dayOfWeek(), QLocale::ShortFormat);
    if (ago >= kMonthsFromDays)
        //: A month, as QLocale::toString() takes it: "Nov 2024"
        return QLocale().toString(day, PersonWords::tr("MMM yyyy"));
    //: A day without its year, as QLocale::toString() takes it: "27 Nov". German "d. MMM", Japanese "M月d日"
    return QLocale().toString(day, text::dayFormat(PersonWords::tr("d MMM")));
}

QString dueShort(const std::string& dueUtc, const QDateTime& now)
{
    const QDate day = dueDay(dueUtc);
    return day.year() == now.toLocalTime().date().year()
               ? QLocale().toString(day, text::dayFormat(PersonWords::tr("d MMM")))
               : QLocale().toString(day, QLocale::ShortFormat);
}

QString clock(std::int64_t ms)
{
    const std::int64_t hours = ms / 3'600'000;
    const QString rest = text::duration(static_cast<double>(ms % 3'600'000) / 1000.0);
    return hours > 0 ? QStringLiteral("%1:%2").arg(hours).arg(rest, 5, QLatin1Char('0')) : rest;
}

QString criterionName(const CriterionNames& names, const std::string& id)
{
    if (const auto it = names.find(id); it != names.end())
        return it->second;
    return text::capitalised(QString::fromStdString(id).replace(u'_', u' '));
}

}  // namespace ui::text
