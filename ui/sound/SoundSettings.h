// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QMetaType>
#include <QString>

#include "core/audio/SoundState.h"

namespace ui::sound {

/// The user's settings for sound.
struct SoundSettings
{
    bool isOn = true;
    core::audio::Volumes volumes;  ///< isMuted is not used; isOn replaces it
    QByteArray output;             ///< id of an audio output; empty: the default output of the system
    bool operator==(const SoundSettings&) const = default;
};

/// An audio output of this computer.
struct OutputInfo
{
    QByteArray id;
    QString name;  ///< the system's name of the output
    bool isDefault = false;
    bool operator==(const OutputInfo&) const = default;
};

enum class SoundStage : std::uint8_t {
    Off,       ///< the user has turned sound off
    Ready,     ///< there is an output, and no sound to play now
    Playing,   ///< the output is playing
    NoOutput,  ///< this computer has no audio output
    Refused    ///< the output accepts none of the formats, or has stopped; it is tried again
};

/// State of the sound output.
struct SoundReport
{
    SoundStage stage = SoundStage::Off;
    QString output;           ///< name of the output in use
    bool isFallback = false;  ///< the output that the user has chosen is missing
    int rateHz = 0;           ///< sample rate of the open output; 0 if none is open
    bool isPlayingSample = false;
    bool operator==(const SoundReport&) const = default;
};

}  // namespace ui::sound

Q_DECLARE_METATYPE(ui::sound::SoundSettings)
Q_DECLARE_METATYPE(ui::sound::SoundReport)
