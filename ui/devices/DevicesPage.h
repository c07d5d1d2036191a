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

/// The page on which a hand is chosen and tried: mouse or pen, a simulated hand, or a force device. Head tracking, foot
/// pedals, gamepads and sound are set up here, too.
///
/// The page finds and opens nothing itself: the reports of the devices are given to it, and its signals ask for the
/// rest.
class DevicesPage : public kit::Page
{
    Q_OBJECT
public:
    DevicesPage(const kit::Actions& actions, QWidget* parent);

    /// The kinds of force devices, in the order of the list. None has a report yet.
    void setKinds(const QList<DeviceKind>& kinds);
    void setReport(const QString& id, const core::session::DeviceReport& report);
    void setSetup(const QString& id, const core::session::DeviceSetup& setup);
    void setFirmware(const QString& id, const FirmwareFile& file);
    /// The hand that is in use. Shows it, too.
    void setChosen(const QString& id);
    /// @param whyNot  why the simulated hand cannot be chosen or left now; empty: it can
    void setSimulatedFixed(const QString& whyNot);

    /// Id of the hand that is shown at the right, kHeadTracking, kPedals or kSound.
    [[nodiscard]] QString shownHand() const;
    /// From the guide to the devices.
    [[nodiscard]] bool stepBack() override;
    /// Force that the user tries with a button held down, tooth frame; zero if none is.
    [[nodiscard]] glm::dvec3 testForce() const;

    /// What the page shows of head tracking, and what it asks for.
    [[nodiscard]] HeadTrackingCard& headTracking() { return *m_headTracking; }

    /// The same for foot pedals and gamepads.
    [[nodiscard]] PedalCard& pedals() { return *m_pedals; }
    /// The same for the pen of a graphics tablet.
    [[nodiscard]] PenCard& pen() { return *m_pen; }
    /// The same for sound.
    [[nodiscard]] SoundCard& sound() { return *m_sound; }

    /// Opens the guide for hand and rest, for the hand that is shown or, if that is none, for the chosen one.
    void openGuide();

    /// "Mouse or pen", "Simulated hand", "Head tracking", "Pedal and gamepad", "Sound", or the name of the product.
    [[nodiscard]] QString handName(const QString& id) const;

signals:
    /// Emitted when the user wants to use this hand.
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
    QWidget* m_devicesPart;  ///< all but the guide
    HandGuide* m_guide;
    QString m_guideHand;  ///< id of the force device that the guide is about
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
