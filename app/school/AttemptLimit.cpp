// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/school/AttemptLimit.h"

#include <memory>
#include <optional>
#include <utility>

#include <QTimer>

#include "app/school/SchoolAccess.h"
#include "database/Repositories.h"

namespace app {

void AttemptLimit::ask(const std::string& lessonId, const std::function<void(bool)>& decide)
{
    if (!m_school.service || m_school.user.role() != database::Role::Student) {
        decide(true);
        return;
    }
    const auto once = [decide, isDecided = std::make_shared<bool>(false)](bool may) {
        if (!std::exchange(*isDecided, true))
            decide(may);
    };
    m_school.service->ask(
        this,
        [who = m_school.user, lessonId](const database::Repositories& school) {
            return school.lessons.attemptsLeft(who, lessonId);
        },
        [once](const core::Result<std::optional<int>>& left) {
            once(!left || !left->has_value() || left->value() > 0);
        });
    QTimer::singleShot(kPatienceMs, this, [once] { once(true); });
}

void AttemptLimit::whenAllowed(const std::string& lessonId, const std::function<void()>& go,
                               const std::function<void()>& refuse)
{
    ask(lessonId, [this, go, refuse, load = m_loads.latest()](bool may) {
        if (!m_loads.isLatest(load))
            return;
        if (may) {
            go();
            return;
        }
        refuse();
        emit usedUp();
    });
}

}  // namespace app
