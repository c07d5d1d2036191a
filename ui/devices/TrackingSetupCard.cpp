// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/TrackingSetupCard.h"

#include <algorithm>
#include <array>

#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>

#include "ui/kit/FileDialog.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::devices {
namespace {

using namespace ui::kit;
using core::tracking::CameraInfo;
using Settings = HeadTrackingSettings;

// Data of the camera list's entries that are not the number of a camera.
constexpr int kThisVideo = -1;
constexpr int kAnotherVideo = -2;
constexpr int kAnotherFolder = -3;

// Entries of the list of lenses.
constexpr int kByFieldOfView = 0;
constexpr int kThisCalibration = 1;
constexpr int kAnotherCalibration = 2;

constexpr std::array<QSize, 3> kSizes{QSize(640, 480), QSize(1280, 720), QSize(1920, 1080)};
constexpr std::array<int, 3> kRates{15, 30, 60};
constexpr double kGainStep = 0.5;
constexpr int kColumns = 4;
constexpr int kNarrowColumns = 2;

QLabel* quietLabel(QWidget* parent)
{
    return kit::formWords({}, kSmall, QFont::Medium, QPalette::PlaceholderText, parent);
}

}  // namespace

TrackingSetupCard::TrackingSetupCard(QWidget* parent)
    : QFrame(parent), m_grid(new QGridLayout(this)), m_camera(kit::choiceInput({}, this)),
      m_size(kit::choiceInput({}, this)), m_rate(kit::choiceInput({}, this)), m_lens(kit::choiceInput({}, this)),
      m_fov(kit::numberInput(Settings::kLeastFovDeg, Settings::kMostFovDeg, 0, QStringLiteral("°"), {}, this)),
      m_tagId(kit::countInput(0, Settings::kMostTagId, this)),
      m_tagMm(kit::numberInput(Settings::kLeastTagMm, Settings::kMostTagMm, 1, QStringLiteral("mm"), {}, this)),
      m_gain(kit::numberInput(Settings::kLeastGain, Settings::kMostGain, 1, QStringLiteral("°"), {}, this)),
      m_way(kit::choiceInput({}, this)), m_print(new QPushButton(this)), m_measure(new QPushButton(this))
{
    setProperty("kind", "card");
    setObjectName(QStringLiteral("trackingSetup"));
    m_camera->setObjectName(QStringLiteral("camera"));
    m_camera->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_size->setObjectName(QStringLiteral("pictureSize"));
    m_rate->setObjectName(QStringLiteral("pictureRate"));
    m_lens->setObjectName(QStringLiteral("lens"));
    m_lens->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_fov->setObjectName(QStringLiteral("fieldOfView"));
    m_tagId->setObjectName(QStringLiteral("tagNumber"));
    m_tagId->setFixedWidth(kit::kInputPx);
    m_tagMm->setObjectName(QStringLiteral("tagEdge"));
    m_gain->setObjectName(QStringLiteral("gain"));
    m_gain->setSingleStep(kGainStep);
    m_way->setObjectName(QStringLiteral("wayOfView"));
    m_print->setObjectName(QStringLiteral("printTag"));
    m_measure->setObjectName(QStringLiteral("measureFieldOfView"));
    m_measure->setEnabled(false);
    for (QDoubleSpinBox* number : {m_fov, m_tagMm, m_gain})
        number->setKeyboardTracking(false);  // each change restarts the tracking
    for (const QSize& size : kSizes)
        m_size->addItem(QStringLiteral("%1 × %2").arg(size.width()).arg(size.height()), size);
    for (const int hz : kRates)
        m_rate->addItem(QString::number(hz), hz);

    m_grid->setContentsMargins(kSpace4, kSpace4, kSpace4, kSpace2);
    m_grid->setHorizontalSpacing(kSpace4);
    m_grid->setVerticalSpacing(kSpace1);
    for (QWidget* input :
         {static_cast<QWidget*>(m_camera), static_cast<QWidget*>(m_size), static_cast<QWidget*>(m_rate),
          static_cast<QWidget*>(m_lens), static_cast<QWidget*>(m_fov), static_cast<QWidget*>(m_measure),
          static_cast<QWidget*>(m_print), static_cast<QWidget*>(m_tagId), static_cast<QWidget*>(m_tagMm),
          static_cast<QWidget*>(m_way), static_cast<QWidget*>(m_gain)})
        m_cells.push_back({quietLabel(this), input, input == m_camera ? 2 : 1});
    setNarrow(false);

    connectInputs();
    text::bindTranslation(this, [this] { retranslateUi(); });
    setSettings(m_settings);
}

