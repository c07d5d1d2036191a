// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

#include "core/tracking/PictureSource.h"
#include "core/tracking/TrackerReport.h"
#include "ui/devices/HeadTrackingSettings.h"
#include "ui/devices/TrackingWords.h"

class QBoxLayout;
class QCheckBox;
class QFrame;
class QPushButton;

namespace ui::devices {

class TagPicture;
class TrackingFigures;
class TrackingSetupCard;

/// Head tracking on the page of devices: the live picture with the tag, how well it runs, and its settings.
///
/// It opens no camera: reports, cameras and settings are given to it, and its signals ask for the rest. A report needs
/// its picture only while this widget is visible.
class HeadTrackingCard : public QWidget
{
    Q_OBJECT
public:
    explicit HeadTrackingCard(QWidget* parent);

    /// Sets whether this program was built with head tracking. The default is true.
    void setInBuild(bool isInBuild);
    void setTracking(core::tracking::TrackerReport report);
    void setCameras(const std::vector<core::tracking::CameraInfo>& cameras);
    void setSettings(const HeadTrackingSettings& settings);
    [[nodiscard]] const HeadTrackingSettings& settings() const { return m_state.settings; }
    /// One part is below the other, for a page where there is no room beside it.
    void setNarrow(bool isNarrow);

    /// What is known now, for the head of the page and its list.
    [[nodiscard]] const TrackingState& state() const { return m_state; }
    /// "Follow my head": the page shows this check box in its head.
    [[nodiscard]] QCheckBox& followSwitch() { return *m_follow; }

signals:
    /// Emitted when the user turns head tracking on or off.
    void trackingChanged(bool isOn);
    /// Emitted when the user has changed a setting other than that.
    void settingsChanged(const HeadTrackingSettings& settings);
    /// Emitted when the place of the head becomes the middle.
    void recentreRequested();
    void printRequested();
    /// Emitted when the user holds the tag at HeadTrackingSettings::kMeasuredMm from the camera.
    void fieldOfViewRequested();
    /// Emitted when state() has changed.
    void stateChanged();

private:
    QWidget* makeLive();
    void changeMirrored(bool isMirrored);
    void showState();

    TrackingState m_state;
    QCheckBox* m_follow;
    QBoxLayout* m_liveColumns = nullptr;
    QFrame* m_live = nullptr;
    TagPicture* m_picture = nullptr;
    QCheckBox* m_mirrored = nullptr;
    TrackingFigures* m_figures = nullptr;
    QPushButton* m_recentre = nullptr;
    TrackingSetupCard* m_setup = nullptr;
};

}  // namespace ui::devices
