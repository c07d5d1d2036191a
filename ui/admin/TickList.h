// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListWidget>

namespace ui::admin {

/// A list that takes the height left by the fields, but shows at least three lines.
class TickList final : public QListWidget
{
public:
    using QListWidget::QListWidget;
    [[nodiscard]] QSize sizeHint() const override { return minimumSizeHint(); }
    [[nodiscard]] QSize minimumSizeHint() const override
    {
        constexpr int kLeastPx = 110;
        return {QListWidget::minimumSizeHint().width(), kLeastPx};
    }
};

}  // namespace ui::admin
