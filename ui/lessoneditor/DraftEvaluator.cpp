// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessoneditor/DraftEvaluator.h"

#include <utility>

#include "ui/lessoneditor/LessonDraft.h"

namespace ui::lessoneditor {

DraftEvaluator::DraftEvaluator(QObject* parent) : QObject(parent)
{
    m_pool.setMaxThreadCount(1);
}

DraftEvaluator::~DraftEvaluator()
{
    m_pool.waitForDone();
}

void DraftEvaluator::weigh(const QJsonObject& draft, const QString& file)
{
    if (m_isAtWork)
        m_next = Wish{draft, file};
    else
        start({draft, file});
}

void DraftEvaluator::forget()
{
    m_next.reset();
    m_isAnswerWanted = false;
}

void DraftEvaluator::start(const Wish& wish)
{
    m_isAtWork = true;
    m_isAnswerWanted = true;
    // The destructor waits for the pool, so `this` is valid. It also removes queued calls.
    m_pool.start([this, wish, before = m_before] {
        const auto found = lessoneditor::weigh(wish.draft, wish.file, before);
        QMetaObject::invokeMethod(
            this, [this, found] { take(found); }, Qt::QueuedConnection);
    });
}

void DraftEvaluator::take(const std::shared_ptr<const EvaluatedDraft>& found)
{
    m_isAtWork = false;
    if (found->assignment)
        m_before = found;
    const bool isWanted = m_isAnswerWanted;
    const auto next = std::exchange(m_next, {});
    if (next)
        start(*next);
    if (isWanted)
        emit weighed(found, !next);
}

}  // namespace ui::lessoneditor
