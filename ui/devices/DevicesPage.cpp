// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/DevicesPage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QCheckBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/devices/DeviceWords.h"
#include "ui/devices/FirmwareCard.h"
#include "ui/devices/ForceTest.h"
#include "ui/devices/HandGuide.h"
#include "ui/devices/HandList.h"
#include "ui/devices/HeadTrackingCard.h"
#include "ui/devices/HomingMarks.h"
#include "ui/devices/LiveTest.h"
#include "ui/devices/PedalCard.h"
#include "ui/devices/PenCard.h"
#include "ui/devices/RuleCard.h"
#include "ui/devices/SetupCard.h"
#include "ui/devices/SoundCard.h"
#include "ui/devices/SoundWords.h"
#include "ui/kit/Actions.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/ScrollPane.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::devices {
namespace {

using core::session::DeviceReport;
using core::session::DeviceSetup;
using core::session::DeviceStage;
using namespace ui::kit;

constexpr int kHandsPx = 300;
constexpr int kNarrowHandsPx = 230;
constexpr int kNarrowPagePx = 1100;
constexpr int kHeadSignPx = 26;
constexpr int kWidestCardPx = 900;
constexpr int kPercentFull = 100;

}  // namespace

DevicesPage::DevicesPage(const Actions& actions, QWidget* parent)
    : Page(actions, parent), m_back(actions.back), m_devicesPart(new QWidget(this)),
      m_guide(new HandGuide(actions, this)), m_chosen(QLatin1String(kPointer)), m_hands(new HandList(this))
{
    removeGuestSign();
    auto* cards = new QWidget(this);
    cards->setMaximumWidth(kWidestCardPx);
    auto* column = new QVBoxLayout(cards);
    column->setContentsMargins(0, 0, kSpace4, 0);
    column->setSpacing(kSpace4);
    m_help = kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, cards);
    m_help->setObjectName(QStringLiteral("deviceHelp"));
    m_progress = new QProgressBar(cards);
    m_progress->setRange(0, kPercentFull);
    m_progress->setTextVisible(false);
    m_progress->setObjectName(QStringLiteral("firmwareProgress"));
    m_rule = new RuleCard(cards);
    m_homing = makeHoming(cards);
    m_live = new LiveTest(cards);
    m_firmware = new FirmwareCard(cards);
    m_setup = new SetupCard(cards);
    m_headTracking = new HeadTrackingCard(cards);
    m_pen = new PenCard(cards);
    m_pedals = new PedalCard(cards);
    m_sound = new SoundCard(cards);
    for (QWidget* part :
         {static_cast<QWidget*>(m_help), static_cast<QWidget*>(m_progress), static_cast<QWidget*>(m_rule), m_homing,
          static_cast<QWidget*>(m_live), static_cast<QWidget*>(m_firmware), static_cast<QWidget*>(m_setup),
          static_cast<QWidget*>(m_pen), static_cast<QWidget*>(m_headTracking), static_cast<QWidget*>(m_pedals),
          static_cast<QWidget*>(m_sound)})
        column->addWidget(part);
    column->addStretch(1);

    auto* right = new QVBoxLayout;
    right->setSpacing(kSpace4);
    right->addWidget(makeHead());
    right->addWidget(new ScrollPane(cards, QPalette::Window, this), 1);
    auto* row = new QHBoxLayout(m_devicesPart);
    row->setContentsMargins(kSpace4, 0, 0, 0);
    row->setSpacing(kSpace6);
    row->addWidget(makeHands());
    row->addLayout(right, 1);
    body()->addWidget(m_devicesPart, 1);
    makeGuide();

    connect(m_hands, &QListWidget::currentRowChanged, this, &DevicesPage::showHand);
    connect(m_hands, &QListWidget::itemActivated, this, &DevicesPage::takeNextStep);
    connect(m_next, &QPushButton::clicked, this, &DevicesPage::takeNextStep);
    connect(m_headTracking, &HeadTrackingCard::stateChanged, this, [this] {
        showHands();
        if (shownHand() == QLatin1String(kHeadTracking))
            showHeadTracking();
    });
    connect(m_pedals, &PedalCard::stateChanged, this, [this] {
        showHands();
        if (shownHand() == QLatin1String(kPedals))
            showPedals();
    });
    connect(m_sound, &SoundCard::stateChanged, this, [this] {
        showHands();
        if (shownHand() == QLatin1String(kSound))
            showSound();
    });
    connect(m_setup, &SetupCard::setupChanged, this, [this](const DeviceSetup& setup) {
        if (Device* device = find(shownHand())) {
            device->setup = setup;
            emit setupChanged(device->kind.id, setup);
        }
    });
    connect(m_firmware, &FirmwareCard::fileChosen, this,
            [this](const QString& path) { emit firmwareChosen(shownHand(), path); });
    text::bindTranslation(this, [this] {
        setTitle(tr("Devices"));
        m_progress->setAccessibleName(tr("Loading the firmware"));
        showHands();
        showHand();
    });
}

