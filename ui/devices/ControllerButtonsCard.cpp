// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/ControllerButtonsCard.h"

#include <utility>

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/devices/ControllerWords.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::devices {
namespace {

using namespace ui::kit;

constexpr int kActionColumns = 2;
constexpr int kTaughtButtonPx = 150;

}  // namespace

ControllerButtonsCard::ControllerButtonsCard(QWidget* parent)
    : QFrame(parent), m_words(kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, this)),
      m_layoutTitle(kit::formWords({}, kBody, QFont::DemiBold, QPalette::WindowText, this)), m_layout(new QGridLayout),
      m_layoutBox(new QWidget(this))
{
    setProperty("kind", "card");
    setObjectName(QStringLiteral("controllerButtons"));
    m_words->setObjectName(QStringLiteral("buttonWords"));
    m_layoutBox->setObjectName(QStringLiteral("gamepadLayout"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSpace4, kSpace4, kSpace4, kSpace4);
    column->setSpacing(kSpace2);
    column->addWidget(m_words);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(kSpace4);
    grid->setVerticalSpacing(kSpace1);
    for (std::size_t k = 0; k < kControllerActions; ++k) {
        const auto action = static_cast<ControllerAction>(k);
        m_names.at(k) = kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, this);
        m_buttons.at(k) = new QPushButton(this);
        m_buttons.at(k)->setCheckable(true);
        m_buttons.at(k)->setFixedWidth(kTaughtButtonPx);
        m_buttons.at(k)->setObjectName(QStringLiteral("action%1").arg(k));
        const int row = static_cast<int>(k) / kActionColumns;
        const int place = 2 * (static_cast<int>(k) % kActionColumns);
        grid->addWidget(m_names.at(k), row, place);
        grid->addWidget(m_buttons.at(k), row, place + 1);
        grid->setColumnStretch(place, 1);
        connect(m_buttons.at(k), &QPushButton::clicked, this,
                [this, action](bool isChecked) { clickAction(action, isChecked); });
    }
    column->addLayout(grid);
    column->addSpacing(kSpace2);
    column->addWidget(m_layoutTitle);
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setHorizontalSpacing(kSpace4);
    m_layout->setVerticalSpacing(kSpace1);
    m_layout->setColumnStretch(1, 1);
    m_layoutBox->setLayout(m_layout);
    const auto rows = static_cast<int>(gamepadLayout().size());
    for (int row = 0; row < rows; ++row) {
        m_layout->addWidget(kit::formWords({}, kBody, QFont::Medium, QPalette::WindowText, m_layoutBox), row, 0);
        m_layout->addWidget(kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, m_layoutBox), row, 1);
    }
    column->addWidget(m_layoutBox);
    text::bindTranslation(this, [this] {
        //: What sticks, triggers and arrows of a gamepad do
        m_layoutTitle->setText(tr("Sticks, triggers and arrows"));
        int row = 0;
        for (const QString& line : gamepadLayout()) {
            for (const int place : {0, 1})
                qobject_cast<QLabel*>(m_layout->itemAtPosition(row, place)->widget())
                    ->setText(line.section(u'\t', place, place));
            ++row;
        }
        showWords();
    });
}

void ControllerButtonsCard::setSettings(const ControllerSettings& settings)
{
    m_settings = settings;
    showWords();
}

void ControllerButtonsCard::setController(const core::session::Controller& controller)
{
    const core::session::Controller before = std::exchange(m_controller, controller);
    if (before.instance != controller.instance) {
        stopLearning();
        showWords();
        return;
    }
    if (!m_learning || before.presses.size() != controller.presses.size())
        return;
    for (std::size_t button = 0; button < controller.presses.size(); ++button)
        if (controller.presses[button] != before.presses[button]) {
            assign(static_cast<int>(button));
            return;
        }
}

void ControllerButtonsCard::stopLearning()
{
    if (std::exchange(m_learning, std::nullopt))
        showWords();
}

/// Handles a click on an action. A second click leaves the action without a button.
void ControllerButtonsCard::clickAction(ControllerAction action, bool isChecked)
{
    if (!isChecked) {
        assign(kNoButton);
        return;
    }
    m_learning = action;
    showWords();
}

/// Assigns a button. Each button has only one action.
void ControllerButtonsCard::assign(int button)
{
    const auto action = std::exchange(m_learning, std::nullopt);
    if (!action)
        return;
    for (int& other : m_settings.buttons)
        if (other == button)
            other = kNoButton;
    m_settings.buttonOf(*action) = button;
    showWords();
    emit settingsChanged(m_settings);
}

void ControllerButtonsCard::showWords()
{
    //: %1: "Undo", or another action
    m_words->setText(m_learning ? tr("Press the button for: %1. Click again for none.").arg(actionName(*m_learning))
                                : tr("Buttons. Click one here, then press it on the pedal or gamepad."));
    for (std::size_t k = 0; k < kControllerActions; ++k) {
        const auto action = static_cast<ControllerAction>(k);
        const int button = m_settings.buttons.at(k);
        m_names.at(k)->setText(actionName(action));
        m_buttons.at(k)->setChecked(m_learning == action);
        m_buttons.at(k)->setText(m_learning == action ? tr("Press it …")
                                 //: No button
                                 : button == kNoButton ? tr("None")
                                                       : buttonName(m_controller, static_cast<std::size_t>(button)));
        m_buttons.at(k)->setAccessibleName(
            //: %1: an action; %2: a button
            tr("%1: %2").arg(m_names.at(k)->text(), m_buttons.at(k)->text()));
    }
    m_layoutTitle->setVisible(m_controller.isGamepad);
    m_layoutBox->setVisible(m_controller.isGamepad);
}

}  // namespace ui::devices
