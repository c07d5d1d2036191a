// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <QWidget>

#include "ui/sound/SoundSettings.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QSlider;

namespace ui::kit {
class TabularDigitsLabel;
}

namespace ui::devices {

/// Sound on the devices page: the volumes, the audio output, and a sample to test them.
///
/// This widget plays nothing. Its owner passes reports, outputs and settings to it and handles its signals.
class SoundCard : public QWidget
{
    Q_OBJECT
public:
    explicit SoundCard(QWidget* parent);

    void setSettings(const sound::SoundSettings& settings);
    void setOutputs(const QList<sound::OutputInfo>& outputs);
    void setReport(const sound::SoundReport& report);
    [[nodiscard]] const sound::SoundSettings& settings() const { return m_settings; }
    [[nodiscard]] const sound::SoundReport& report() const { return m_report; }
    /// Returns the check box "Play sound", which the page shows in its header.
    [[nodiscard]] QCheckBox& soundSwitch() { return *m_switch; }

signals:
    /// Emitted when the user has changed a setting.
    void settingsChanged(const ui::sound::SoundSettings& settings);
    void sampleRequested();
    /// Emitted when report() has changed.
    void stateChanged();

private:
    /// One volume: the overall volume (0), or that of a part of the sound (1 and above).
    struct Volume
    {
        QLabel* caption = nullptr;
        QSlider* slider = nullptr;
        kit::TabularDigitsLabel* percent = nullptr;
    };
    void makeVolumes(QWidget* card);
    void makeOutput(QWidget* card);
    void showState();
    void listOutputs();
    void change(const sound::SoundSettings& settings);
    [[nodiscard]] static float& volumeOf(sound::SoundSettings& settings, std::size_t volume);

    sound::SoundSettings m_settings;
    sound::SoundReport m_report;
    QList<sound::OutputInfo> m_outputs;
    QCheckBox* m_switch;
    std::array<Volume, core::audio::kPartCount + 1> m_volumes{};
    QLabel* m_outputCaption = nullptr;
    QComboBox* m_output = nullptr;
    QPushButton* m_sample = nullptr;
};

}  // namespace ui::devices
