// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/SetupCard.h"

#include <QButtonGroup>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "core/session/RestHeight.h"
#include "ui/devices/PlacementPicture.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::devices {
namespace {

using core::session::DeviceSetup;
using namespace ui::kit;

constexpr double kScaleStep = 0.1;

QLabel* headingLabel(QWidget* parent)
{
    return kit::formWords({}, kSmall, QFont::Medium, QPalette::PlaceholderText, parent);
}

}  // namespace

SetupCard::SetupCard(QWidget* parent)
    : QFrame(parent), m_columns(new QBoxLayout(QBoxLayout::LeftToRight, this)), m_picture(new PlacementPicture(this)),
      m_scale(kit::numberInput(DeviceSetup::kLeastScale, DeviceSetup::kMostScale, 1, {}, {}, this))
{
    setProperty("kind", "card");
    setObjectName(QStringLiteral("setup"));
    m_columns->setContentsMargins(kSpace4, kSpace4, kSpace4, kSpace4);
    m_columns->setSpacing(kSpace6);
    m_columns->addWidget(m_picture);
    auto* form = new QVBoxLayout;
    form->setSpacing(kSpace1);
    auto* choices = new QHBoxLayout;
    choices->setSpacing(kSpace6);
    const auto addGroup = [&](QLabel* heading, auto& buttons, const std::array<const char*, 3>& names, auto apply) {
        auto* column = new QVBoxLayout;
        column->setSpacing(0);
        column->addWidget(heading);
        auto* group = new QButtonGroup(this);
        for (std::size_t k = 0; k < buttons.size(); ++k) {
            auto* button = new QRadioButton(this);
            button->setObjectName(QLatin1String(names.at(k)));
            group->addButton(button, static_cast<int>(k));
            column->addWidget(button);
            buttons.at(k) = button;
        }
        column->addStretch(1);
        choices->addLayout(column);
        connect(group, &QButtonGroup::idClicked, this, [this, apply](int id) {
            DeviceSetup setup = m_setup;
            apply(setup, id);
            change(setup);
        });
    };
    auto* stand = headingLabel(this);
    addGroup(stand, m_stands, {"standUpright", "standOnItsBack", ""}, [](DeviceSetup& setup, int id) {
        setup.stand = static_cast<DeviceSetup::Stand>(id);
        setup.restMm = 0.0;  // the hand is in another place now
    });
    auto* side = headingLabel(this);
    addGroup(side, m_sides, {"sideFront", "sideRight", "sideLeft"},
             [](DeviceSetup& setup, int id) { setup.side = static_cast<DeviceSetup::Side>(id); });
    choices->addStretch(1);
    form->addLayout(choices);
    form->addSpacing(kSpace2);
    addScale(form);
    form->addStretch(1);
    m_columns->addLayout(form, 1);
    text::bindTranslation(this, [=, this] {
        //: How the device is placed on the table
        stand->setText(tr("It stands"));
        //: Of a device: on its base, as it was sold
        m_stands[0]->setText(tr("as sold"));
        m_stands[1]->setText(tr("on its back, arms up"));
        //: Where the device stands, seen by the user
        side->setText(tr("Place"));
        m_sides[0]->setText(tr("in front of you"));
        m_sides[1]->setText(tr("on your right"));
        m_sides[2]->setText(tr("on your left"));
        for (auto* button : findChildren<QRadioButton*>())
            button->setAccessibleName(button->text());
    });
    setSetup(m_setup);
}

void SetupCard::addScale(QVBoxLayout* form)
{
    auto* scale = headingLabel(this);
    form->addWidget(scale);
    auto* scaleRow = new QHBoxLayout;
    scaleRow->setSpacing(kSpace2);
    m_scale->setObjectName(QStringLiteral("scale"));
    m_scale->setSingleStep(kScaleStep);
    m_scale->setFixedWidth(kit::kInputPx);
    scaleRow->addWidget(m_scale);
    auto* scaleHelp = headingLabel(this);
    scaleRow->addWidget(scaleHelp, 1);
    form->addLayout(scaleRow);
    connect(m_scale, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        DeviceSetup setup = m_setup;
        setup.scale = value;
        setup.restMm = core::session::reachableRestMm(setup.restMm, value);
        change(setup);
    });
    text::bindTranslation(m_scale, [this, scale, scaleHelp] {
        //: How far the hand moves for one millimetre of the bur
        scale->setText(tr("Scale"));
        scaleHelp->setText(tr("Movement of the hand for 1 mm of the bur, in millimetres"));
        m_scale->setAccessibleName(tr("Scale"));
    });
}

void SetupCard::setNarrow(bool isNarrow)
{
    m_columns->setDirection(isNarrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void SetupCard::setSetup(const DeviceSetup& setup)
{
    m_setup = setup;
    m_stands.at(static_cast<std::size_t>(setup.stand))->setChecked(true);
    m_sides.at(static_cast<std::size_t>(setup.side))->setChecked(true);
    const QSignalBlocker silent(m_scale);
    kit::showNumber(*m_scale, setup.scale);
    m_picture->setSetup(setup);
}

void SetupCard::change(const DeviceSetup& setup)
{
    if (setup == m_setup)
        return;
    setSetup(setup);
    emit setupChanged(setup);
}

}  // namespace ui::devices
