// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QRect>

#include "core/settings/Parameters.h"
#include "ui/console/Registration.h"
#include "ui/window/PracticeState.h"

namespace ui::console {
class Console;
class WatchPanel;
}  // namespace ui::console
namespace ui::kit {
class Actions;
}
namespace ui::practice {
class HandControls;
}
namespace ui::tooth {
class ToothView;
}

namespace ui::window {

class ExerciseView;
class HardnessController;
class PracticeRoom;

/// Shows the console and its watched values over the practice room. Owns the parameters that console and settings can
/// change.
class ConsoleView final : public QObject
{
    Q_OBJECT
public:
    ConsoleView(PracticeRoom& room, kit::Actions& actions);

    [[nodiscard]] console::Console& console() { return *m_console; }
    [[nodiscard]] const console::WatchPanel& watch() const { return *m_watch; }
    [[nodiscard]] core::settings::Parameters& parameters() { return m_parameters; }
    /// Adds all parameters. Call it once. The arguments must outlive the console.
    void addParameters(HardnessController& hardness, tooth::ToothView& view, practice::HandControls& hand,
                       const PracticeState& state, const ExerciseView& exercise);
    /// Returns the meter of the servo's period, which gets a value with each frame.
    [[nodiscard]] console::PeriodMeter& periods() { return m_periods; }
    [[nodiscard]] const console::PeriodMeter& periods() const { return m_periods; }

    [[nodiscard]] bool isOpen() const;
    /// Returns whether a widget with the keyboard focus belongs to the open console.
    [[nodiscard]] bool isTypedIn(const QWidget* focused) const;
    /// Removes the watched values. Returns whether there were any.
    bool hideWatch();
    void placeIn(const QRect& area);

signals:
    void closed();
    /// Emitted when the size has changed, so that placeIn() must be called.
    void resized();

private:
    kit::Actions& m_actions;
    core::settings::Parameters m_parameters;
    console::PeriodMeter m_periods;
    console::WatchPanel* m_watch;
    console::Console* m_console;
};

}  // namespace ui::window
