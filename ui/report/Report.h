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

#include "database/AttemptRecord.h"
#include "database/ClassOverview.h"
#include "database/Person.h"
#include "lessons/PointLossTimeline.h"
#include "lessons/ScoreSheet.h"
#include "ui/scoring/ScoreCard.h"
#include "ui/text/PeopleTexts.h"

class QPagedPaintDevice;
class QPainter;

/// What is printed: a score card and a class, on A4 or Letter, in black on white.
namespace ui::report {

struct ClassReport
{
    QString className;
    QString teacher;
    database::ClassOverview overview;
    QList<database::ClassAssignment> given;  ///< what the class is to do
    text::LessonTitles titles;
    database::LessonResults results;  ///< of the lesson whose charts are shown; none where its id is empty
    int passMarkTenths = 0;           ///< of its rubric
    lessons::LocalText rubricTitle;
    int rubricVersion = 0;
    std::string rubricHash;
    std::map<std::string, QString> criteria;  ///< names by id
    scoring::Proof proof;
};

/// Leaves the page that is full and makes the same painter paint on a clean one, in points again. Empty: the pages are
/// only counted, and what takes long to draw is left out.
using NextPage = std::function<void()>;

/// Paints a report. One unit of the painter is a point, 1/72 inch; its origin is the corner of what may be printed on.
/// @param pagePt  what may be printed on
/// @return pages
int paint(QPainter& painter, const QSizeF& pagePt, const NextPage& next, const scoring::ScoreCard& card);
int paint(QPainter& painter, const QSizeF& pagePt, const NextPage& next, const ClassReport& report);

/// The same on a printer or into a PDF, on the paper that it is set to. False: it could not be begun.
[[nodiscard]] bool paintOn(QPagedPaintDevice& device, const scoring::ScoreCard& card);
[[nodiscard]] bool paintOn(QPagedPaintDevice& device, const ClassReport& report);

}  // namespace ui::report