/// Makes the list of input devices and the settings that apply to all of them.
QWidget* DevicesPage::makeHands()
{
    auto* part = new QWidget(this);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, kSpace4);
    column->setSpacing(kSpace2);
    m_openGuide = new QPushButton(part);
    m_openGuide->setObjectName(QStringLiteral("openHandGuide"));
    column->addWidget(m_hands, 1);
    column->addWidget(m_openGuide, 0, Qt::AlignLeft);
    connect(m_openGuide, &QPushButton::clicked, this, &DevicesPage::openGuide);
    text::bindTranslation(m_openGuide, [this] {
        //: A button that opens a guide: which hand works, and where it rests
        m_openGuide->setText(tr("Hand and rest"));
        m_openGuide->setAccessibleName(m_openGuide->text());
    });
    return part;
}

void DevicesPage::makeGuide()
{
    m_guide->hide();
    body()->addWidget(m_guide, 1);
    connect(m_guide, &HandGuide::closed, this, &DevicesPage::closeGuide);
    connect(m_guide, &HandGuide::setupChanged, this, [this](const DeviceSetup& setup) {
        setSetup(m_guideHand, setup);
        emit setupChanged(m_guideHand, setup);
    });
}

void DevicesPage::openGuide()
{
    const QString id = isHand(shownHand()) ? shownHand() : m_chosen;
    const Device* const device = find(id);
    m_guideHand = device != nullptr ? id : QString();
    m_devicesPart->hide();
    m_guide->show();
    if (device != nullptr)
        m_guide->begin(handName(id), device->setup, device->report);
    else
        m_guide->begin();
}

bool DevicesPage::stepBack()
{
    const bool wasOpen = m_guide->isVisible();
    closeGuide();
    return wasOpen;
}

void DevicesPage::closeGuide()
{
    const bool wasOpen = m_guide->isVisible();
    m_guide->hide();
    m_devicesPart->show();
    if (wasOpen)
        m_openGuide->setFocus();
}

QWidget* DevicesPage::makeHead()
{
    auto* head = new QWidget(this);
    head->setMaximumWidth(kWidestCardPx);
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(0, 0, kSpace4, 0);
    row->setSpacing(kSpace2);
    m_sign = new QLabel(head);
    row->addWidget(m_sign, 0, Qt::AlignTop);
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    m_name = kit::formWords({}, kTitle, QFont::DemiBold, QPalette::WindowText, head);
    m_name->setObjectName(QStringLiteral("deviceName"));
    m_state = kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, head);
    m_state->setObjectName(QStringLiteral("deviceState"));
    words->addWidget(m_name);
    words->addWidget(m_state);
    row->addLayout(words, 1);
    m_next = new QPushButton(head);
    m_next->setObjectName(QStringLiteral("deviceNext"));
    m_next->setProperty("kind", "filled");
    row->addWidget(m_next, 0, Qt::AlignTop);
    row->addWidget(&m_headTracking->followSwitch(), 0, Qt::AlignTop);
    row->addWidget(&m_sound->soundSwitch(), 0, Qt::AlignTop);
    setTabOrder(m_hands, m_next);
    setTabOrder(m_next, &m_headTracking->followSwitch());
    setTabOrder(&m_headTracking->followSwitch(), &m_sound->soundSwitch());
    return head;
}

