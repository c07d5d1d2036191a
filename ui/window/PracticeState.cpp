// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/PracticeState.h"

#include "ui/text/LessonTexts.h"
#include "ui/text/Texts.h"

namespace ui::window {

const lessons::Lesson* PracticeState::lesson() const
{
    if (isReplaying)
        return replayedLesson ? &*replayedLesson : nullptr;
    return assignment && assignment->lesson ? &*assignment->lesson : nullptr;
}

QString PracticeState::title() const
{
    if (const lessons::Lesson* shown = lesson())
        return text::said(shown->title);
    return tooth != nullptr ? text::toothTitle(*tooth) : QString();
}

core::terrain::PerMaterial PracticeState::ownWork() const
{
    if (isReplaying)
        return workAtRest;
    // The session reports the previous tooth until it has loaded the new one.
    return session.toothGeneration == ownGeneration ? session.removedMm3 : core::terrain::PerMaterial{};
}

}  // namespace ui::window
