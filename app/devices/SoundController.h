// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThread>
#include <QTimer>

#include "ui/sound/SoundPlayer.h"
#include "ui/window/MainWindow.h"

namespace app {

/// Plays the sound of the handpiece in a thread of its own, shows its state on the page of devices and stores the
/// settings. The sound plays while the tooth is visible and the window is active. Ui thread.
class SoundController final : public QObject
{
    Q_OBJECT

public:
    /// @param sound  must outlive the controller, which is its only reader
    /// @param makePort  called in the sound thread
    SoundController(ui::window::MainWindow& window, core::rt::TripleBuffer<core::audio::SoundState>& sound,
                    ui::sound::SoundPlayer::MakePort makePort);
    ~SoundController() override;

    /// Plays the sound of another state from now on: that of a replay, or again that of the servo.
    /// @param sound  must outlive the controller
    void play(core::rt::TripleBuffer<core::audio::SoundState>& sound);

private:
    void change(const ui::sound::SoundSettings& settings);
    void turn(bool isOn);
    void watch();
    void take(const ui::sound::SoundReport& report);
    /// Calls a function of the player in its thread.
    template <class Work>
    void tell(Work work)
    {
        QMetaObject::invokeMethod(&m_player, std::move(work), Qt::QueuedConnection);
    }

    ui::window::MainWindow& m_window;
    ui::sound::SoundSettings m_settings;
    ui::sound::SoundPlayer m_player;
    QThread m_thread;
    QTimer m_watch;
    bool m_isHeard = false;
    bool m_hasPlayed = false;  ///< sound has played since the last message that it does not
    bool m_isTold = false;     ///< a message says that no sound plays
};

}  // namespace app
