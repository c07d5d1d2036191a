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

/// Head tracking on the devices page: the live picture with the tag, figures on its quality, and its settings.
///
/// It opens no camera. Its owner passes reports, cameras and settings to it and handles its signals. A report needs its
/// picture only while this widget is visible.
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
    /// Sets whether the parts are one below the other, for a narrow page.
    void setNarrow(bool isNarrow);

    /// Returns the current state, for the page's header and its list.
    [[nodiscard]] const TrackingState& state() const { return m_state; }
    /// Returns the check box "Follow my head", which the page shows in its header.
    [[nodiscard]] QCheckBox& followSwitch() { return *m_follow; }

signals:
    /// Emitted when the user switches head tracking on or off.
    void trackingChanged(bool isOn);
    /// Emitted when the user has changed another setting.
    void settingsChanged(const HeadTrackingSettings& settings);
    /// Emitted when the user makes the current position of the head the centre.
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
