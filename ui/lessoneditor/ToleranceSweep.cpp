// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessoneditor/ToleranceSweep.h"

#include <algorithm>
#include <cmath>

#include <QDir>

#include "core/preparation/CapturedIdeal.h"

namespace ui::lessoneditor {

PastAttempts readAttempts(const QString& folder, const std::function<void(int, int)>& told,
                          const std::atomic<bool>& cancel)
{
    PastAttempts past;
    QStringList names = QDir(folder).entryList({QStringLiteral("*.cusprec")}, QDir::Files, QDir::Name);
    if (names.size() > kMostRecordings)
        names.resize(kMostRecordings);
    int done = 0;
    told(done, static_cast<int>(names.size()));
    for (const QString& name : names) {
        if (cancel.load())
            return past;
        const auto path = std::filesystem::path(QDir(folder).filePath(name).toStdU16String());
        const auto recording = core::recording::readRecording(path);
        const auto again = recording ? ::lessons::markAgain(*recording)
                                     : core::Result<::lessons::Remarked>(tl::unexpected(recording.error()));
        if (again)
            past.attempts.push_back({name, core::preparation::surfaceHash(*again->outcome.tooth.anatomy),
                                     again->outcome.tooth.top, again->mark.measured});
        else
            past.faults << QString::fromStdString(again.error().detail);
        told(++done, static_cast<int>(names.size()));
    }
    return past;
}

std::vector<MeasuredAttempt> measureAttempts(const ::lessons::Assignment& assignment,
                                             const std::vector<PastAttempt>& attempts)
{
    std::vector<MeasuredAttempt> measured;
    const std::uint64_t surface = core::preparation::surfaceHash(*assignment.anatomy);
    for (const PastAttempt& attempt : attempts) {
        if (attempt.surface != surface)
            continue;
        auto marked = ::lessons::mark(assignment, core::terrain::restored(assignment.anatomy, attempt.top));
        if (!marked)
            continue;
        marked->measured.process = attempt.way.process;
        marked->measured.infractions = attempt.way.infractions;
        marked->measured.aidsUsed = attempt.way.aidsUsed;
        measured.push_back({attempt.name, ::lessons::valuesOf(marked->measured)});
    }
    return measured;
}

std::size_t Sweep::stepOf(double wanted) const
{
    const double step = std::clamp(wanted, 0.0, kMostTimes) / kMostTimes * (kSweepSteps - 1);
    return static_cast<std::size_t>(std::lround(step));
}

int Sweep::medianTenths(std::size_t step) const
{
    std::vector<int> all;
    for (const Line& line : lines)
        all.push_back(line.tenths[step]);
    if (all.empty())
        return 0;
    std::sort(all.begin(), all.end());
    const std::size_t half = all.size() / 2;
    return all.size() % 2 == 1 ? all[half] : (all[half - 1] + all[half]) / 2;
}

Sweep sweepOf(const ::lessons::Rubric& rubric, const std::vector<MeasuredAttempt>& attempts, int criterion)
{
    Sweep sweep;
    sweep.passMarkTenths = rubric.passMarkTenths;
    for (const MeasuredAttempt& attempt : attempts)
        sweep.lines.push_back({attempt.name, {}});
    for (int step = 0; step < kSweepSteps; ++step) {
        const double times = kMostTimes * step / (kSweepSteps - 1);
        sweep.times.push_back(times);
        ::lessons::Rubric scaled = rubric;
        for (std::size_t k = 0; k < scaled.criteria.size(); ++k)
            if (criterion < 0 || static_cast<std::size_t>(criterion) == k)
                scaled.criteria[k].tolerance *= times;
        int passed = 0;
        for (std::size_t k = 0; k < attempts.size(); ++k) {
            const ::lessons::ScoreSheet sheet = ::lessons::grade(scaled, attempts[k].values);
            sweep.lines[k].tenths.push_back(sheet.totalTenths);
            passed += sheet.passed() ? 1 : 0;
        }
        sweep.passed.push_back(passed);
    }
    return sweep;
}

}  // namespace ui::lessoneditor
