// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sound/SoundPlayer.h"

#include <algorithm>
#include <utility>

namespace ui::sound {
namespace {

constexpr int kSampleWatchMs = 100;

}  // namespace

SoundPlayer::SoundPlayer(MakePort makePort, core::rt::TripleBuffer<core::audio::SoundState>& state)
    : m_makePort(std::move(makePort)), m_source(state)
{
    m_source.setParent(this);
    m_retry.setSingleShot(true);
    m_retry.setInterval(kRetryMs);
    connect(&m_retry, &QTimer::timeout, this, &SoundPlayer::listOutputs);
    m_idle.setSingleShot(true);
    m_idle.setInterval(kIdleMs);
    connect(&m_idle, &QTimer::timeout, this, [this] {
        close();
        report();
    });
    m_sampleWatch.setInterval(kSampleWatchMs);
    connect(&m_sampleWatch, &QTimer::timeout, this, [this] {
        if (m_source.isPlayingSample() && m_rateHz != 0)
            return;
        m_sampleWatch.stop();
        m_source.stopSample();
        update();
    });
}

void SoundPlayer::begin()
{
    m_port = m_makePort();
    connect(m_port.get(), &AudioPort::outputsChanged, this, &SoundPlayer::listOutputs);
    connect(m_port.get(), &AudioPort::stopped, this, &SoundPlayer::lose);
    listOutputs();
}

void SoundPlayer::end()
{
    if (m_isOpening) {
        QMetaObject::invokeMethod(this, &SoundPlayer::end, Qt::QueuedConnection);
        return;
    }
    m_retry.stop();
    m_idle.stop();
    m_sampleWatch.stop();
    m_port.reset();
    m_rateHz = 0;
    emit ended();
}

void SoundPlayer::setSettings(const SoundSettings& settings)
{
    const bool isOther = settings.output != m_settings.output;
    m_settings = settings;
    core::audio::Volumes volumes = settings.volumes;
    volumes.isMuted = !settings.isOn;
    m_source.setVolumes(volumes);
    if (isOther)
        m_isRefused = false;
    update();
}

void SoundPlayer::setHeard(bool isHeard)
{
    m_isHeard = isHeard;
    m_source.setHeard(isHeard);
    update();
}

void SoundPlayer::playSample()
{
    if (!m_settings.isOn)
        return;
    m_source.playSample();
    update();
    m_sampleWatch.start();
}

/// Lists the outputs, and retries one that has failed.
void SoundPlayer::listOutputs()
{
    const QList<OutputInfo> outputs = m_port->outputs();
    m_isRefused = false;
    if (outputs != m_outputs) {
        m_outputs = outputs;
        emit outputsFound(m_outputs);
    }
    update();
}

/// Returns the output to play on, or null if there is none.
const OutputInfo* SoundPlayer::chosenOutput() const
{
    const auto first = [this](auto fits) { return std::find_if(m_outputs.begin(), m_outputs.end(), fits); };
    auto found = first([this](const OutputInfo& one) { return one.id == m_settings.output; });
    if (found == m_outputs.end())
        found = first([](const OutputInfo& one) { return one.isDefault; });
    if (found == m_outputs.end())
        found = m_outputs.begin();
    return found == m_outputs.end() ? nullptr : &*found;
}

/// Opens, changes or closes the output to match the settings and whether the handpiece is in use.
void SoundPlayer::update()
{
    if (!m_port)
        return;
    if (m_isOpening) {
        m_isChanged = true;
        return;
    }
    const OutputInfo* const wanted = chosenOutput();
    if (m_rateHz != 0 && (wanted == nullptr || wanted->id != m_playing.id))
        close();
    if (m_settings.isOn && (m_isHeard || m_source.isPlayingSample())) {
        m_idle.stop();
        if (m_rateHz == 0 && !m_isRefused)
            open();
    } else if (m_rateHz != 0 && !m_idle.isActive()) {
        m_idle.start();  // until the handpiece has run down
    }
    report();
    if (std::exchange(m_isChanged, false))
        update();
}

void SoundPlayer::open()
{
    const OutputInfo* const chosen = chosenOutput();
    if (chosen == nullptr)
        return;
    const OutputInfo wanted = *chosen;
    m_isOpening = true;
    const QList<AudioFormat> formats = m_port->formats(wanted.id);
    const auto taken = std::find_if(formats.begin(), formats.end(), [&](const AudioFormat& format) {
        m_source.begin(format);
        return m_port->start(wanted.id, format, m_source);
    });
    m_isOpening = false;
    if (taken != formats.end()) {
        m_playing = wanted;
        m_rateHz = taken->rateHz;
        return;
    }
    m_isRefused = true;
    m_retry.start();
}

void SoundPlayer::close()
{
    m_idle.stop();
    m_port->stop();
    m_rateHz = 0;
}

/// Handles an output that has stopped by itself. It may be gone, or return in a moment.
void SoundPlayer::lose()
{
    if (m_isOpening)
        return;
    close();
    m_isRefused = true;
    m_retry.start();
    report();
}

void SoundPlayer::report()
{
    SoundReport report;
    const OutputInfo* const wanted = chosenOutput();
    if (!m_settings.isOn)
        report.stage = SoundStage::Off;
    else if (wanted == nullptr)
        report.stage = SoundStage::NoOutput;
    else if (m_isRefused)
        report.stage = SoundStage::Refused;
    else
        report.stage = m_rateHz != 0 ? SoundStage::Playing : SoundStage::Ready;
    report.output = wanted == nullptr ? QString() : wanted->name;
    report.isFallback = wanted != nullptr && !m_settings.output.isEmpty() && wanted->id != m_settings.output;
    report.rateHz = m_rateHz;
    report.isPlayingSample = m_source.isPlayingSample() && m_rateHz != 0;
    emit reported(report);
}

}  // namespace ui::sound
