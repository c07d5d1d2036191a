// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include <QWidget>

#include "core/session/DeviceReport.h"

class QDoubleSpinBox;
class QLabel;
class QLayout;
class QPushButton;
class QRadioButton;

namespace ui::kit {
class Actions;
}

namespace ui::devices {

class HandGuidePicture;
class StillnessTest;

/// A guide to steady drilling: the hand, the screen, the hand rest, and a test of steadiness. Each step has a picture.
/// Every setting is applied at once.
class HandGuide : public QWidget
{
    Q_OBJECT
public:
    HandGuide(const kit::Actions& actions, QWidget* parent);

    /// Shows the first step for a mouse or a pen.
    void begin();
    /// Shows the first step for a force device.
    void begin(const QString& deviceName, const core::session::DeviceSetup& setup,
               const core::session::DeviceReport& report);
    /// Sets the newest report of the force device.
    void setReport(const core::session::DeviceReport& report);
    void setSetup(const core::session::DeviceSetup& setup);

signals:
    /// Emitted when the user has changed the height of the rest or the scale of the force device.
    void setupChanged(const core::session::DeviceSetup& setup);
    /// Emitted when the user has completed or left the guide.
    void closed();

protected:
    void hideEvent(QHideEvent* event) override;

private:
    enum class Step : std::uint8_t { Hand, Screen, Rest, Still, Summary };

    QWidget* makeCard(QWidget* parent);
    QLayout* makeButtons(QWidget* parent);
    QWidget* makeHand(QWidget* parent);
    QWidget* makeRest(QWidget* parent);
    QWidget* makeSummary(QWidget* parent);
    void showStep(Step step);
    void showWords();
    void showHeight();
    void storeHeight(double gripMm);
    void change(const core::session::DeviceSetup& setup);
    [[nodiscard]] QString titleWords() const;
    [[nodiscard]] QString helpWords() const;
    [[nodiscard]] QString restWords() const;
    [[nodiscard]] QString summaryWords() const;
    /// Returns the height of the grip above the middle of the work area, mm. Empty if the device is not ready.
    [[nodiscard]] std::optional<double> gripMm() const;

    QAction* m_otherHand;
    Step m_step = Step::Hand;
    QString m_deviceName;
    bool m_hasForce = false;
    core::session::DeviceSetup m_setup;
    core::session::DeviceReport m_report;
    std::optional<double> m_refusedMm;  ///< requested height from which the tooth cannot be reached

    QLabel* m_count;
    QLabel* m_title;
    QLabel* m_help = nullptr;
    HandGuidePicture* m_picture = nullptr;
    QWidget* m_hand = nullptr;
    QRadioButton* m_right = nullptr;
    QRadioButton* m_left = nullptr;
    QWidget* m_rest = nullptr;
    QLabel* m_height = nullptr;
    QPushButton* m_store = nullptr;
    QPushButton* m_middle = nullptr;
    QLabel* m_stored = nullptr;
    StillnessTest* m_still = nullptr;
    QWidget* m_summary = nullptr;
    QDoubleSpinBox* m_scale = nullptr;
    QPushButton* m_back = nullptr;
    QPushButton* m_next = nullptr;
};

}  // namespace ui::devices
