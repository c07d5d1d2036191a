// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <QTest>

#include "core/audio/Audition.h"
#include "core/audio/ServoSound.h"
#include "core/audio/Synthesizer.h"
#include "core/audio/WaveFile.h"
#include "core/base/Rng.h"
#include "core/servo/ServoState.h"
#include "core/settings/Handpiece.h"
#include "lab/Spectrum.h"
#include "tests/support/Allocations.h"
#include "tests/support/Suite.h"

using namespace core::audio;
using core::terrain::Material;

namespace {

constexpr double kRateHz = 48'000.0;
/// Largest difference of two successive samples, in any situation.
constexpr float kMostJump = 0.8F;
/// Largest difference that a change of state makes to the first sample after it; for the second sample it is twice as
/// large, and so on.
constexpr float kMostStep = 0.025F;
constexpr std::size_t kFirstSamples = 10;

std::size_t samplesIn(double seconds, double rateHz = kRateHz)
{
    return static_cast<std::size_t>(seconds * rateHz);
}

std::vector<float> rendered(Synthesizer& synthesizer, const SoundState& state, double seconds)
{
    std::vector<float> samples(samplesIn(seconds, synthesizer.rateHz()));
    synthesizer.render(state, samples);
    return samples;
}

/// Returns one second of sound after a second in the same state.
std::vector<float> settled(const SoundState& state, double rateHz = kRateHz, const Volumes& volumes = {})
{
    Synthesizer synthesizer(rateHz);
    synthesizer.setVolumes(volumes);
    static_cast<void>(rendered(synthesizer, state, 1.0));
    return rendered(synthesizer, state, 1.0);
}

SoundState running(const core::settings::Handpiece& handpiece, float share)
{
    SoundState state;
    state.drive = driveOf(handpiece.freeRpm);
    state.turns = true;
    state.freeRpm = static_cast<float>(handpiece.freeRpm);
    state.burRpm = share * state.freeRpm;
    return state;
}

SoundState cutting(Material material, float mm3PerS)
{
    SoundState state = running({}, 0.85F);
    state.isTouching = true;
    state.material = material;
    state.cutMm3PerS = mm3PerS;
    return state;
}

Volumes only(core::audio::Part part)
{
    Volumes volumes;
    volumes.parts.fill(0.0F);
    volumes.parts.at(static_cast<std::size_t>(part)) = 1.0F;
    volumes.master = 1.0F;
    return volumes;
}

float loudest(const std::vector<float>& samples)
{
    float most = 0.0F;
    for (const float sample : samples)
        most = std::max(most, std::abs(sample));
    return most;
}

bool areFinite(const std::vector<float>& samples)
{
    return std::all_of(samples.begin(), samples.end(), [](float sample) { return std::isfinite(sample); });
}

double levelOf(const std::vector<float>& samples)
{
    double sum = 0.0;
    for (const float sample : samples)
        sum += static_cast<double>(sample) * static_cast<double>(sample);
    return std::sqrt(sum / static_cast<double>(samples.size()));
}

SoundState randomState(core::Rng& rng)
{
    constexpr int kDrives = 3;
    SoundState state;
    state.drive = static_cast<Drive>(rng.next() % kDrives);
    state.turns = rng.uniform() < 0.8;
    state.freeRpm = static_cast<float>(rng.uniform(5'000.0, 450'000.0));
    state.burRpm = static_cast<float>(rng.uniform(0.0, 1.1)) * state.freeRpm;
    state.isTouching = rng.uniform() < 0.5;
    state.cutMm3PerS = static_cast<float>(rng.uniform(0.0, 10.0));
    state.chatter = static_cast<float>(rng.uniform(0.0, 1.5));
    state.spray = rng.uniform() < 0.5;
    state.suction = rng.uniform() < 0.5;
    state.contacts = static_cast<std::uint32_t>(rng.next() % 3);
    state.contactMmPerS = static_cast<float>(rng.uniform(0.0, 50.0));
    state.material = static_cast<Material>(rng.next() % core::terrain::kMaterialCount);
    return state;
}

Volumes randomVolumes(core::Rng& rng)
{
    Volumes volumes;
    volumes.master = static_cast<float>(rng.uniform());
    for (float& part : volumes.parts)
        part = static_cast<float>(rng.uniform());
    volumes.isMuted = rng.uniform() < 0.2;
    return volumes;
}

}  // namespace