void TrackingSetupCard::connectInputs()
{
    const auto applies = [this](auto apply) {
        return [this, apply](auto value) {
            Settings settings = m_settings;
            apply(settings, value);
            change(settings);
        };
    };
    connect(m_camera, &QComboBox::activated, this, &TrackingSetupCard::takeCamera);
    connect(m_size, &QComboBox::activated, this, applies([](Settings& settings, int entry) {
                const QSize chosen = kSizes.at(static_cast<std::size_t>(entry));
                settings.width = chosen.width();
                settings.height = chosen.height();
            }));
    connect(m_rate, &QComboBox::activated, this,
            applies([](Settings& settings, int entry) { settings.hz = kRates.at(static_cast<std::size_t>(entry)); }));
    connect(m_lens, &QComboBox::activated, this, &TrackingSetupCard::takeLens);
    connect(m_fov, &QDoubleSpinBox::valueChanged, this,
            applies([](Settings& settings, double value) { settings.fovDeg = value; }));
    connect(m_tagId, &QSpinBox::valueChanged, this,
            applies([](Settings& settings, int value) { settings.tagId = value; }));
    connect(m_tagMm, &QDoubleSpinBox::valueChanged, this,
            applies([](Settings& settings, double value) { settings.tagMm = value; }));
    connect(m_gain, &QDoubleSpinBox::valueChanged, this,
            applies([](Settings& settings, double value) { settings.gain = value; }));
    connect(m_way, &QComboBox::activated, this,
            applies([](Settings& settings, int entry) { settings.isWindow = entry == 1; }));
    connect(m_print, &QPushButton::clicked, this, &TrackingSetupCard::printRequested);
    connect(m_measure, &QPushButton::clicked, this, &TrackingSetupCard::fieldOfViewRequested);
}

void TrackingSetupCard::retranslateUi()
{
    const auto name = [this](QWidget* input, const QString& words) {
        const auto cell =
            std::find_if(m_cells.begin(), m_cells.end(), [input](const Cell& one) { return one.input == input; });
        cell->caption->setText(words);
        if (auto* choice = qobject_cast<QComboBox*>(input))
            kit::nameInput(choice, words);
        else
            input->setAccessibleName(words);
    };
    name(m_camera, tr("Camera"));
    name(m_size, tr("Size of its pictures"));
    name(m_rate, tr("Pictures a second"));
    name(m_lens, tr("Its lens"));
    name(m_fov, tr("Its field of view, sideways"));
    m_fov->setToolTip(tr("60° fits most cameras. The data sheet of the camera has the exact number."));
    name(m_tagId, tr("Number of the tag"));
    name(m_tagMm, tr("Edge of its black square"));
    name(m_gain, tr("Turn of the view for 1° of the head"));
    name(m_way, tr("When the head moves"));
    m_way->clear();
    m_way->addItem(tr("The tooth turns"));
    //: The tooth is seen through the screen as through a window
    m_way->addItem(tr("The screen is a window"));
    m_way->setCurrentIndex(m_settings.isWindow ? 1 : 0);
    m_print->setText(tr("Print the tag …"));
    m_print->setAccessibleName(m_print->text());
    //: %1: a length in millimetres
    name(m_measure, tr("Hold the tag %1 mm from the lens").arg(Settings::kMeasuredMm));
    m_measure->setText(tr("Measure the field of view"));
    m_measure->setAccessibleDescription(m_measure->accessibleName());
    m_measure->setAccessibleName(m_measure->text());
    listCameras();
    listLenses();
}

/// Arranges the card in rows of four equal columns, or of two if the card is narrow.
void TrackingSetupCard::setNarrow(bool isNarrow)
{
    const int columns = isNarrow ? kNarrowColumns : kColumns;
    int at = 0;
    for (const Cell& cell : m_cells) {
        const int row = 3 * (at / columns);
        const int column = at % columns;
        m_grid->removeWidget(cell.caption);
        m_grid->removeWidget(cell.input);
        m_grid->addWidget(cell.caption, row, column, 1, cell.columns, Qt::AlignBottom);
        const bool isChoice = qobject_cast<QComboBox*>(cell.input) != nullptr;
        m_grid->addWidget(cell.input, row + 1, column, 1, cell.columns,
                          isChoice ? Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter);
        m_grid->setRowMinimumHeight(row + 2, kSpace1);
        at += cell.columns;
    }
    for (int column = 0; column < kColumns; ++column)
        m_grid->setColumnStretch(column, column < columns ? 1 : 0);
}

void TrackingSetupCard::setCameras(const std::vector<CameraInfo>& cameras)
{
    const auto isSame = [](const CameraInfo& a, const CameraInfo& b) {
        return a.number == b.number && a.name == b.name;
    };
    if (std::equal(cameras.begin(), cameras.end(), m_cameras.begin(), m_cameras.end(), isSame))
        return;
    m_cameras = cameras;
    listCameras();
}

