// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>

#include <QObject>
#include <QTimer>

namespace ui::window {

/// Detects that nobody has used the program for a given time.
///
/// Keys, mouse, pen and touch screen count as use, in every window of the program; touch() adds other kinds.
class IdleLock final : public QObject
{
    Q_OBJECT
public:
    /// Returns the time since a fixed moment in the past. The time never decreases.
    using Clock = std::function<std::chrono::milliseconds()>;

    /// Starts with a limit of ten minutes.
    explicit IdleLock(Clock clock, QObject* parent);

    /// Sets the time without use after which expired() is emitted.
    void setLimit(std::chrono::milliseconds limit);
    /// Restarts the time.
    void touch() { m_touchedAt = m_clock(); }
    /// Emits expired() if the limit has passed. A timer calls this twenty times within the limit.
    void check();

    /// Returns the steady clock of the system.
    [[nodiscard]] static Clock steadyClock();

signals:
    /// Emitted at each check after the limit has passed, until the program is used again.
    void expired();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    Clock m_clock;
    std::chrono::milliseconds m_limit{};
    std::chrono::milliseconds m_touchedAt{};
    QTimer m_timer;
};

}  // namespace ui::window
