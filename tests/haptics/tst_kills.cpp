// SPDX-License-Identifier: GPL-3.0-or-later
// A program is killed at a random moment during an attempt, and the next program finds and resumes the attempt. This
// test program is its own victim: with --victim it works until it is killed, and prints its progress. With --found it
// prints what is left of a victim's attempt, for power_cut.sh.
#include <QCoreApplication>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <thread>

#include <unistd.h>

#include "core/recording/Replay.h"
#include "core/servo/ServoState.h"
#include "core/session/JournalLoop.h"
#include "core/session/SessionChannels.h"
#include "tests/support/Checks.h"
#include "tests/support/Rig.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Trials.h"

using namespace core;
using namespace core::session;
using namespace core::servo;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

namespace {

constexpr int kMostLives = 8;  ///< of one attempt
constexpr std::int64_t kMayBeLostUs = 100'000;

/// Makes strokes over the block, two a second, each at another place. The first begins at once.
class StrokingDevice final : public haptics::HapticDevice
{
public:
    explicit StrokingDevice(std::uint64_t seed) : m_phase(static_cast<double>(seed)) {}
    haptics::DeviceSample exchange(const glm::dvec3&) noexcept override
    {
        const double t = 0.001 * m_ticks++;
        return {{2.0 * std::sin(1.7 * t + m_phase), 2.0 * std::sin(1.1 * t + 2.0 * m_phase),
                 0.2 - 0.9 * std::abs(std::sin(6.0 * t))},
                true};
    }

private:
    double m_phase;
    int m_ticks = 0;
};

/// Ticks like app::LoopThread.
template <class Beat>
void keepBeating(std::chrono::microseconds period, const Beat& beat)
{
    auto due = Clock::now();
    std::chrono::microseconds step = period;
    for (;;) {
        beat(step);
        due += period;
        step = period;
        if (const auto now = Clock::now(); now > due) {
            const auto missed = (now - due) / period;
            due += missed * period;
            step += missed * period;
        }
        std::this_thread::sleep_until(due);
    }
}

/// Prints a line with one write, so that a kill does not split it.
void say(const char* line)
{
    static_cast<void>(!::write(STDOUT_FILENO, line, std::strlen(line)));
}

/// Works on the attempt found in a folder, or on a new one, until it is killed. Prints these lines:
///     at MICROSECONDS CUT_MICROSECONDS EVENTS_WRITTEN    time of the servo; time of the first cut, or -1
///     was TICK HASH                                      state hash of the tooth after a tick
[[noreturn]] void work(const char* folder, std::uint64_t seed)
{
    const auto servoLinks = std::make_unique<ServoChannels>();
    const auto uiLinks = std::make_unique<UiChannels>();
    StrokingDevice device(seed);
    SessionLoop session(*servoLinks, *uiLinks, {});
    haptics::ServoLoop servo(device, makeServoTick({}).value(), *servoLinks, uiLinks->servo, 1ms);
    JournalLoop journal(session, folder);
    const auto send = [&](SessionCommand command) { static_cast<void>(uiLinks->commands.tryPush(std::move(command))); };

    std::atomic<std::int64_t> atUs{0};
    std::atomic<std::int64_t> cutUs{-1};
    const auto files = recording::journalsIn(folder);
    if (auto found = files.empty() ? std::nullopt : recording::findAttempt(files.front()).value()) {
        atUs = found->recording.duration().count();
        cutUs = 0;
        auto attempt = rebuild(found->recording).value();
        journal.takeUp(1, std::move(*found));
        send(ResumeAttempt{std::move(attempt), 1});
    } else {
        send(ReplaceTooth{std::make_unique<terrain::Tooth>(support::smallBlock()), 1, "lesson"});
    }
    send(SetDrill{true});

    const std::thread journalThread([&] { keepBeating(JournalLoop::kPeriod, [&](auto dt) { journal.tick(dt); }); });
    const std::thread syncThread(
        [&] { keepBeating(JournalLoop::kSyncRest, [&](auto dt) { journal.syncing().tick(dt); }); });
    const std::thread sessionThread([&] { keepBeating(10ms, [&](auto dt) { session.tick(dt); }); });
    const std::thread servoThread([&] {
        keepBeating(1ms, [&](std::chrono::microseconds dt) {
            const bool begun = servo.tooth() != nullptr;
            servo.tick(dt);
            if (!begun)
                return;
            atUs += std::min(dt, haptics::ServoLoop::kLongestStep).count();
            const terrain::PerMaterial& removed = servo.state().removedMm3;
            if (cutUs < 0 && removed[0] + removed[1] + removed[2] + removed[3] > 0.0)
                cutUs = atUs.load();
        });
    });
    Rng rng(seed);
    char line[128];
    for (int n = 0;; ++n) {
        std::snprintf(line, sizeof line, "at %lld %lld %llu\n", static_cast<long long>(atUs.load()),
                      static_cast<long long>(cutUs.load()), static_cast<unsigned long long>(journal.eventsWritten()));
        say(line);
        if (n % 20 == 19) {
            if (const auto soFar = session.recordingSoFar(); soFar && soFar->witness()) {
                std::snprintf(line, sizeof line, "was %llu %llu\n",
                              static_cast<unsigned long long>(soFar->witness()->tick),
                              static_cast<unsigned long long>(soFar->witness()->stateHash));
                say(line);
            }
        }
        const int act = rng.below(40);
        if (act == 0)
            send(Undo{});
        else if (act == 1)
            send(Redo{});
        else if (act == 2)
            send(SetBur{static_cast<std::uint8_t>(rng.below(4))});
        else if (act == 3)
            send(AddNote{static_cast<std::uint64_t>(n)});
        for (TilePatch patch; uiLinks->patches.tryPop(patch);) {
            // no view reads them
        }
        std::this_thread::sleep_for(3ms);  // the period of the user's thread
    }
}

/// The output of a victim.
struct Said
{
    std::int64_t atUs = 0;
    std::int64_t cutUs = -1;
    std::uint64_t written = 0;
    std::map<std::uint64_t, std::uint64_t> hashes;  ///< state hashes by tick
};

Said parsed(const QByteArray& output)
{
    Said said;
    const QList<QByteArray> lines = output.left(output.lastIndexOf('\n') + 1).split('\n');
    for (const QByteArray& line : lines) {
        const QList<QByteArray> words = line.split(' ');
        if (words[0] == "at") {
            said.atUs = words[1].toLongLong();
            said.cutUs = words[2].toLongLong();
            said.written = words[3].toULongLong();
        } else if (words[0] == "was") {
            said.hashes[words[1].toULongLong()] = words[2].toULongLong();
        }
    }
    return said;
}

/// Returns the attempt in a folder, if one exists that has reached its first moment.
Result<std::optional<recording::FoundAttempt>> attemptIn(const std::filesystem::path& folder)
{
    const auto files = recording::journalsIn(folder);
    if (files.size() > 1)
        return unexpected(ErrorCode::WrongKind, "There is more than one journal.");
    return files.empty() ? Result<std::optional<recording::FoundAttempt>>(std::nullopt)
                         : recording::findAttempt(files.front());
}

struct Compared
{
    int alike = 0;
    int different = 0;
    bool isPlayable = false;
};

/// Compares the recovered states with those that the victim printed, to the bit.
Compared compared(const recording::Recording& left, const std::map<std::uint64_t, std::uint64_t>& hashes)
{
    Compared states;
    std::uint64_t tick = 0;
    const auto outcome = recording::replay(left, [&](const ServoEvent& event, const recording::Replayer& servo) {
        if (!recording::isStep(event))
            return;
        const auto known = hashes.find(++tick);
        if (known != hashes.end())
            ++(terrain::stateHash(servo.tooth().tooth()) == known->second ? states.alike : states.different);
    });
    states.isPlayable = outcome.has_value();
    return states;
}

/// After a power cut, prints "found EVENTS lost AT_LEAST_MS AT_MOST_MS states COMPARED", or "nothing ..." if no cutting
/// had reached the disk. The power was cut between the two moments at which the victim's output was read.
int sayWhatIsLeft(const char* folder, const char* saidBefore, const char* saidAfter)
{
    const auto words = [](const char* path) {
        QFile file(QString::fromLocal8Bit(path));
        return file.open(QIODevice::ReadOnly) ? parsed(file.readAll()) : Said();
    };
    const Said before = words(saidBefore);
    const Said after = words(saidAfter);
    const auto attempt = attemptIn(folder);
    if (!attempt) {
        std::fprintf(stderr, "%s\n", attempt.error().detail.c_str());
        return 1;
    }
    if (!*attempt) {
        const auto since = [&](const Said& said) {
            return said.cutUs >= 0 ? 1.0e-3 * static_cast<double>(said.atUs - said.cutUs) : 0.0;
        };
        std::printf("nothing 0 lost %.1f %.1f states 0\n", since(before), since(after));
        return 0;
    }
    const recording::Recording& left = (*attempt)->recording;
    const Compared states = compared(left, after.hashes);
    const auto lost = [&](const Said& said) {
        return 1.0e-3 * static_cast<double>(std::max<std::int64_t>(0, said.atUs - left.duration().count()));
    };
    std::printf("found %llu lost %.1f %.1f states %d\n", static_cast<unsigned long long>(left.events()), lost(before),
                lost(after), states.alike);
    if (!states.isPlayable || states.different > 0)
        std::fprintf(stderr, "What was left is not what was done.\n");
    return states.isPlayable && states.different == 0 ? 0 : 1;
}

}  // namespace

