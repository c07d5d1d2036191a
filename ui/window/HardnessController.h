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

/// The hardness of the tooth that is shown: presets on their page, a trial of one in the room, and single numbers in
/// console and settings.
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
    /// Tells who works here and whether they may save presets and choose the one in use.
    void setMayKeep(const database::Login& who, bool may);
    /// saveRequested(), or an imported file, has become this version.
    /// @param note  a warning; may be empty
    void showSaved(const core::settings::FeelPreset& preset, const QString& note);
    void showFault(const QString& sentence);
    /// Sets the hardness of the tooth that is shown, and what it would be without changes by hand.
    void setFeel(const core::settings::FeelPreset& now, const core::settings::FeelPreset& usual);

    /// The block for the trial is shown.
    void beginTrial();
    void endTrial();
    [[nodiscard]] bool isTrial() const;
    void follow(const core::servo::ServoState& servo);

signals:
    /// Emitted when the page opens; setPresets() answers.
    void presetsRequested();
    /// Emitted when a preset shall be saved as another version of its name.
    void saveRequested(const core::settings::FeelPreset& preset);
    void useRequested(const core::settings::FeelPreset& preset);
    void importRequested(const QString& path);
    void retireRequested(const QString& name, bool isRetired);
    void exportRequested(const core::settings::FeelPreset& preset, const QString& path);
    /// Emitted when a block shall be shown to try a preset on; beginTrial() answers.
    void trialRequested(const core::settings::FeelPreset& preset);
    void trialBlockChosen(const core::settings::ToothKind& kind);
    /// Emitted when the block shall feel like this from now on.
    void trialFelt(const core::settings::FeelPreset& preset);
    /// Emitted when this tooth, and later ones except in exams, shall feel like this.
    void feelRequested(const core::settings::FeelPreset& preset);
    /// Emitted when the page shall be shown after a trial.
    void pageRequested();
    /// Emitted when the values in settings may have changed.
    void feelChanged();

private:
    void connectPage();
    void connectCard();
    void connectConsole();
    [[nodiscard]] QString useByName(const QString& name);
    /// Returns why not, or an empty string.
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
    core::settings::FeelPreset m_feel;       ///< of the tooth that is shown
    core::settings::FeelPreset m_usualFeel;  ///< of that tooth, without changes by hand
    /// The stored preset and its changed copy, for which a block was requested.
    std::optional<std::pair<core::settings::FeelPreset, core::settings::FeelPreset>> m_tried;
    std::optional<presets::BlindTrial> m_blindTrial;  ///< in place of it
};

}  // namespace ui::window
