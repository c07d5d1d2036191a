// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QDateTime>
#include <QList>
#include <QSizeF>
#include <QString>

#include "database/overview.h"
#include "database/people.h"
#include "database/records.h"
#include "lessons/Moments.h"
#include "lessons/ScoreSheet.h"
#include "ui/people/PeopleWords.h"
#include "ui/study/ScoredWork.h"

class QPagedPaintDevice;
class QPainter;

/// What is printed: a score card and a class, on A4 or Letter, in black on white.
namespace ui::report {

/// What stands at the foot of each page, so that paper and database can be compared.
struct Proof
{
    QString
        auditCode;    ///< head of the audit chain, with its signature, as the database gives it; empty: not kept in one
    QString program;  ///< version
    QDateTime printed;
    int pages = 0;  ///< 0: nobody has counted them yet
};

struct ScoreCard
{
    QString lesson;  ///< or the tooth
    QString person;
    database::AttemptRecord attempt;
    lessons::ScoreSheet sheet;
    database::AttemptTalk talk;
    std::optional<study::ScoredWork> work;              ///< nothing: no pictures
    std::vector<std::vector<lessons::Moment>> moments;  ///< of the criteria, in their order; empty: not known
    QList<database::AttemptRecord> history;             ///< at this lesson, newest first
    std::vector<database::BandPoint> band;              ///< of the class
    Proof proof;
};

struct ClassReport
{
    QString className;
    QString teacher;
    database::ClassOverview overview;
    QList<database::ClassAssignment> given;  ///< what the class is to do
    people::LessonTitles titles;
    database::LessonResults results;  ///< of the lesson whose charts are shown; none where its id is empty
    int passMarkTenths = 0;           ///< of its rubric
    lessons::LocalText rubricTitle;
    int rubricVersion = 0;
    std::string rubricHash;
    std::map<std::string, QString> criteria;  ///< names by id
    Proof proof;
};

/// Leaves the page that is full and makes the same painter paint on a clean one, in points again. Empty: the pages are
/// only counted, and what takes long to draw is left out.
using NextPage = std::function<void()>;

/// Paints a report. One unit of the painter is a point, 1/72 inch; its origin is the corner of what may be printed on.
/// @param pagePt  what may be printed on
/// @return pages
int paint(QPainter& painter, const QSizeF& pagePt, const NextPage& next, const ScoreCard& card);
int paint(QPainter& painter, const QSizeF& pagePt, const NextPage& next, const ClassReport& report);

/// The same on a printer or into a PDF, on the paper that it is set to. False: it could not be begun.
[[nodiscard]] bool paintOn(QPagedPaintDevice& device, const ScoreCard& card);
[[nodiscard]] bool paintOn(QPagedPaintDevice& device, const ClassReport& report);

}  // namespace ui::report
