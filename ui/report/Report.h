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

/// Printed reports: a score card, and the overview of a class. On A4 or Letter, black on white.
namespace ui::report {

struct ClassReport
{
    QString className;
    QString teacher;
    database::ClassOverview overview;
    QList<database::ClassAssignment> given;  ///< the assignments of the class
    text::LessonTitles titles;
    database::LessonResults results;  ///< of the lesson whose charts are printed; empty id: no charts
    int passMarkTenths = 0;           ///< pass mark of that lesson's rubric; 0: unknown
    lessons::LocalText rubricTitle;
    int rubricVersion = 0;
    std::string rubricHash;
    std::map<std::string, QString> criteria;  ///< names by id
    scoring::Proof proof;
};

/// Ends a page and starts the next one with the same painter, in points. An empty function means that pages are only
/// counted; slow drawing is then skipped.
using NextPage = std::function<void()>;

/// Paints a report. One unit of the painter is a point, 1/72 inch; its origin is the corner of the printable area.
/// @param pagePt  size of the printable area
/// @return number of pages
int paint(QPainter& painter, const QSizeF& pagePt, const NextPage& next, const scoring::ScoreCard& card);
int paint(QPainter& painter, const QSizeF& pagePt, const NextPage& next, const ClassReport& report);

/// Paints a report on a printer or into a PDF, in the size of its paper. Returns false if the device could not be
/// opened.
[[nodiscard]] bool paintOn(QPagedPaintDevice& device, const scoring::ScoreCard& card);
[[nodiscard]] bool paintOn(QPagedPaintDevice& device, const ClassReport& report);

}  // namespace ui::report