class TestSynthesizer : public QObject
{
    Q_OBJECT

private slots:
    void theFundamentalFollowsTheSpeedOfTheBur_data()
    {
        QTest::addColumn<int>("handpiece");
        QTest::addColumn<double>("rateHz");
        for (int handpiece = 0; handpiece < 3; ++handpiece)
            for (const double rateHz : {22'050.0, 44'100.0, 48'000.0, 96'000.0})
                QTest::addRow("handpiece %d at %.0f Hz", handpiece, rateHz) << handpiece << rateHz;
    }
    void theFundamentalFollowsTheSpeedOfTheBur()
    {
        QFETCH(const int, handpiece);
        QFETCH(const double, rateHz);
        for (const float share : {1.0F, 0.8F, 0.5F}) {
            const SoundState state = running(core::settings::handpieces()[static_cast<std::size_t>(handpiece)], share);
            const double wantedHz = static_cast<double>(state.burRpm) / 60.0;
            const lab::Spectrum spectrum(settled(state, rateHz, only(core::audio::Part::Handpiece)), rateHz);
            const double heardHz = spectrum.strongestHz(50.0, 0.45 * rateHz);
            QVERIFY2(std::abs(heardHz - wantedHz) < 0.01 * wantedHz,
                     qPrintable(QStringLiteral("%1 instead of %2 Hz").arg(heardHz).arg(wantedHz)));
        }
    }

    void aLoadLowersThePitch()
    {
        const auto heardHz = [](float share) {
            return lab::Spectrum(settled(running({}, share)), kRateHz).strongestHz(1'000.0, 8'000.0);
        };
        QVERIFY(heardHz(0.8F) < 0.85 * heardHz(1.0F));
    }

