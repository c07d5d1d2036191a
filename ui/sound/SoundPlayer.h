// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include <QTimer>

#include "ui/sound/AudioPort.h"
#include "ui/sound/BlockSource.h"

namespace ui::sound {

/// Plays the sound of the handpiece on the output that the user has chosen.
///
/// If that output is missing, plays on the system's default output until it returns. If an output rejects a format, the
/// next one is tried. Without any output there is no sound, and the report says so.
///
/// Lives in the sound thread. All functions except the constructor are called there, and the port is created there.
class SoundPlayer final : public QObject
{
    Q_OBJECT
public:
    using MakePort = std::function<std::unique_ptr<AudioPort>()>;
    /// Time after which a failed output is tried again, and an unused output is closed.
    static constexpr int kRetryMs = 1'000;
    static constexpr int kIdleMs = 1'500;

    /// @param state  must outlive the player, which is its only reader
    SoundPlayer(MakePort makePort, core::rt::TripleBuffer<core::audio::SoundState>& state);

    /// Creates the port and looks for outputs. Call this first.
    void begin();
    /// Closes the port, then emits ended(). Call this last, while the thread runs.
    void end();
    void setSettings(const SoundSettings& settings);
    /// Sets whether the handpiece at the tooth is audible now.
    void setHeard(bool isHeard);
    void playSample();
    /// Plays another state from now on. It must outlive the player, too.
    void setState(core::rt::TripleBuffer<core::audio::SoundState>& state) { m_source.setState(state); }

signals:
    void reported(const ui::sound::SoundReport& report);
    void ended();
    void outputsFound(const QList<ui::sound::OutputInfo>& outputs);

private:
    void listOutputs();
    void update();
    void open();
    void close();
    void lose();
    void report();
    [[nodiscard]] const OutputInfo* chosenOutput() const;

    MakePort m_makePort;
    std::unique_ptr<AudioPort> m_port;
    BlockSource m_source;
    SoundSettings m_settings;
    QList<OutputInfo> m_outputs;
    OutputInfo m_playing;  ///< the open output; valid while m_rateHz is not 0
    int m_rateHz = 0;      ///< 0: no output is open
    bool m_isHeard = false;
    bool m_isRefused = false;
    bool m_isOpening = false;  ///< an output is being opened; changes that arrive meanwhile are applied afterwards
    bool m_isChanged = false;  ///< outputs or settings changed while an output was being opened
    QTimer m_retry{this};
    QTimer m_idle{this};
    QTimer m_sampleWatch{this};
};

}  // namespace ui::sound
