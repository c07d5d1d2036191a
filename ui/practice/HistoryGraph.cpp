// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/practice/HistoryGraph.h"

#include <algorithm>
#include <unordered_map>

namespace ui::practice {
namespace {

/// A chain of moments, in which each one is the oldest child of the one before.
struct Line
{
    int parent = -1;
    std::vector<int> rows;
};

/// Returns the chains, sorted by their first rows.
std::vector<Line> linesOf(const std::vector<HistoryRow>& rows)
{
    std::vector<Line> lines;
    std::unordered_map<int, std::size_t> endsAt;  // row -> the chain that ends with it
    for (int n = 0; n < static_cast<int>(rows.size()); ++n) {
        const int parent = rows[static_cast<std::size_t>(n)].parent;
        const auto line = endsAt.find(parent);
        std::size_t at = lines.size();
        if (parent >= 0 && line != endsAt.end()) {
            at = line->second;
            endsAt.erase(line);
        } else {
            lines.push_back({parent, {}});
        }
        lines[at].rows.push_back(n);
        endsAt[n] = at;
    }
    return lines;
}

}  // namespace

std::vector<HistoryRow> historyRows(std::span<const core::history::MomentInfo> moments)
{
    std::vector<HistoryRow> rows;
    std::unordered_map<std::uint64_t, int> rowOf;
    for (const core::history::MomentInfo& moment : moments) {
        HistoryRow row;
        row.moment = moment;
        row.takenMm3 = moment.removed.volumesMm3;
        if (const auto parent = rowOf.find(static_cast<std::uint64_t>(moment.parent)); parent != rowOf.end()) {
            row.parent = parent->second;
            const auto& before = moments[static_cast<std::size_t>(row.parent)].removed.volumesMm3;
            for (std::size_t m = 0; m < before.size(); ++m)
                row.takenMm3[m] -= before[m];
        }
        rowOf[static_cast<std::uint64_t>(moment.id)] = static_cast<int>(rows.size());
        rows.push_back(std::move(row));
    }
    std::vector<int> taken;  // last row that each lane is used for
    for (const Line& line : linesOf(rows)) {
        const int first = line.parent < 0 ? line.rows.front() : line.parent + 1;
        const int last = line.rows.back();
        auto lane = std::find_if(taken.begin(), taken.end(), [first](int until) { return until < first; });
        if (lane == taken.end())
            lane = taken.insert(taken.end(), 0);
        *lane = last;
        const int at = static_cast<int>(lane - taken.begin());
        for (const int row : line.rows)
            rows[static_cast<std::size_t>(row)].lane = at;
        for (int row = line.parent < 0 ? line.rows.front() : line.parent; row < last; ++row)
            rows[static_cast<std::size_t>(row)].toBelow.push_back(at);
        for (int row = first + (line.parent < 0 ? 1 : 0); row <= last; ++row)
            rows[static_cast<std::size_t>(row)].fromAbove.push_back(at);
    }
    return rows;
}

}  // namespace ui::practice
