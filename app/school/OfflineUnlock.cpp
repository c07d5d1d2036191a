// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/school/OfflineUnlock.h"

#include <algorithm>

namespace app {

using namespace std::chrono_literals;

std::chrono::seconds OfflineUnlock::wait() const
{
    return std::max(std::chrono::ceil<std::chrono::seconds>(m_next - m_now()), 0s);
}

void OfflineUnlock::reject()
{
    if (++m_wrong > kFreeTries)
        m_next = m_now() + std::chrono::seconds(1LL << std::min(m_wrong - kFreeTries, kMostDoublings));
}

void OfflineUnlock::resetTries()
{
    m_wrong = 0;
    m_next = {};
}

}  // namespace app
