// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIODevice>
#include <QList>
#include <QObject>

#include "ui/sound/SoundSettings.h"

namespace ui::sound {

/// Layout of the samples that an output accepts.
struct AudioFormat
{
    int rateHz = 48'000;
    int channels = 2;
    bool isFloat = true;  ///< false: 16-bit integers
    bool operator==(const AudioFormat&) const = default;
};

/// Access to the audio outputs of the computer. Used only by the thread that creates it.
class AudioPort : public QObject
{
    Q_OBJECT
public:
    /// Length of the buffer between the synthesiser and the system, milliseconds.
    static constexpr int kBufferMs = 16;
    /// Interval at which that buffer is filled, milliseconds.
    static constexpr int kFillMs = 3;

    [[nodiscard]] virtual QList<OutputInfo> outputs() const = 0;
    /// Returns the formats to try with an output, the best first.
    [[nodiscard]] virtual QList<AudioFormat> formats(const QByteArray& output) const = 0;
    /// Begins to read samples from a source. Stops the previous source.
    /// @param source  open; must live until stop()
    /// @returns false if the output is missing or rejects the format
    [[nodiscard]] virtual bool start(const QByteArray& output, const AudioFormat& format, QIODevice& source) = 0;
    virtual void stop() = 0;

signals:
    void outputsChanged();
    /// Emitted when an output stops by itself, because it was removed or has failed.
    void stopped();
};

}  // namespace ui::sound
