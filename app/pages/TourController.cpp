// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/TourController.h"

#include "database/SchoolSettings.h"

namespace app {
namespace {

using database::Repositories;

const std::string kSeen = "tour.seen";

}  // namespace

TourController::TourController(ui::window::MainWindow& window) : m_window(window)
{
    connect(&m_window.navigation(), &ui::window::Navigation::tourEnded, this, &TourController::keep);
}

void TourController::welcome(SchoolAccess* school, const database::Login& who)
{
    m_school = school;
    m_who = who;
    if (who.isGuest())  // "Practise now" leads to the tooth at once
        return;
    m_school->ask(
        this, [who](const Repositories& data) { return data.settings.read(who); },
        [this, who](const core::Result<database::SettingsMap>& settings) {
            // If the settings cannot be read, the user starts to work without the tour.
            if (settings && settings->count(kSeen) == 0 && m_who == who)
                m_window.beginTour();
        });
}

/// Stores that the user has seen the tour. If that fails, the tour is offered again at the next login.
void TourController::keep()
{
    if (m_who.isGuest())
        return;
    m_school->ask(
        this, [who = m_who](const Repositories& school) { return school.settings.changeOwn(who, kSeen, "yes"); },
        [](const core::Status&) {});
}

}  // namespace app
