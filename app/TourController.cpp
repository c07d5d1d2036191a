// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/TourController.h"

#include "database/sql/Settings.h"

namespace app {
namespace {

using database::sql::DatabaseContext;

const std::string kSeen = "tour.seen";

}  // namespace

TourController::TourController(ui::window::MainWindow& window) : m_window(window)
{
    connect(&m_window, &ui::window::MainWindow::tourEnded, this, &TourController::keep);
}

void TourController::welcome(SchoolService* desk, const database::Login& who)
{
    m_desk = desk;
    m_who = who;
    if (who.isGuest())  // "Practise now" leads to the tooth at once
        return;
    m_desk->ask(
        this, [who](const DatabaseContext& school) { return database::sql::readSettings(school, who); },
        [this, who](const core::Result<database::sql::SettingsMap>& settings) {
            // If the setting cannot be read, no tour begins.
            if (settings && settings->count(kSeen) == 0 && m_who == who)
                m_window.beginTour();
        });
}

/// Not told if it fails: then the tour is offered once more.
void TourController::keep()
{
    if (m_who.isGuest())
        return;
    m_desk->ask(
        this,
        [who = m_who](const DatabaseContext& school) -> core::Result<bool> {
            if (auto kept = database::sql::changeOwnSetting(school, who, kSeen, "yes"); !kept)
                return tl::unexpected(kept.error());
            return true;
        },
        [](const core::Result<bool>&) {});
}

}  // namespace app
