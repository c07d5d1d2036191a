// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/devices/PedalController.h"

#include <algorithm>
#include <utility>

#include "ui/devices/DevicesPage.h"
#include "ui/devices/PedalCard.h"
#include "ui/kit/Actions.h"
#include "ui/kit/MessageBar.h"
#include "ui/tooth/PadInput.h"
#include "ui/tooth/ToothView.h"
#include "ui/tooth/Viewpoint.h"
#include "ui/window/PadKeys.h"

namespace app {
namespace {

using core::session::Controller;
using core::session::ControllerReport;
using core::session::PedalSource;
using core::session::PedalStage;
using ui::devices::ControllerAction;
using ui::devices::ControllerSettings;
using ui::devices::DevicesPage;
using ui::devices::PedalCard;
using ui::kit::MessageBar;
using ui::window::PadArrow;

constexpr int kControllerPollMs = 16;
constexpr int kIdleControllerPollMs = 250;  ///< while nothing is plugged in

PedalSource sourceOf(const ChosenPedal& chosen, const ControllerSettings& settings)
{
    return {chosen.guid.toStdString(), settings.axis, settings.buttonOf(ControllerAction::Drill), settings.shape};
}

}  // namespace

PedalController::PedalController(ui::window::MainWindow& window, haptics::DeviceSwitch& bur,
                                 std::function<bool()> isSimulated)
    : m_window(window), m_bur(bur), m_isSimulated(std::move(isSimulated)), m_chosen(storedPedal()), m_input(m_pedal)
{
    PedalCard& card = m_window.devicesPage().pedals();
    card.setInBuild(haptics::hasControllers());
    card.setPedal(m_chosen.guid, m_chosen.name);
    connectPage();
    connect(&m_poll, &QTimer::timeout, this, &PedalController::poll);
    if (!haptics::hasControllers())
        return;
    choosePedal();
    m_input.start();
    m_poll.start(kIdleControllerPollMs);
}

PedalController::~PedalController()
{
    m_bur.setPedal(nullptr);
    m_window.view().setPad({});
}

void PedalController::connectPage()
{
    DevicesPage& page = m_window.devicesPage();
    const PedalCard* const card = &page.pedals();
    connect(card, &PedalCard::settingsChanged, this, [this](const QString& guid, const ControllerSettings& settings) {
        m_settings[guid] = settings;
        storeController(guid, settings);
        if (guid == m_chosen.guid)
            choosePedal();
    });
    connect(card, &PedalCard::pedalChosen, this, [this](const QString& guid, const QString& name) {
        m_chosen = {guid, name};
        storePedal(m_chosen);
        choosePedal();
    });
}

/// Passes the chosen pedal and its settings to the input.
void PedalController::choosePedal()
{
    if (m_chosen.guid.isEmpty()) {
        m_input.setPedal({});
        return;
    }
    const auto known = m_settings.find(m_chosen.guid);
    const ControllerSettings settings =
        known != m_settings.end() ? known->second : storedController(m_chosen.guid).value_or(ControllerSettings{});
    m_input.setPedal(sourceOf(m_chosen, settings));
}

const ControllerSettings& PedalController::settingsOf(const Controller& controller)
{
    const QString guid = QString::fromStdString(controller.guid);
    const auto known = m_settings.find(guid);
    if (known != m_settings.end())
        return known->second;
    ControllerSettings& fresh = m_settings[guid];
    fresh = storedController(guid).value_or(ui::devices::firstSettings(controller.isGamepad));
    m_window.devicesPage().pedals().setSettings(guid, fresh);
    if (guid == m_chosen.guid)
        choosePedal();
    return fresh;
}

void PedalController::poll()
{
    const ControllerReport report = m_input.report();
    m_poll.setInterval(report.controllers.empty() ? kIdleControllerPollMs : kControllerPollMs);
    takeControllers(report.controllers);
    followPedal(report);
    steer(report.controllers);
    m_window.devicesPage().pedals().setReport(report);
}

void PedalController::takeControllers(const std::vector<Controller>& controllers)
{
    std::map<int, std::vector<std::uint32_t>> now;
    for (const Controller& controller : controllers) {
        static_cast<void>(settingsOf(controller));
        const auto before = m_presses.find(controller.instance);
        now[controller.instance] = controller.presses;
        if (before != m_presses.end() && before->second.size() == controller.presses.size())
            pressButtons(controller, before->second);
    }
    m_presses = std::move(now);
}

/// Decides whether the pedal runs the bur, and switches the drill off after the pedal was unplugged.
void PedalController::followPedal(const ControllerReport& report)
{
    const bool works = report.pedal == PedalStage::Ready || report.pedal == PedalStage::WaitsForRest;
    const bool worked = std::exchange(m_works, works);
    if (works && !worked && m_isLost)
        regainPedal();
    else if (!works && worked && report.pedal == PedalStage::Missing)
        losePedal();
    else if (report.pedal == PedalStage::NotChosen)
        m_isLost = false;
    const QAction& drill = *m_window.actions().drill;
    if (m_mustStop && m_window.isInRoom() && !m_window.isReplaying() && drill.isEnabled()) {
        m_mustStop = false;
        m_hasStopped = drill.isChecked();
        switchDrill(false);
    } else if (m_isLost && !m_mustStop && drill.isChecked()) {
        m_isLost = false;  // the user drills without it
        m_window.messages().withdraw(MessageBar::Topic::Pedal);
    }
    const bool runsBur = (m_works || m_isLost) && !m_isSimulated();
    if (runsBur != m_bur.hasPedal())
        m_bur.setPedal(runsBur ? &m_pedal : nullptr);
}

/// Shows that the pedal was unplugged. The input has stopped the bur already; followPedal() switches the drill off.
void PedalController::losePedal()
{
    m_isLost = true;
    m_mustStop = true;
    m_hasStopped = false;
    m_window.messages().withdraw(MessageBar::Topic::Pedal);
    m_window.messages().say([this] {
        return MessageBar::Message{
            MessageBar::Kind::Warning,
            tr("The pedal was unplugged, and the bur was stopped. Plug it in again, or switch the drill on to work "
               "without it."),
            {},
            tr("Show the device"),
            [this] { m_window.actions().devices->trigger(); },
            MessageBar::Topic::Pedal};
    });
}

void PedalController::regainPedal()
{
    m_isLost = false;
    m_mustStop = false;
    if (std::exchange(m_hasStopped, false))
        switchDrill(true);
    m_window.messages().withdraw(MessageBar::Topic::Pedal);
    m_window.messages().say([] {
        return MessageBar::Message{MessageBar::Kind::News,  tr("The pedal is plugged in again."), {}, {}, {},
                                   MessageBar::Topic::Pedal};
    });
}

void PedalController::switchDrill(bool on)
{
    QAction* const drill = m_window.actions().drill;
    if (drill->isChecked() != on)
        drill->trigger();
}

void PedalController::pressButtons(const Controller& controller, const std::vector<std::uint32_t>& before)
{
    if (m_window.devicesPage().pedals().isLearning())
        return;
    const ControllerSettings settings = settingsOf(controller);
    for (std::size_t button = 0; button < before.size(); ++button) {
        if (controller.presses[button] == before[button])
            continue;
        if (controller.isGamepad)
            pressFixed(button);
        for (std::size_t k = 0; k < ui::devices::kControllerActions; ++k)
            if (settings.buttons.at(k) == static_cast<int>(button))
                press(static_cast<ControllerAction>(k));
    }
}

/// Triggers the action of a button. Does nothing outside the practice room.
void PedalController::press(ControllerAction action)
{
    const ui::kit::Actions& actions = m_window.actions();
    if (!m_window.isInRoom() || m_window.unsavedWork().isAsking())
        return;
    switch (action) {
    case ControllerAction::Drill:
        return;  // m_pedal handles this button, which runs the bur while it is down
    case ControllerAction::Undo:
        return actions.undo->trigger();
    case ControllerAction::Redo:
        return actions.redo->trigger();
    case ControllerAction::Mirror:
        return actions.mirror->trigger();
    case ControllerAction::Centre:
        return actions.bringHome->isVisible() ? actions.bringHome->trigger() : actions.resetView->trigger();
    case ControllerAction::NextView: {
        const QStringList sides = ui::tooth::viewpointNames();
        m_viewpoint = (m_viewpoint + 1) % static_cast<int>(sides.size());
        return m_window.view().lookFrom(sides.at(m_viewpoint));
    }
    case ControllerAction::NextBur: {
        const auto& burs = actions.burs;
        const auto now = std::find_if(burs.begin(), burs.end(), [](const QAction* one) { return one->isChecked(); });
        const qsizetype first = now == burs.end() ? 0 : now - burs.begin() + 1;
        for (qsizetype k = 0; k < burs.size(); ++k)
            if (QAction* const next = burs.at((first + k) % burs.size()); next->isEnabled() && next->isVisible())
                return next->trigger();
        return;
    }
    case ControllerAction::Grade:
        // Grading may open a dialog with an event loop of its own, in which poll() is called again. So it must not
        // start inside poll().
        QTimer::singleShot(0, actions.grade, &QAction::trigger);
        return;
    }
}

/// Handles the buttons of a gamepad with a fixed meaning: the arrows, A and Back.
void PedalController::pressFixed(std::size_t button)
{
    const auto step = [this](PadArrow arrow) {
        QTimer::singleShot(0, this, [this, arrow] { ui::window::stepByPad(m_window, arrow); });
    };
    switch (button) {
    case core::session::kPadUp:
        return step(PadArrow::Up);
    case core::session::kPadDown:
        return step(PadArrow::Down);
    case core::session::kPadLeft:
        return step(PadArrow::Left);
    case core::session::kPadRight:
        return step(PadArrow::Right);
    case core::session::kButtonA:
        QTimer::singleShot(0, this, [] { ui::window::chooseByPad(); });
        return;
    case core::session::kButtonBack:
        if (ui::window::closeByPad())
            return;
        if (m_window.isInRoom())
            m_window.view().setFocus();
        else
            m_window.actions().back->trigger();
        return;
    default:
        return;
    }
}

/// Moves the bur and the view with the first gamepad that is in use.
void PedalController::steer(const std::vector<Controller>& controllers)
{
    ui::tooth::PadInput input;
    std::set<int> rested;
    for (const Controller& controller : controllers) {
        if (!controller.isGamepad)
            continue;
        ui::tooth::PadInput asked = ui::tooth::padInput(controller);
        // A trigger that is down or stuck when its gamepad is plugged in has no effect until it is released.
        if (asked.press == 0.0 || m_restedPads.contains(controller.instance))
            rested.insert(controller.instance);
        else
            asked.press = 0.0;
        if (input == ui::tooth::PadInput{})
            input = asked;
    }
    m_restedPads = std::move(rested);
    const bool drills = m_window.isInRoom() && !m_window.isReplaying() && !m_window.unsavedWork().isAsking();
    m_window.view().setPad(drills ? input : ui::tooth::PadInput{});
}

}  // namespace app
