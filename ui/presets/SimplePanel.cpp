// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/presets/SimplePanel.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

#include "ui/kit/FormInputs.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/PresetTexts.h"

namespace ui::presets {
namespace {

QLabel* quiet(QWidget* parent, Qt::Alignment side)
{
    auto* label = new QLabel(parent);
    label->setFont(kit::typeface(kit::kSmall));
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setAlignment(side | Qt::AlignVCenter);
    return label;
}

}  // namespace

SimplePanel::SimplePanel(QWidget* parent) : QWidget(parent), m_middle(quiet(this, Qt::AlignLeft))
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kit::kSpace2);
    grid->setVerticalSpacing(kit::kSpace1);
    grid->setColumnStretch(2, 1);
    std::array<QLabel*, kDials> names{};
    std::array<QLabel*, kDials> lows{};
    std::array<QLabel*, kDials> highs{};
    for (std::size_t k = 0; k < kDials; ++k) {
        const int row = static_cast<int>(k);
        names[k] = new QLabel(this);
        lows[k] = quiet(this, Qt::AlignRight);
        highs[k] = quiet(this, Qt::AlignLeft);
        auto* slider = new QSlider(Qt::Horizontal, this);
        slider->setRange(-kDialSteps, kDialSteps);
        slider->setPageStep(kDialSteps / 4);
        // The wheel must not turn a dial that the user scrolls past.
        slider->setFocusPolicy(Qt::StrongFocus);
        kit::bindToForm(slider);
        slider->setObjectName(QStringLiteral("dial%1").arg(k));
        connect(slider, &QSlider::valueChanged, this, &SimplePanel::tell);
        m_sliders[k] = slider;
        grid->addWidget(names[k], row, 0);
        grid->addWidget(lows[k], row, 1);
        grid->addWidget(slider, row, 2);
        grid->addWidget(highs[k], row, 3);
    }
    m_middle->setTextFormat(Qt::PlainText);
    m_middle->setWordWrap(true);
    m_middle->setObjectName(QStringLiteral("dialMiddle"));
    grid->addWidget(m_middle, static_cast<int>(kDials), 0, 1, 4);
    text::bindTranslation(this, [this, names, lows, highs] {
        const std::array<std::array<QString, 3>, kDials> words{{
            {tr("Enamel"), tr("softer"), tr("harder")},
            {tr("Dentin"), tr("softer"), tr("harder")},
            {tr("Caries"), tr("softer"), tr("harder")},
            {tr("Plastic tooth"), tr("softer"), tr("harder")},
            //: How hard one must press before anything comes away
            {tr("Touch that cuts"), tr("lighter"), tr("heavier")},
            //: What an uncut tooth feels like under the bur
            {tr("Wall"), tr("softer"), tr("stiffer")},
        }};
        for (std::size_t k = 0; k < kDials; ++k) {
            names[k]->setText(words[k][0]);
            lows[k]->setText(words[k][1]);
            highs[k]->setText(words[k][2]);
            //: A slider: what it is about, and the words at its ends
            m_sliders[k]->setAccessibleName(tr("%1, %2 to %3").arg(words[k][0], words[k][1], words[k][2]));
            m_sliders[k]->setToolTip(m_sliders[k]->accessibleName());
        }
        say();
    });
}

void SimplePanel::setPreset(const std::vector<core::settings::FeelPreset>& bases,
                            const core::settings::FeelPreset& preset)
{
    std::optional<Dials> dials;
    m_base = preset;
    for (const core::settings::FeelPreset& base : bases)
        if (dials = dialsFor(base, preset); dials) {
            // A preset with the same numbers under another name is its own origin.
            if (std::any_of(dials->begin(), dials->end(), [](double dial) { return std::abs(dial) > 1e-9; }))
                m_base = base;
            break;
        }
    m_isTyped = !dials;
    say();
    for (std::size_t k = 0; k < kDials; ++k) {
        const QSignalBlocker quiet(m_sliders[k]);
        m_sliders[k]->setValue(dials ? static_cast<int>(std::lround((*dials)[k] * kDialSteps)) : 0);
    }
}

/// Says which preset the sliders start from, without which their middle has no meaning.
void SimplePanel::say()
{
    //: Of sliders. %1 is a hardness preset
    m_middle->setText(
        m_isTyped ? tr("In the middle: the numbers that were typed.")
                  : tr("In the middle: %1.")
                        .arg(text::presetWords({QString::fromStdString(m_base.name), m_base.version, {}, false})));
    m_middle->setVisible(!m_base.name.empty());
    for (QSlider* slider : m_sliders)
        slider->setAccessibleDescription(m_middle->text());
}

void SimplePanel::tell()
{
    Dials dials{};
    for (std::size_t k = 0; k < kDials; ++k)
        dials[k] = static_cast<double>(m_sliders[k]->value()) / kDialSteps;
    emit changed(turned(m_base, dials));
}

}  // namespace ui::presets
