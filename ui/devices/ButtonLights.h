// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <QWidget>

namespace ui::devices {

/// Shows the four grip buttons with their functions. A held button is filled.
class ButtonLights : public QWidget
{
    Q_OBJECT
public:
    explicit ButtonLights(QWidget* parent);

    /// @param held  as DeviceReport::buttons
    void setHeld(std::uint8_t held);
    [[nodiscard]] std::uint8_t held() const { return m_held; }
    [[nodiscard]] QSize sizeHint() const override { return {280, 30}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void describe();

    std::uint8_t m_held = 0;
};

}  // namespace ui::devices
