// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <QWidget>

namespace ui::devices {

/// Three rings, one for each arm. A ring fills and gets a tick when its arm has passed the index mark.
class HomingMarks : public QWidget
{
    Q_OBJECT
public:
    explicit HomingMarks(QWidget* parent);

    void setHomed(const std::array<bool, 3>& homed);
    [[nodiscard]] const std::array<bool, 3>& homed() const { return m_homed; }
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void describe();

    std::array<bool, 3> m_homed{};
};

}  // namespace ui::devices