class TestKills : public QObject
{
    Q_OBJECT
private slots:
    /// At night, 99 of 100 losses are at most 100 ms. The longest one is only printed, because a busy computer may
    /// cause more.
    void nothingWrittenIsEverLost()
    {
        const int kills = support::trials(20, 1000);
        Rng rng(static_cast<std::uint64_t>(kills));
        auto folder = std::make_unique<QTemporaryDir>();
        std::uint64_t before = 0;  ///< events of the attempt when the last program ended
        std::map<std::uint64_t, std::uint64_t> hashes;
        int lives = 0;
        int found = 0;
        int resumed = 0;
        int alike = 0;
        std::vector<double> lostMs;
        for (int kill = 0; kill < kills; ++kill) {
            if (++lives > kMostLives) {
                folder = std::make_unique<QTemporaryDir>();
                before = 0;
                hashes.clear();
                lives = 1;
            }
            QProcess victim;
            victim.start(QCoreApplication::applicationFilePath(), {"--victim", folder->path(), QString::number(kill)});
            QVERIFY(victim.waitForStarted());
            // Some are killed before they have begun.
            if (rng.below(8) != 0)
                victim.waitForReadyRead();
            QTest::qSleep(rng.below(600));  // kills at a random moment
            victim.kill();
            QVERIFY(victim.waitForFinished());
            QCOMPARE(victim.exitStatus(), QProcess::CrashExit);
            const QByteArray complaints = victim.readAllStandardError();
            QVERIFY2(complaints.isEmpty(), complaints.constData());
            const Said said = parsed(victim.readAllStandardOutput());
            hashes.insert(said.hashes.begin(), said.hashes.end());
            resumed += before > 0 && said.atUs > 0 ? 1 : 0;

            const auto attempt = attemptIn(folder->path().toStdString());
            QVERIFY(support::succeeds(attempt));
            // There may be no attempt, or none that has reached its first moment. Then there was none before either. A
            // killed program leaves no lock.
            if (!*attempt) {
                QCOMPARE(before, 0U);
                QCOMPARE(said.written, 0U);
                hashes.clear();
                if (said.cutUs >= 0)
                    lostMs.push_back(1.0e-3 * static_cast<double>(said.atUs - said.cutUs));
                continue;
            }
            const recording::Recording& left = (*attempt)->recording;
            QVERIFY(left.events() >= before);
            QVERIFY(left.events() >= said.written);
            before = left.events();
            ++found;
            lostMs.push_back(1.0e-3 * static_cast<double>(said.atUs - left.duration().count()));
            // The recovered attempt is that of the victim, to the bit. The lost part is worked again, differently.
            hashes.erase(hashes.upper_bound(left.ticks()), hashes.end());
            const Compared states = compared(left, hashes);
            QVERIFY(states.isPlayable);
            QCOMPARE(states.different, 0);
            alike += states.alike;
            QCOMPARE(left.lesson(), std::string("lesson"));
        }
        std::sort(lostMs.begin(), lostMs.end());
        QVERIFY(found > kills / 2);
        QVERIFY(resumed > kills / 4);
        QVERIFY(alike > kills / 2);
        const double most = lostMs[lostMs.size() * 99 / 100];
        qInfo(
            "%d kills, %d attempts found, %d resumed, %d states compared; lost: half %.1f ms, 99 of 100 %.1f ms, most "
            "%.1f ms",
            kills, found, resumed, alike, lostMs[lostMs.size() / 2], most, lostMs.back());
        if (support::isNightly())
            QVERIFY2(most * 1000.0 <= static_cast<double>(kMayBeLostUs), qPrintable(QString::number(most)));
    }
};

int main(int argc, char* argv[])
{
    if (argc == 4 && std::strcmp(argv[1], "--victim") == 0)
        work(argv[2], std::strtoull(argv[3], nullptr, 10));
    if (argc == 5 && std::strcmp(argv[1], "--found") == 0)
        return sayWhatIsLeft(argv[2], argv[3], argv[4]);
    QCoreApplication application(argc, argv);
    if (support::isNightly())
        qputenv("QTEST_FUNCTION_TIMEOUT", "3600000");  // Qt Test would abort the test after five minutes
    TestKills test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_kills.moc"
