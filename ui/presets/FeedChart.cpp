// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/presets/FeedChart.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QChart>
#include <QChartView>
#include <QEvent>
#include <QGraphicsLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLegend>
#include <QLineSeries>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QRegularExpression>
#include <QVBoxLayout>
#include <QValueAxis>

#include "core/drilling/Feed.h"
#include "ui/charts/SaveButton.h"
#include "ui/presets/PresetWords.h"
#include "ui/shell/Announce.h"
#include "ui/shell/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::presets {
namespace {

using core::settings::FeelPreset;
using core::settings::Substance;

constexpr double kMostN = 2.0;
constexpr double kToldN = 1.0;
constexpr double kStepN = 0.1;  ///< of the arrow keys
constexpr int kPoints = 80;

/// Pulp gives way at a touch: its line would only press the others flat.
struct Line
{
    Substance substance;
    QColor onLight;
    QColor onDark;
};
/// After Okabe and Ito, each readable on its page; the figures tell them apart as well.
const std::array<Line, 5> kLines{{{Substance::SoftCaries, "#8A4B00", "#E69F00"},
                                  {Substance::FirmCaries, "#B5478A", "#CC79A7"},
                                  {Substance::Plastic, "#5B6770", "#A9B4BC"},
                                  {Substance::Dentin, "#00785A", "#2FBF98"},
                                  {Substance::Enamel, "#0060A8", "#56B4E9"}}};

/// In one line, in any script: between Japanese signs a line breaks as it does at a space.
QString unbroken(const QString& words)
{
    static const QRegularExpression kBetweenSigns(
        QStringLiteral("(?<=[\\x{3000}-\\x{9fff}])(?=[\\x{3000}-\\x{9fff}])"));
    return words.toHtmlEscaped()
        .replace(kBetweenSigns, QStringLiteral("&#8288;"))
        .replace(u' ', QStringLiteral("&nbsp;"));
}

}  // namespace

FeedChart::FeedChart(QWidget* parent)
    : WalkedChart(kStepN, kMostN, parent), m_chart(new QChart), m_view(new QChartView(m_chart, this)),
      m_words(new QLabel(this))
{
    m_view->setRenderHint(QPainter::Antialiasing);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setFocusPolicy(Qt::NoFocus);
    m_view->viewport()->setMouseTracking(true);
    m_view->viewport()->installEventFilter(this);
    m_view->setBackgroundBrush(Qt::NoBrush);
    m_view->setStyleSheet(QStringLiteral("background: transparent"));
    m_chart->setMargins({0, 0, 0, 0});
    m_chart->layout()->setContentsMargins(0, 0, 0, 0);
    m_chart->setBackgroundVisible(false);
    m_words->setFont(shell::typeface(shell::kSmall));
    m_words->setTextFormat(Qt::RichText);
    m_words->setWordWrap(true);
    m_words->setObjectName(QStringLiteral("feedWords"));
    auto* save = new charts::SaveButton([this] { return chart(); }, this);
    save->beSmall();
    connect(save, &charts::SaveButton::told, this, [this](const QString& sentence) {
        say(sentence);
        shell::announce(*m_words);
    });
    auto* row = new QHBoxLayout;  // beside the curves, which rise to the corner
    row->setSpacing(0);
    row->addWidget(m_view, 1);
    row->addWidget(save, 0, Qt::AlignTop);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(shell::kSpace1, shell::kSpace1, shell::kSpace1, shell::kSpace1);
    column->setSpacing(shell::kSpace1);
    column->addLayout(row, 1);
    column->addWidget(m_words);
    text::inEveryLanguage(this, [this] {
        setAccessibleName(tr("Feed over force"));
        m_view->setAccessibleName(accessibleName());
        m_view->viewport()->setAccessibleName(accessibleName());
        draw();
    });
}

void FeedChart::setPreset(const FeelPreset& preset, const FeelPreset& was)
{
    m_preset = preset;
    m_was = was;
    draw();
}

void FeedChart::setTool(std::size_t bur, std::size_t handpiece)
{
    bur = std::min(bur, core::drilling::burs().size() - 1);
    handpiece = std::min(handpiece, core::settings::handpieces().size() - 1);
    const bool isOther = bur != m_bur || handpiece != m_handpiece;
    m_bur = bur;
    m_handpiece = handpiece;
    if (isOther)
        draw();
}

double FeedChart::feed(const FeelPreset& preset, Substance substance, double newtons) const
{
    return core::drilling::feedMmPerS(core::settings::hardnessOf(preset, substance), preset.axialShare,
                                      core::settings::handpieces()[m_handpiece], core::drilling::burs()[m_bur],
                                      newtons);
}

bool FeedChart::differsIn(Substance substance) const
{
    return m_was.axialShare != m_preset.axialShare ||
           core::settings::hardnessOf(m_was, substance) != core::settings::hardnessOf(m_preset, substance);
}

QString FeedChart::figure(Substance substance, double newtons) const
{
    //: %1 is a material, %2 a speed
    return tr("%1 %2 mm/s").arg(substanceName(substance), text::number(feed(m_preset, substance, newtons), 1));
}

QString FeedChart::words(double newtons) const
{
    QStringList parts;
    for (const Line& line : kLines)
        parts << figure(line.substance, newtons);
    return tr("Straight down with %1 N").arg(text::number(newtons, 1)) + QStringLiteral(": ") +
           parts.join(QStringLiteral(" · "));
}

