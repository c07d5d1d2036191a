// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QElapsedTimer>
#include <QFrame>

#include "core/settings/PedalLearner.h"
#include "ui/devices/ControllerSettings.h"

class QBoxLayout;
class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace ui::devices {

class ResponseCurve;

/// Sets up how the travel of a pedal controls the speed of the bur: teaching, dead zone, curve, direction.
class PedalSetupCard : public QFrame
{
    Q_OBJECT
public:
    explicit PedalSetupCard(QWidget* parent);

    void setSettings(const ControllerSettings& settings);
    /// Sets the newest reading of the shown controller.
    void setController(const core::session::Controller& controller);
    /// Ends the teaching without a result.
    void stopLearning();
    [[nodiscard]] bool isLearning() const { return m_learner.has_value(); }

signals:
    void settingsChanged(const ui::devices::ControllerSettings& settings);
    /// Emitted when the pedal has been taught.
    void taught();

private:
    void setLearning(bool isLearning);
    void showCurve();
    void showWords();

    ControllerSettings m_settings;
    core::session::Controller m_controller;
    std::optional<core::settings::PedalLearner> m_learner;
    QElapsedTimer m_sinceReading;
    QLabel* m_words;
    QPushButton* m_teach;
    QCheckBox* m_inverted;
    QSpinBox* m_deadZone;
    QDoubleSpinBox* m_curve;
    ResponseCurve* m_picture;
};

}  // namespace ui::devices
