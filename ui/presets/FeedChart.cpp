// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/presets/FeedChart.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QRegularExpression>
#include <QVBoxLayout>

#include "core/cutting/Feed.h"
#include "ui/charts/SaveButton.h"
#include "ui/kit/Accessibility.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/PresetTexts.h"
#include "ui/text/Texts.h"

namespace ui::presets {
namespace {

using core::settings::FeelPreset;
using core::settings::Substance;

constexpr double kMostN = 2.0;
constexpr double kToldN = 1.0;
constexpr double kStepN = 0.1;  ///< step of the arrow keys
constexpr int kPoints = 80;
constexpr int kRows = 20;  ///< rows of an exported table

/// The lines of the chart. Pulp is left out: it yields at a touch, and its line would flatten the others.
struct Line
{
    Substance substance;
    QColor onLight;
    QColor onDark;
    Qt::PenStyle inFiles;
};
/// Colours after Okabe and Ito, each readable on its background. On the screen the figures below distinguish the lines
/// as well, and in a file their strokes do.
const std::array<Line, 5> kLines{{{Substance::SoftCaries, "#8A4B00", "#E69F00", Qt::SolidLine},
                                  {Substance::FirmCaries, "#B5478A", "#CC79A7", Qt::DashLine},
                                  {Substance::Plastic, "#5B6770", "#A9B4BC", Qt::DashDotLine},
                                  {Substance::Dentin, "#00785A", "#2FBF98", Qt::DashDotDotLine},
                                  {Substance::Enamel, "#0060A8", "#56B4E9", Qt::SolidLine}}};

/// Returns text that stays on one line in any script. Japanese text may otherwise break between any two characters.
QString unbroken(const QString& words)
{
    static const QRegularExpression kBetweenSigns(
        QStringLiteral("(?<=[\\x{3000}-\\x{9fff}])(?=[\\x{3000}-\\x{9fff}])"));
    return words.toHtmlEscaped()
        .replace(kBetweenSigns, QStringLiteral("&#8288;"))
        .replace(u' ', QStringLiteral("&nbsp;"));
}

}  // namespace

FeedChart::FeedChart(QWidget* parent) : WalkedChart(parent), m_words(new QLabel(this))
{
    m_words->setFont(kit::typeface(kit::kSmall));
    m_words->setTextFormat(Qt::RichText);
    m_words->setWordWrap(true);
    m_words->setObjectName(QStringLiteral("feedWords"));
    auto* save = new charts::SaveButton([this] { return chart(); }, this);
    save->beSmall();
    connect(save, &charts::SaveButton::told, this, [this](const QString& sentence) {
        say(sentence);
        kit::announce(*m_words);
    });
    auto* row = new QHBoxLayout;  // beside the curves, which rise towards the corner
    row->setSpacing(0);
    row->addWidget(view(), 1);
    row->addWidget(save, 0, Qt::AlignTop);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kit::kSpace1, kit::kSpace1, kit::kSpace1, kit::kSpace1);
    column->setSpacing(kit::kSpace1);
    column->addLayout(row, 1);
    column->addWidget(m_words);
    text::bindTranslation(this, [this] {
        setAccessibleName(tr("Feed over force"));
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
    bur = std::min(bur, core::bur::burs().size() - 1);
    handpiece = std::min(handpiece, core::settings::handpieces().size() - 1);
    const bool isOther = bur != m_bur || handpiece != m_handpiece;
    m_bur = bur;
    m_handpiece = handpiece;
    if (isOther)
        draw();
}

double FeedChart::feed(const FeelPreset& preset, Substance substance, double newtons) const
{
    return core::cutting::feedMmPerS(core::settings::hardnessFor(preset, {}),
                                     core::settings::hardnessOf(preset, substance),
                                     core::settings::handpieces()[m_handpiece], core::bur::burs()[m_bur], newtons);
}

bool FeedChart::differsIn(Substance substance) const
{
    return m_was.axialShare != m_preset.axialShare || m_was.flatEndShare != m_preset.flatEndShare ||
           m_was.fullLoadN != m_preset.fullLoadN ||
           core::settings::hardnessOf(m_was, substance) != core::settings::hardnessOf(m_preset, substance);
}

QString FeedChart::figure(Substance substance, double newtons) const
{
    //: %1 is a material, %2 a speed
    return tr("%1 %2 mm/s").arg(text::substanceName(substance), text::number(feed(m_preset, substance, newtons), 1));
}

QString FeedChart::words(double newtons) const
{
    QStringList parts;
    for (const Line& line : kLines)
        parts << figure(line.substance, newtons);
    return tr("Straight down with %1 N").arg(text::number(newtons, 1)) + QStringLiteral(": ") +
           parts.join(QStringLiteral(" · "));
}

charts::Line FeedChart::lineOf(const FeelPreset& preset, Substance substance, int points) const
{
    charts::Line line{text::substanceName(substance), {}, charts::Mark::Plain};
    for (int k = 0; k <= points; ++k) {
        const double newtons = kMostN * k / points;
        line.dots << charts::Dot{newtons, feed(preset, substance, newtons), {}};
    }
    return line;
}

/// @param isShown  true on the screen, where the figures below name the lines
charts::Chart FeedChart::chart(bool isShown) const
{
    charts::Curve curve;
    curve.x = {tr("Force, N"), 0.0, kMostN};
    const bool isOnDark = isShown && kit::isDark(palette());
    const int points = isShown ? kPoints : kRows;
    double most = 0.5;
    for (const Line& one : kLines) {
        charts::Line line = lineOf(m_preset, one.substance, points);
        line.colour = isOnDark ? one.onDark : one.onLight;
        line.stroke = isShown ? Qt::SolidLine : one.inFiles;
        curve.lines << line;
        if (!differsIn(one.substance))
            continue;
        line.dots = lineOf(m_was, one.substance, points).dots;
        //: %1 is a material; its line is that of the preset before it was changed
        line.name = tr("%1, as it was kept").arg(line.name);
        line.colour.setAlphaF(0.6F);
        line.stroke = isShown ? Qt::DashLine : Qt::DotLine;
        line.widthPx = 1.4;
        curve.lines << line;
    }
    for (charts::Line& line : curve.lines) {
        most = std::max(most, line.dots.back().y);
        if (isShown)
            line.name.clear();
    }
    curve.y = {tr("Feed, mm/s"), 0.0, 5.0 * charts::roundEnd(most / 5.0)};
    return {tr("Feed over force"), {}, {}, curve, QString::fromStdString(m_preset.name)};
}

void FeedChart::draw()
{
    setDrawn(chart(true));
    tell(kToldN);
}

void FeedChart::tell(double newtons)
{
    m_toldN = newtons;
    setAccessibleDescription(words(newtons));
    //: %1 is a force
    say(tr("Straight down with %1 N").arg(text::number(newtons, 1)));
}

void FeedChart::walk(charts::Step step)
{
    tell(stepped(step, m_toldN, kStepN, kMostN));
    kit::announce(*this);
}

void FeedChart::point(std::optional<QPointF> at)
{
    tell(at ? std::clamp(plot().xAt(at->x()), 0.0, kMostN) : kToldN);
}

/// Shows each figure in the colour of its line.
void FeedChart::say(const QString& sentence)
{
    const bool dark = kit::isDark(palette());
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

}  // namespace ui::presets
