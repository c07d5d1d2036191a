// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/school/SchoolAccess.h"
#include "database/Login.h"
#include "ui/window/MainWindow.h"

namespace app {

/// Starts the tour at the first login of each user: their settings in the database tell whether they have seen it. A
/// guest starts it themselves. Ui thread.
class TourController final : public QObject
{
    Q_OBJECT

public:
    explicit TourController(ui::window::MainWindow& window);

    /// A user has logged in, or a guest begins.
    /// @param school  reads and stores the user's settings, outlives this; null for a guest
    void welcome(SchoolAccess* school, const database::Login& who);

private:
    void keep();

    ui::window::MainWindow& m_window;
    SchoolAccess* m_school = nullptr;
    database::Login m_who;
};

}  // namespace app
