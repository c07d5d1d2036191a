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

/// Foot pedals and gamepads on the page of devices: their axes and buttons as they move, and their settings.
///
/// It reads no controller: reports and settings are given to it, and its signals ask for the rest.
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

    /// What is known now, for the head of the page and its list.
    [[nodiscard]] const ControllerState& state() const { return m_state; }
    /// The controller that is shown; null if none is plugged in.
    [[nodiscard]] const core::session::Controller* shown() const;
    /// True while the user teaches a pedal or a button: buttons do nothing else meanwhile.
    [[nodiscard]] bool isLearning() const;

signals:
    /// Emitted when the user has changed the settings of a controller.
    void settingsChanged(const QString& guid, const ui::devices::ControllerSettings& settings);
    /// Emitted when the user chooses what runs the bur; empty: no pedal does.
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
    int m_shown = -1;       ///< instance of the controller that is shown
    QPushButton* m_forget;  ///< a pedal that is not plugged in
    QFrame* m_live;
    QComboBox* m_choice = nullptr;
    QLabel* m_twice = nullptr;
    AxisBars* m_bars = nullptr;
    QCheckBox* m_runsBur = nullptr;
    PedalSetupCard* m_setup;
    ControllerButtonsCard* m_buttons;
};

}  // namespace ui::devices
