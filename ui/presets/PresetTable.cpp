// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/presets/PresetTable.h"

#include <array>
#include <utility>

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>

#include "ui/kit/FormInputs.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/PresetTexts.h"

namespace ui::presets {
namespace {

using core::settings::kSubstances;
using core::settings::Substance;
using namespace ui::kit;

constexpr int kDecimals = 3;
constexpr int kWideInputPx = 152;
constexpr int kNamePx = 144;  ///< longer names wrap

QLabel* head(Qt::Alignment side, QWidget* parent)
{
    auto* label = new QLabel(parent);
    label->setFont(typeface(kSmall, QFont::DemiBold));
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setAlignment(side | Qt::AlignBottom);
    return label;
}

}  // namespace

PresetTable::PresetTable(QWidget* parent) : QWidget(parent)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, kSpace2, 0);
    grid->setHorizontalSpacing(kSpace2);
    grid->setVerticalSpacing(kSpace1);
    grid->setColumnStretch(3, 1);
    const auto fields = core::settings::feelFields();
    m_inputs.resize(fields.size());
    auto* material = head(Qt::AlignLeft, this);
    auto* rate = head(Qt::AlignLeft, this);
    auto* from = head(Qt::AlignLeft, this);
    grid->addWidget(material, 0, 0);
    grid->addWidget(rate, 0, 1);
    grid->addWidget(from, 0, 2);
    std::array<QLabel*, kSubstances> names{};
    int row = 1;
    for (std::size_t k = 0; k < kSubstances; ++k, ++row) {
        names[k] = new QLabel(this);
        grid->addWidget(names[k], row, 0);
        grid->addWidget(input(2 * k), row, 1);
        grid->addWidget(input(2 * k + 1), row, 2);
    }
    grid->addWidget(line(this), row++, 0, 1, 4);
    std::vector<std::pair<QLabel*, QLabel*>> rest;
    for (std::size_t k = 2 * kSubstances; k < fields.size(); ++k, ++row) {
        auto* name = new QLabel(this);
        name->setWordWrap(true);
        name->setFixedWidth(kNamePx);
        auto* help = kit::formWords({}, kSmall, QFont::Normal, QPalette::PlaceholderText, this);
        rest.emplace_back(name, help);
        grid->addWidget(name, row, 0);
        grid->addWidget(input(k), row, 1);
        grid->addWidget(help, row, 2, 1, 2);
    }
    grid->setRowStretch(row, 1);
    text::bindTranslation(this, [this, material, rate, from, names, rest, fields] {
        material->setText(tr("Material"));
        rate->setText(tr("Rate"));
        //: The force from which on a material is cut
        from->setText(tr("Cuts from"));
        for (std::size_t k = 0; k < kSubstances; ++k)
            names[k]->setText(text::substanceName(static_cast<Substance>(k)));
        for (std::size_t k = 0; k < rest.size(); ++k) {
            rest[k].first->setText(text::feelFieldName(fields[2 * kSubstances + k].id));
            rest[k].second->setText(text::fieldHelp(fields[2 * kSubstances + k].id));
        }
        for (std::size_t k = 0; k < fields.size(); ++k) {
            m_inputs[k]->setAccessibleName(text::feelFieldName(fields[k].id));
            m_inputs[k]->setAccessibleDescription(text::fieldHelp(fields[k].id));
            m_inputs[k]->setToolTip(brokenIntoLines(text::fieldHelp(fields[k].id) + u'\n' +
                                                    tr("From %1.").arg(text::rangeWords(fields[k]))));
        }
    });
}

QDoubleSpinBox* PresetTable::input(std::size_t field)
{
    const auto& number = core::settings::feelFields()[field];
    auto* made = kit::numberInput(number.minimum, number.maximum, kDecimals, QString::fromUtf8(number.unit), {}, this);
    made->setFixedWidth(kWideInputPx);
    made->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    made->setObjectName(QLatin1String(number.id));
    connect(made, &QDoubleSpinBox::valueChanged, this, &PresetTable::tell);
    m_inputs[field] = made;
    return made;
}

void PresetTable::setPreset(const core::settings::FeelPreset& preset)
{
    m_preset = preset;
    m_isQuiet = true;
    const auto fields = core::settings::feelFields();
    for (std::size_t k = 0; k < fields.size(); ++k)
        kit::showNumber(*m_inputs[k], preset.*fields[k].value);
    m_isQuiet = false;
}

/// Reports only the number that was changed. Others keep their decimals, which the fields do not show.
void PresetTable::tell()
{
    if (m_isQuiet)
        return;
    const auto fields = core::settings::feelFields();
    for (std::size_t k = 0; k < fields.size(); ++k)
        if (sender() == m_inputs[k])
            m_preset.*fields[k].value = m_inputs[k]->value();
    emit changed(m_preset);
}

}  // namespace ui::presets
