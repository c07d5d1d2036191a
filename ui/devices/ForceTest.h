// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <QWidget>
#include <glm/vec3.hpp>

class QPushButton;

namespace ui::devices {

/// Six buttons. While one is held, the device pushes the hand gently in its direction.
class ForceTest : public QWidget
{
    Q_OBJECT
public:
    static constexpr double kTestN = 0.8;

    explicit ForceTest(QWidget* parent);

    /// Returns the force of the held button, tooth frame, N. Zero if none is held.
    [[nodiscard]] glm::dvec3 force() const;

private:
    std::array<QPushButton*, 6> m_buttons{};
};

}  // namespace ui::devices
