// SPDX-License-Identifier: GPL-3.0-or-later
// The sound player with outputs that a test plugs in, unplugs and makes fail.
#include <algorithm>
#include <cmath>
#include <cstring>

#include <QSignalSpy>
#include <QTest>

#include "tests/support/Suite.h"
#include "ui/sound/SoundPlayer.h"

using namespace ui::sound;
using core::audio::SoundState;

namespace {

const OutputInfo kSpeakers{"speakers", "Speakers", true};
const OutputInfo kHeadphones{"headphones", "Headphones", false};

/// A fake of a computer's audio outputs, which read only when the test requests it.
class TestPort final : public AudioPort
{
public:
    [[nodiscard]] QList<OutputInfo> outputs() const override { return m_outputs; }
    [[nodiscard]] QList<AudioFormat> formats(const QByteArray& /*output*/) const override
    {
        return {{96'000, 2, true}, {48'000, 2, true}, {44'100, 1, false}};
    }
    [[nodiscard]] bool start(const QByteArray& output, const AudioFormat& format, QIODevice& source) override
    {
        ++m_starts;
        m_source = nullptr;
        const bool isThere =
            std::any_of(m_outputs.begin(), m_outputs.end(), [&](const OutputInfo& one) { return one.id == output; });
        if (!isThere || m_refused.contains(format.rateHz))
            return false;
        m_playing = output;
        m_format = format;
        m_source = &source;
        return true;
    }
    void stop() override { m_source = nullptr; }

    void plug(const QList<OutputInfo>& outputs)
    {
        m_outputs = outputs;
        emit outputsChanged();
    }
    void breakDown()
    {
        m_source = nullptr;
        emit stopped();
    }
    /// Plays for some seconds and returns the loudest sample.
    [[nodiscard]] float play(double seconds) const
    {
        const auto samples =
            static_cast<std::size_t>(seconds * m_format.rateHz) * static_cast<std::size_t>(m_format.channels);
        const std::size_t sampleBytes = m_format.isFloat ? sizeof(float) : sizeof(qint16);
        const QByteArray bytes = m_source->read(static_cast<qint64>(samples * sampleBytes));
        float loudest = 0.0F;
        for (std::size_t k = 0; k < samples; ++k) {
            float sample = 0.0F;
            if (m_format.isFloat) {
                std::memcpy(&sample, bytes.constData() + k * sampleBytes, sampleBytes);
            } else {
                qint16 whole = 0;
                std::memcpy(&whole, bytes.constData() + k * sampleBytes, sampleBytes);
                sample = static_cast<float>(whole) / 32'767.0F;
            }
            loudest = std::max(loudest, std::abs(sample));
        }
        return loudest;
    }

    QList<OutputInfo> m_outputs;
    QList<int> m_refused;  ///< rates
    QByteArray m_playing;
    AudioFormat m_format;
    QIODevice* m_source = nullptr;  ///< null: nothing plays
    int m_starts = 0;
};

SoundState turning()
{
    SoundState state;
    state.turns = true;
    state.burRpm = state.freeRpm;
    return state;
}

}  // namespace

class TestSoundPlayer : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        m_reports.clear();
        m_channel = std::make_unique<core::rt::TripleBuffer<SoundState>>();
        m_channel->publish(turning());
        m_player = std::make_unique<SoundPlayer>(
            [this] {
                auto port = std::make_unique<TestPort>();
                port->m_outputs = m_first;
                m_port = port.get();
                return port;
            },
            *m_channel);
        connect(m_player.get(), &SoundPlayer::reported, this,
                [this](const SoundReport& report) { m_reports.push_back(report); });
        m_first = {kSpeakers, kHeadphones};
    }
    void cleanup() { m_player.reset(); }

