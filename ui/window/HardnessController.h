// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QObject>

#include "core/servo/ServoState.h"
#include "core/settings/Parameters.h"
#include "database/Person.h"
#include "lessons/PresetShelf.h"
#include "ui/presets/BlindTrial.h"
#include "ui/window/PracticeState.h"

namespace ui::console {
class Console;
}
namespace ui::kit {
class MessageBar;
}
namespace ui::presets {
class PresetsPage;
class TrialCard;
}  // namespace ui::presets

namespace ui::window {

class CommandSender;
class FileDialogs;
class PracticeRoom;
class UnsavedWork;

/// Manages the hardness of the tooth that is shown: presets on their page, the trial of a preset in the practice room,
/// and single numbers in console and settings.
class HardnessController final : public QObject
{
    Q_OBJECT
public:
    HardnessController(const PracticeState& state, PracticeRoom& room, presets::PresetsPage& page,
                       console::Console& console, kit::MessageBar& messages, FileDialogs& files, UnsavedWork& unsaved,
                       CommandSender& commands);

    /// Adds the numbers of a preset to the parameters of console and settings.
    void addTo(core::settings::Parameters& parameters);
    /// Sets the presets that exist, and the one in use.
    void setPresets(std::vector<lessons::ReadPreset> all, const core::settings::FeelPreset& inUse);
    /// Sets the user, and whether they may save presets and choose the one in use.
    void setMayKeep(const database::Login& who, bool may);
    /// Shows that a preset was saved, after saveRequested() or the import of a file.
    /// @param preset  the preset with its new version
    /// @param note    a warning; may be empty
    void showSaved(const core::settings::FeelPreset& preset, const QString& note);
    void showFault(const QString& sentence);
    /// Sets the hardness of the tooth that is shown.
    /// @param usual  its hardness without changes by hand
    void setFeel(const core::settings::FeelPreset& now, const core::settings::FeelPreset& usual);

    /// Shows the card of the trial. Call it when the block for the trial is shown.
    void beginTrial();
    void endTrial();
    [[nodiscard]] bool isTrial() const;
    void follow(const core::servo::ServoState& servo);

signals:
    /// Emitted when the page needs the presets. The receiver calls setPresets().
    void presetsRequested();
    /// Emitted when the user requests to save a preset as another version of its name.
    void saveRequested(const core::settings::FeelPreset& preset);
    void useRequested(const core::settings::FeelPreset& preset);
    void importRequested(const QString& path);
    void retireRequested(const QString& name, bool isRetired);
    void exportRequested(const core::settings::FeelPreset& preset, const QString& path);
    /// Emitted when the user requests a trial of a preset. The receiver shows a block and calls beginTrial().
    void trialRequested(const core::settings::FeelPreset& preset);
    void trialBlockChosen(const core::settings::ToothKind& kind);
    /// Emitted when the hardness of the block changes during a trial.
    void trialFelt(const core::settings::FeelPreset& preset);
    /// Emitted when the user requests another hardness for this tooth and later ones. It does not apply to exams.
    void feelRequested(const core::settings::FeelPreset& preset);
    /// Emitted when a trial has ended, to open the page of presets.
    void pageRequested();
    /// Emitted when the values in settings may have changed.
    void feelChanged();

private:
    void connectPage();
    void connectCard();
    void connectConsole();
    [[nodiscard]] QString useByName(const QString& name);
    /// Changes the hardness by hand. Returns an empty string, or the reason why it was not changed.
    [[nodiscard]] std::string feelByHand(const core::settings::FeelPreset& wanted);
    [[nodiscard]] QString whyNotByHand(const core::settings::FeelPreset& next) const;
    [[nodiscard]] core::settings::FeelPreset usualIfEqual(const core::settings::FeelPreset& wanted) const;

    const PracticeState& m_state;
    PracticeRoom& m_room;
    presets::PresetsPage& m_page;
    console::Console& m_console;
    kit::MessageBar& m_messages;
    FileDialogs& m_files;
    UnsavedWork& m_unsaved;
    CommandSender& m_commands;
    presets::TrialCard* m_card;
    core::settings::FeelPreset m_feel;       ///< hardness of the tooth that is shown
    core::settings::FeelPreset m_usualFeel;  ///< hardness of that tooth without changes by hand
    /// The stored preset and its changed copy, for a trial that was requested and has not begun yet.
    std::optional<std::pair<core::settings::FeelPreset, core::settings::FeelPreset>> m_tried;
    std::optional<presets::BlindTrial> m_blindTrial;  ///< set instead of m_tried for a blind trial
};

}  // namespace ui::window
