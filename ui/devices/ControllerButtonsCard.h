// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include <QFrame>

#include "ui/devices/ControllerSettings.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace ui::devices {

/// Assigns functions to the buttons of a controller: the user clicks a function, then presses a button.
class ControllerButtonsCard : public QFrame
{
    Q_OBJECT
public:
    explicit ControllerButtonsCard(QWidget* parent);

    void setSettings(const ControllerSettings& settings);
    /// Sets the newest state of the shown controller.
    void setController(const core::session::Controller& controller);
    /// Ends the assignment without a result.
    void stopLearning();
    [[nodiscard]] bool isLearning() const { return m_learning.has_value(); }

signals:
    void settingsChanged(const ui::devices::ControllerSettings& settings);

private:
    void clickAction(ControllerAction action, bool isChecked);
    void assign(int button);
    void showWords();

    ControllerSettings m_settings;
    core::session::Controller m_controller;
    std::optional<ControllerAction> m_learning;
    QLabel* m_words;
    std::array<QLabel*, kControllerActions> m_names{};
    std::array<QPushButton*, kControllerActions> m_buttons{};
    QLabel* m_layoutTitle;
    QGridLayout* m_layout;
    QWidget* m_layoutBox;
};

}  // namespace ui::devices
