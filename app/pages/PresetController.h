// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <QObject>
#include <QString>

#include "app/pages/SchoolPresets.h"
#include "app/school/SchoolAccess.h"
#include "core/settings/FeelPreset.h"
#include "database/Login.h"
#include "lessons/PresetShelf.h"
#include "ui/window/MainWindow.h"

namespace app {

/// Lists, saves and retires hardness presets, and knows the one in use. The presets of a school are in its database:
/// admins save them and choose the one in use. A guest's own presets are files in a folder. Ui thread.
class PresetController final : public QObject
{
    Q_OBJECT

public:
    PresetController(ui::window::MainWindow& window, std::function<database::Login()> who);

    /// @param school  the service of the database with the presets, must outlive its use; null: there is none
    void setSchool(SchoolAccess* school);
    /// Reads the presets again: another user has logged in, or the presets may have changed.
    void refresh();
    /// As refresh(), before a tooth is loaded: another station may have changed the presets. If they cannot be read,
    /// keeps those that are known, and shows no error.
    void readAgain();
    /// Calls `goOn` when all pending reads have ended, or after 1.5 seconds.
    void whenRead(const std::function<void()>& goOn);

    /// The preset of new teeth, unless their lesson names another.
    [[nodiscard]] const core::settings::FeelPreset& inUse() const { return m_inUse; }

signals:
    /// Emitted when another preset is used for new teeth.
    void inUseChanged();
    /// Emitted when the last pending read has ended.
    void isRead();

private:
    void connectPage();
    void read(bool showsError);
    /// @param who  the user who asked
    void apply(const database::Login& who, SchoolPresets found);
    void use(const QString& name, const std::optional<QString>& insteadOf);
    void showChoice(const QString& name, const ChosenPreset& choice);
    void showUsed(const QString& name, const QString& before, const QString& said);
    void retire(const QString& name, bool isRetired);
    /// @param note  warnings about the file it comes from; may be empty
    void save(const core::settings::FeelPreset& preset, const QString& note);
    void showSaved(const core::Result<core::settings::FeelPreset>& saved, const QString& note);
    void import(const QString& path);
    void exportTo(const core::settings::FeelPreset& preset, const QString& path);

    ui::window::MainWindow& m_window;
    std::function<database::Login()> m_who;
    SchoolAccess* m_school = nullptr;
    lessons::PresetFolder m_folder;
    std::vector<lessons::ReadPreset> m_all;  ///< as shelved()
    core::settings::FeelPreset m_inUse;
    bool m_showsReadError = false;
    int m_pendingReads = 0;
};

}  // namespace app
