// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QFrame>

#include "core/tracking/PictureSource.h"
#include "ui/devices/HeadTrackingSettings.h"

class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSpinBox;

namespace ui::devices {

/// Settings of head tracking: camera, tag, and rotation of the view.
class TrackingSetupCard : public QFrame
{
    Q_OBJECT
public:
    explicit TrackingSetupCard(QWidget* parent);

    void setCameras(const std::vector<core::tracking::CameraInfo>& cameras);
    void setSettings(const HeadTrackingSettings& settings);
    /// Sets whether the camera sees the tag, so that the field of view can be measured.
    void setSeen(bool isSeen);
    /// Sets whether the form has two columns instead of four, for a narrow page.
    void setNarrow(bool isNarrow);

signals:
    /// Emitted when the user has changed a setting.
    void settingsChanged(const HeadTrackingSettings& settings);
    void printRequested();
    /// Emitted when the user holds the tag at kMeasuredMm from the camera.
    void fieldOfViewRequested();

private:
    struct Cell
    {
        QLabel* caption;
        QWidget* input;
        int columns;
    };
    void connectInputs();
    void retranslateUi();
    void listCameras();
    void listLenses();
    void takeCamera(int entry);
    void takeLens(int entry);
    void choosePictures(bool isFolder);
    void chooseCalibration();
    void change(const HeadTrackingSettings& settings);

    std::vector<core::tracking::CameraInfo> m_cameras;
    HeadTrackingSettings m_settings;
    QGridLayout* m_grid;
    std::vector<Cell> m_cells;
    QComboBox* m_camera;
    QComboBox* m_size;
    QComboBox* m_rate;
    QComboBox* m_lens;
    QDoubleSpinBox* m_fov;
    QSpinBox* m_tagId;
    QDoubleSpinBox* m_tagMm;
    QDoubleSpinBox* m_gain;
    QComboBox* m_way;
    QPushButton* m_print;
    QPushButton* m_measure;
    bool m_isSeen = false;
};

}  // namespace ui::devices
