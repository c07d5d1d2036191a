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

/// Measures drift and tremor while the user holds the hand still for 8 seconds. Measures the grip of a force device or,
/// without one, the pointer on the screen.
class StillnessTest : public QWidget
{
    Q_OBJECT
public:
    static constexpr double kLeadS = 2.0;  ///< time from pressing the button to the start of the measurement

    explicit StillnessTest(QWidget* parent);

    /// Clears the result.
    /// @param hasForce  measures a force device instead of the pointer
    void begin(bool hasForce);
    /// Sets the position of the force device's bur, tooth frame, mm. Empty: the device is not ready.
    void setBur(std::optional<glm::dvec3> burMm);
    /// Sets the focus to the start button, so that the space bar starts the test.
    void focusStart();
    /// Stops a running test.
    void stop();
    [[nodiscard]] const std::optional<core::session::Stillness>& result() const { return m_result; }
    /// Returns the meaning of the figures in words. Empty before the first result.
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
    std::optional<core::session::StillnessCheck> m_check;  ///< of the running test
    std::optional<core::session::Stillness> m_result;
    const char* m_failure = nullptr;  ///< untranslated text
    double m_startS = 0.0;
    QTimer m_look{this};
    QLabel* m_words;
    QProgressBar* m_progress;
    QPushButton* m_start;
};

}  // namespace ui::devices
