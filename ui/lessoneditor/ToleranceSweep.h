// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <vector>

#include <QString>
#include <QStringList>

#include "lessons/Assignment.h"

/// The scores of past attempts under other tolerances. Pure functions; any thread but the ui thread.
namespace ui::lessoneditor {

/// The result of a recording. A recording is replayed once, and measured again whenever the ideal changes.
struct PastAttempt
{
    QString name;                 ///< name of its file
    std::uint64_t surface = 0;    ///< core::preparation::surfaceHash() of its tooth
    std::vector<float> top;       ///< top map after the attempt, mm
    core::grading::Measured way;  ///< process, rule violations and aids; the other members are unset
};

/// The recordings of a folder.
struct PastAttempts
{
    std::vector<PastAttempt> attempts;
    QStringList faults;  ///< a sentence for each recording that could not be read
};

/// Largest number of recordings that are read from one folder.
inline constexpr int kMostRecordings = 500;

/// Replays every recording of a folder (*.cusprec), at least 60 times as fast as it was recorded.
/// @param told    called with the number of replayed recordings and the number of all
/// @param cancel  checked between recordings; if set, returns the attempts read so far
[[nodiscard]] PastAttempts readAttempts(const QString& folder, const std::function<void(int, int)>& told,
                                        const std::atomic<bool>& cancel);

/// The measures of one attempt against a draft.
struct MeasuredAttempt
{
    QString name;
    ::lessons::Values values;
};

/// Measures the attempts on the assignment's tooth, and omits the others. Takes some milliseconds per attempt.
[[nodiscard]] std::vector<MeasuredAttempt> measureAttempts(const ::lessons::Assignment& assignment,
                                                           const std::vector<PastAttempt>& attempts);

/// The scores when all tolerances are multiplied by each step from 0 to kMostTimes.
struct Sweep
{
    struct Line
    {
        QString name;
        std::vector<int> tenths;  ///< one per step
    };
    std::vector<double> times;
    std::vector<Line> lines;
    std::vector<int> passed;  ///< number of attempts that pass, one per step
    int passMarkTenths = 0;
    [[nodiscard]] std::size_t stepOf(double wanted) const;
    [[nodiscard]] int medianTenths(std::size_t step) const;
};

inline constexpr double kMostTimes = 3.0;
inline constexpr int kSweepSteps = 31;

/// Returns the sweep of these attempts.
/// @param criterion  multiplies the tolerance of this criterion only; negative: of all
[[nodiscard]] Sweep sweepOf(const ::lessons::Rubric& rubric, const std::vector<MeasuredAttempt>& attempts,
                            int criterion);

}  // namespace ui::lessoneditor
