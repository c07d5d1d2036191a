// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/PedalCard.h"

#include <algorithm>
#include <utility>

#include <QCheckBox>
#include <QComboBox>
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ui/devices/AxisBars.h"
#include "ui/devices/ControllerButtonsCard.h"
#include "ui/devices/PedalSetupCard.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::devices {

using namespace ui::kit;
using core::session::Controller;
using core::session::ControllerReport;

PedalCard::PedalCard(QWidget* parent)
    : QWidget(parent), m_forget(new QPushButton(this)), m_live(new QFrame(this)), m_setup(new PedalSetupCard(this)),
      m_buttons(new ControllerButtonsCard(this))
{
    setObjectName(QStringLiteral("pedals"));
    makeLive();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace4);
    m_forget->setObjectName(QStringLiteral("forgetPedal"));
    column->addWidget(m_forget, 0, Qt::AlignLeft);
    for (QWidget* part :
         {static_cast<QWidget*>(m_live), static_cast<QWidget*>(m_setup), static_cast<QWidget*>(m_buttons)})
        column->addWidget(part);
    connect(m_choice, &QComboBox::activated, this, [this](int entry) {
        m_shown = m_choice->itemData(entry).toInt();
        showController();
    });
    connect(m_runsBur, &QCheckBox::toggled, this, &PedalCard::choosePedal);
    connect(m_forget, &QPushButton::clicked, this, &PedalCard::forgetPedal);
    connect(m_setup, &PedalSetupCard::settingsChanged, this, &PedalCard::change);
    connect(m_setup, &PedalSetupCard::taught, this, [this] { m_runsBur->setChecked(true); });
    connect(m_buttons, &ControllerButtonsCard::settingsChanged, this, &PedalCard::change);
    text::bindTranslation(this, [this] {
        kit::nameInput(m_choice, tr("Pedal or gamepad"));
        m_runsBur->setText(tr("The bur turns only while this pedal is pressed"));
        m_runsBur->setAccessibleName(m_runsBur->text());
        m_forget->setText(tr("Work without this pedal"));
        m_forget->setAccessibleName(m_forget->text());
        m_twice->setText(
            tr("Another one of the same kind is plugged in too. The one that was plugged in first counts."));
        showState();
    });
    showController();
}

void PedalCard::makeLive()
{
    m_live->setProperty("kind", "card");
    m_live->setObjectName(QStringLiteral("pedalLive"));
    auto* column = new QVBoxLayout(m_live);
    column->setContentsMargins(kSpace4, kSpace4, kSpace4, kSpace4);
    column->setSpacing(kSpace2);
    m_choice = kit::choiceInput({}, m_live);
    m_choice->setObjectName(QStringLiteral("controller"));
    m_twice = kit::formWords({}, kSmall, QFont::Normal, QPalette::PlaceholderText, m_live);
    m_twice->hide();
    m_bars = new AxisBars(m_live);
    m_runsBur = new QCheckBox(m_live);
    m_runsBur->setObjectName(QStringLiteral("runsBur"));
    for (QWidget* part : {static_cast<QWidget*>(m_choice), static_cast<QWidget*>(m_twice),
                          static_cast<QWidget*>(m_bars), static_cast<QWidget*>(m_runsBur)})
        column->addWidget(part);
}

void PedalCard::setInBuild(bool isInBuild)
{
    m_state.isInBuild = isInBuild;
    showState();
}

void PedalCard::setReport(const ControllerReport& report)
{
    const core::session::ControllerReport before = std::exchange(m_state.report, report);
    listControllers();
    showController();
    const bool isSameList = std::equal(
        before.controllers.begin(), before.controllers.end(), report.controllers.begin(), report.controllers.end(),
        [](const Controller& a, const Controller& b) { return a.instance == b.instance; });
    if (!isSameList || before.pedal != report.pedal || before.error.detail != report.error.detail)
        showState();
}

void PedalCard::setSettings(const QString& guid, const ControllerSettings& settings)
{
    m_settings[guid] = settings;
    showController();
}

void PedalCard::setPedal(const QString& guid, const QString& name)
{
    m_pedal = guid;
    m_state.pedalName = name;
    showController();
    showState();
}

