// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include <QWidget>

class QPainter;

namespace ui::devices {

/// Draws the current step of HandGuide.
class HandGuidePicture : public QWidget
{
    Q_OBJECT
public:
    enum class Scene : std::uint8_t { Hand, Screen, Rest, Still };

    explicit HandGuidePicture(QWidget* parent);

    /// @param isLeft    the user is left-handed
    /// @param hasForce  draws a force device instead of a mouse or a pen
    void setScene(Scene scene, bool isLeft, bool hasForce);
    /// Sets the heights on the scale beside the force device, mm above the middle of the work area.
    /// @param gripMm  empty: the device is not ready
    void setHeights(std::optional<double> gripMm, double restMm);
    [[nodiscard]] QSize sizeHint() const override { return {360, 240}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {270, 180}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintHand(QPainter& painter) const;
    void paintScreen(QPainter& painter) const;
    void paintRest(QPainter& painter) const;
    void paintHeights(QPainter& painter) const;
    void paintStill(QPainter& painter) const;

    Scene m_scene = Scene::Hand;
    bool m_isLeft = false;
    bool m_hasForce = false;
    std::optional<double> m_gripMm;
    double m_restMm = 0.0;
};

}  // namespace ui::devices
