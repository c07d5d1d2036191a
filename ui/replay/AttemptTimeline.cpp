// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/replay/AttemptTimeline.h"

#include <algorithm>

namespace ui::replay {
namespace {

/// Moments closer than this are equal, because the reported position is one update late.
constexpr double kSameS = 0.025;

/// Returns whether a mark changed the tooth or how it is displayed.
bool isStep(const Mark& mark)
{
    return mark.kind == Mark::Kind::Undo || mark.kind == Mark::Kind::Redo || mark.kind == Mark::Kind::StartAgain ||
           mark.kind == Mark::Kind::Touched;
}

}  // namespace

double AttemptTimeline::stepAfter(double seconds) const
{
    double next = lengthS;
    for (const Stroke& stroke : strokes)
        if (stroke.doneS > seconds + kSameS)
            next = std::min(next, stroke.doneS);
    for (const Mark& mark : marks)
        if (isStep(mark) && mark.atS > seconds + kSameS)
            next = std::min(next, mark.atS);
    return next;
}

double AttemptTimeline::stepBefore(double seconds) const
{
    double last = 0.0;
    for (const Stroke& stroke : strokes)
        if (stroke.doneS < seconds - kSameS)
            last = std::max(last, stroke.doneS);
    for (const Mark& mark : marks)
        if (isStep(mark) && mark.atS < seconds - kSameS)
            last = std::max(last, mark.atS);
    return last;
}

std::vector<Remark> AttemptTimeline::remarksAt(double seconds) const
{
    std::vector<Remark> read;
    for (const Remark& remark : remarks)
        if (seconds >= remark.atS - kLeadUpS - kSameS && seconds <= remark.atS + kReadS)
            read.push_back(remark);
    return read;
}

}  // namespace ui::replay