const Controller* PedalCard::shown() const
{
    const auto& all = m_state.report.controllers;
    const auto found =
        std::find_if(all.begin(), all.end(), [this](const Controller& one) { return one.instance == m_shown; });
    return found == all.end() ? nullptr : &*found;
}

bool PedalCard::isLearning() const
{
    return m_setup->isLearning() || m_buttons->isLearning();
}

ControllerSettings PedalCard::settingsOf(const Controller& controller) const
{
    const auto known = m_settings.find(QString::fromStdString(controller.guid));
    return known != m_settings.end() ? known->second : firstSettings(controller.isGamepad);
}

/// Updates the list only when a controller is plugged in or removed, because the user may have opened the list.
void PedalCard::listControllers()
{
    const auto& all = m_state.report.controllers;
    bool isSame = m_choice->count() == static_cast<int>(all.size());
    for (int k = 0; isSame && k < m_choice->count(); ++k)
        isSame = m_choice->itemData(k).toInt() == all[static_cast<std::size_t>(k)].instance;
    if (!isSame) {
        m_choice->clear();
        for (const Controller& one : all)
            m_choice->addItem(QString::fromStdString(one.name), one.instance);
    }
    if (shown() == nullptr) {
        const auto pedal = std::find_if(all.begin(), all.end(), [this](const Controller& one) {
            return QString::fromStdString(one.guid) == m_pedal;
        });
        m_shown = all.empty() ? -1 : pedal != all.end() ? pedal->instance : all.front().instance;
    }
    m_choice->setCurrentIndex(m_choice->findData(m_shown));
}

void PedalCard::showController()
{
    const Controller* const controller = shown();
    for (QWidget* part :
         {static_cast<QWidget*>(m_live), static_cast<QWidget*>(m_setup), static_cast<QWidget*>(m_buttons)})
        part->setVisible(controller != nullptr);
    if (controller == nullptr) {
        m_setup->stopLearning();
        m_buttons->stopLearning();
        m_shownSettings.reset();
        return;
    }
    const ControllerSettings settings = settingsOf(*controller);
    if (m_shownSettings != settings) {
        m_shownSettings = settings;
        m_setup->setSettings(settings);
        m_buttons->setSettings(settings);
    }
    m_setup->setController(*controller);
    m_buttons->setController(*controller);
    m_bars->setController(*controller, settings.axis);
    const auto& all = m_state.report.controllers;
    m_twice->setVisible(std::count_if(all.begin(), all.end(), [controller](const Controller& one) {
                            return one.guid == controller->guid;
                        }) > 1);
    const QSignalBlocker silent(m_runsBur);
    m_runsBur->setChecked(QString::fromStdString(controller->guid) == m_pedal);
    m_runsBur->setEnabled(settings.canRunBur() || m_runsBur->isChecked());
}

void PedalCard::change(const ControllerSettings& settings)
{
    const Controller* const controller = shown();
    if (controller == nullptr)
        return;
    const QString guid = QString::fromStdString(controller->guid);
    // Both cards have a copy of the settings of the controller.
    m_settings[guid] = settings;
    m_shownSettings = settings;
    m_setup->setSettings(settings);
    m_buttons->setSettings(settings);
    m_runsBur->setEnabled(settings.canRunBur() || m_runsBur->isChecked());
    emit settingsChanged(guid, settings);
}

void PedalCard::choosePedal(bool isPedal)
{
    const Controller* const controller = shown();
    if (controller == nullptr)
        return;
    m_pedal = isPedal ? QString::fromStdString(controller->guid) : QString();
    m_state.pedalName = isPedal ? QString::fromStdString(controller->name) : QString();
    emit pedalChosen(m_pedal, m_state.pedalName);
}

/// Forgets a pedal that was removed for good, so that the program does not wait for it.
void PedalCard::forgetPedal()
{
    m_pedal.clear();
    m_state.pedalName.clear();
    m_state.report.pedal = core::session::PedalStage::NotChosen;
    emit pedalChosen({}, {});
    showState();
}

void PedalCard::showState()
{
    m_forget->setVisible(m_state.isInBuild && m_state.report.pedal == core::session::PedalStage::Missing);
    m_runsBur->setAccessibleDescription(stateWords(m_state));
    emit stateChanged();
}

}  // namespace ui::devices