    /// The noise of enamel is at least twice as bright as that of dentin, and each material's own band is at least 10
    /// dB stronger in its sound than in the other's.
    void enamelAndDentinAreToldApart_data()
    {
        QTest::addColumn<double>("rateHz");
        for (const double rateHz : {22'050.0, 48'000.0, 96'000.0})
            QTest::addRow("%.0f Hz", rateHz) << rateHz;
    }
    void enamelAndDentinAreToldApart()
    {
        QFETCH(const double, rateHz);
        const auto spectrumOf = [rateHz](Material material, float mm3PerS) {
            return lab::Spectrum(settled(cutting(material, mm3PerS), rateHz, only(core::audio::Part::Cutting)), rateHz);
        };
        const lab::Spectrum enamel = spectrumOf(Material::Enamel, 0.4F);
        const lab::Spectrum dentin = spectrumOf(Material::Dentin, 1.6F);
        const double highestHz = 0.45 * rateHz;
        QVERIFY(enamel.centroidHz(100.0, highestHz) > 1.8 * dentin.centroidHz(100.0, highestHz));
        const auto highOverLow = [highestHz](const lab::Spectrum& spectrum) {
            return spectrum.power(5'000.0, highestHz) / spectrum.power(100.0, 3'500.0);
        };
        QVERIFY(highOverLow(enamel) > 10.0 * highOverLow(dentin));
    }

    /// They also differ in the complete sound with whine, spray and suction.
    void enamelAndDentinAreToldApartInTheWhole()
    {
        const auto spectrumOf = [](Material material, float mm3PerS) {
            SoundState state = cutting(material, mm3PerS);
            state.spray = true;
            state.suction = true;
            return lab::Spectrum(settled(state), kRateHz);
        };
        const lab::Spectrum enamel = spectrumOf(Material::Enamel, 0.4F);
        const lab::Spectrum dentin = spectrumOf(Material::Dentin, 1.6F);
        // The bands leave out the whine and its harmonics, at 4.5 and 9.1 kHz.
        QVERIFY(enamel.power(6'000.0, 8'400.0) > 2.0 * dentin.power(6'000.0, 8'400.0));
        QVERIFY(dentin.power(1'500.0, 3'500.0) > 4.0 * enamel.power(1'500.0, 3'500.0));
    }

    void aHarderCutIsLouder()
    {
        const auto level = [](float mm3PerS) {
            return levelOf(settled(cutting(Material::Dentin, mm3PerS), kRateHz, only(core::audio::Part::Cutting)));
        };
        QVERIFY(level(0.0F) > 0.0);  // the bur rubs
        QVERIFY(level(0.4F) > 1.5 * level(0.0F));
        QVERIFY(level(1.6F) > 1.5 * level(0.4F));
    }

    void everyPartIsHeardAndHasAVolume()
    {
        SoundState state = cutting(Material::Enamel, 0.4F);
        state.spray = true;
        state.suction = true;
        for (const core::audio::Part part : {core::audio::Part::Handpiece, core::audio::Part::Cutting,
                                             core::audio::Part::Spray, core::audio::Part::Suction})
            QVERIFY(loudest(settled(state, kRateHz, only(part))) > 0.02F);
        QCOMPARE(loudest(settled(state, kRateHz, only(core::audio::Part::Contact))), 0.0F);
        Synthesizer synthesizer(kRateHz);
        synthesizer.setVolumes(only(core::audio::Part::Contact));
        static_cast<void>(rendered(synthesizer, state, 0.5));
        ++state.contacts;
        state.contactMmPerS = 20.0F;
        QVERIFY(loudest(rendered(synthesizer, state, 0.1)) > 0.1F);
        QCOMPARE(loudest(rendered(synthesizer, state, 0.1)), 0.0F);
    }

    void chatterBeats()
    {
        SoundState state = cutting(Material::Enamel, 0.4F);
        const lab::Spectrum smooth(settled(state, kRateHz, only(core::audio::Part::Cutting)), kRateHz);
        state.chatter = 1.0F;
        const lab::Spectrum rough(settled(state, kRateHz, only(core::audio::Part::Cutting)), kRateHz);
        QVERIFY(rough.power(100.0, 500.0) > 10.0 * smooth.power(100.0, 500.0));
    }

    void restAndMuteAreSilence()
    {
        Synthesizer synthesizer(kRateHz);
        QCOMPARE(loudest(rendered(synthesizer, {}, 0.1)), 0.0F);
        SoundState state = cutting(Material::Enamel, 0.4F);
        state.spray = true;
        QVERIFY(loudest(rendered(synthesizer, state, 0.5)) > 0.05F);
        Volumes muted;
        muted.isMuted = true;
        synthesizer.setVolumes(muted);
        static_cast<void>(rendered(synthesizer, state, 0.2));
        QCOMPARE(loudest(rendered(synthesizer, state, 0.5)), 0.0F);
        synthesizer.setVolumes({});
        QVERIFY(loudest(rendered(synthesizer, state, 0.5)) > 0.05F);
        static_cast<void>(rendered(synthesizer, {}, 5.0));  // the handpiece runs down
        QCOMPARE(loudest(rendered(synthesizer, {}, 0.5)), 0.0F);
    }

    void noChangeMakesAJump_data()
    {
        QTest::addColumn<double>("rateHz");
        for (const double rateHz : {22'050.0, 44'100.0, 48'000.0, 96'000.0})
            QTest::addRow("%.0f Hz", rateHz) << rateHz;
    }
    void noChangeMakesAJump()
    {
        QFETCH(const double, rateHz);
        core::Rng rng(20);
        Synthesizer synthesizer(rateHz);
        float last = 0.0F;
        std::vector<float> block;
        for (int change = 0; change < 400; ++change) {
            const SoundState state = randomState(rng);
            if (rng.uniform() < 0.3)
                synthesizer.setVolumes(randomVolumes(rng));
            block.assign(1 + rng.next() % 3'000, 0.0F);
            synthesizer.render(state, block);
            QVERIFY(areFinite(block));
            QVERIFY(loudest(block) < 1.0F);
            for (const float sample : block) {
                QVERIFY(std::abs(sample - last) < kMostJump);
                last = sample;
            }
        }
    }

    void theFirstSampleAfterAChangeIsNearlyTheSame()
    {
        core::Rng rng(21);
        for (const double rateHz : {22'050.0, 48'000.0, 96'000.0}) {
            Synthesizer changed(rateHz);
            SoundState state;
            Volumes volumes;
            for (int change = 0; change < 400; ++change) {
                std::vector<float> before(1 + rng.next() % 3'000);
                changed.render(state, before);
                Synthesizer unchanged = changed;
                const SoundState next = randomState(rng);
                const Volumes nextVolumes = rng.uniform() < 0.5 ? randomVolumes(rng) : volumes;
                // Renders the same sound with and without the change.
                std::vector<float> expected(kFirstSamples);
                std::vector<float> heard(kFirstSamples);
                unchanged.render(state, expected);
                changed.setVolumes(nextVolumes);
                changed.render(next, heard);
                for (std::size_t k = 0; k < kFirstSamples; ++k)
                    QVERIFY2(std::abs(heard[k] - expected[k]) < kMostStep * static_cast<float>(k + 1),
                             qPrintable(QStringLiteral("sample %1 after change %2 at %3 Hz: %4")
                                            .arg(k)
                                            .arg(change)
                                            .arg(rateHz)
                                            .arg(static_cast<double>(heard[k] - expected[k]))));
                state = next;
                volumes = nextVolumes;
            }
        }
    }

    void valuesThatAreNoNumbersDoNoHarm()
    {
        Synthesizer synthesizer(kRateHz);
        static_cast<void>(rendered(synthesizer, cutting(Material::Enamel, 0.4F), 0.2));
        for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                                -std::numeric_limits<float>::infinity()}) {
            SoundState state = cutting(Material::Enamel, bad);
            state.freeRpm = bad;
            state.burRpm = bad;
            state.chatter = bad;
            state.contactMmPerS = bad;
            state.contacts = 7;
            state.material = static_cast<Material>(200);
            state.drive = static_cast<Drive>(200);
            Volumes volumes;
            volumes.master = bad;
            volumes.parts.fill(bad);
            synthesizer.setVolumes(volumes);
            QVERIFY(areFinite(rendered(synthesizer, state, 0.2)));
            synthesizer.setVolumes({});
            QVERIFY(areFinite(rendered(synthesizer, state, 0.2)));
        }
        const std::vector<float> after = rendered(synthesizer, cutting(Material::Enamel, 0.4F), 0.5);
        QVERIFY(areFinite(after));
        QVERIFY(loudest(after) > 0.05F);
        for (const double rateHz : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), 1.0e9}) {
            Synthesizer odd(rateHz);
            std::vector<float> samples(1'000);
            odd.render(cutting(Material::Enamel, 0.4F), samples);
            QVERIFY(areFinite(samples));
        }
    }

    /// A decaying sound must not end in denormal numbers, which some processors compute slowly.
    void nothingBecomesDenormal()
    {
        Synthesizer synthesizer(kRateHz);
        SoundState state = cutting(Material::Enamel, 0.4F);
        state.spray = true;
        state.contacts = 1;
        static_cast<void>(rendered(synthesizer, state, 0.5));
        state = {};
        state.suction = true;
        state.contacts = 2;
        for (int second = 0; second < 5; ++second)
            for (const float sample : rendered(synthesizer, state, 1.0))
                QVERIFY(sample == 0.0F || std::abs(sample) >= std::numeric_limits<float>::min());
    }

    void renderingAllocatesNothing()
    {
        Synthesizer synthesizer(kRateHz);
        std::vector<float> samples(samplesIn(0.1));
        core::Rng rng(22);
        const long before = support::allocationsOnThisThread();
        for (int k = 0; k < 20; ++k) {
            synthesizer.setVolumes(randomVolumes(rng));
            synthesizer.render(randomState(rng), samples);
        }
        QCOMPARE(support::allocationsOnThisThread() - before, 0L);
    }

    void channelsAreEqual()
    {
        Synthesizer one(kRateHz);
        Synthesizer two(kRateHz);
        const SoundState state = cutting(Material::Enamel, 0.4F);
        std::vector<float> mono(1'000);
        std::vector<float> stereo(2'001, 7.0F);
        one.render(state, mono);
        two.render(state, stereo, 2);
        for (std::size_t k = 0; k < mono.size(); ++k) {
            QCOMPARE(stereo[2 * k], mono[k]);
            QCOMPARE(stereo[2 * k + 1], mono[k]);
        }
        QCOMPARE(stereo.back(), 7.0F);  // the last value is not a whole frame
    }

    void theSampleHasEnamelAndDentin()
    {
        QVERIFY(!auditionAt(-1.0).turns);
        QVERIFY(auditionAt(0.5).turns);
        QVERIFY(!auditionAt(0.5).isTouching);
        QCOMPARE(auditionAt(2.0).material, Material::Enamel);
        QVERIFY(auditionAt(2.0).isTouching);
        QCOMPARE(auditionAt(3.5).material, Material::Dentin);
        QVERIFY(auditionAt(3.5).isTouching);
        QVERIFY(!auditionAt(kAuditionS).turns);
    }

    void theServoIsHeard()
    {
        ServoSound sound;
        core::servo::ServoState state;
        const core::settings::Handpiece turbine;
        constexpr double kTickS = 0.001;
        QVERIFY(!sound.update(state, turbine, kTickS).turns);
        state.drillOn = true;
        state.burRpm = 320'000.0;
        SoundState heard;
        for (int tick = 0; tick < 100; ++tick) {
            state.deviceMm.z -= 0.01;
            heard = sound.update(state, turbine, kTickS);
        }
        QVERIFY(heard.turns && heard.spray && heard.suction && !heard.isTouching);
        QCOMPARE(heard.drive, Drive::Turbine);
        QCOMPARE(heard.load(), 0.0F);
        QCOMPARE(heard.contacts, 0U);
        state.touching = true;
        state.burRpm = 240'000.0;
        state.forceN = {0.0, 0.0, 1.0};
        for (int tick = 0; tick < 100; ++tick) {
            state.removedMm3[1] += 0.0004;
            heard = sound.update(state, turbine, kTickS);
        }
        QCOMPARE(heard.contacts, 1U);
        QVERIFY(std::abs(heard.contactMmPerS - 10.0F) < 0.1F);
        QVERIFY(std::abs(heard.cutMm3PerS - 0.4F) < 0.01F);
        QCOMPARE(heard.load(), 0.25F);
        QVERIFY(heard.chatter < 0.1F);  // the bur is no longer in contact
        for (int tick = 0; tick < 100; ++tick) {
            state.forceN.z = tick % 4 < 2 ? 0.7 : 1.3;
            heard = sound.update(state, turbine, kTickS);
        }
        QVERIFY(heard.chatter > 0.5F);
        // On a new tooth, the decrease of the removed volume is not a cut.
        state.removedMm3 = {};
        for (int tick = 0; tick < 100; ++tick)
            heard = sound.update(state, turbine, kTickS);
        QVERIFY(heard.cutMm3PerS < 0.001F);
        state.health = core::servo::kDeviceLost;
        QVERIFY(!sound.update(state, turbine, kTickS).turns);
        QVERIFY(!sound.update({}, core::settings::handpieces()[2], kTickS).spray);
    }

    void aWaveFileIsWhole()
    {
        const std::vector<float> samples{0.0F, 1.0F, -1.0F, 2.0F};
        const std::string bytes = waveFile(samples, 44'100);
        QCOMPARE(bytes.size(), std::size_t(44 + 8));
        QCOMPARE(bytes.substr(0, 4), std::string("RIFF"));
        QCOMPARE(bytes.substr(8, 8), std::string("WAVEfmt "));
        QCOMPARE(bytes.substr(24, 4), std::string("\x44\xAC\x00\x00", 4));
        QCOMPARE(bytes.substr(44), std::string("\x00\x00\xFF\x7F\x01\x80\xFF\x7F", 8));
    }
};

CUSP_TEST(TestSynthesizer)
#include "tst_synthesizer.moc"
