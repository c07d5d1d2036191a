// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/devices/SoundStore.h"

#include <array>

#include "ui/kit/AppSettings.h"

namespace app {
namespace {

using ui::kit::memory;
using ui::sound::SoundSettings;

const QString kSoundOnKey = QStringLiteral("sound/on");
const QString kOutputKey = QStringLiteral("sound/output");
const QString kVolumeKey = QStringLiteral("sound/volume");
/// The keys of the volumes, in the order of core::audio::Part.
constexpr std::array<const char*, core::audio::kPartCount> kPartKeys{"sound/handpiece", "sound/cutting",
                                                                     "sound/contact", "sound/spray", "sound/suction"};

void recallVolume(const QSettings& stored, const QString& key, float& volume)
{
    bool isNumber = false;
    const double value = stored.value(key).toDouble(&isNumber);
    if (isNumber && value >= 0.0 && value <= 1.0)
        volume = static_cast<float>(value);
}

}  // namespace

SoundSettings storedSound()
{
    const QSettings stored = memory();
    SoundSettings settings;
    settings.isOn = ui::kit::recalled(stored, kSoundOnKey, settings.isOn);
    settings.output = stored.value(kOutputKey).toString().toUtf8();
    recallVolume(stored, kVolumeKey, settings.volumes.master);
    for (std::size_t part = 0; part < kPartKeys.size(); ++part)
        recallVolume(stored, QLatin1String(kPartKeys.at(part)), settings.volumes.parts.at(part));
    return settings;
}

void storeSound(const SoundSettings& settings)
{
    QSettings stored = memory();
    stored.setValue(kSoundOnKey, settings.isOn);
    stored.setValue(kOutputKey, QString::fromUtf8(settings.output));
    stored.setValue(kVolumeKey, static_cast<double>(settings.volumes.master));
    for (std::size_t part = 0; part < kPartKeys.size(); ++part)
        stored.setValue(QLatin1String(kPartKeys.at(part)), static_cast<double>(settings.volumes.parts.at(part)));
}

}  // namespace app
