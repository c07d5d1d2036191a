// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/SoundCard.h"

#include <algorithm>
#include <cmath>

#include <QCheckBox>
#include <QComboBox>
#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include "ui/devices/NextStep.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/TabularDigitsLabel.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::devices {
namespace {

using namespace ui::kit;
using sound::OutputInfo;
using sound::SoundReport;
using sound::SoundSettings;

constexpr int kPercent = 100;
constexpr int kPageStep = 10;
constexpr int kPercentPx = 48;
constexpr std::array<const char*, core::audio::kPartCount + 1> kNames{
    "soundVolume", "handpieceVolume", "cuttingVolume", "contactVolume", "sprayVolume", "suctionVolume"};

QFrame* makeCard(const char* name, QWidget* parent)
{
    auto* card = new QFrame(parent);
    card->setProperty("kind", "card");
    card->setObjectName(QLatin1String(name));
    return card;
}

}  // namespace

SoundCard::SoundCard(QWidget* parent) : QWidget(parent), m_switch(new QCheckBox(this))
{
    setObjectName(QStringLiteral("sound"));
    m_switch->setObjectName(QStringLiteral("playSound"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace4);
    QFrame* const volumes = makeCard("soundVolumes", this);
    QFrame* const output = makeCard("soundOutput", this);
    makeVolumes(volumes);
    makeOutput(output);
    column->addWidget(volumes);
    column->addWidget(output);
    connect(m_switch, &QCheckBox::toggled, this, [this](bool isOn) {
        SoundSettings settings = m_settings;
        settings.isOn = isOn;
        change(settings);
    });
    text::bindTranslation(this, [this] {
        m_switch->setText(tr("Play sound"));
        m_switch->setAccessibleName(m_switch->text());
        const std::array<QString, core::audio::kPartCount + 1> captions{
            tr("Volume"),
            //: Volume of a part of the sound
            tr("Handpiece"),
            //: Volume of a part of the sound
            tr("Cutting"),
            //: Volume of a part of the sound: the bur meets the tooth
            tr("Contact"),
            //: Volume of a part of the sound: water that cools the bur
            tr("Spray"),
            //: Volume of a part of the sound
            tr("Suction")};
        for (std::size_t k = 0; k < m_volumes.size(); ++k) {
            m_volumes.at(k).caption->setText(captions.at(k));
            //: Name of a slider; %1: "Handpiece", "Cutting"
            m_volumes.at(k).slider->setAccessibleName(k == 0 ? captions.at(k) : tr("Volume: %1").arg(captions.at(k)));
        }
        //: Of sound: loudspeakers or headphones
        m_outputCaption->setText(tr("Output"));
        kit::nameInput(m_output, m_outputCaption->text());
        m_sample->setText(tr("Play a sample"));
        m_sample->setAccessibleName(m_sample->text());
        m_sample->setToolTip(tr("The turbine runs free, cuts enamel, then dentin"));
        listOutputs();
        showState();
    });
    setSettings(m_settings);
}

void SoundCard::makeVolumes(QWidget* card)
{
    auto* grid = new QGridLayout(card);
    grid->setContentsMargins(kSpace4, kSpace4, kSpace4, kSpace4);
    grid->setHorizontalSpacing(kSpace4);
    grid->setVerticalSpacing(kSpace2);
    grid->setColumnStretch(1, 1);
    for (std::size_t k = 0; k < m_volumes.size(); ++k) {
        Volume& volume = m_volumes.at(k);
        volume.caption = new QLabel(card);
        volume.caption->setFont(typeface(kBody, k == 0 ? QFont::DemiBold : QFont::Normal));
        volume.slider = new QSlider(Qt::Horizontal, card);
        volume.slider->setObjectName(QLatin1String(kNames.at(k)));
        volume.slider->setRange(0, kPercent);
        volume.slider->setPageStep(kPageStep);
        volume.caption->setBuddy(volume.slider);
        volume.percent = new TabularDigitsLabel(card);
        volume.percent->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        volume.percent->setFixedWidth(kPercentPx);
        const int row = static_cast<int>(k);
        grid->addWidget(volume.caption, row, 0);
        grid->addWidget(volume.slider, row, 1);
        grid->addWidget(volume.percent, row, 2);
        connect(volume.slider, &QSlider::valueChanged, this, [this, k](int percent) {
            SoundSettings settings = m_settings;
            volumeOf(settings, k) = static_cast<float>(percent) / static_cast<float>(kPercent);
            change(settings);
        });
    }
}

void SoundCard::makeOutput(QWidget* card)
{
    auto* row = new QHBoxLayout(card);
    row->setContentsMargins(kSpace4, kSpace4, kSpace4, kSpace4);
    row->setSpacing(kSpace4);
    m_outputCaption = new QLabel(card);
    m_output = kit::choiceInput({}, card);
    m_output->setObjectName(QStringLiteral("audioOutput"));
    m_output->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_sample = new QPushButton(card);
    m_sample->setObjectName(QStringLiteral("playSample"));
    row->addWidget(m_outputCaption);
    row->addWidget(m_output, 1);
    row->addWidget(m_sample);
    connect(m_output, &QComboBox::activated, this, [this](int entry) {
        SoundSettings settings = m_settings;
        settings.output = m_output->itemData(entry).toByteArray();
        change(settings);
    });
    connect(m_sample, &QPushButton::clicked, this, &SoundCard::sampleRequested);
}

float& SoundCard::volumeOf(SoundSettings& settings, std::size_t volume)
{
    return volume == 0 ? settings.volumes.master : settings.volumes.parts.at(volume - 1);
}

void SoundCard::setSettings(const SoundSettings& settings)
{
    m_settings = settings;
    const QSignalBlocker silentSwitch(m_switch);
    m_switch->setChecked(settings.isOn);
    for (std::size_t k = 0; k < m_volumes.size(); ++k) {
        const QSignalBlocker silent(m_volumes.at(k).slider);
        const auto percent = static_cast<int>(std::lround(kPercent * volumeOf(m_settings, k)));
        m_volumes.at(k).slider->setValue(percent);
        m_volumes.at(k).percent->setText(QStringLiteral("%1 %").arg(percent));
    }
    listOutputs();
    showState();
}

void SoundCard::setOutputs(const QList<OutputInfo>& outputs)
{
    m_outputs = outputs;
    listOutputs();
}

void SoundCard::setReport(const SoundReport& report)
{
    if (report == m_report)
        return;
    m_report = report;
    showState();
    emit stateChanged();
}

/// Lists the outputs. A chosen output that is missing stays in the list.
void SoundCard::listOutputs()
{
    const QSignalBlocker silent(m_output);
    m_output->clear();
    //: Audio output
    m_output->addItem(tr("As the system is set"), QByteArray());
    for (const OutputInfo& output : m_outputs)
        m_output->addItem(output.name, output.id);
    int chosen = m_output->findData(m_settings.output);
    if (chosen < 0) {
        //: Audio output that was chosen before and is not plugged in
        m_output->addItem(tr("The chosen output (missing)"), m_settings.output);
        chosen = m_output->count() - 1;
    }
    m_output->setCurrentIndex(chosen);
}

void SoundCard::change(const SoundSettings& settings)
{
    setSettings(settings);
    emit settingsChanged(settings);
}

void SoundCard::showState()
{
    using sound::SoundStage;
    const bool canPlay = m_report.stage == SoundStage::Ready || m_report.stage == SoundStage::Playing;
    for (const Volume& volume : m_volumes)
        volume.slider->setEnabled(m_settings.isOn);
    m_sample->setEnabled(canPlay && !m_report.isPlayingSample);
    setFilled(*m_sample, canPlay);
}

}  // namespace ui::devices
