// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <QFrame>

#include "core/settings/PenSettings.h"

class QDoubleSpinBox;
class QLabel;

namespace ui::devices {

class PenField;
class ResponseCurve;

/// The pen of a graphics tablet on the devices page: a test field, and the curve from pressure to force.
class PenCard : public QFrame
{
    Q_OBJECT
public:
    explicit PenCard(QWidget* parent);

    void setSettings(const core::settings::PenSettings& settings);
    /// Sets the force at full pressure, newtons.
    void setFullForce(double newtons);

signals:
    void settingsChanged(const core::settings::PenSettings& settings);

private:
    enum class Seen : std::uint8_t { Nothing, Mouse, Pen };

    QLayout* makeCurve(QLabel* caption);
    void showCurve();
    void showWords();

    core::settings::PenSettings m_settings;
    Seen m_seen = Seen::Nothing;
    double m_pressure = 0.0;
    double m_fullForceN = 0.0;
    PenField* m_field;
    QLabel* m_words;
    QDoubleSpinBox* m_curve;
    ResponseCurve* m_picture;
};

}  // namespace ui::devices
