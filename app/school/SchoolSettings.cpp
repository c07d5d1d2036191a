// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/school/SchoolSettings.h"

#include <QString>

namespace app {

int idleMinutesOf(const database::SettingsMap& settings)
{
    const auto found = settings.find(kIdleMinutes);
    const int minutes = found == settings.end() ? 0 : QString::fromStdString(found->second).toInt();
    return minutes > 0 ? minutes : kUsualIdleMinutes;
}

}  // namespace app
