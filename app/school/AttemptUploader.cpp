// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/school/AttemptUploader.h"

#include <algorithm>

#include <QTimer>

#include "app/school/GradedMarker.h"

namespace app {
namespace {

constexpr int kAgainMs = 5000;

}  // namespace

AttemptUploader::AttemptUploader(SchoolService& desk) : m_desk(desk) {}

void AttemptUploader::send(const std::shared_ptr<const PendingAttempt>& letter)
{
    if (!m_waiting.emplace(letter->record.uid, letter).second)
        return;
    if (!letter->journal.empty())
        markGraded(letter->journal, {letter->record.uid, letter->recording.events(), letter->record.expectedTenths});
    offer(letter, false);
}

void AttemptUploader::offer(const std::shared_ptr<const PendingAttempt>& letter, bool isAgain)
{
    m_desk.keep(this, letter->who, letter->record, letter->recording,
                [this, letter, isAgain](const core::Status& done) {
                    if (done) {
                        m_waiting.erase(letter->record.uid);
                        emit kept(*letter, isAgain);
                    } else {
                        QTimer::singleShot(kAgainMs, this, [this, letter] { offer(letter, true); });
                        emit refused(*letter, isAgain, done.error());
                    }
                });
}

void AttemptUploader::send(const database::Login& who, const database::ExamStart& start)
{
    m_desk.keep(this, who, start, [this, who, start](const core::Status& done) {
        if (!done)
            QTimer::singleShot(m_desk.retryMs(), this, [this, who, start] { send(who, start); });
    });
}

bool AttemptUploader::hasAnyOf(const database::Login& who) const
{
    return std::any_of(m_waiting.begin(), m_waiting.end(), [&who](const auto& one) { return one.second->who == who; });
}

std::set<std::filesystem::path> AttemptUploader::journals() const
{
    std::set<std::filesystem::path> found;
    for (const auto& [uid, letter] : m_waiting)
        found.insert(letter->journal);
    return found;
}

}  // namespace app
