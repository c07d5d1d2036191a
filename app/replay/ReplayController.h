// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QObject>
#include <QTimer>

#include "app/replay/ReplayLoop.h"
#include "app/threads/LoopThread.h"
#include "core/session/SessionChannels.h"
#include "ui/window/MainWindow.h"

namespace app {

/// A replay that is on: the loop that plays it, its threads, and what the window requests of it. Ui thread.
class ReplayController final : public QObject
{
    Q_OBJECT

public:
    /// @param links   of the replay alone; must outlive it, as the window
    /// @param generation     of the recording's tooth in the window, which is yet to be shown
    /// @param device         one that can lead a hand, which nobody else reads meanwhile; null: there is none
    [[nodiscard]] static core::Result<std::unique_ptr<ReplayController>>
    make(const core::recording::Recording& recording, core::session::UiChannels& links, ui::window::MainWindow& window,
         std::uint64_t generation, haptics::HapticDevice* device);
    ~ReplayController() override;

    /// Once the window shows the recording's tooth.
    void start();
    /// Before start(): works all of it out and shows its end.
    void goToEnd() { m_loop.goToEnd(); }
    /// Plays from a little before a moment, seen as the student saw that moment.
    void playTo(double momentS);

    /// Shows another attempt beside this one, in the place of what is there.
    [[nodiscard]] core::Status putBeside(const core::recording::Recording& recording, const QString& name);
    void closeBeside();

    [[nodiscard]] const ReplayTrack& attempt() const { return m_loop.attempt(); }
    /// The device leads the hand, which is shown in place of the recorded one.
    [[nodiscard]] bool isLeading() const { return m_guide && m_loop.hand() == ReplayLoop::Hand::Led; }

private:
    ReplayController(std::unique_ptr<ReplayTrack> attempt, ui::window::MainWindow& window,
                     haptics::HapticDevice* device);
    void startThreads();
    void stopThreads();
    void lead(bool wanted);
    void watch();
    void watchHand();
    void lookAtMoment();

    ui::window::MainWindow& m_window;
    ReplayLoop m_loop;
    QTimer m_watch;
    double m_toldReadyS = -1.0;  ///< as the window knows the course
    double m_toldBesideS = -1.0;
    std::optional<double> m_momentS;                           ///< the view still has to be turned to it
    std::unique_ptr<core::session::UiChannels> m_besideLinks;  ///< of the attempt beside
    haptics::HapticDevice* m_device;
    haptics::GuideLinks m_guideLinks;
    std::unique_ptr<haptics::GuideLoop> m_guide;  ///< once a lead was wanted
    ReplayLoop::Hand m_toldHand = ReplayLoop::Hand::Free;

    // Threads last: they are joined before what they run on goes away.
    std::unique_ptr<LoopThread> m_preparing;
    std::unique_ptr<LoopThread> m_playing;
    std::unique_ptr<LoopThread> m_leading;
};

}  // namespace app
