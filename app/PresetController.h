// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <QObject>
#include <QString>

#include "app/school/SchoolService.h"
#include "core/settings/FeelPreset.h"
#include "database/Login.h"
#include "lessons/PresetShelf.h"
#include "ui/window/MainWindow.h"

namespace app {

/// Lists the hardness presets, says which one teeth use, and saves new ones. A school's presets are in its database,
/// where admins save them and choose which is in use. A person without a login has their own in a folder. Ui thread.
class PresetController final : public QObject
{
    Q_OBJECT

public:
    PresetController(ui::window::MainWindow& window, std::function<database::Login()> who);

    /// The school's data can be asked from now on; null: not any more.
    void setSchool(SchoolService* school);
    /// Somebody else works here now, or what is kept may have changed.
    void refresh();
    /// A tooth is to begin, and another station may have said otherwise meanwhile. Where that cannot be read, what is
    /// known holds, and nothing is told.
    void readAgain();
    /// Goes on when what was asked for is there, or after a moment without it.
    void whenRead(const std::function<void()>& goOn);

    /// What teeth feel like, unless a lesson says otherwise.
    [[nodiscard]] const core::settings::FeelPreset& inUse() const { return m_inUse; }

signals:
    /// Teeth that are begun from now on feel otherwise.
    void inUseChanged();
    /// Nothing is being asked for any more.
    void isRead();

private:
    void connectPage();
    void read(bool tellsFault);
    void take(std::vector<lessons::ReadPreset> all, const QString& inUse);
    void use(const QString& name, const std::optional<QString>& insteadOf);
    void tellUsed(const QString& name, const QString& before, const QString& said);
    void retire(const QString& name, bool isRetired);
    /// @param note  what its file deserves a look for; may be empty
    void keep(const core::settings::FeelPreset& preset, const QString& note);
    void tellKept(const core::Result<core::settings::FeelPreset>& kept, const QString& note);
    void import(const QString& path);
    void exportTo(const core::settings::FeelPreset& preset, const QString& path);

    ui::window::MainWindow& m_window;
    std::function<database::Login()> m_who;
    SchoolService* m_school = nullptr;
    lessons::PresetFolder m_folder;
    std::vector<lessons::ReadPreset> m_all;  ///< as shelved()
    core::settings::FeelPreset m_inUse;
    bool m_isUnread = false;  ///< as was told last
    int m_asked = 0;          ///< how often the school was asked what there is, and has not answered yet
};

}  // namespace app