void TrackingSetupCard::setSettings(const HeadTrackingSettings& settings)
{
    m_settings = settings;
    listCameras();
    listLenses();
    m_size->setCurrentIndex(m_size->findData(QSize(settings.width, settings.height)));
    m_rate->setCurrentIndex(m_rate->findData(settings.hz));
    for (QComboBox* ofCamera : {m_size, m_rate})
        ofCamera->setEnabled(settings.video.isEmpty());
    m_fov->setEnabled(settings.calibration.isEmpty());
    setSeen(m_isSeen);
    m_way->setCurrentIndex(settings.isWindow ? 1 : 0);
    for (auto [input, value] :
         {std::pair(m_fov, settings.fovDeg), {m_tagMm, settings.tagMm}, {m_gain, settings.gain}}) {
        const QSignalBlocker silent(input);
        kit::showNumber(*input, value);
    }
    const QSignalBlocker silent(m_tagId);
    m_tagId->setValue(settings.tagId);
}

void TrackingSetupCard::setSeen(bool isSeen)
{
    m_isSeen = isSeen;
    m_measure->setEnabled(isSeen && m_settings.calibration.isEmpty());
}

void TrackingSetupCard::listCameras()
{
    m_camera->clear();
    const auto nameOf = [&](const CameraInfo& camera) {
        //: %1: a number
        return camera.name.empty() ? tr("Camera %1").arg(camera.number) : QString::fromStdString(camera.name);
    };
    for (const CameraInfo& camera : m_cameras) {
        const auto sameName = std::count_if(m_cameras.begin(), m_cameras.end(),
                                            [&](const CameraInfo& other) { return other.name == camera.name; });
        m_camera->addItem(sameName > 1 ? QStringLiteral("%1 (%2)").arg(nameOf(camera)).arg(camera.number)
                                       : nameOf(camera),
                          camera.number);
    }
    if (m_settings.video.isEmpty() && m_camera->findData(m_settings.camera) < 0)
        m_camera->addItem(m_cameras.empty() ? tr("No camera is plugged in")
                                            //: %1: the number of a camera
                                            : tr("Camera %1, not plugged in").arg(m_settings.camera),
                          m_settings.camera);
    m_camera->insertSeparator(m_camera->count());
    if (!m_settings.video.isEmpty())
        m_camera->addItem(QFileInfo(m_settings.video).fileName(), kThisVideo);
    m_camera->addItem(tr("A video file …"), kAnotherVideo);
    m_camera->addItem(tr("A folder of images …"), kAnotherFolder);
    m_camera->setCurrentIndex(m_camera->findData(m_settings.video.isEmpty() ? m_settings.camera : kThisVideo));
}

void TrackingSetupCard::takeCamera(int entry)
{
    const int camera = m_camera->itemData(entry).toInt();
    if (camera == kThisVideo)
        return;
    if (camera == kAnotherVideo || camera == kAnotherFolder) {
        listCameras();
        choosePictures(camera == kAnotherFolder);
        return;
    }
    HeadTrackingSettings settings = m_settings;
    settings.camera = camera;
    settings.video.clear();
    change(settings);
}

void TrackingSetupCard::choosePictures(bool isFolder)
{
    const QString from = m_settings.video.isEmpty() ? QDir::homePath() : QFileInfo(m_settings.video).absolutePath();
    auto* dialog = isFolder ? new FileDialog(this, tr("Choose a folder of images"), from)
                            : new FileDialog(this, tr("Choose a video file"), from,
                                             tr("Videos (*.mp4 *.mkv *.avi *.mov *.webm *.ogv);;All files (*)"));
    dialog->setFileMode(isFolder ? QFileDialog::Directory : QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        HeadTrackingSettings settings = m_settings;
        settings.video = path;
        change(settings);
    });
    dialog->open();
}

void TrackingSetupCard::listLenses()
{
    m_lens->clear();
    m_lens->addItem(tr("By its field of view"), kByFieldOfView);
    if (!m_settings.calibration.isEmpty())
        m_lens->addItem(QFileInfo(m_settings.calibration).fileName(), kThisCalibration);
    m_lens->addItem(tr("A calibration file …"), kAnotherCalibration);
    m_lens->setCurrentIndex(m_settings.calibration.isEmpty() ? 0 : 1);
}

void TrackingSetupCard::takeLens(int entry)
{
    const int lens = m_lens->itemData(entry).toInt();
    if (lens == kByFieldOfView) {
        HeadTrackingSettings settings = m_settings;
        settings.calibration.clear();
        change(settings);
    } else if (lens == kAnotherCalibration) {
        listLenses();
        chooseCalibration();
    }
}

void TrackingSetupCard::chooseCalibration()
{
    const QString from =
        m_settings.calibration.isEmpty() ? QDir::homePath() : QFileInfo(m_settings.calibration).absolutePath();
    auto* dialog = new FileDialog(this, tr("Choose a calibration of the camera"), from,
                                  tr("Calibrations (*.json);;All files (*)"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        HeadTrackingSettings settings = m_settings;
        settings.calibration = path;
        change(settings);
    });
    dialog->open();
}

void TrackingSetupCard::change(const HeadTrackingSettings& settings)
{
    if (settings == m_settings)
        return;
    setSettings(settings);
    emit settingsChanged(settings);
}

}  // namespace ui::devices
