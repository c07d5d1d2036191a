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

/// The foot of each printed page, with which paper and database can be compared.
struct Proof
{
    QString
        auditCode;    ///< head of the audit chain, with its signature, as the database gives it; empty: not kept in one
    QString program;  ///< version
    QDateTime printed;
    int pages = 0;  ///< 0: nobody has counted them yet
};

/// The contents of a printed score card.
struct ScoreCard
{
    QString lesson;  ///< or the tooth
    QString person;
    database::AttemptRecord attempt;
    lessons::ScoreSheet sheet;
    database::AttemptTalk talk;
    std::optional<ScoredWork> work;                     ///< nothing: no pictures
    std::vector<std::vector<lessons::Moment>> moments;  ///< of the criteria, in their order; empty: not known
    QList<database::AttemptRecord> history;             ///< at this lesson, newest first
    std::vector<database::BandPoint> band;              ///< of the class
    Proof proof;
};

}  // namespace ui::scoring
