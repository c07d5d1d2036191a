// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessoneditor/SweepChart.h"

#include <algorithm>
#include <cmath>

#include <QEvent>
#include <QHBoxLayout>

#include "ui/charts/SaveButton.h"
#include "ui/kit/Accessibility.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::lessoneditor {
namespace {

/// More lines than these could not be told apart.
constexpr std::size_t kMostLines = 30;
constexpr double kFullPoints = 100.0;
constexpr double kStepTimes = kMostTimes / (kSweepSteps - 1);  ///< factor of one press of an arrow key
constexpr double kReachPx = 6.0;                               ///< distance from the pointer to an attempt's line

int quantile(const Sweep& sweep, std::size_t step, double share)
{
    std::vector<int> all;
    for (const Sweep::Line& line : sweep.lines)
        all.push_back(line.tenths[step]);
    std::sort(all.begin(), all.end());
    return all[static_cast<std::size_t>(std::lround(share * static_cast<double>(all.size() - 1)))];
}

}  // namespace

SweepChart::SweepChart(QWidget* parent) : WalkedChart(parent)
{
    m_save = new charts::SaveButton([this] { return chart(); }, this);
    m_save->beSmall();
    connect(m_save, &charts::SaveButton::told, this, &SweepChart::saved);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kit::kSpace1, kit::kSpace1, kit::kSpace1, kit::kSpace1);
    row->setSpacing(0);
    row->addWidget(view(), 1);
    row->addWidget(m_save, 0, Qt::AlignTop);
    text::bindTranslation(this, [this] {
        setAccessibleName(tr("Scores of past attempts over the tolerance"));
        setSweep(m_sweep);
    });
}

void SweepChart::setSweep(const Sweep& sweep)
{
    if (&sweep != &m_sweep)
        m_sweep = sweep;
    m_toldTimes = 1.0;
    setAccessibleDescription(words(m_toldTimes));
    m_save->setVisible(!m_sweep.lines.empty());
    setDrawn(chartIn(palette()));
}

QString SweepChart::words(double times) const
{
    if (m_sweep.lines.empty())
        return {};
    const std::size_t step = m_sweep.stepOf(times);
    //: %1: a number, "1.5"; %2 of %3 attempts; %4: points
    return tr("At %1 times the tolerance %2 of %3 pass; median %4")
        .arg(text::number(m_sweep.times[step], 1))
        .arg(m_sweep.passed[step])
        .arg(m_sweep.lines.size())
        .arg(text::points(m_sweep.medianTenths(step)));
}

QList<charts::Line> SweepChart::attemptLines() const
{
    const auto line = [this](const QString& name, const auto& tenthsAt, const QString& of) {
        charts::Line made{name, {}, charts::Mark::Plain};
        for (std::size_t step = 0; step < m_sweep.times.size(); ++step) {
            const double points = 0.1 * tenthsAt(step);
            //: %1: the name of a file, or which line
            const QString words =
                tr("%1: %2 points at %3 times the tolerance")
                    .arg(of.isEmpty() ? name : of, text::number(points, 1), text::number(m_sweep.times[step], 1));
            made.dots << charts::Dot{m_sweep.times[step], points, words, 0, of};
        }
        return made;
    };
    if (m_sweep.lines.size() > kMostLines)
        return {line(tr("Lower quartile"), [this](std::size_t s) { return quantile(m_sweep, s, 0.25); }, {}),
                line(tr("Upper quartile"), [this](std::size_t s) { return quantile(m_sweep, s, 0.75); }, {})};
    QList<charts::Line> lines;
    for (const Sweep::Line& one : m_sweep.lines)
        lines << line(
            tr("Each attempt"), [&one](std::size_t step) { return one.tenths[step]; }, one.name);
    return lines;
}

charts::Chart SweepChart::chart() const
{
    return chartIn(kit::pagePalette(false));
}

charts::Chart SweepChart::chartIn(const QPalette& palette) const
{
    charts::Curve curve;
    curve.x = {tr("Times the tolerance"), 0.0, kMostTimes};
    curve.y = {tr("Points"), 0.0, kFullPoints};
    if (!m_sweep.lines.empty()) {
        const kit::Tones tone = kit::tones(palette);
        curve.lines = attemptLines();
        for (charts::Line& line : curve.lines) {
            line.colour = tone.accent;
            line.colour.setAlphaF(0.55F);
            line.widthPx = 1.4;
        }
        charts::Line median{tr("Median"), {}, charts::Mark::Plain, true, palette.color(QPalette::WindowText)};
        median.widthPx = 2.4;
        charts::Line passed{tr("Attempts that pass, %"), {}, charts::Mark::Plain, true, tone.attention, Qt::DashLine};
        for (std::size_t step = 0; step < m_sweep.times.size(); ++step) {
            const double times = m_sweep.times[step];
            const double share = 100.0 * m_sweep.passed[step] / static_cast<double>(m_sweep.lines.size());
            median.dots << charts::Dot{times, 0.1 * m_sweep.medianTenths(step), words(times)};
            passed.dots << charts::Dot{times, share, words(times)};
        }
        curve.lines << median << passed;
        curve.limits = {{0.1 * m_sweep.passMarkTenths, false, tr("Pass mark")}, {1.0, true, tr("As set")}};
        if (m_sweep.lines.size() <= kMostLines)
            curve.ofTitle = tr("Recording");
    }
    return {tr("Scores of past attempts over the tolerance"), {}, {}, curve};
}

void SweepChart::walk(charts::Step step)
{
    m_toldTimes = stepped(step, m_toldTimes, kStepTimes, kMostTimes);
    setAccessibleDescription(words(m_toldTimes));
    emit pointedAt(words(m_toldTimes));
    kit::announce(*this);
}

void SweepChart::point(std::optional<QPointF> at)
{
    if (!at || m_sweep.lines.empty()) {
        emit pointedAt({});
        return;
    }
    const charts::Plot plot = this->plot();
    QString told = words(plot.xAt(at->x()));
    double nearestPx = kReachPx;
    for (const charts::Dot& dot : charts::stopsOf(drawn())) {
        const QPointF away = plot.at(dot.x, dot.y) - *at;
        if (const double awayPx = std::hypot(away.x(), away.y()); awayPx < nearestPx) {
            nearestPx = awayPx;
            told = dot.words;
        }
    }
    emit pointedAt(told);
}

void SweepChart::changeEvent(QEvent* event)
{
    WalkedChart::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        setDrawn(chartIn(palette()));
}

}  // namespace ui::lessoneditor
