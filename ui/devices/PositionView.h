// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <glm/vec3.hpp>

namespace ui::devices {

/// Shows the position of the grip in the work area: a dot from above and from the front.
class PositionView : public QWidget
{
    Q_OBJECT
public:
    explicit PositionView(QWidget* parent);

    /// @param tipMm   tooth frame
    /// @param reachMm  radius of the work area in the tooth frame
    void setTip(const glm::vec3& tipMm, double reachMm);
    [[nodiscard]] QSize sizeHint() const override { return {300, 158}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {260, 140}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void describe();

    glm::vec3 m_tipMm{0.0F};
    double m_reachMm = 40.0;
};

}  // namespace ui::devices
