// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/SweepChart.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QAreaSeries>
#include <QChart>
#include <QChartView>
#include <QEvent>
#include <QGraphicsLayout>
#include <QHBoxLayout>
#include <QLegendMarker>
#include <QLineSeries>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QValueAxis>

#include "ui/charts/SaveButton.h"
#include "ui/shell/Announce.h"
#include "ui/shell/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::study {
namespace {

/// More lines than these nobody tells apart.
constexpr std::size_t kMostLines = 30;
constexpr double kFullPoints = 100.0;
constexpr double kStepTimes = kMostTimes / (kSweepSteps - 1);  ///< of the arrow keys

int quantile(const Sweep& sweep, std::size_t step, double share)
{
    std::vector<int> all;
    for (const Sweep::Line& line : sweep.lines)
        all.push_back(line.tenths[step]);
    std::sort(all.begin(), all.end());
    return all[static_cast<std::size_t>(std::lround(share * static_cast<double>(all.size() - 1)))];
}

}  // namespace

SweepChart::SweepChart(QWidget* parent)
    : WalkedChart(kStepTimes, kMostTimes, parent), m_chart(new QChart), m_view(new QChartView(m_chart, this))
{
    m_view->setRenderHint(QPainter::Antialiasing);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setFocusPolicy(Qt::NoFocus);
    m_view->viewport()->setMouseTracking(true);
    m_view->viewport()->installEventFilter(this);
    m_chart->setMargins({0, 0, 0, 0});
    m_chart->layout()->setContentsMargins(0, 0, 0, 0);
    m_save = new charts::SaveButton([this] { return chart(); }, this);
    m_save->beSmall();
    connect(m_save, &charts::SaveButton::told, this, &SweepChart::saved);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(shell::kSpace1, shell::kSpace1, shell::kSpace1, shell::kSpace1);
    row->setSpacing(0);
    row->addWidget(m_view, 1);
    row->addWidget(m_save, 0, Qt::AlignTop);
    text::inEveryLanguage(this, [this] {
        for (QWidget* part : {static_cast<QWidget*>(this), static_cast<QWidget*>(m_view), m_view->viewport()})
            part->setAccessibleName(tr("Scores of past attempts over the tolerance"));
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
    draw();
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
        charts::Line made{name, {}, charts::Mark::Plain, true, {}};
        for (std::size_t step = 0; step < m_sweep.times.size(); ++step) {
            const double points = 0.1 * tenthsAt(step);
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
    const QString title = tr("Scores of past attempts over the tolerance");
    if (m_sweep.lines.empty())
        return {title, {}, {}, charts::Curve()};
    charts::Curve curve;
    curve.x = {tr("Times the tolerance"), 0.0, kMostTimes};
    curve.y = {tr("Points"), 0.0, kFullPoints};
    curve.lines = attemptLines();
    const shell::Tones tone = shell::tones(shell::pagePalette(false));
    for (charts::Line& line : curve.lines)
        line.colour = tone.accent;
    charts::Line median{tr("Median"), {}, charts::Mark::Plain, true, Qt::black};
    charts::Line passed{tr("Attempts that pass, %"), {}, charts::Mark::Plain, true, tone.attention};
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
    return {title, {}, {}, curve};
}

void SweepChart::walkTo(double times)
{
    if (m_sweep.lines.empty())
        return;
    m_toldTimes = std::clamp(times, 0.0, kMostTimes);
    setAccessibleDescription(words(m_toldTimes));
    emit pointedAt(words(m_toldTimes));
    shell::announce(*this);
}

void SweepChart::draw()
{
    m_chart->removeAllSeries();
    m_chart->setLocalizeNumbers(true);
    m_chart->setLocale(QLocale());
    for (QAbstractAxis* axis : m_chart->axes()) {
        m_chart->removeAxis(axis);
        delete axis;
    }
    const QPalette& p = palette();
    const shell::Tones tone = shell::tones(p);
    m_chart->setBackgroundVisible(false);
    m_view->setBackgroundBrush(Qt::NoBrush);
    m_view->setStyleSheet(QStringLiteral("background: transparent"));
    m_chart->legend()->setAlignment(Qt::AlignBottom);
    m_chart->legend()->setMarkerShape(QLegend::MarkerShapeFromSeries);
    m_chart->legend()->setLabelColor(p.color(QPalette::WindowText));
    m_chart->legend()->setFont(shell::typeface(shell::kSmall));
    const auto axis = [&](double high, const QString& title, Qt::Alignment side, const QString& format) {
        auto* made = new QValueAxis;
        made->setRange(0.0, high);
        made->setTitleText(title);
        made->setLabelFormat(format);
        made->setLabelsFont(shell::typeface(shell::kSmall));
        made->setTitleFont(shell::typeface(shell::kSmall));
        made->setLabelsColor(p.color(QPalette::PlaceholderText));
        made->setTitleBrush(p.color(QPalette::PlaceholderText));
        made->setLinePenColor(p.color(QPalette::Mid));
        made->setGridLineColor(p.color(QPalette::Mid));
        m_chart->addAxis(made, side);
        return made;
    };
    auto* times = axis(kMostTimes, tr("Times the tolerance"), Qt::AlignBottom, QStringLiteral("%.1f"));
    times->setTickCount(7);
    auto* points = axis(kFullPoints, tr("Points"), Qt::AlignLeft, QStringLiteral("%.0f"));
    points->setTickCount(6);
    const auto attach = [&](QAbstractSeries* series, QAbstractAxis* upright) {
        m_chart->addSeries(series);
        series->attachAxis(times);
        series->attachAxis(upright);
    };
    const auto hideInLegend = [&](QAbstractSeries* series) {
        for (QLegendMarker* marker : m_chart->legend()->markers(series))
            marker->setVisible(false);
    };
    const auto lineOf = [&](const auto& tenthsAt, const QPen& pen, const QString& name) {
        auto* line = new QLineSeries;
        for (std::size_t step = 0; step < m_sweep.times.size(); ++step)
            line->append(m_sweep.times[step], 0.1 * tenthsAt(step));
        line->setPen(pen);
        line->setName(name);
        return line;
    };
    if (m_sweep.lines.empty())
        return;
    if (m_sweep.lines.size() <= kMostLines) {
        QColor faint = tone.accent;
        faint.setAlphaF(0.55F);
        bool isFirst = true;
        for (const Sweep::Line& one : m_sweep.lines) {
            auto* line =
                lineOf([&](std::size_t step) { return one.tenths[step]; }, QPen(faint, 1.4), tr("Each attempt"));
            attach(line, points);
            connect(line, &QLineSeries::hovered, this, [this, name = one.name](const QPointF& at, bool isOver) {
                if (isOver)
                    //: %1: the name of a file, or which line
                    emit pointedAt(tr("%1: %2 points at %3 times the tolerance")
                                       .arg(name, text::number(at.y(), 1), text::number(at.x(), 1)));
            });
            if (!std::exchange(isFirst, false))
                hideInLegend(line);
        }
    } else {
        auto* low = lineOf([&](std::size_t s) { return quantile(m_sweep, s, 0.25); }, Qt::NoPen, {});
        auto* high = lineOf([&](std::size_t s) { return quantile(m_sweep, s, 0.75); }, Qt::NoPen, {});
        auto* half = new QAreaSeries(high, low);
        low->setParent(half);
        high->setParent(half);
        QColor faint = tone.accent;
        faint.setAlphaF(0.3F);
        half->setBrush(faint);
        half->setPen(Qt::NoPen);
        half->setName(tr("Middle half"));
        attach(half, points);
    }
    attach(lineOf([&](std::size_t s) { return m_sweep.medianTenths(s); }, QPen(p.color(QPalette::WindowText), 2.4),
                  tr("Median")),
           points);
    attach(lineOf([&](std::size_t) { return m_sweep.passMarkTenths; },
                  QPen(p.color(QPalette::PlaceholderText), 1.2, Qt::DotLine), tr("Pass mark")),
           points);
    auto* counts = axis(static_cast<double>(m_sweep.lines.size()), tr("Attempts that pass"), Qt::AlignRight,
                        QStringLiteral("%.0f"));
    counts->setGridLineVisible(false);
    counts->setTickType(QValueAxis::TicksDynamic);
    counts->setTickAnchor(0.0);
    counts->setTickInterval(std::max(1.0, std::ceil(static_cast<double>(m_sweep.lines.size()) / 5.0)));
    auto* passed = new QLineSeries;
    for (std::size_t step = 0; step < m_sweep.times.size(); ++step)
        passed->append(m_sweep.times[step], m_sweep.passed[step]);
    passed->setPen(QPen(tone.attention, 2.0, Qt::DashLine));
    passed->setName(tr("Attempts that pass"));
    attach(passed, counts);
    // What is in force.
    auto* now = new QLineSeries;
    now->append(1.0, 0.0);
    now->append(1.0, kFullPoints);
    now->setPen(QPen(p.color(QPalette::Link), 1.6));
    now->setName(tr("As set"));
    attach(now, points);
}

void SweepChart::changeEvent(QEvent* event)
{
    WalkedChart::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        draw();
}

bool SweepChart::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::MouseMove && !m_sweep.lines.empty()) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        const QPointF at =
            m_chart->mapToValue(m_chart->mapFromScene(m_view->mapToScene(mouse->pos())), m_chart->series().constLast());
        emit pointedAt(words(at.x()));
    } else if (event->type() == QEvent::Leave && !hasFocus()) {
        emit pointedAt({});
    }
    return WalkedChart::eventFilter(watched, event);
}

}  // namespace ui::study