charts::Line FeedChart::lineOf(const FeelPreset& preset, Substance substance, const QColor& colour,
                               const QString& name) const
{
    charts::Line line{name, {}, charts::Mark::Plain, true, colour};
    for (int k = 0; k <= std::lround(kMostN / kStepN); ++k) {
        const double newtons = kStepN * k;
        line.dots << charts::Dot{newtons, feed(preset, substance, newtons), words(newtons)};
    }
    return line;
}

charts::Chart FeedChart::chart() const
{
    charts::Curve curve;
    curve.x = {tr("Force, N"), 0.0, kMostN};
    double most = 0.5;
    for (const Line& line : kLines) {
        const QString name = substanceName(line.substance);
        curve.lines << lineOf(m_preset, line.substance, line.onLight, name);
        if (differsIn(line.substance))
            //: %1 is a material; its line is that of the preset before it was changed
            curve.lines << lineOf(m_was, line.substance, line.onLight, tr("%1, as it was kept").arg(name));
    }
    for (const charts::Line& line : curve.lines)
        most = std::max(most, line.dots.back().y);
    curve.y = {tr("Feed, mm/s"), 0.0, charts::roundEnd(most)};
    return {tr("Feed over force"), {}, {}, curve, QString::fromStdString(m_preset.name)};
}

void FeedChart::draw()
{
    m_chart->removeAllSeries();
    m_chart->setLocalizeNumbers(true);
    m_chart->setLocale(QLocale());
    for (QAbstractAxis* axis : m_chart->axes()) {
        m_chart->removeAxis(axis);
        delete axis;
    }
    const QPalette& p = palette();
    const bool dark = shell::isDark(p);
    double most = 0.5;
    for (const Line& line : kLines)
        for (const FeelPreset* preset : {&m_preset, &m_was})
            most = std::max(most, feed(*preset, line.substance, kMostN));
    const auto axis = [&](double high, const QString& title, Qt::Alignment side, const QString& format) {
        auto* made = new QValueAxis;
        made->setRange(0.0, high);
        made->setTitleText(title);
        made->setLabelFormat(format);
        made->setTickCount(5);
        made->setLabelsFont(shell::typeface(shell::kSmall));
        made->setTitleFont(shell::typeface(shell::kSmall));
        made->setLabelsColor(p.color(QPalette::PlaceholderText));
        made->setTitleBrush(p.color(QPalette::PlaceholderText));
        made->setLinePenColor(p.color(QPalette::Mid));
        made->setGridLineColor(p.color(QPalette::Mid));
        m_chart->addAxis(made, side);
        return made;
    };
    auto* force = axis(kMostN, tr("Force, N"), Qt::AlignBottom, QStringLiteral("%.1f"));
    auto* pace = axis(most, tr("Feed, mm/s"), Qt::AlignLeft, QStringLiteral("%.0f"));
    if (most > 4.0)
        pace->applyNiceNumbers();
    else
        pace->setLabelFormat(QStringLiteral("%.1f"));
    m_chart->legend()->hide();  // the figures below name the lines
    const auto put = [&](const FeelPreset& preset, const Line& line, const QPen& pen) {
        auto* series = new QLineSeries;
        for (int k = 0; k <= kPoints; ++k) {
            const double newtons = kMostN * k / kPoints;
            series->append(newtons, feed(preset, line.substance, newtons));
        }
        series->setPen(pen);
        m_chart->addSeries(series);
        series->attachAxis(force);
        series->attachAxis(pace);
    };
    for (const Line& line : kLines) {
        const QColor colour = dark ? line.onDark : line.onLight;
        QColor faint = colour;
        faint.setAlphaF(0.6F);
        if (differsIn(line.substance))
            put(m_was, line, QPen(faint, 1.4, Qt::DashLine));
        put(m_preset, line, QPen(colour, 2.2));
    }
    point(kToldN);
}

void FeedChart::point(double newtons)
{
    m_toldN = newtons;
    setAccessibleDescription(words(newtons));
    //: %1 is a force
    say(tr("Straight down with %1 N").arg(text::number(newtons, 1)));
}

void FeedChart::walkTo(double newtons)
{
    point(std::clamp(kStepN * std::round(newtons / kStepN), 0.0, kMostN));
    shell::announce(*this);
}

/// Each figure with the colour of its line.
void FeedChart::say(const QString& sentence)
{
    const bool dark = shell::isDark(palette());
    QStringList parts;
    for (const Line& line : kLines)
        parts << QStringLiteral("<span style=\"color:%1\"><b>━━</b></span>&nbsp;%2")
                     .arg((dark ? line.onDark : line.onLight).name(), unbroken(figure(line.substance, m_toldN)));
    const bool differs =
        std::any_of(kLines.begin(), kLines.end(), [this](const Line& line) { return differsIn(line.substance); });
    if (differs)
        parts << unbroken(tr("dashed: as it was kept"));
    m_words->setText(
        QStringLiteral("<b>%1</b><br>%2").arg(sentence.toHtmlEscaped(), parts.join(QStringLiteral(" &nbsp; "))));
}

void FeedChart::changeEvent(QEvent* event)
{
    WalkedChart::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        draw();
}

bool FeedChart::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::MouseMove && !m_chart->series().isEmpty()) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        const QPointF at =
            m_chart->mapToValue(m_chart->mapFromScene(m_view->mapToScene(mouse->pos())), m_chart->series().constLast());
        point(std::clamp(at.x(), 0.0, kMostN));
    } else if (event->type() == QEvent::Leave && !hasFocus()) {
        point(kToldN);
    }
    return WalkedChart::eventFilter(watched, event);
}

}  // namespace ui::presets
