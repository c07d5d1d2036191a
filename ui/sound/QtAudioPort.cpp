// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sound/QtAudioPort.h"

#include <algorithm>
#include <utility>

#include <QAudioDevice>
#include <QAudioSink>
#include <QMediaDevices>
#include <QTimer>

namespace ui::sound {
namespace {

constexpr int kLookMs = 1'000;

/// Returns the output with this id, or a null device if it is missing.
QAudioDevice deviceOf(const QByteArray& id)
{
    const QList<QAudioDevice> devices = QMediaDevices::audioOutputs();
    const auto found =
        std::find_if(devices.begin(), devices.end(), [&](const QAudioDevice& one) { return one.id() == id; });
    return found == devices.end() ? QAudioDevice() : *found;
}

/// The audio outputs of the system, as Qt Multimedia lists them.
///
/// Qt 6.4 with PulseAudio sends no signal when an output appears or vanishes, so the list is read every second. Samples
/// are pushed. If Qt pulls them, it fetches 20 ms at a time, and none at all from a shorter buffer, so a load would be
/// heard after 40 ms or more.
class QtAudioPort final : public AudioPort
{
public:
    QtAudioPort();
    ~QtAudioPort() override { close(); }

    [[nodiscard]] QList<OutputInfo> outputs() const override;
    [[nodiscard]] QList<AudioFormat> formats(const QByteArray& output) const override;
    [[nodiscard]] bool start(const QByteArray& output, const AudioFormat& format, QIODevice& source) override;
    void stop() override { close(); }

private:
    void close();
    void fill();
    void look();

    std::unique_ptr<QAudioSink> m_sink;
    QIODevice* m_to = nullptr;    ///< writes samples to m_sink
    QIODevice* m_from = nullptr;  ///< source of the samples
    QByteArray m_block;
    QTimer m_fill{this};
    QList<OutputInfo> m_known;
    QTimer m_look{this};
};

QtAudioPort::QtAudioPort() : m_known(QtAudioPort::outputs())
{
    m_look.setInterval(kLookMs);
    connect(&m_look, &QTimer::timeout, this, &QtAudioPort::look);
    m_look.start();
    m_fill.setTimerType(Qt::PreciseTimer);
    m_fill.setInterval(kFillMs);
    connect(&m_fill, &QTimer::timeout, this, &QtAudioPort::fill);
}

void QtAudioPort::look()
{
    const QList<OutputInfo> now = outputs();
    if (now == std::exchange(m_known, now))
        return;
    emit outputsChanged();
}

/// Fills the free part of the buffer.
void QtAudioPort::fill()
{
    const qint64 bytes = std::min<qint64>(m_sink->bytesFree(), m_block.size());
    if (bytes <= 0)
        return;
    const qint64 read = m_from->read(m_block.data(), bytes);
    if (read > 0)
        m_to->write(m_block.constData(), read);
}

QList<OutputInfo> QtAudioPort::outputs() const
{
    QList<OutputInfo> outputs;
    for (const QAudioDevice& device : QMediaDevices::audioOutputs())
        outputs.push_back({device.id(), device.description(), device.isDefault()});
    return outputs;
}

QList<AudioFormat> QtAudioPort::formats(const QByteArray& output) const
{
    constexpr int kLeastRateHz = 22'050;
    constexpr int kMostRateHz = 96'000;
    QList<int> rates{48'000, 44'100, kLeastRateHz};
    // The output's preferred rate needs no conversion, so it is tried first.
    const int own = deviceOf(output).preferredFormat().sampleRate();
    if (own >= kLeastRateHz && own <= kMostRateHz) {
        rates.removeAll(own);
        rates.prepend(own);
    }
    QList<AudioFormat> formats;
    for (const int rate : rates)
        for (const int channels : {2, 1})
            for (const bool isFloat : {true, false})
                formats.push_back({rate, channels, isFloat});
    return formats;
}

bool QtAudioPort::start(const QByteArray& output, const AudioFormat& format, QIODevice& source)
{
    close();
    const QAudioDevice device = deviceOf(output);
    QAudioFormat wanted;
    wanted.setSampleRate(format.rateHz);
    wanted.setChannelCount(format.channels);
    wanted.setSampleFormat(format.isFloat ? QAudioFormat::Float : QAudioFormat::Int16);
    if (device.isNull() || !device.isFormatSupported(wanted))
        return false;
    constexpr int kUsInMs = 1'000;
    constexpr int kMostFillMs = 200;
    m_sink = std::make_unique<QAudioSink>(device, wanted);
    m_sink->setBufferSize(wanted.bytesForDuration(kBufferMs * kUsInMs));
    m_to = m_sink->start();
    if (m_to == nullptr || m_sink->error() != QAudio::NoError || m_sink->state() == QAudio::StoppedState) {
        m_sink.reset();
        return false;
    }
    // Queued, because the receiver may destroy the sink.
    connect(
        m_sink.get(), &QAudioSink::stateChanged, this,
        [this](QAudio::State state) {
            if (m_sink && state == QAudio::StoppedState && m_sink->state() == QAudio::StoppedState)
                emit stopped();
        },
        Qt::QueuedConnection);
    m_from = &source;
    m_block.resize(wanted.bytesForDuration(kMostFillMs * kUsInMs));
    fill();
    m_fill.start();
    return true;
}

void QtAudioPort::close()
{
    if (!m_sink)
        return;
    m_fill.stop();
    m_sink->disconnect(this);
    m_sink->stop();
    m_sink.reset();
}

}  // namespace

std::unique_ptr<AudioPort> qtAudioPort()
{
    return std::make_unique<QtAudioPort>();
}

}  // namespace ui::sound
