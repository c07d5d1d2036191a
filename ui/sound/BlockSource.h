// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include <QIODevice>

#include "core/audio/Synthesizer.h"
#include "core/rt/TripleBuffer.h"
#include "ui/sound/AudioPort.h"

namespace ui::sound {

/// Endless source of samples for an audio output. Every few milliseconds it reads the newest state of the servo and
/// lets the synthesiser compute a block of samples. Sound thread.
class BlockSource final : public QIODevice
{
    Q_OBJECT
public:
    /// Frames between two reads of the state, 5 ms at 48 kHz. A larger audio buffer does not make the steps coarser.
    static constexpr std::size_t kBlockFrames = 240;

    /// @param state  must outlive the source, which is its only reader
    explicit BlockSource(core::rt::TripleBuffer<core::audio::SoundState>& state);

    /// Reads another state from now on. It must outlive the source, which must be its only reader.
    void setState(core::rt::TripleBuffer<core::audio::SoundState>& state) { m_state = &state; }

    /// Starts with a format. Discards earlier sound.
    void begin(const AudioFormat& format);
    void setVolumes(const core::audio::Volumes& volumes);
    /// Sets whether the state of the servo is audible. If not, the sound of the handpiece runs down.
    void setHeard(bool isHeard) { m_isHeard = isHeard; }
    /// Plays the sample (core::audio::auditionAt) from its beginning, instead of the state.
    void playSample() { m_sampleFrame = 0; }
    void stopSample() { m_sampleFrame.reset(); }
    [[nodiscard]] bool isPlayingSample() const { return m_sampleFrame.has_value(); }

    [[nodiscard]] bool isSequential() const override { return true; }
    [[nodiscard]] qint64 bytesAvailable() const override;

protected:
    /// Reads whole frames only.
    qint64 readData(char* data, qint64 mostBytes) override;
    qint64 writeData(const char* data, qint64 bytes) override;

private:
    [[nodiscard]] core::audio::SoundState next(std::size_t frames);

    core::rt::TripleBuffer<core::audio::SoundState>* m_state;
    AudioFormat m_format;
    core::audio::Synthesizer m_synthesizer;
    core::audio::Volumes m_volumes;
    std::array<float, kBlockFrames> m_block{};
    std::optional<std::size_t> m_sampleFrame;  ///< next frame of the sample; empty: it is not playing
    bool m_isHeard = false;
};

}  // namespace ui::sound
