// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/TourDesk.h"

#include "database/sql/Settings.h"

namespace app {
namespace {

using database::sql::School;

const std::string kSeen = "tour.seen";

}  // namespace

TourDesk::TourDesk(ui::window::MainWindow& window) : m_window(window)
{
    connect(&m_window, &ui::window::MainWindow::tourEnded, this, &TourDesk::keep);
}

void TourDesk::welcome(SchoolDesk* desk, const database::Session& who)
{
    m_desk = desk;
    m_who = who;
    if (who.isGuest())  // "Practise now" leads to the tooth at once
        return;
    m_desk->ask(
        this, [who](const School& school) { return database::sql::readSettings(school, who); },
        [this, who](const core::Result<database::sql::SettingsMap>& settings) {
            // Where it cannot be known, nobody is kept from his work.
            if (settings && settings->count(kSeen) == 0 && m_who == who)
                m_window.beginTour();
        });
}

/// Not told if it fails: then the tour is offered once more.
void TourDesk::keep()
{
    if (m_who.isGuest())
        return;
    m_desk->ask(
        this,
        [who = m_who](const School& school) -> core::Result<bool> {
            if (auto kept = database::sql::changeOwnSetting(school, who, kSeen, "yes"); !kept)
                return tl::unexpected(kept.error());
            return true;
        },
        [](const core::Result<bool>&) {});
}

}  // namespace app