QWidget* DevicesPage::makeHoming(QWidget* parent)
{
    auto* card = new QFrame(parent);
    card->setProperty("kind", "card");
    card->setObjectName(QStringLiteral("homing"));
    auto* column = new QVBoxLayout(card);
    column->setContentsMargins(kSpace4, kSpace4, kSpace4, kSpace4);
    column->setSpacing(kSpace4);
    auto* what = kit::formWords({}, kTitle, QFont::Medium, QPalette::WindowText, card);
    what->setObjectName(QStringLiteral("homingWords"));
    auto* hint = kit::formWords({}, kSmall, QFont::Normal, QPalette::PlaceholderText, card);
    m_marks = new HomingMarks(card);
    column->addWidget(what);
    column->addWidget(m_marks);
    column->addWidget(hint);
    text::bindTranslation(card, [what, hint] {
        //: Of the grip of a force device
        what->setText(tr("Pull the grip out of the device as far as it goes, then push it straight in."));
        hint->setText(
            tr("Each arm has to pass its index mark. If no ring fills, check that the mains adapter is plugged "
               "in."));
    });
    return card;
}

void DevicesPage::setKinds(const QList<DeviceKind>& kinds)
{
    m_devices.clear();
    for (const DeviceKind& kind : kinds)
        m_devices.push_back({kind, {}, {}, {}});
    showHands();
    showHand();
}

const DevicesPage::Device* DevicesPage::find(const QString& id) const
{
    const auto found =
        std::find_if(m_devices.begin(), m_devices.end(), [&](const Device& device) { return device.kind.id == id; });
    return found == m_devices.end() ? nullptr : &*found;
}

DevicesPage::Device* DevicesPage::find(const QString& id)
{
    return const_cast<Device*>(std::as_const(*this).find(id));  // NOLINT(cppcoreguidelines-pro-type-const-cast)
}

void DevicesPage::setReport(const QString& id, const DeviceReport& report)
{
    Device* const device = find(id);
    if (device == nullptr)
        return;
    device->report = report;
    showHands();
    if (shownHand() == id)
        showStage(*device);
    if (m_guideHand == id && m_guide->isVisible())
        m_guide->setReport(report);
}

void DevicesPage::setSetup(const QString& id, const DeviceSetup& setup)
{
    Device* const device = find(id);
    if (device == nullptr)
        return;
    device->setup = setup;
    if (shownHand() == id)
        m_setup->setSetup(setup);
}

void DevicesPage::setFirmware(const QString& id, const FirmwareFile& file)
{
    Device* const device = find(id);
    if (device == nullptr)
        return;
    device->firmware = file;
    if (shownHand() == id)
        m_firmware->setFile(file);
}

void DevicesPage::setChosen(const QString& id)
{
    m_chosen = id;
    showHands();
    m_hands->selectHand(id);
    showHand();
}

void DevicesPage::setSimulatedFixed(const QString& whyNot)
{
    if (whyNot == m_whySimulatedFixed)
        return;
    m_whySimulatedFixed = whyNot;
    showHand();
}

QString DevicesPage::shownHand() const
{
    return m_hands->selectedHand();
}

glm::dvec3 DevicesPage::testForce() const
{
    return m_live->isVisible() ? m_live->force().force() : glm::dvec3(0.0);
}

QString DevicesPage::handName(const QString& id) const
{
    if (id == QLatin1String(kPointer))
        return tr("Mouse or pen");
    if (id == QLatin1String(kSimulated))
        return tr("Simulated hand");
    if (id == QLatin1String(kHeadTracking))
        return tr("Head tracking");
    if (id == QLatin1String(kPedals))
        return tr("Pedal and gamepad");
    if (id == QLatin1String(kSound))
        return tr("Sound");
    const Device* const device = find(id);
    return device == nullptr ? id : device->kind.name;
}

