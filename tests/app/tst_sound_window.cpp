// SPDX-License-Identifier: GPL-3.0-or-later
// The window with an audio output that a test unplugs.
#include <atomic>

#include <QTemporaryDir>

#include "tests/app/ProgramWindow.h"
#include "tests/support/OpenGlMain.h"
#include "ui/devices/DevicesPage.h"
#include "ui/devices/SoundCard.h"
#include "ui/kit/AppSettings.h"
#include "ui/sound/AudioPort.h"

using ui::sound::AudioFormat;
using ui::sound::OutputInfo;
using ui::sound::SoundStage;

namespace {

/// A fake of a computer with one audio output. The output accepts everything and discards it. Sound thread.
class OneOutput final : public ui::sound::AudioPort
{
public:
    [[nodiscard]] QList<OutputInfo> outputs() const override
    {
        return m_isThere ? QList<OutputInfo>{{"speakers", "Speakers", true}} : QList<OutputInfo>{};
    }
    [[nodiscard]] QList<AudioFormat> formats(const QByteArray& /*output*/) const override { return {{}}; }
    [[nodiscard]] bool start(const QByteArray& /*output*/, const AudioFormat& /*format*/,
                             QIODevice& /*source*/) override
    {
        return m_isThere;
    }
    void stop() override {}

    void plug(bool isThere)
    {
        m_isThere = isThere;
        emit outputsChanged();
        if (!isThere)
            emit stopped();
    }

private:
    bool m_isThere = true;
};

}  // namespace

class TestSoundWindow : public support::ProgramWindow
{
    Q_OBJECT
private slots:
    void init()
    {
        ui::kit::memory().clear();
        m_folder = std::make_unique<QTemporaryDir>();
        app::WindowOptions options;
        options.source = {36};
        options.audioPort = [this] {
            auto port = std::make_unique<OneOutput>();
            m_port = port.get();
            return port;
        };
        begin(options);
        waitForTooth();
        window().activateWindow();
        WAIT_FOR(stage() == SoundStage::Playing);
    }
    void cleanup() { m_application.reset(); }

    void theUserIsToldThatTheOutputIsGone()
    {
        QVERIFY(message().isEmpty() || !isToldOfSound());
        plug(false);
        WAIT_FOR(stage() == SoundStage::NoOutput);
        WAIT_FOR(isToldOfSound());
        drill(-2.0);  // cutting is still possible
        plug(true);
        WAIT_FOR(stage() == SoundStage::Playing);
        WAIT_FOR(!isToldOfSound());
    }

    void soundIsTurnedOffAndStaysOff()
    {
        actions().sound->trigger();
        WAIT_FOR(stage() == SoundStage::Off);
        QVERIFY(!card().settings().isOn);
        actions().sound->trigger();
        WAIT_FOR(stage() == SoundStage::Playing);
        actions().sound->trigger();
        WAIT_FOR(stage() == SoundStage::Off);
        plug(false);  // a user who has muted the sound gets no message about the output
        plug(true);
        QVERIFY(!isToldOfSound());
        m_application.reset();
        app::WindowOptions options;
        options.source = {36};
        begin(options);
        WAIT_FOR(stage() == SoundStage::Off);
        QVERIFY(!actions().sound->isChecked());
    }

    void onAnotherPageItIsSilent()
    {
        actions().devices->trigger();
        WAIT_FOR(stage() == SoundStage::Ready);
        actions().back->trigger();
        WAIT_FOR(stage() == SoundStage::Playing);
    }

private:
    [[nodiscard]] ui::devices::SoundCard& card() const { return child<ui::devices::DevicesPage>()->sound(); }
    [[nodiscard]] SoundStage stage() const { return card().report().stage; }
    [[nodiscard]] bool isToldOfSound() const { return message().contains("no audio output"); }
    void plug(bool isThere) const
    {
        QMetaObject::invokeMethod(m_port.load(), [port = m_port.load(), isThere] { port->plug(isThere); });
    }

    std::atomic<OneOutput*> m_port = nullptr;
};

int main(int argc, char** argv)
{
    return support::openGlMain<TestSoundWindow>(argc, argv);
}

#include "tst_sound_window.moc"
