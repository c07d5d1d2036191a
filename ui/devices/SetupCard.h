// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <QFrame>

#include "core/session/DeviceReport.h"

class QBoxLayout;
class QDoubleSpinBox;
class QRadioButton;
class QVBoxLayout;

namespace ui::devices {

class PlacementPicture;

/// The form for the placement of the device, with a picture: orientation, side and scale.
class SetupCard : public QFrame
{
    Q_OBJECT
public:
    explicit SetupCard(QWidget* parent);

    void setSetup(const core::session::DeviceSetup& setup);
    /// Sets whether the picture is above the form, for a narrow page.
    void setNarrow(bool isNarrow);
    [[nodiscard]] const core::session::DeviceSetup& setup() const { return m_setup; }

signals:
    /// Emitted when the user has changed the set-up.
    void setupChanged(const core::session::DeviceSetup& setup);

private:
    void addScale(QVBoxLayout* form);
    void change(const core::session::DeviceSetup& setup);

    core::session::DeviceSetup m_setup;
    QBoxLayout* m_columns;
    PlacementPicture* m_picture;
    std::array<QRadioButton*, 2> m_stands{};
    std::array<QRadioButton*, 3> m_sides{};
    QDoubleSpinBox* m_scale;
};

}  // namespace ui::devices
