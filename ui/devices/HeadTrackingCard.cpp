// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/HeadTrackingCard.h"

#include <optional>
#include <utility>

#include <QCheckBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ui/devices/NextStep.h"
#include "ui/devices/TagPicture.h"
#include "ui/devices/TrackingFigures.h"
#include "ui/devices/TrackingSetupCard.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::devices {

using namespace ui::kit;
using core::tracking::TrackerReport;
using core::tracking::TrackerStage;

HeadTrackingCard::HeadTrackingCard(QWidget* parent) : QWidget(parent), m_follow(new QCheckBox(this))
{
    setObjectName(QStringLiteral("headTracking"));
    m_follow->setObjectName(QStringLiteral("followHead"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace4);
    column->addWidget(makeLive());
    m_setup = new TrackingSetupCard(this);
    column->addWidget(m_setup);

    connect(m_follow, &QCheckBox::toggled, this, [this](bool isOn) {
        HeadTrackingSettings settings = m_state.settings;
        settings.isOn = isOn;
        m_state.report = {};
        setSettings(settings);
        emit trackingChanged(isOn);
    });
    connect(m_mirrored, &QCheckBox::toggled, this, &HeadTrackingCard::changeMirrored);
    connect(m_recentre, &QPushButton::clicked, this, &HeadTrackingCard::recentreRequested);
    connect(m_setup, &TrackingSetupCard::printRequested, this, &HeadTrackingCard::printRequested);
    connect(m_setup, &TrackingSetupCard::fieldOfViewRequested, this, &HeadTrackingCard::fieldOfViewRequested);
    connect(m_setup, &TrackingSetupCard::settingsChanged, this, [this](const HeadTrackingSettings& settings) {
        setSettings(settings);
        emit settingsChanged(settings);
    });
    text::bindTranslation(this, [this] {
        m_follow->setText(tr("Follow my head"));
        m_follow->setAccessibleName(m_follow->text());
        //: Of a picture: it looks like a mirror
        m_mirrored->setText(tr("Mirrored"));
        m_mirrored->setAccessibleName(m_mirrored->text());
        m_recentre->setText(tr("Straight ahead is here"));
        m_recentre->setAccessibleName(m_recentre->text());
        showState();
    });
    setSettings(m_state.settings);
}

QWidget* HeadTrackingCard::makeLive()
{
    m_live = new QFrame(this);
    m_live->setProperty("kind", "card");
    m_live->setObjectName(QStringLiteral("trackingLive"));
    m_liveColumns = new QBoxLayout(QBoxLayout::LeftToRight, m_live);
    m_liveColumns->setContentsMargins(kSpace4, kSpace4, kSpace4, kSpace4);
    m_liveColumns->setSpacing(kSpace6);
    auto* seen = new QVBoxLayout;
    seen->setSpacing(kSpace2);
    m_picture = new TagPicture(m_live);
    seen->addWidget(m_picture);
    auto* below = new QHBoxLayout;
    below->setSpacing(kSpace4);
    m_mirrored = new QCheckBox(m_live);
    m_mirrored->setObjectName(QStringLiteral("mirrored"));
    auto* privacy = kit::formWords({}, kSmall, QFont::Normal, QPalette::PlaceholderText, m_live);
    privacy->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    below->addWidget(m_mirrored);
    below->addWidget(privacy, 1);
    seen->addLayout(below);
    m_liveColumns->addLayout(seen, 5);
    auto* quality = new QVBoxLayout;
    m_figures = new TrackingFigures(m_live);
    m_recentre = new QPushButton(m_live);
    m_recentre->setObjectName(QStringLiteral("recentre"));
    quality->addWidget(m_figures);
    quality->addStretch(1);
    quality->addWidget(m_recentre, 0, Qt::AlignLeft);
    m_liveColumns->addLayout(quality, 3);
    text::bindTranslation(m_live, [privacy] { privacy->setText(tr("No picture is saved or sent.")); });
    return m_live;
}

void HeadTrackingCard::setNarrow(bool isNarrow)
{
    m_liveColumns->setDirection(isNarrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    m_setup->setNarrow(isNarrow);
}

void HeadTrackingCard::setInBuild(bool isInBuild)
{
    m_state.isInBuild = isInBuild;
    showState();
}

void HeadTrackingCard::setTracking(TrackerReport report)
{
    const core::tracking::Picture picture = std::exchange(report.picture, {});
    m_state.report = std::move(report);
    if (hasPictures(m_state))
        m_picture->setPicture(picture, m_state.report.sameTags > 0 ? std::optional(m_state.report.tag.tag.cornersPx)
                                                                   : std::nullopt);
    showState();
}

void HeadTrackingCard::setCameras(const std::vector<core::tracking::CameraInfo>& cameras)
{
    m_setup->setCameras(cameras);
}

void HeadTrackingCard::setSettings(const HeadTrackingSettings& settings)
{
    m_state.settings = settings;
    m_setup->setSettings(settings);
    m_picture->setMirrored(settings.mirrored);
    const QSignalBlocker silentFollow(m_follow);
    m_follow->setChecked(settings.isOn);
    const QSignalBlocker silentMirrored(m_mirrored);
    m_mirrored->setChecked(settings.mirrored);
    showState();
}

void HeadTrackingCard::changeMirrored(bool isMirrored)
{
    HeadTrackingSettings settings = m_state.settings;
    settings.mirrored = isMirrored;
    setSettings(settings);
    emit settingsChanged(settings);
}

void HeadTrackingCard::showState()
{
    const bool isTracking = hasPictures(m_state) && m_state.report.stage == TrackerStage::Tracking;
    m_live->setVisible(m_state.isInBuild);
    m_setup->setVisible(m_state.isInBuild);
    m_follow->setEnabled(m_state.isInBuild);
    m_follow->setAccessibleDescription(stateWords(m_state));
    m_recentre->setEnabled(isTracking);
    m_setup->setSeen(isTracking);
    setFilled(*m_recentre, isTracking);
    if (hasPictures(m_state))
        m_figures->setReport(m_state.report);
    else
        m_figures->clear();
    if (!hasPictures(m_state) || !m_picture->hasPicture())
        m_picture->setWords(m_state.settings.isOn
                                ? stateWords(m_state)
                                : tr("The picture of the camera appears here when head tracking is on."));
    emit stateChanged();
}

}  // namespace ui::devices