    void theWorkIsHeardWhileItIsSeen()
    {
        begin();
        QCOMPARE(report().stage, SoundStage::Ready);
        QVERIFY(m_port->m_source == nullptr);  // an output is open only while it is needed
        m_player->setHeard(true);
        QCOMPARE(report().stage, SoundStage::Playing);
        QCOMPARE(report().output, kSpeakers.name);
        QCOMPARE(report().rateHz, 96'000);
        QVERIFY(m_port->play(0.5) > 0.05F);
        m_player->setHeard(false);
        QVERIFY(m_port->m_source != nullptr);  // the handpiece runs down
        static_cast<void>(m_port->play(5.0));
        QCOMPARE(m_port->play(0.1), 0.0F);
        QTRY_VERIFY(m_port->m_source == nullptr);
        QCOMPARE(report().stage, SoundStage::Ready);
    }

    void turnedOffItIsSilent()
    {
        begin();
        m_player->setHeard(true);
        static_cast<void>(m_port->play(0.5));
        SoundSettings settings;
        settings.isOn = false;
        m_player->setSettings(settings);
        QCOMPARE(report().stage, SoundStage::Off);
        static_cast<void>(m_port->play(0.2));
        QCOMPARE(m_port->play(0.2), 0.0F);
        QTRY_VERIFY(m_port->m_source == nullptr);
        m_player->setSettings({});
        QCOMPARE(report().stage, SoundStage::Playing);
        QVERIFY(m_port->play(0.5) > 0.05F);
    }

    void volumesReachTheSamples()
    {
        begin();
        m_player->setHeard(true);
        const float loud = m_port->play(0.5);
        SoundSettings settings;
        settings.volumes.master *= 0.25F;
        m_player->setSettings(settings);
        static_cast<void>(m_port->play(0.2));
        const float quiet = m_port->play(0.5);
        QVERIFY(quiet > 0.0F && quiet < 0.4F * loud);
    }

    void theNewestStateIsHeard()
    {
        begin();
        m_player->setHeard(true);
        QVERIFY(m_port->play(0.5) > 0.05F);
        m_channel->publish({});
        static_cast<void>(m_port->play(5.0));
        QCOMPARE(m_port->play(0.1), 0.0F);
        m_channel->publish(turning());
        QVERIFY(m_port->play(0.5) > 0.05F);
    }

    void aRefusedRateIsFollowedByAnother()
    {
        begin();
        m_port->m_refused = {96'000, 48'000};
        m_player->setHeard(true);
        QCOMPARE(report().stage, SoundStage::Playing);
        QCOMPARE(report().rateHz, 44'100);
        QVERIFY(!m_port->m_format.isFloat);
        QVERIFY(m_port->play(0.5) > 0.05F);
    }

    void anOutputThatRefusesEverythingIsTriedAgain()
    {
        begin();
        m_port->m_refused = {96'000, 48'000, 44'100};
        m_player->setHeard(true);
        QCOMPARE(report().stage, SoundStage::Refused);
        QCOMPARE(report().output, kSpeakers.name);
        const int starts = m_port->m_starts;
        SoundSettings quieter;
        quieter.volumes.master = 0.5F;
        m_player->setSettings(quieter);
        QCOMPARE(m_port->m_starts, starts);  // not restarted at each move of a slider
        m_port->m_refused.clear();
        QTRY_VERIFY(report().stage == SoundStage::Playing);
    }

    void withoutAnOutputItIsSilentAndSaysSo()
    {
        m_first = {};
        begin();
        m_player->setHeard(true);
        QCOMPARE(report().stage, SoundStage::NoOutput);
        m_player->playSample();
        QCOMPARE(report().stage, SoundStage::NoOutput);
        m_port->plug({kSpeakers});
        QCOMPARE(report().stage, SoundStage::Playing);
        QVERIFY(m_port->play(0.5) > 0.05F);
    }

    void anOutputThatVanishesIsReplacedAndComesBack()
    {
        begin();
        SoundSettings settings;
        settings.output = kHeadphones.id;
        m_player->setSettings(settings);
        m_player->setHeard(true);
        QCOMPARE(m_port->m_playing, kHeadphones.id);
        QVERIFY(!report().isFallback);
        m_port->plug({kSpeakers});
        QCOMPARE(m_port->m_playing, kSpeakers.id);
        QVERIFY(m_port->m_source != nullptr);
        QCOMPARE(report().stage, SoundStage::Playing);
        QVERIFY(report().isFallback);
        QVERIFY(m_port->play(0.5) > 0.05F);
        m_port->plug({kSpeakers, kHeadphones});
        QCOMPARE(m_port->m_playing, kHeadphones.id);
        QVERIFY(!report().isFallback);
        m_port->plug({});
        QCOMPARE(report().stage, SoundStage::NoOutput);
        QVERIFY(m_port->m_source == nullptr);
        m_port->plug({kHeadphones});
        QCOMPARE(report().stage, SoundStage::Playing);
    }

    void anOutputThatStopsByItselfIsOpenedAgain()
    {
        begin();
        m_player->setHeard(true);
        m_port->breakDown();
        QCOMPARE(report().stage, SoundStage::Refused);
        QTRY_VERIFY(report().stage == SoundStage::Playing);
        QVERIFY(m_port->play(0.5) > 0.05F);
    }

    void anotherDefaultOutputIsFollowed()
    {
        begin();
        m_player->setHeard(true);
        OutputInfo speakers = kSpeakers;
        OutputInfo headphones = kHeadphones;
        std::swap(speakers.isDefault, headphones.isDefault);
        m_port->plug({speakers, headphones});
        QCOMPARE(m_port->m_playing, kHeadphones.id);
        QVERIFY(!report().isFallback);  // no output was selected
    }

    void theSampleIsPlayedOnThePage()
    {
        begin();
        m_player->playSample();
        QVERIFY(report().isPlayingSample);
        QVERIFY(m_port->play(5.5) > 0.05F);
        static_cast<void>(m_port->play(5.0));
        QTRY_VERIFY(!report().isPlayingSample);
        QTRY_VERIFY(m_port->m_source == nullptr);
        SoundSettings off;
        off.isOn = false;
        m_player->setSettings(off);
        m_player->playSample();
        QVERIFY(!report().isPlayingSample);
    }

    void outputsAreListed()
    {
        QSignalSpy found(m_player.get(), &SoundPlayer::outputsFound);
        begin();
        QCOMPARE(found.count(), 1);
        QCOMPARE(found.front().front().value<QList<OutputInfo>>(), m_first);
        m_port->plug(m_first);
        QCOMPARE(found.count(), 1);
        m_port->plug({kSpeakers});
        QCOMPARE(found.count(), 2);
    }

    void onlyWholeFramesAreRead()
    {
        BlockSource source(*m_channel);
        source.begin({48'000, 2, true});
        source.setHeard(true);
        QCOMPARE(source.read(8 * 10 + 3).size(), 8 * 10);
        QCOMPARE(source.read(5).size(), 0);
        QVERIFY(!source.atEnd());
    }

private:
    void begin()
    {
        m_player->setSettings({});
        m_player->begin();
    }
    [[nodiscard]] const SoundReport& report() const { return m_reports.back(); }

    QList<OutputInfo> m_first;
    std::unique_ptr<core::rt::TripleBuffer<SoundState>> m_channel;
    std::unique_ptr<SoundPlayer> m_player;
    TestPort* m_port = nullptr;
    QList<SoundReport> m_reports;
};

CUSP_TEST(TestSoundPlayer)
#include "tst_sound_player.moc"
