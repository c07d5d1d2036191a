// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <QWidget>

#include "core/tracking/TrackerReport.h"

namespace ui::kit {
class TabularDigitsLabel;
}

namespace ui::devices {

/// Figures on the quality of head tracking: frame rate, share of frames with the tag, processing time, latency and
/// jitter.
class TrackingFigures : public QWidget
{
    Q_OBJECT
public:
    explicit TrackingFigures(QWidget* parent);

    void setReport(const core::tracking::TrackerReport& report);
    /// Replaces the figures by dashes.
    void clear();

private:
    std::array<kit::TabularDigitsLabel*, 5> m_values{};
};

}  // namespace ui::devices
