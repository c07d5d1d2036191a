// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/session/DeviceReport.h"

namespace ui::devices {

/// Draws the placement of a device with three arms: from its side, and from above with the user and the screen.
class PlacementPicture : public QWidget
{
    Q_OBJECT
public:
    explicit PlacementPicture(QWidget* parent);

    void setSetup(const core::session::DeviceSetup& setup);
    [[nodiscard]] QSize sizeHint() const override { return {380, 190}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {300, 160}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void describe();
    void paintFromTheSide(QPainter& painter) const;
    void paintFromAbove(QPainter& painter) const;

    core::session::DeviceSetup m_setup;
};

}  // namespace ui::devices
