// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/devices/SoundController.h"

#include <utility>

#include <QGuiApplication>

#include "app/devices/SoundStore.h"
#include "ui/devices/DevicesPage.h"
#include "ui/devices/SoundCard.h"
#include "ui/devices/SoundWords.h"
#include "ui/kit/Actions.h"
#include "ui/kit/MessageBar.h"
#include "ui/tooth/ToothView.h"

namespace app {
namespace {

using ui::devices::SoundCard;
using ui::kit::MessageBar;
using ui::sound::OutputInfo;
using ui::sound::SoundPlayer;
using ui::sound::SoundReport;
using ui::sound::SoundSettings;
using ui::sound::SoundStage;

constexpr int kLookMs = 100;

}  // namespace

SoundController::SoundController(ui::window::MainWindow& window, core::rt::TripleBuffer<core::audio::SoundState>& sound,
                                 SoundPlayer::MakePort makePort)
    : m_window(window), m_settings(storedSound()), m_player(std::move(makePort), sound)
{
    SoundCard& card = m_window.devicesPage().sound();
    connect(&card, &SoundCard::settingsChanged, this, &SoundController::change);
    connect(&card, &SoundCard::sampleRequested, this, [this] { tell([this] { m_player.playSample(); }); });
    connect(m_window.actions().sound, &QAction::triggered, this, &SoundController::turn);
    connect(&m_player, &SoundPlayer::reported, &card, &SoundCard::setReport);
    connect(&m_player, &SoundPlayer::reported, this, &SoundController::take);
    connect(&m_player, &SoundPlayer::outputsFound, &card, &SoundCard::setOutputs);
    card.setSettings(m_settings);
    m_window.actions().sound->setChecked(m_settings.isOn);
    m_player.moveToThread(&m_thread);
    m_thread.setObjectName(QStringLiteral("sound"));
    m_thread.start(QThread::HighPriority);
    tell([this, settings = m_settings] {
        m_player.setSettings(settings);
        m_player.begin();
    });
    m_watch.setInterval(kLookMs);
    connect(&m_watch, &QTimer::timeout, this, &SoundController::watch);
    m_watch.start();
}

SoundController::~SoundController()
{
    connect(&m_player, &SoundPlayer::ended, &m_thread, &QThread::quit, Qt::DirectConnection);
    tell([this] { m_player.end(); });
    m_thread.wait();
}

void SoundController::play(core::rt::TripleBuffer<core::audio::SoundState>& sound)
{
    tell([this, state = &sound] { m_player.setState(*state); });
}

void SoundController::change(const SoundSettings& settings)
{
    m_settings = settings;
    storeSound(m_settings);
    m_window.actions().sound->setChecked(m_settings.isOn);
    tell([this, settings] { m_player.setSettings(settings); });
}

void SoundController::turn(bool isOn)
{
    SoundSettings settings = m_settings;
    settings.isOn = isOn;
    m_window.devicesPage().sound().setSettings(settings);
    change(settings);
    m_window.messages().withdraw(MessageBar::Topic::Sound);
    m_window.messages().say([this, isOn] {
        MessageBar::Message message;
        const QString key = m_window.actions().sound->shortcut().toString(QKeySequence::NativeText);
        //: %1: a key
        message.sentence = isOn ? tr("The sound is on.") : tr("The sound is off. %1 turns it on again.").arg(key);
        message.topic = MessageBar::Topic::Sound;
        return message;
    });
}

/// Shows a message, once, when an output that was playing has failed and the tooth is visible. The page of devices
/// shows the state in any case.
void SoundController::take(const SoundReport& report)
{
    const bool isSilent = report.stage == SoundStage::NoOutput || report.stage == SoundStage::Refused;
    if (!isSilent) {
        m_hasPlayed = m_hasPlayed || report.stage == SoundStage::Playing;
        if (std::exchange(m_isTold, false))
            m_window.messages().withdraw(MessageBar::Topic::Sound);
        return;
    }
    if (!std::exchange(m_hasPlayed, false) || !m_window.view().isVisible())
        return;
    m_isTold = true;
    m_window.messages().say([this, report] {
        MessageBar::Message message;
        message.kind = MessageBar::Kind::News;
        message.sentence = ui::devices::stateWords(report);
        message.detail = ui::devices::helpWords(report);
        message.actionText = tr("Show the device");
        message.action = [this] { m_window.actions().devices->trigger(); };
        message.topic = MessageBar::Topic::Sound;
        return message;
    });
}

/// Turns the sound off while another page covers the tooth or another program is active.
void SoundController::watch()
{
    const bool isHeard = m_window.view().isVisible() && !m_window.isMinimized() &&
                         QGuiApplication::applicationState() == Qt::ApplicationActive;
    if (isHeard == m_isHeard)
        return;
    m_isHeard = isHeard;
    tell([this, isHeard] { m_player.setHeard(isHeard); });
}

}  // namespace app
