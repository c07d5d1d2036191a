// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <vector>

#include <QString>
#include <QStringList>

#include "lessons/Assignment.h"

/// How attempts that are there would score under other tolerances. Pure functions; any thread that may wait.
namespace ui::lessoneditor {

/// An attempt as its recording left it: replayed once, measured as often as the ideal changes.
struct PastAttempt
{
    QString name;                 ///< of its file
    std::uint64_t surface = 0;    ///< core::preparation::surfaceHash() of its tooth
    std::vector<float> top;       ///< as it was cut
    core::grading::Measured way;  ///< process, infractions and aids; the rest says nothing here
};

/// What was read of a folder.
struct PastAttempts
{
    std::vector<PastAttempt> attempts;
    QStringList faults;  ///< a sentence for each recording that could not be read
};

/// At most so many recordings of a folder are read.
inline constexpr int kMostRecordings = 500;

/// Replays every recording of a folder (*.cusprec) for what it came to: a 60th of the time that they took, or less.
/// @param told    called with how many of how many are done
/// @param cancel  looked at between recordings; what is done by then is answered
[[nodiscard]] PastAttempts readAttempts(const QString& folder, const std::function<void(int, int)>& told,
                                        const std::atomic<bool>& cancel);

/// One attempt, measured against a draft.
struct MeasuredAttempt
{
    QString name;
    ::lessons::Values values;
};

/// Those that were made on the assignment's tooth; others are left out. Some milliseconds each.
[[nodiscard]] std::vector<MeasuredAttempt> measureAttempts(const ::lessons::Assignment& assignment,
                                                           const std::vector<PastAttempt>& attempts);

/// Scores under tolerances of `times` as much, for each of the steps from 0 to kMostTimes.
struct Sweep
{
    struct Line
    {
        QString name;
        std::vector<int> tenths;  ///< one a step
    };
    std::vector<double> times;
    std::vector<Line> lines;
    std::vector<int> passed;  ///< attempts that pass, one a step
    int passMarkTenths = 0;
    [[nodiscard]] std::size_t stepOf(double wanted) const;
    [[nodiscard]] int medianTenths(std::size_t step) const;
};

inline constexpr double kMostTimes = 3.0;
inline constexpr int kSweepSteps = 31;

/// @param criterion  the only one whose tolerance is taken times as much; negative: all of them
[[nodiscard]] Sweep sweepOf(const ::lessons::Rubric& rubric, const std::vector<MeasuredAttempt>& attempts,
                            int criterion);

}  // namespace ui::lessoneditor
