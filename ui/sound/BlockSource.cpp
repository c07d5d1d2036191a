// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sound/BlockSource.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/audio/Audition.h"
#include "core/rt/TripleBuffer.h"

namespace ui::sound {
namespace {

template <class T>
char* putFrame(char* data, T value, int channels)
{
    for (int channel = 0; channel < channels; ++channel) {
        std::memcpy(data, &value, sizeof value);
        data += sizeof value;
    }
    return data;
}

}  // namespace

BlockSource::BlockSource(core::rt::TripleBuffer<core::audio::SoundState>& state)
    : m_state(&state), m_synthesizer(m_format.rateHz)
{
    // Unbuffered, because Qt would fill a buffer of its own far ahead.
    open(QIODevice::ReadOnly | QIODevice::Unbuffered);
}

void BlockSource::begin(const AudioFormat& format)
{
    m_format = format;
    m_synthesizer = core::audio::Synthesizer(format.rateHz);
    m_synthesizer.setVolumes(m_volumes);
}

void BlockSource::setVolumes(const core::audio::Volumes& volumes)
{
    m_volumes = volumes;
    m_synthesizer.setVolumes(volumes);
}

qint64 BlockSource::bytesAvailable() const
{
    constexpr qint64 kPlenty = 1 << 20;
    return kPlenty;
}

core::audio::SoundState BlockSource::next(std::size_t frames)
{
    if (!m_sampleFrame)
        return m_isHeard ? m_state->latest() : core::audio::SoundState{};
    const double seconds = static_cast<double>(*m_sampleFrame) / m_format.rateHz;
    *m_sampleFrame += frames;
    if (seconds >= core::audio::kAuditionS)
        m_sampleFrame.reset();
    return core::audio::auditionAt(seconds);
}

qint64 BlockSource::readData(char* data, qint64 mostBytes)
{
    const auto sampleBytes = m_format.isFloat ? sizeof(float) : sizeof(qint16);
    const std::size_t frameBytes = sampleBytes * static_cast<std::size_t>(m_format.channels);
    std::size_t left = static_cast<std::size_t>(std::max<qint64>(0, mostBytes)) / frameBytes;
    const auto bytes = static_cast<qint64>(left * frameBytes);
    while (left > 0) {
        const std::size_t frames = std::min(left, kBlockFrames);
        const std::span<float> block(m_block.data(), frames);
        m_synthesizer.render(next(frames), block);
        constexpr float kFullScale = 32767.0F;
        for (const float sample : block)
            data = m_format.isFloat
                       ? putFrame(data, sample, m_format.channels)
                       : putFrame(data, static_cast<qint16>(std::lround(kFullScale * sample)), m_format.channels);
        left -= frames;
    }
    return bytes;
}

qint64 BlockSource::writeData(const char* /*data*/, qint64 /*bytes*/)
{
    return -1;
}

}  // namespace ui::sound
