// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/practice/SidePanel.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/kit/Actions.h"
#include "ui/kit/ForceBar.h"
#include "ui/kit/MaterialSwatch.h"
#include "ui/kit/ScrollPane.h"
#include "ui/kit/TabularDigitsLabel.h"
#include "ui/kit/Theme.h"
#include "ui/practice/BurChooser.h"
#include "ui/practice/DrillSwitch.h"
#include "ui/practice/HandControls.h"
#include "ui/practice/HandpieceChooser.h"
#include "ui/practice/Limit.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"
#include "ui/tooth/PointerControl.h"

namespace ui::practice {
namespace {

using core::terrain::Material;
using lessons::ShownTarget;

constexpr int kWidthPx = 272;
constexpr double kRpmStep = 1000.0;  ///< a smaller change of speed is not shown
constexpr int kSwatchPx = 18;
/// Least interval between changes of text and digits. Faster changes would blur the last digit.
constexpr qint64 kWordsEveryMs = 80;
/// A smaller force is friction, which the user does not notice.
constexpr double kSidewaysFromN = 0.15;
/// In the air, a smaller force is vibration of the bur (core::contact::BurVibration) and not a push.
constexpr double kTrembleN = 0.2;
/// Distance to the pulp. Below the first a lining is needed, and below the second the pulp is harmed (docs/teeth.md,
/// "Ideal preparations").
constexpr double kThinMm = 1.0;
constexpr double kHarmfulMm = 0.5;

std::size_t at(Material material)
{
    return static_cast<std::size_t>(material);
}

QLabel* quietLabel(QWidget* parent)
{
    auto* label = new QLabel(parent);
    label->setFont(kit::typeface(kit::kSmall));
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

QString dash()
{
    return QStringLiteral("–");
}

}  // namespace

SidePanel::SidePanel(kit::Actions& actions, tooth::ToothView& view, QWidget* parent) : QFrame(parent)
{
    setProperty("kind", "bar");
    text::bindTranslation(this, [this] { setAccessibleName(tr("Live figures and handpiece")); });
    setFixedWidth(kWidthPx);

    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(kit::kSpace4, kit::kSpace4, kit::kSpace4, kit::kSpace2);
    column->setSpacing(kit::kSpace2);

    column->addWidget(new DrillSwitch(actions.drill, content));
    m_hand = new HandControls(view, content);
    column->addWidget(m_hand);
    column->addSpacing(kit::kSpace1);

    addFigures(column, content);
    m_health = new QLabel(content);
    m_health->setFont(kit::typeface(kit::kSmall, QFont::Medium));
    m_health->setWordWrap(true);
    m_health->setObjectName(QStringLiteral("health"));
    m_health->hide();
    column->addWidget(m_health);

    column->addSpacing(kit::kSpace1);
    column->addWidget(kit::line(content));
    auto* burRow = new QHBoxLayout;
    m_burWords = quietLabel(content);
    burRow->addWidget(m_burWords);
    burRow->addStretch(1);
    m_rpm = new kit::TabularDigitsLabel(content);
    m_rpm->setFont(kit::typeface(kit::kSmall, QFont::Medium));
    m_rpm->setObjectName(QStringLiteral("burRpm"));
    burRow->addWidget(m_rpm);
    column->addLayout(burRow);
    column->addWidget(new BurChooser(actions, content));
    column->addWidget(new HandpieceChooser(actions.handpieces, content));

    addVolumes(column, content);
    column->addStretch(1);

    auto* fill = new QVBoxLayout(this);
    fill->setContentsMargins(0, 0, 0, 0);
    fill->addWidget(new kit::ScrollPane(content, QPalette::Base, this));

    text::bindTranslation(this, [this] {
        retranslateUi();
        nameFigures();
        // The newest figures arrive with the next frame.
        m_sinceWords.invalidate();
        setFigures({}, {}, {});
        m_sinceWords.invalidate();
    });
}

void SidePanel::addFigures(QVBoxLayout* column, QWidget* content)
{
    m_swatch = new kit::MaterialSwatch(28, content);
    m_material = addFigure(column, "materialFigure", m_swatch);
    column->addSpacing(kit::kSpace1);
    m_forceBar = new kit::ForceBar(tooth::PointerControl::kStrongestN, content);
    m_force = addFigure(column, "forceFigure");
    column->addWidget(m_forceBar);
    column->addSpacing(kit::kSpace1);
    auto* pair = new QHBoxLayout;
    pair->setSpacing(kit::kSpace2);
    m_depth = addFigure(pair, "depthFigure");
    m_pulp = addFigure(pair, "pulpFigure");
    pair->setStretch(0, 1);
    pair->setStretch(1, 1);
    column->addLayout(pair);
    auto* asked = new QHBoxLayout;
    asked->setSpacing(kit::kSpace2);
    m_decay = addFigure(asked, "decayFigure");
    m_margin = addFigure(asked, "marginFigure");
    asked->setStretch(0, 1);
    asked->setStretch(1, 1);
    column->addLayout(asked);
}

/// Adds the figures for the volumes removed so far, one for each tissue.
void SidePanel::addVolumes(QVBoxLayout* column, QWidget* content)
{
    m_removedBlock = new QWidget(content);
    auto* volumes = new QVBoxLayout(m_removedBlock);
    volumes->setContentsMargins(0, kit::kSpace1, 0, 0);
    volumes->setSpacing(kit::kSpace1);
    volumes->addWidget(kit::line(m_removedBlock));
    volumes->addSpacing(kit::kSpace1);
    m_removedWords = quietLabel(m_removedBlock);
    volumes->addWidget(m_removedWords);
    volumes->addSpacing(kit::kSpace1);
    column->addWidget(m_removedBlock);
    const auto addVolume = [&](QWidget* before, QLabel* words, const char* objectName) {
        auto* block = new QWidget(m_removedBlock);
        auto* row = new QHBoxLayout(block);
        row->setContentsMargins(0, 0, 0, 0);
        row->setSpacing(kit::kSpace2);
        auto* value = new kit::TabularDigitsLabel(block);
        value->setFont(kit::typeface(kit::kBody, QFont::Medium));
        value->setAlignment(Qt::AlignRight);
        value->setObjectName(QString::fromLatin1(objectName));
        if (before != nullptr)
            row->addWidget(before);
        row->addWidget(words);
        row->addStretch(1);
        row->addWidget(value);
        volumes->addWidget(block);
        return value;
    };
    const auto addMaterial = [&](Material material, const char* objectName) {
        auto* swatch = new kit::MaterialSwatch(kSwatchPx, content);
        swatch->setMaterial(material);
        auto* name = new QLabel(content);
        kit::TabularDigitsLabel* value = addVolume(swatch, name, objectName);
        m_removedNames.at(at(material)) = name;
        if (material == Material::Enamel)
            m_enamelSwatch = swatch;
        m_removed.at(at(material)) = value;
    };
    addMaterial(Material::Enamel, "enamelRemoved");
    addMaterial(Material::Dentin, "dentinRemoved");
    addMaterial(Material::Pulp, "pulpRemoved");
    // The part of the removed enamel and dentin that the grade counts. It excludes what is vertically above the decay.
    // It is a line of its own, because it is not another tissue.
    volumes->addSpacing(kit::kSpace1);
    m_overcutWords = new QLabel(content);
    m_overcut = addVolume(nullptr, m_overcutWords, "overcut");
    m_overcutRow = m_overcut->parentWidget();
}

void SidePanel::retranslateUi()
{
    name(m_material, tr("Under the bur"));
    name(m_force, tr("Force"));
    name(m_depth, tr("Depth"));
    m_depth.block->setToolTip(
        kit::brokenIntoLines(tr("Depth of the tip below the original surface. No value is shown at the edge of the "
                                "tooth, where a vertical depth means little.")));
    name(m_pulp, tr("To the pulp"));
    m_pulp.block->setToolTip(kit::brokenIntoLines(
        tr("Shortest distance from the head of the bur to the pulp, downwards or sideways. Leave two "
           "millimetres; less than half a millimetre harms the pulp.")));
    //: How far the bur is from what is to be kept
    name(m_margin, tr("To the limit"));
    m_margin.block->setToolTip(
        kit::brokenIntoLines(tr("Distance from the head of the bur to tissue that must be kept, downwards or sideways. "
                                "No value is shown above one millimetre.")));
    m_removedWords->setText(tr("Removed"));
    m_removed.at(at(Material::Pulp))
        ->setToolTip(kit::brokenIntoLines(tr("Area of opened pulp, seen from above. The grade uses this figure.")));
    m_burWords->setText(tr("Bur"));
    m_rpm->setToolTip(
        kit::brokenIntoLines(tr("Speed of the bur in revolutions per minute. Load slows it down until it stalls")));
}

void SidePanel::name(Figure& figure, const QString& caption)
{
    figure.caption = caption;
    figure.words->setText(caption);
}

SidePanel::Figure SidePanel::addFigure(QBoxLayout* layout, const char* objectName, QWidget* before)
{
    auto* block = new QWidget;
    auto* lines = new QVBoxLayout(block);
    lines->setContentsMargins(0, 0, 0, 0);
    lines->setSpacing(0);
    auto* words = quietLabel(block);
    words->setWordWrap(true);
    lines->addStretch(1);
    lines->addWidget(words);
    auto* row = new QHBoxLayout;
    row->setSpacing(kit::kSpace2);
    if (before != nullptr)
        row->addWidget(before);
    auto* value = new kit::TabularDigitsLabel(block);
    value->setFont(kit::typeface(kit::kFigure, QFont::Medium));
    value->setObjectName(QString::fromLatin1(objectName));
    row->addWidget(value, 1);
    lines->addLayout(row);
    layout->addWidget(block);
    return {block, {}, words, value};
}

void SidePanel::setFigure(const Figure& figure, const QString& words, const QString& unit, const QColor& colour)
{
    figure.value->setText(words, unit);
    figure.value->setColour(colour);
    figure.block->setAccessibleName(QStringLiteral("%1: %2 %3").arg(figure.caption, words, unit));
}

void SidePanel::setColours(render::Palette colours)
{
    for (kit::MaterialSwatch* swatch : findChildren<kit::MaterialSwatch*>())
        swatch->setColours(colours);
}

void SidePanel::setTold(bool depth, bool pulp)
{
    m_tellsDepth = depth;
    m_tellsPulp = pulp;
    showFigures();
}

void SidePanel::setBlindfold(bool on)
{
    m_blindfold = on;
    showFigures();
}

/// Shows the figures that are permitted and have a value.
void SidePanel::showFigures()
{
    for (QWidget* telling : {m_material.block, m_removedBlock})
        telling->setVisible(!m_blindfold);
    const bool tells = m_target != ShownTarget::Nothing && !m_blindfold;
    m_depth.block->setVisible(m_tellsDepth && tells);
    m_decay.block->setVisible(tells);
    m_overcutRow->setVisible(tells);
    // A figure without a value is hidden but keeps its space, so that the other figures do not move.
    const auto show = [](const Figure& figure, bool isTold, bool hasValue) {
        QSizePolicy policy = figure.block->sizePolicy();
        policy.setRetainSizeWhenHidden(isTold);
        figure.block->setSizePolicy(policy);
        figure.block->setVisible(isTold && hasValue);
    };
    show(m_pulp, m_tellsPulp && tells && !m_isBlock, m_hasPulp);
    show(m_margin, tells, m_hasMargin);
    for (const Material material : {Material::Dentin, Material::Pulp})
        m_removed.at(at(material))->parentWidget()->setVisible(!m_isBlock);
    for (QWidget* swatch : {m_swatch, m_enamelSwatch})
        swatch->setVisible(!m_isBlock);
}

QString SidePanel::nameOf(Material material) const
{
    if (m_isBlock && (material == Material::Enamel || material == Material::Dentin))
        //: What a practice block is made of, in place of "Enamel"
        return tr("Block");
    return text::capitalised(text::materialName(material));
}

void SidePanel::setFigures(const core::servo::ServoState& servo, const core::session::SessionState& session,
                           const core::imaging::DepthReading& reading)
{
    const double feltN = glm::length(servo.forceN);
    const double forceN = servo.touching || feltN > kTrembleN ? feltN : 0.0;
    const bool limited = (servo.health & core::servo::kForceClamped) != 0;
    m_forceBar->setForce(forceN, m_hand->pushForce(), limited);
    if (m_sinceWords.isValid() && m_sinceWords.elapsed() < kWordsEveryMs)
        return;
    m_sinceWords.start();

    const kit::Tones tone = kit::tones(palette());
    const QColor quiet = palette().color(QPalette::PlaceholderText);
    const bool inPulp = servo.touching && servo.materialUnderBur == Material::Pulp;
    m_swatch->setMaterial(servo.touching ? std::optional(servo.materialUnderBur) : std::nullopt);
    if (servo.touching)
        setFigure(m_material, nameOf(servo.materialUnderBur), {}, inPulp ? tone.harmText : QColor());
    else if (servo.handpieceOnCrown)
        setFigure(m_material, tr("Handpiece"), {}, quiet);
    else
        setFigure(m_material, tr("Air", "the bur touches nothing"), {}, quiet);
    //: Turns a minute
    m_rpm->setText(text::number(std::round(servo.burRpm / kRpmStep) * kRpmStep, 0), tr("rpm"));
    const double sidewaysN = glm::length(glm::dvec2(servo.forceN));
    QString unit = QStringLiteral("N");
    if (limited)
        //: Unit of the force while the wanted force is beyond what the device may give
        unit = tr("N, limited");
    else if (sidewaysN > kSidewaysFromN)
        //: Unit of the force, and how much of it comes from a wall that presses sideways
        unit = tr("N, %1 sideways").arg(text::number(sidewaysN, 1));
    setFigure(m_force, text::number(forceN, 2), unit, limited ? tone.attentionText : QColor());
    if (reading.overTooth)
        setFigure(m_depth, text::number(reading.depthMm, 2), QStringLiteral("mm"));
    else
        setFigure(m_depth, dash(), QStringLiteral("mm"), quiet);
    if (reading.toPulpMm) {
        const double left = *reading.toPulpMm;
        setFigure(m_pulp, text::number(left, 2), QStringLiteral("mm"),
                  left < kHarmfulMm ? tone.harmText
                  : left < kThinMm  ? tone.attentionText
                                    : QColor());
    }
    if (m_hasPulp != reading.toPulpMm.has_value()) {
        m_hasPulp = !m_hasPulp;
        showFigures();
    }

    const double decay = session.wholeMm3.at(at(Material::Caries));
    if (m_target != ShownTarget::Decay) {
        // setGuide() shows this figure
    } else if (decay > 0.0) {
        const double left = 100.0 * std::max(0.0, decay - session.removedMm3.at(at(Material::Caries))) / decay;
        // Never shows "0 %" while some decay is left.
        setFigure(m_decay, left > 0.0 && left < 0.5 ? tr("< 1") : text::number(left, 0), QStringLiteral("%"));
    } else {
        setFigure(m_decay, dash(), {}, quiet);
    }
    for (const Material material : {Material::Enamel, Material::Dentin}) {
        double removed = session.removedMm3.at(at(material));
        if (m_isBlock && material == Material::Enamel)
            removed += session.removedMm3.at(at(Material::Dentin));
        m_removed.at(at(material))->setText(text::number(removed, 2), QStringLiteral("mm³"));
    }
    // The grade uses the opened area. The volume of a small opening would be shown as 0.00 mm³.
    kit::TabularDigitsLabel* pulp = m_removed.at(at(Material::Pulp));
    pulp->setText(text::number(session.pulpExposedMm2, 2), QStringLiteral("mm²"));
    pulp->setColour(session.pulpExposedMm2 > 0.0 ? tone.harmText : QColor());
    if (m_target == ShownTarget::Decay)
        m_overcut->setText(text::number(session.overcutMm3, 2), QStringLiteral("mm³"));

    showHealth(servo);
}

void SidePanel::showHealth(const core::servo::ServoState& servo)
{
    // A clamped force is shown by the figure. A message would appear and vanish many times a second.
    QString health = text::healthText(servo.health & ~std::uint32_t{core::servo::kForceClamped});
    if (health.isEmpty() && servo.handpieceOnCrown && !servo.touching)
        health = tr("The handpiece touches the crown, so the bur cannot go deeper.");
    const kit::Tones tone = kit::tones(palette());
    const bool lost = (servo.health & core::servo::kDeviceLost) != 0;
    QPalette words = palette();
    words.setColor(QPalette::WindowText, lost ? tone.harmText : tone.attentionText);
    if (m_health->text() != health) {
        m_health->setPalette(words);
        m_health->setText(health);
        m_health->setVisible(!health.isEmpty());
    }
}

void SidePanel::setLesson(const lessons::Lesson* lesson)
{
    m_target = lessons::shownTarget(lesson);
    m_isBlock = lesson != nullptr && lessons::isOnPlainBlock(*lesson);
    nameFigures();
}

void SidePanel::nameFigures()
{
    for (const Material material : {Material::Enamel, Material::Dentin, Material::Pulp})
        m_removedNames.at(at(material))->setText(nameOf(material));
    const bool isDecay = m_target == ShownTarget::Decay;
    //: Of what is to be taken away: decay, or the preparation that is asked for
    name(m_decay, isDecay ? tr("Decay left") : tr("Still to cut"));
    m_overcutWords->setText(text::capitalised(isDecay ? tr("beside the decay") : tr("beyond the ideal")));
    m_overcut->setToolTip(isDecay ? kit::brokenIntoLines(text::soundTissueCounted()) : QString());
    showFigures();
    setGuide({}, {});
}

void SidePanel::setGuide(const std::optional<double>& marginMm, const std::optional<core::guidance::Progress>& progress)
{
    const kit::Tones tone = kit::tones(palette());
    const QColor quiet = palette().color(QPalette::PlaceholderText);
    const QString mm = QStringLiteral("mm");
    if (marginMm)
        setFigure(m_margin, text::number(*marginMm, 2), mm,
                  *marginMm < kAtLimitMm     ? tone.harmText
                  : *marginMm < kNearLimitMm ? tone.attentionText
                                             : QColor());
    if (m_hasMargin != marginMm.has_value()) {
        m_hasMargin = !m_hasMargin;
        showFigures();
    }
    if (m_target == ShownTarget::Decay)
        return;
    if (progress && progress->askedMm3 > 0.0) {
        const double left = 100.0 * progress->leftMm3 / progress->askedMm3;
        // Never shows "0 %" while some is left.
        setFigure(m_decay, left > 0.0 && left < 0.5 ? tr("< 1") : text::number(left, 0), QStringLiteral("%"));
        m_overcut->setText(text::number(progress->beyondMm3, 2), QStringLiteral("mm³"));
    } else {
        setFigure(m_decay, dash(), {}, quiet);
        m_overcut->setText(dash(), {});
    }
}

}  // namespace ui::practice
