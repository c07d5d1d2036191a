// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include <QTimer>
#include <QWidget>

#include "core/session/StillnessCheck.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace ui::devices {

/// Lets the user hold the hand still for 8 seconds, and says how far it drifted and trembled. It looks at the grip of a
/// force device or, without one, at the pointer on the screen.
class StillnessTest : public QWidget
{
    Q_OBJECT
public:
    static constexpr double kLeadS = 2.0;  ///< from the button to the first measured moment

    explicit StillnessTest(QWidget* parent);

    /// Forgets the result.
    /// @param hasForce  a force device is measured; otherwise the pointer
    void begin(bool hasForce);
    /// Sets where the bur of the force device is, mm, in the frame of the tooth. Empty if the device is not ready.
    void setBur(std::optional<glm::dvec3> burMm);
    /// Lets the space bar start the test.
    void focusStart();
    /// Stops a test that is running.
    void stop();
    [[nodiscard]] const std::optional<core::session::Stillness>& result() const { return m_result; }
    /// Returns what the figures mean, in words. Empty before the first result.
    [[nodiscard]] QString resultWords() const;
    /// For tests: replaces the clock, which returns seconds.
    void setClock(std::function<double()> clock) { m_clock = std::move(clock); }

private:
    void start();
    void look();
    void fail(const char* words);
    void showWords();
    [[nodiscard]] glm::dvec3 pointerMm() const;

    std::function<double()> m_clock;
    bool m_hasForce = false;
    std::optional<glm::dvec3> m_burMm;
    std::optional<core::session::StillnessCheck> m_check;  ///< runs
    std::optional<core::session::Stillness> m_result;
    const char* m_failure = nullptr;  ///< to be translated
    double m_startS = 0.0;
    QTimer m_look{this};
    QLabel* m_words;
    QProgressBar* m_progress;
    QPushButton* m_start;
};

}  // namespace ui::devices
