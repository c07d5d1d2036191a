// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>

#include <QString>
#include <QWidget>

#include "ui/devices/ControllerSettings.h"
#include "ui/devices/ControllerWords.h"

class QCheckBox;
class QComboBox;
class QFrame;
class QLabel;
class QPushButton;

namespace ui::devices {

class AxisBars;
class ControllerButtonsCard;
class PedalSetupCard;

/// Foot pedals and gamepads on the devices page: live display of their axes and buttons, and their settings.
///
/// This widget reads no controller. Its owner passes reports and settings to it and handles its signals.
class PedalCard : public QWidget
{
    Q_OBJECT
public:
    explicit PedalCard(QWidget* parent);

    /// Sets whether this program was built with SDL 2. The default is true.
    void setInBuild(bool isInBuild);
    void setReport(const core::session::ControllerReport& report);
    /// Sets the settings of one kind of controller.
    void setSettings(const QString& guid, const ControllerSettings& settings);
    /// Sets the controller that runs the bur.
    /// @param guid  empty: none
    void setPedal(const QString& guid, const QString& name);

    /// Returns the current state, for the page's header and its list.
    [[nodiscard]] const ControllerState& state() const { return m_state; }
    /// Returns the shown controller, or null if none is plugged in.
    [[nodiscard]] const core::session::Controller* shown() const;
    /// Returns whether the user is teaching a pedal or a button. Meanwhile buttons have no other effect.
    [[nodiscard]] bool isLearning() const;

signals:
    /// Emitted when the user has changed the settings of a controller.
    void settingsChanged(const QString& guid, const ui::devices::ControllerSettings& settings);
    /// Emitted when the user chooses the controller that runs the bur. Empty: none.
    void pedalChosen(const QString& guid, const QString& name);
    /// Emitted when state() has changed.
    void stateChanged();

private:
    void makeLive();
    void listControllers();
    void showController();
    void showState();
    void change(const ControllerSettings& settings);
    void choosePedal(bool isPedal);
    void forgetPedal();
    [[nodiscard]] ControllerSettings settingsOf(const core::session::Controller& controller) const;

    ControllerState m_state;
    std::map<QString, ControllerSettings> m_settings;
    QString m_pedal;  ///< guid
    std::optional<ControllerSettings> m_shownSettings;
    int m_shown = -1;       ///< instance of the shown controller; -1: none
    QPushButton* m_forget;  ///< removes the choice of a pedal that is not plugged in
    QFrame* m_live;
    QComboBox* m_choice = nullptr;
    QLabel* m_twice = nullptr;
    AxisBars* m_bars = nullptr;
    QCheckBox* m_runsBur = nullptr;
    PedalSetupCard* m_setup;
    ControllerButtonsCard* m_buttons;
};

}  // namespace ui::devices
