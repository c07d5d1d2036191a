// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/settings/FeelPreset.h"
#include "ui/charts/Chart.h"
#include "ui/charts/WalkedChart.h"

class QLabel;

namespace ui::presets {

/// A chart of the speed in mm/s at which the selected bur sinks into each material, against the push force. Dashed
/// lines show the preset on which this one is based. The chart shows the figures at the pointer or at the position of
/// the arrow keys, and can be exported.
class FeedChart : public charts::WalkedChart
{
    Q_OBJECT
public:
    explicit FeedChart(QWidget* parent);

    void setPreset(const core::settings::FeelPreset& preset, const core::settings::FeelPreset& was);
    /// @param bur        index into core::bur::burs()
    /// @param handpiece  index into core::settings::handpieces()
    void setTool(std::size_t bur, std::size_t handpiece = 0);
    /// Returns the figures in words: "At 1.0 N: enamel 0.8 mm/s, ...".
    [[nodiscard]] QString words(double newtons) const;
    /// Returns the chart for export. Each curve is named by its material.
    [[nodiscard]] charts::Chart chart() const { return chart(false); }
    [[nodiscard]] QSize minimumSizeHint() const override { return {300, 200}; }

protected:
    void walk(charts::Step step) override;
    void point(std::optional<QPointF> at) override;
    void changeEvent(QEvent* event) override;

private:
    void draw();
    void tell(double newtons);
    [[nodiscard]] charts::Chart chart(bool isShown) const;
    /// Shows a sentence with the figures at m_toldN below it.
    void say(const QString& sentence);
    [[nodiscard]] charts::Line lineOf(const core::settings::FeelPreset& preset, core::settings::Substance substance,
                                      int points) const;
    [[nodiscard]] bool differsIn(core::settings::Substance substance) const;
    [[nodiscard]] QString figure(core::settings::Substance substance, double newtons) const;
    [[nodiscard]] double feed(const core::settings::FeelPreset& preset, core::settings::Substance substance,
                              double newtons) const;

    QLabel* m_words;
    core::settings::FeelPreset m_preset;
    core::settings::FeelPreset m_was;
    std::size_t m_bur = 1;
    std::size_t m_handpiece = 0;
    double m_toldN = 0.0;
};

}  // namespace ui::presets
