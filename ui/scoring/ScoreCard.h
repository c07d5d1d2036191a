// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <QDateTime>
#include <QList>
#include <QString>

#include "database/AttemptRecord.h"
#include "database/ClassOverview.h"
#include "database/Person.h"
#include "lessons/PointLossTimeline.h"
#include "lessons/ScoreSheet.h"
#include "ui/scoring/ScoredWork.h"

namespace ui::scoring {

/// The footer of each printed page. It allows the print to be compared with the database.
struct Proof
{
    QString auditCode;  ///< head of the audit chain with its signature; empty: the attempt is not in a database
    QString program;    ///< version
    QDateTime printed;
    int pages = 0;  ///< 0: not counted yet
};

/// The contents of a printed score card.
struct ScoreCard
{
    QString lesson;  ///< title of the lesson, or name of the tooth
    QString person;
    database::AttemptRecord attempt;
    lessons::ScoreSheet sheet;
    database::AttemptTalk talk;
    std::optional<ScoredWork> work;                     ///< empty: no pictures
    std::vector<std::vector<lessons::Moment>> moments;  ///< of each criterion, in order; empty: unknown
    QList<database::AttemptRecord> history;             ///< attempts at this lesson, newest first
    std::vector<database::BandPoint> band;              ///< scores of the class
    Proof proof;
};

}  // namespace ui::scoring
