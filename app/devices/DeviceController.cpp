// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/devices/DeviceController.h"

#include <algorithm>
#include <utility>

#include "core/session/RestHeight.h"
#include "ui/devices/DeviceWords.h"
#include "ui/devices/DevicesPage.h"
#include "ui/kit/Actions.h"
#include "ui/kit/AppSettings.h"
#include "ui/kit/MessageBar.h"
#include "ui/practice/HandControls.h"
#include "ui/practice/SidePanel.h"
#include "ui/tooth/ToothView.h"
#include "ui/window/PracticeRoom.h"

namespace app {
namespace {

using core::session::DeviceReport;
using core::session::DeviceSetup;
using core::session::DeviceStage;
using ui::devices::DevicesPage;
using ui::kit::memory;
using ui::kit::MessageBar;

constexpr int kPollMs = 33;
constexpr std::size_t kGripUndo = 1;
constexpr std::size_t kGripMirror = 2;
constexpr std::size_t kGripCentre = 3;

const QString kPointer = QLatin1String(ui::devices::kPointer);
const QString kSimulated = QLatin1String(ui::devices::kSimulated);
const QString kHandKey = QStringLiteral("devices/hand");
const QString kOnItsBack = QStringLiteral("on its back");
const QString kRight = QStringLiteral("right");
const QString kLeft = QStringLiteral("left");

QString keyOf(const QString& id, const char* what)
{
    return QStringLiteral("devices/%1/%2").arg(id, QLatin1String(what));
}

DeviceSetup recalledSetup(const QString& id)
{
    const QSettings kept = memory();
    DeviceSetup setup;
    if (kept.value(keyOf(id, "stand")).toString() == kOnItsBack)
        setup.stand = DeviceSetup::Stand::OnItsBack;
    const QString side = kept.value(keyOf(id, "side")).toString();
    setup.side = side == kRight  ? DeviceSetup::Side::Right
                 : side == kLeft ? DeviceSetup::Side::Left
                                 : DeviceSetup::Side::Front;
    bool isNumber = false;
    const double scale = kept.value(keyOf(id, "scale")).toDouble(&isNumber);
    if (isNumber && scale >= DeviceSetup::kLeastScale && scale <= DeviceSetup::kMostScale)
        setup.scale = scale;
    const double rest = kept.value(keyOf(id, "rest_mm")).toDouble(&isNumber);
    if (isNumber)
        setup.restMm = core::session::reachableRestMm(rest, setup.scale);
    return setup;
}

void remember(const QString& id, const DeviceSetup& setup)
{
    QSettings kept = memory();
    kept.setValue(keyOf(id, "stand"),
                  setup.stand == DeviceSetup::Stand::OnItsBack ? kOnItsBack : QStringLiteral("as sold"));
    kept.setValue(keyOf(id, "side"), setup.side == DeviceSetup::Side::Right  ? kRight
                                     : setup.side == DeviceSetup::Side::Left ? kLeft
                                                                             : QStringLiteral("front"));
    kept.setValue(keyOf(id, "scale"), setup.scale);
    kept.setValue(keyOf(id, "rest_mm"), setup.restMm);
}

}  // namespace

DeviceController::DeviceController(ui::window::MainWindow& window, const Hands& hands, std::vector<DeviceRow> rows,
                                   const QString& chosen)
    : m_window(window), m_hands(hands), m_chosen(kPointer), m_inUse(kPointer)
{
    QList<ui::devices::DeviceKind> kinds;
    for (DeviceRow& row : rows) {
        kinds.push_back(row.kind);
        m_devices.push_back({std::move(row), nullptr, {}, {}});
    }
    m_window.devicesPage().setKinds(kinds);
    recall();
    connectPage();
    const Device* const device = find(chosen);
    if (chosen == kPointer || chosen == kSimulated || (device != nullptr && device->row.make))
        m_chosen = chosen;
    m_window.devicesPage().setChosen(m_chosen);
    m_poll.setInterval(kPollMs);
    connect(&m_poll, &QTimer::timeout, this, &DeviceController::poll);
    startWanted();
    showState(nullptr, {});
    poll();
}

DeviceController::~DeviceController()
{
    for (Device& device : m_devices)
        stop(device);
}

void DeviceController::recall()
{
    const QString chosen = memory().value(kHandKey).toString();
    for (Device& device : m_devices) {
        const QString& id = device.row.kind.id;
        device.setup = recalledSetup(id);
        m_window.devicesPage().setSetup(id, device.setup);
        device.firmware = memory().value(keyOf(id, "firmware")).toString();
        if (!device.firmware.isEmpty() && device.row.checkFirmware)
            m_window.devicesPage().setFirmware(id, device.row.checkFirmware(device.firmware));
        if (id == chosen && device.row.make)
            m_chosen = id;
    }
}

void DeviceController::connectPage()
{
    const DevicesPage* const page = &m_window.devicesPage();
    connect(page, &DevicesPage::handRequested, this, &DeviceController::want);
    connect(page, &DevicesPage::opened, this, [this](bool isOpen) {
        m_isPageOpen = isOpen;
        startWanted();
        poll();
    });
    connect(page, &DevicesPage::setupChanged, this, [this](const QString& id, const DeviceSetup& setup) {
        Device* const device = find(id);
        if (device == nullptr)
            return;
        device->setup = setup;
        remember(id, setup);
        if (device->device)
            device->device->setUp(setup);
    });
    connect(page, &DevicesPage::firmwareChosen, this, [this](const QString& id, const QString& path) {
        Device* const device = find(id);
        if (device == nullptr || !device->row.checkFirmware)
            return;
        device->firmware = path;
        memory().setValue(keyOf(id, "firmware"), path);
        m_window.devicesPage().setFirmware(id, device->row.checkFirmware(path));
        if (device->device)
            device->device->setFirmware(path.toStdString());
    });
}

const DeviceController::Device* DeviceController::find(const QString& id) const
{
    const auto found =
        std::find_if(m_devices.begin(), m_devices.end(), [&](const Device& one) { return one.row.kind.id == id; });
    return found == m_devices.end() ? nullptr : &*found;
}

DeviceController::Device* DeviceController::find(const QString& id)
{
    return const_cast<Device*>(std::as_const(*this).find(id));
}

QString DeviceController::hand() const
{
    return isForceChosen() ? m_chosen : kPointer;
}

QString DeviceController::cutsWith() const
{
    return m_inUse == kPointer ? QString::fromLatin1(ui::tooth::idOf(m_window.view().pushedWith())) : m_inUse;
}

bool DeviceController::isSimulated() const
{
    return m_inUse == kSimulated;
}

bool DeviceController::hasForce() const
{
    return m_inUse != kPointer;
}

double DeviceController::scale() const
{
    const Device* const device = find(m_chosen);
    return device != nullptr ? device->setup.scale : 1.0;
}

bool DeviceController::isForceChosen() const
{
    return m_chosen == kSimulated || m_wasReady;
}

/// Starts and stops devices. All of them run while the page of devices is open, so that it can show which ones are
/// plugged in; otherwise only the chosen device runs.
void DeviceController::startWanted()
{
    bool isAnyRunning = false;
    for (Device& device : m_devices) {
        if (m_isPageOpen || device.row.kind.id == m_chosen)
            start(device);
        else
            stop(device);
        isAnyRunning = isAnyRunning || device.isRunning;
    }
    if (isAnyRunning)
        m_poll.start();
    else
        m_poll.stop();
}

void DeviceController::start(Device& device)
{
    if (device.isRunning || !device.row.make)
        return;
    if (!device.device)
        device.device = device.row.make();
    device.device->setUp(device.setup);
    device.device->setFirmware(device.firmware.toStdString());
    device.device->start();
    device.isRunning = true;
}

void DeviceController::stop(Device& device)
{
    if (std::exchange(device.isRunning, false))
        device.device->stop();
}

void DeviceController::poll()
{
    DevicesPage& page = m_window.devicesPage();
    if (m_isPageOpen) {
        page.setSimulatedFixed(m_window.isExamRunning() ? tr("This cannot be changed during an exam.") : QString());
        for (Device& device : m_devices) {
            if (!device.isRunning)
                continue;
            page.setReport(device.row.kind.id, device.device->report());
            device.device->setTestForce(page.shownHand() == device.row.kind.id ? page.testForce() : glm::dvec3(0.0));
        }
    }
    follow();
}

/// Chooses a hand. The simulated hand starts another attempt, so asks the user about their unsaved work first.
void DeviceController::want(const QString& id)
{
    if (id == kSimulated)
        m_window.unsavedWork().leaveWork([this, id] { choose(id); });
    else
        choose(id);
}

void DeviceController::choose(const QString& id)
{
    if (id == m_chosen)
        return;
    const bool concernsSimulated = id == kSimulated || m_chosen == kSimulated;
    m_chosen = id;
    if (id != kSimulated)  // the simulated hand is chosen for this run only
        memory().setValue(kHandKey, id);
    m_isLost = false;
    m_wasReady = false;
    m_stage = {};
    m_window.messages().withdraw(MessageBar::Topic::Device);
    m_window.devicesPage().setChosen(id);
    startWanted();
    follow();
    if (concernsSimulated)
        emit simulatedChanged();
    else
        emit inUseChanged();
}

/// Reads the state of the chosen hand, and selects the hand that moves the bur now.
void DeviceController::follow()
{
    Device* const device = find(m_chosen);
    if (device == nullptr || !device->isRunning) {
        use(m_chosen == kSimulated ? kSimulated : kPointer);
        return;
    }
    const DeviceReport report = device->device->report();
    const bool isReady = report.stage == DeviceStage::Ready && device->device->isReady();
    const bool wasInUse = m_inUse == m_chosen;
    const bool wasReady = std::exchange(m_wasReady, isReady);
    if (m_stage != report.stage)
        askForUser(*device, report);
    // A tooth that is not visible must not push the hand.
    use(isReady && m_window.isInRoom() ? m_chosen : kPointer);
    if (!m_window.isInRoom() || m_window.isReplaying())
        m_isLost = false;
    else if ((wasInUse && !isReady) || (m_isLost && isReady)) {
        m_isLost = !isReady;
        say(*device, isReady);
    }
    if (isReady && wasInUse && wasReady)
        pressButtons(report);
    m_presses = report.presses;
    showState(device, report);
}

void DeviceController::use(const QString& id)
{
    Device* const device = find(id);
    haptics::HapticDevice& hand = device != nullptr  ? *device->device
                                  : id == kSimulated ? m_hands.simulated
                                                     : m_hands.pointer;
    m_hands.bur.select(hand);
    if (std::exchange(m_inUse, id) == id)
        return;
    m_window.offerHome(hasForce());
    m_window.setSelfDrilling(isSimulated());
    m_window.room().setHandHasForce(hasForce());
    m_window.room().panel().hand().setForceDevice(device != nullptr ? device->row.kind.name : QString());
    if (device == nullptr)
        showState(nullptr, {});
    emit inUseChanged();
}

void DeviceController::say(const Device& device, bool isReady)
{
    MessageBar& messages = m_window.messages();
    messages.withdraw(MessageBar::Topic::Device);
    const QString name = device.row.kind.name;
    if (isReady)
        messages.say([name] {
            return MessageBar::Message{
                //: %1: a force device
                MessageBar::Kind::News,   tr("The %1 is ready again and moves the bur.").arg(name), {}, {}, {},
                MessageBar::Topic::Device};
        });
    else
        messages.say([this, name] {
            return MessageBar::Message{
                MessageBar::Kind::Warning,
                //: %1: a force device
                tr("The %1 no longer responds, and the bur was lifted. Continue with the mouse, or plug it in again.")
                    .arg(name),
                {},
                tr("Show the device"),
                [this] { m_window.actions().devices->trigger(); },
                MessageBar::Topic::Device};
        });
}

/// Shows a message when the device waits for the user and the page of devices is closed. Does not replace a message
/// about something else: poll() calls this again until that message is closed.
void DeviceController::askForUser(const Device& device, const DeviceReport& report)
{
    const bool waits = report.stage == DeviceStage::Homing || report.stage == DeviceStage::NeedsFirmware ||
                       report.stage == DeviceStage::Unavailable;
    MessageBar& messages = m_window.messages();
    if (waits && !m_isPageOpen && messages.isVisibleTo(&m_window) && messages.topic() != MessageBar::Topic::Device)
        return;  // m_stage stays as it was, so the next poll tries again
    if ((waits && !m_isPageOpen) || report.stage == DeviceStage::Ready)
        messages.withdraw(MessageBar::Topic::Device);
    m_stage = report.stage;
    if (!waits || m_isPageOpen)
        return;
    messages.say([this, kind = device.row.kind, report] {
        //: %1: a force device; %2: a sentence about its state
        return MessageBar::Message{MessageBar::Kind::Warning,
                                   tr("%1: %2").arg(kind.name, ui::devices::stateWords(kind, report)),
                                   {},
                                   tr("Show the device"),
                                   [this] { m_window.actions().devices->trigger(); },
                                   MessageBar::Topic::Device};
    });
}

/// Triggers the actions of the grip buttons that were pressed since the last poll. The grip button for the drill is not
/// among them: the servo reads it as the pedal of the device.
void DeviceController::pressButtons(const DeviceReport& report)
{
    const ui::kit::Actions& actions = m_window.actions();
    if (!m_window.isInRoom())
        return;
    for (const auto& [button, action] :
         {std::pair(kGripUndo, actions.undo), {kGripMirror, actions.mirror}, {kGripCentre, actions.bringHome}})
        for (std::uint32_t n = m_presses.at(button); n < report.presses.at(button); ++n)
            action->trigger();
}

/// Shows the device and its state on the button of the practice room.
/// @param device  null: the hand is no force device
void DeviceController::showState(const Device* device, const DeviceReport& report)
{
    ui::kit::Actions& actions = m_window.actions();
    const QString name = m_window.devicesPage().handName(m_chosen);
    if (device == nullptr) {
        actions.showDevice(m_chosen == kSimulated ? QStringLiteral("ghost") : QStringLiteral("mouse"), name);
        return;
    }
    //: %1: a force device; %2: a sentence about its state
    actions.showDevice(report.stage == DeviceStage::Ready ? QStringLiteral("arm") : QStringLiteral("arm-missing"),
                       tr("%1: %2").arg(name, ui::devices::stateWords(device->row.kind, report)));
}

}  // namespace app