void DevicesPage::showHands()
{
    QList<HandList::Row> rows;
    const auto add = [&](const QString& id, const QString& state, Sign sign) {
        rows.push_back({id, handName(id), state, sign, id == m_chosen, false});
    };
    add(QLatin1String(kPointer), tr("Always ready."), Sign::Ready);
    add(QLatin1String(kSimulated), tr("Drills by itself while you watch."), Sign::Ready);
    for (const Device& device : m_devices)
        add(device.kind.id, stateWords(device.kind, device.report), signOf(device.kind, device.report));
    const TrackingState& tracking = m_headTracking->state();
    add(QLatin1String(kHeadTracking), stateWords(tracking), signOf(tracking));
    rows.back().isApart = true;
    add(QLatin1String(kPedals), stateWords(m_pedals->state()), signOf(m_pedals->state()));
    add(QLatin1String(kSound), stateWords(m_sound->report()), signOf(m_sound->report()));
    m_hands->setRows(rows);
}

void DevicesPage::showHand()
{
    const Device* const device = find(shownHand());
    const bool isHeadTracking = shownHand() == QLatin1String(kHeadTracking);
    m_name->setText(handName(shownHand()));
    m_pen->setVisible(shownHand() == QLatin1String(kPointer));
    m_headTracking->setVisible(isHeadTracking);
    m_headTracking->followSwitch().setVisible(isHeadTracking);
    const bool isPedals = shownHand() == QLatin1String(kPedals);
    m_pedals->setVisible(isPedals);
    const bool isSound = shownHand() == QLatin1String(kSound);
    m_sound->setVisible(isSound);
    m_sound->soundSwitch().setVisible(isSound);
    if (device != nullptr) {
        m_rule->setKind(device->kind);
        m_firmware->setFile(device->firmware);
        m_setup->setSetup(device->setup);
        showStage(*device);
    } else if (isHeadTracking) {
        showHeadTracking();
    } else if (isPedals) {
        showPedals();
    } else if (isSound) {
        showSound();
    } else {
        const bool isPointer = shownHand() == QLatin1String(kPointer);
        m_sign->setPixmap(signPixmap(Sign::Ready, palette(), kHeadSignPx, devicePixelRatioF()));
        m_state->setText(isPointer ? tr("Always ready.") : tr("Drills by itself while you watch."));
        m_help->setText(isPointer
                            ? tr("The bur follows the pointer over the tooth and goes down while you press the button. "
                                 "You feel no force. Feed, depth stop and force are set beside the tooth.")
                            : tr("A simulated hand with a simulated force device cuts the ideal preparation. When you "
                                 "start or leave it, the attempt begins anew. Its attempts are not saved.") +
                                  (m_whySimulatedFixed.isEmpty() ? QString() : u'\n' + m_whySimulatedFixed));
    }
    if (device == nullptr) {
        for (QWidget* part :
             {static_cast<QWidget*>(m_progress), static_cast<QWidget*>(m_rule), m_homing, static_cast<QWidget*>(m_live),
              static_cast<QWidget*>(m_firmware), static_cast<QWidget*>(m_setup)})
            part->hide();
        m_help->show();
    }
    showNextStep();
}

void DevicesPage::showStage(const Device& device)
{
    const DeviceReport& report = device.report;
    m_sign->setPixmap(signPixmap(signOf(device.kind, report), palette(), kHeadSignPx, devicePixelRatioF()));
    QString state = stateWords(device.kind, report);
    if (!report.serial.empty())
        //: %1: the number of a device
        state += u' ' + tr("Serial number %1.").arg(QString::fromStdString(report.serial));
    if (report.others > 0)
        state += u' ' + tr("Another one is plugged in too. To use that one, unplug this one.");
    m_state->setText(state);
    const QString help = helpWords(device.kind, report);
    m_help->setText(help);
    m_help->setVisible(!help.isEmpty());
    const bool isInBuild = device.kind.isInBuild;
    m_progress->setVisible(isInBuild && report.stage == DeviceStage::LoadingFirmware);
    m_progress->setValue(static_cast<int>(std::lround(kPercentFull * report.progress)));
    m_rule->setVisible(isInBuild && lacksPermission(report) && !device.kind.rule.isEmpty());
    m_homing->setVisible(isInBuild && report.stage == DeviceStage::Homing);
    m_marks->setHomed(report.homed);
    m_live->setVisible(isInBuild && report.stage == DeviceStage::Ready);
    m_live->setReport(report, device.setup.scale);
    m_firmware->setVisible(isInBuild && device.kind.needsFirmware);
    m_setup->setVisible(isInBuild);
    showNextStep();
}

