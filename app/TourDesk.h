// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/SchoolDesk.h"
#include "database/Session.h"
#include "ui/shell/MainWindow.h"

namespace app {

/// Shows everybody round once: whether somebody has seen the tour is kept with his settings in the database, a guest's
/// on this computer. Ui thread.
class TourDesk final : public QObject
{
    Q_OBJECT

public:
    explicit TourDesk(ui::shell::MainWindow& window);

    /// Somebody begins to work here.
    /// @param desk  where his settings are kept, outlives this; null for a guest
    void welcome(SchoolDesk* desk, const database::Session& who);

private:
    void keep();

    ui::shell::MainWindow& m_window;
    SchoolDesk* m_desk = nullptr;
    database::Session m_who;
};

}  // namespace app
