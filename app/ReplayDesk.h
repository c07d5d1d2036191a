// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QObject>
#include <QTimer>

#include "app/LoopThread.h"
#include "app/ReplayLoop.h"
#include "ui/shell/MainWindow.h"

namespace app {

/// A replay that is on: the loop that plays it, its threads, and the window's wishes about it. While it lives, nobody
/// else may write what the window reads of servo and session. Ui thread.
class ReplayDesk final : public QObject
{
    Q_OBJECT

public:
    /// @param links, window  must outlive it
    /// @param generation     of the recording's tooth in the window, which is yet to be shown
    [[nodiscard]] static core::Result<std::unique_ptr<ReplayDesk>> make(const core::recording::Recording& recording,
                                                                        core::session::UiLinks& links,
                                                                        ui::shell::MainWindow& window,
                                                                        std::uint64_t generation);
    ~ReplayDesk() override;

    /// Once the window shows the recording's tooth.
    void start();
    /// Before start(): works all of it out and shows its end.
    void goToEnd() { m_loop.goToEnd(); }
    /// Shows a moment, and holds it.
    void holdAt(double seconds);

    [[nodiscard]] const ReplayTrack& attempt() const { return m_loop.attempt(); }

private:
    ReplayDesk(std::unique_ptr<ReplayTrack> attempt, ui::shell::MainWindow& window);
    void watch();

    ui::shell::MainWindow& m_window;
    ReplayLoop m_loop;
    QTimer m_watch;
    double m_toldReadyS = -1.0;  ///< as the window knows the course

    // Threads last: they are joined before what they run on goes away.
    std::unique_ptr<LoopThread> m_preparing;
    std::unique_ptr<LoopThread> m_playing;
};

}  // namespace app
