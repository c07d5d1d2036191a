// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include <QList>
#include <glm/vec3.hpp>

#include "core/session/DeviceReport.h"
#include "ui/devices/DeviceKind.h"
#include "ui/kit/Page.h"

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace ui::devices {

class FirmwareCard;
class HandGuide;
class HandList;
class HeadTrackingCard;
class HomingMarks;
class LiveTest;
class PedalCard;
class PenCard;
class RuleCard;
class SetupCard;
class SoundCard;

/// The page on which the user chooses and tests an input device: mouse or pen, a simulated hand, or a force device.
/// Head tracking, foot pedals, gamepads and sound are set up here, too.
///
/// The page opens no device. Its owner passes reports to it and handles its signals.
class DevicesPage : public kit::Page
{
    Q_OBJECT
public:
    DevicesPage(const kit::Actions& actions, QWidget* parent);

    /// Sets the kinds of force devices, in the order of the list. They have no reports yet.
    void setKinds(const QList<DeviceKind>& kinds);
    void setReport(const QString& id, const core::session::DeviceReport& report);
    void setSetup(const QString& id, const core::session::DeviceSetup& setup);
    void setFirmware(const QString& id, const FirmwareFile& file);
    /// Sets the device in use and selects it.
    void setChosen(const QString& id);
    /// @param whyNot  why the user cannot switch to or from the simulated hand now; empty: they can
    void setSimulatedFixed(const QString& whyNot);

    /// Returns the id of the selected row: a device, kHeadTracking, kPedals or kSound.
    [[nodiscard]] QString shownHand() const;
    /// Goes back from the guide to the list of devices.
    [[nodiscard]] bool stepBack() override;
    /// Returns the force of the test button being held, tooth frame, N. Zero if none is held.
    [[nodiscard]] glm::dvec3 testForce() const;

    /// Returns the card of head tracking, for its setters and signals.
    [[nodiscard]] HeadTrackingCard& headTracking() { return *m_headTracking; }

    /// Returns the card of foot pedals and gamepads, likewise.
    [[nodiscard]] PedalCard& pedals() { return *m_pedals; }
    /// Returns the card of the pen of a graphics tablet, likewise.
    [[nodiscard]] PenCard& pen() { return *m_pen; }
    /// Returns the card of sound, likewise.
    [[nodiscard]] SoundCard& sound() { return *m_sound; }

    /// Opens the guide for hand and rest for the selected device. If no input device is selected, opens it for the one
    /// in use.
    void openGuide();

    /// Returns "Mouse or pen", "Simulated hand", "Head tracking", "Pedal and gamepad", "Sound", or a product name.
    [[nodiscard]] QString handName(const QString& id) const;

signals:
    /// Emitted when the user chooses a device for use.
    void handRequested(const QString& id);
    void setupChanged(const QString& id, const core::session::DeviceSetup& setup);
    void firmwareChosen(const QString& id, const QString& path);
    /// Emitted when the page opens and when it closes.
    void opened(bool isOpen);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Device
    {
        DeviceKind kind;
        core::session::DeviceReport report;
        core::session::DeviceSetup setup;
        FirmwareFile firmware;
    };
    QWidget* makeHead();
    QWidget* makeHands();
    QWidget* makeHoming(QWidget* parent);
    void makeGuide();
    void closeGuide();
    void showHands();
    void showHand();
    void showStage(const Device& device);
    void showHeadTracking();
    void showPedals();
    [[nodiscard]] bool isHand(const QString& id) const;
    void showSound();
    [[nodiscard]] QCheckBox* shownSwitch() const;
    void showNextStep();
    void takeNextStep();
    [[nodiscard]] const Device* find(const QString& id) const;
    [[nodiscard]] Device* find(const QString& id);

    QAction* m_back;
    QWidget* m_devicesPart;  ///< all parts except the guide
    HandGuide* m_guide;
    QString m_guideHand;  ///< id of the force device in the guide
    QPushButton* m_openGuide = nullptr;
    QList<Device> m_devices;
    QString m_chosen;
    QString m_whySimulatedFixed;

    HandList* m_hands;
    QLabel* m_sign = nullptr;
    QLabel* m_name = nullptr;
    QLabel* m_state = nullptr;
    QPushButton* m_next = nullptr;
    QLabel* m_help = nullptr;
    QProgressBar* m_progress = nullptr;
    RuleCard* m_rule = nullptr;
    QWidget* m_homing = nullptr;
    HomingMarks* m_marks = nullptr;
    LiveTest* m_live = nullptr;
    FirmwareCard* m_firmware = nullptr;
    SetupCard* m_setup = nullptr;
    HeadTrackingCard* m_headTracking = nullptr;
    PenCard* m_pen = nullptr;
    PedalCard* m_pedals = nullptr;
    SoundCard* m_sound = nullptr;
};

}  // namespace ui::devices