void DevicesPage::showHeadTracking()
{
    const TrackingState& tracking = m_headTracking->state();
    m_sign->setPixmap(signPixmap(signOf(tracking), palette(), kHeadSignPx, devicePixelRatioF()));
    m_state->setText(stateWords(tracking));
    m_help->setText(helpWords(tracking));
}

void DevicesPage::showPedals()
{
    const ControllerState& pedals = m_pedals->state();
    m_sign->setPixmap(signPixmap(signOf(pedals), palette(), kHeadSignPx, devicePixelRatioF()));
    m_state->setText(stateWords(pedals));
    m_help->setText(helpWords(pedals));
}

bool DevicesPage::isHand(const QString& id) const
{
    return id != QLatin1String(kHeadTracking) && id != QLatin1String(kPedals) && id != QLatin1String(kSound);
}

void DevicesPage::showSound()
{
    const sound::SoundReport& report = m_sound->report();
    m_sign->setPixmap(signPixmap(signOf(report), palette(), kHeadSignPx, devicePixelRatioF()));
    m_state->setText(stateWords(report));
    m_help->setText(helpWords(report));
}

/// Returns the check box that replaces the "use" button for head tracking and sound, otherwise null.
QCheckBox* DevicesPage::shownSwitch() const
{
    if (shownHand() == QLatin1String(kHeadTracking))
        return &m_headTracking->followSwitch();
    return shownHand() == QLatin1String(kSound) ? &m_sound->soundSwitch() : nullptr;
}

/// Emphasizes the button for the next step.
void DevicesPage::showNextStep()
{
    const QString id = shownHand();
    const Device* const device = find(id);
    const bool isChosen = id == m_chosen;
    const bool isReady = device == nullptr || device->report.stage == DeviceStage::Ready;
    m_firmware->setIsNextStep(isChosen && device != nullptr && device->report.stage == DeviceStage::NeedsFirmware);
    m_rule->setIsNextStep(isChosen);
    m_next->setVisible((!isChosen || isReady) && isHand(id));
    //: The button that leads back to the tooth
    m_next->setText(isChosen ? tr("Practise")
                             //: %1: "Novint Falcon", "Mouse or pen"
                             : tr("Use: %1").arg(handName(id)));
    m_next->setAccessibleName(m_next->text());
    const bool concernsSimulated = id == QLatin1String(kSimulated) || m_chosen == QLatin1String(kSimulated);
    const bool isFixed = !isChosen && concernsSimulated && !m_whySimulatedFixed.isEmpty();
    m_next->setEnabled(!isFixed && (device == nullptr || device->kind.isInBuild));
    m_next->setToolTip(isFixed ? m_whySimulatedFixed : QString());
}

void DevicesPage::takeNextStep()
{
    if (QCheckBox* const onOrOff = shownSwitch())
        onOrOff->setFocus();  // a click in the list must not switch a camera on
    else if (!isHand(shownHand()))
        m_pedals->setFocus();
    else if (!m_next->isEnabled())
        return;
    else if (shownHand() == m_chosen)
        m_back->trigger();
    else
        emit handRequested(shownHand());
}

void DevicesPage::showEvent(QShowEvent* event)
{
    Page::showEvent(event);
    if (event->spontaneous())
        return;
    closeGuide();
    m_hands->selectHand(m_chosen);
    m_hands->setFocus();
    emit opened(true);
}

void DevicesPage::resizeEvent(QResizeEvent* event)
{
    Page::resizeEvent(event);
    const bool isNarrow = width() < kNarrowPagePx;
    m_hands->setFixedWidth(isNarrow ? kNarrowHandsPx : kHandsPx);
    m_live->setNarrow(isNarrow);
    m_setup->setNarrow(isNarrow);
    m_headTracking->setNarrow(isNarrow);
}

void DevicesPage::hideEvent(QHideEvent* event)
{
    Page::hideEvent(event);
    if (!event->spontaneous())
        emit opened(false);
}

}  // namespace ui::devices
