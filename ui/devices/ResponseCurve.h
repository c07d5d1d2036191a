// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include <QWidget>

namespace ui::devices {

/// A small chart of the response to an input over its range, with a point at the current input.
class ResponseCurve : public QWidget
{
    Q_OBJECT
public:
    /// Maps an input, 0 to 1, to an output, 0 to 1.
    using Curve = std::function<double(double input)>;

    explicit ResponseCurve(QWidget* parent);

    void setCurve(Curve curve);
    /// @param input  0 to 1; empty: no point
    void setInput(std::optional<double> input);
    /// Sets the name for screen readers, which is also the tooltip.
    void setName(const QString& name);
    [[nodiscard]] QSize sizeHint() const override { return {180, 120}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Curve m_curve;
    std::optional<double> m_input;
};

}  // namespace ui::devices
