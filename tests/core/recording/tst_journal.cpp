// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTemporaryDir>
#include <QTest>

#include <array>

#include "core/bur/Bur.h"
#include "core/recording/Format.h"
#include "core/recording/JournalFile.h"
#include "core/recording/Replay.h"
#include "core/servo/ServoState.h"
#include "core/session/JournalLoop.h"
#include "core/session/SessionChannels.h"
#include "tests/fuzz/Exercises.h"
#include "tests/support/Checks.h"
#include "tests/support/Files.h"
#include "tests/support/FullDisk.h"
#include "tests/support/Rig.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"
#include "tests/support/Trials.h"

using namespace core;
using namespace core::session;
using namespace core::servo;
using namespace std::chrono_literals;
using recording::FoundAttempt;
using recording::Recording;

namespace {

namespace fs = std::filesystem;

/// Ticks both loops of the journal once.
void beat(JournalLoop& journal)
{
    journal.tick(JournalLoop::kPeriod);
    journal.syncing().tick(JournalLoop::kPeriod);
}

/// Lets eight seconds of the journal's time pass. After a failure it pauses for less than that.
void pass(JournalLoop& journal)
{
    for (int n = 0; n < 200; ++n)
        journal.tick(JournalLoop::kPeriod);
}

/// An attempt with its journal.
struct Work
{
    support::Rig rig;
    std::unique_ptr<JournalLoop> journal;

    /// Begins an attempt on a small block with the drill on. Without a lesson, the attempt is not begun.
    explicit Work(const fs::path& folder, const char* lesson = "")
        : journal(std::make_unique<JournalLoop>(*rig.session, folder))
    {
        if (lesson != nullptr)
            rig.drill(support::smallBlock(), 1, lesson);
    }
    /// Cuts for this many ticks, and ticks the journal as often as the program does.
    void cut(int ticks, double x = 0.0)
    {
        for (int n = 0; n < ticks; ++n) {
            rig.lean(x, 0.0, 2.0, 1);
            if (rig.beats % 40 == 0)
                beat(*journal);
        }
    }
    void settle()
    {
        rig.settle();
        beat(*journal);
    }
};

std::vector<ServoEvent> eventsOf(const Recording& recording)
{
    std::vector<ServoEvent> events;
    recording.forEach([&](const ServoEvent& event) { events.push_back(event); });
    return events;
}

bool isPrefix(const std::vector<ServoEvent>& part, const std::vector<ServoEvent>& whole)
{
    return part.size() <= whole.size() && std::equal(part.begin(), part.end(), whole.begin());
}

}  // namespace

class TestJournal : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = m_folder->filePath("unfinished").toStdString();
    }

    void holdsAllThatHappened()
    {
        Work work(m_path, "a lesson");
        support::Rig& rig = work.rig;
        rig.send(SetAids{kHeatMapAid});
        const auto before = std::chrono::system_clock::now();
        work.cut(5000);
        rig.send(Undo{});
        work.cut(300, 1.0);
        work.settle();
        QCOMPARE(work.journal->eventsWritten(), rig.session->recordingSoFar()->events());
        QCOMPARE(files().size(), 1U);
        work.journal.reset();  // as if the program ended here
        const auto found = recording::findAttempt(files().front());
        QVERIFY(support::succeeds(found) && *found);
        const Recording& read = (*found)->recording;
        QVERIFY(eventsOf(read) == eventsOf(rig.session->recordingSoFar().value()));
        QCOMPARE(read.lesson(), std::string("a lesson"));
        QVERIFY(read.settings() == rig.settings);
        QCOMPARE(read.anatomy()->layers, support::smallBlock()->layers);
        QCOMPARE(recording::replay(read)->stateHash, rig.liveHash());
        const auto begun = std::chrono::system_clock::time_point(std::chrono::milliseconds((*found)->begunUtcMs));
        QVERIFY(begun >= before - 1s && begun <= std::chrono::system_clock::now());
    }

    void anUntouchedToothLeavesNoFile()
    {
        Work work(m_path, nullptr);
        support::Rig& rig = work.rig;
        beat(*work.journal);
        rig.open(support::smallBlock());
        rig.run(500);
        beat(*work.journal);
        QVERIFY(files().empty());
        QVERIFY(!fs::exists(m_path));
        // The first cut starts the journal, from the beginning of the attempt.
        rig.send(SetDrill{true});
        work.cut(200);
        QCOMPARE(files().size(), 1U);
        QVERIFY(work.journal->eventsWritten() > 600);
    }

    void anotherToothPutsItAway()
    {
        Work work(m_path);
        work.cut(200);
        work.rig.lift();
        const auto first = files();
        QCOMPARE(first.size(), 1U);
        work.rig.open(support::smallBlock(), 2);
        beat(*work.journal);
        QVERIFY(files().empty());
        work.cut(200);
        work.rig.lift();
        QCOMPARE(files().size(), 1U);
        work.journal->end();
        QCOMPARE(files().size(), 1U);
        work.journal->putAway();
        QVERIFY(files().empty());
    }

    void comesBackAndGoesOn()
    {
        std::uint64_t left = 0;
        {
            Work work(m_path, "lesson");
            work.cut(400);
            work.settle();
            left = work.rig.liveHash();
        }
        std::int64_t begun = 0;
        for (int life = 0; life < 3; ++life) {
            QCOMPARE(files().size(), 1U);
            FoundAttempt found = std::move(recording::findAttempt(files().front()).value().value());
            if (life > 0)
                QCOMPARE(found.begunUtcMs, begun);
            begun = found.begunUtcMs;
            Work work(m_path, nullptr);
            support::Rig& rig = work.rig;
            rig.open(support::smallBlock());  // the tooth at the start
            beat(*work.journal);
            const Recording before = found.recording;
            work.journal->takeUp(2, std::move(found));
            rig.resume(before, 2);
            QCOMPARE(rig.liveHash(), left);
            beat(*work.journal);
            QCOMPARE(files().size(), 1U);  // the new file has replaced the old one
            rig.send(SetDrill{true});
            work.cut(200, 0.7 * life);
            work.settle();
            left = rig.liveHash();
            QVERIFY(isPrefix(eventsOf(before), eventsOf(rig.session->recordingSoFar().value())));
        }
        const auto last = recording::findAttempt(files().front());
        QCOMPARE(recording::replay((*last)->recording)->stateHash, left);
    }

    void nobodyElseFindsAnAttemptAtWork()
    {
        Work work(m_path);
        work.cut(200);
        const fs::path path = files().front();
        const auto atWork = recording::findAttempt(path);
        QVERIFY(atWork && !*atWork);
        work.journal.reset();
        {
            const auto first = recording::findAttempt(path);
            QVERIFY(first && *first);
            const auto second = recording::findAttempt(path);
            QVERIFY(second && !*second);
        }
        QVERIFY(recording::findAttempt(path)->has_value());
        const auto gone = recording::findAttempt(m_path / "none.cuspjournal");
        QVERIFY(gone && !*gone);
    }

    /// Looks for unfinished attempts while a journal is being created, as when a user logs in during work.
    void whoeverLooksTakesNothingThatIsBeingMade()
    {
        Work work(m_path);
        work.cut(200);
        work.journal->putAway();
        const Recording soFar = *work.rig.session->recordingSoFar();
        std::atomic<bool> goOn = true;
        std::thread looker([this, &goOn] {
            while (goOn)
                for (const fs::path& path : files())
                    static_cast<void>(recording::findAttempt(path));
        });
        const int rounds = support::trials(60, 300);
        int kept = 0;
        for (int n = 0; n < rounds; ++n) {
            const fs::path path = m_path / (std::to_string(n) + ".cuspjournal");
            const auto made = recording::JournalFile::create(path, soFar, 1);
            kept += made && (*made)->sync() && fs::exists(path) ? 1 : 0;
            if (made)
                (*made)->remove();
        }
        goOn = false;
        looker.join();
        QCOMPARE(kept, rounds);
    }

    /// It says who worked when, and how.
    void aJournalIsForItsOwnerOnly()
    {
        const fs::path path = m_path / "of" / "one" / "own.cuspjournal";
        const auto journal = recording::JournalFile::create(path, Recording({}, support::smallBlock()), 0);
        QVERIFY(journal);
        constexpr fs::perms kOthers = fs::perms::group_all | fs::perms::others_all;
        QCOMPARE(fs::status(path.parent_path()).permissions() & kOthers, fs::perms::none);
        int files = 0;
        for (fs::directory_iterator at(path.parent_path()); at != fs::directory_iterator(); ++at, ++files)
            QCOMPARE(at->status().permissions() & kOthers, fs::perms::none);
        QCOMPARE(files, 1);
    }

    void cutAnywhereGivesTheLongestWholePart()
    {
        const std::string whole = shortJournal();
        const auto all = recording::attemptFrom(whole);
        QVERIFY(all);
        const std::vector<ServoEvent> events = eventsOf(all->recording);
        std::size_t last = 0;
        std::size_t lengths = 0;
        for (std::size_t length = 0; length < whole.size(); ++length) {
            const auto read = recording::attemptFrom(std::string_view(whole).substr(0, length));
            if (!read) {
                QCOMPARE(last, 0U);  // once it is readable, a longer file never contains less
                QVERIFY(read.error().detail.ends_with('.'));
                continue;
            }
            const std::vector<ServoEvent> part = eventsOf(read->recording);
            QVERIFY(isPrefix(part, events));
            QVERIFY(part.size() >= last);
            lengths += part.size() > last ? 1 : 0;
            last = part.size();
            QCOMPARE(read->recording.lesson(), std::string("lesson"));
        }
        QVERIFY2(lengths > 5 && events.size() - last < 100,
                 qPrintable(QString("%1 lengths, %2 of %3 events").arg(lengths).arg(last).arg(events.size())));
        // Additional bytes at the end do no harm.
        QCOMPARE(eventsOf(recording::attemptFrom(whole + std::string(1000, '\0'))->recording).size(), events.size());
        QCOMPARE(eventsOf(recording::attemptFrom(whole + whole)->recording).size(), events.size());
    }

    void flippedBitsAreNeverBelieved()
    {
        std::string bytes = shortJournal();
        const std::vector<ServoEvent> events = eventsOf(recording::attemptFrom(bytes)->recording);
        constexpr std::size_t kMagicBytes = 8;
        std::size_t kept = 0;
        for (std::size_t at = 0; at < bytes.size(); ++at) {
            for (unsigned bit = 0; bit < 8; ++bit) {
                const char before = bytes[at];
                bytes[at] = static_cast<char>(static_cast<unsigned char>(before) ^ (1U << bit));
                const auto read = recording::attemptFrom(bytes);
                bytes[at] = before;
                if (!read)
                    continue;
                const std::vector<ServoEvent> part = eventsOf(read->recording);
                // The version only says which Cusp wrote the file. A supported version has the same events.
                const bool isVersion = at >= kMagicBytes && at < kMagicBytes + sizeof(std::uint32_t);
                QVERIFY2((isVersion || part.size() < events.size()) && isPrefix(part, events),
                         qPrintable(QString("byte %1, bit %2").arg(at).arg(bit)));
                ++kept;
            }
        }
        QVERIFY(kept > 1000);
    }

    void strangersAreRefused_data()
    {
        support::columns<QByteArray, ErrorCode>("bytes", "code");
        init();
        const QByteArray good = QByteArray::fromStdString(shortJournal());
        QByteArray newer = good;
        newer[8] = static_cast<char>(good[8] + 1);
        QByteArray older = good;
        older[8] = static_cast<char>(recording::kOldestVersion - 1);
        QTest::newRow("empty") << QByteArray() << ErrorCode::WrongKind;
        QTest::newRow("text") << QByteArray("Once upon a time there was a tooth.") << ErrorCode::WrongKind;
        QTest::newRow("a recording") << QByteArray::fromStdString(Recording({}, support::smallBlock()).toBytes())
                                     << ErrorCode::WrongKind;
        QTest::newRow("magic alone") << good.left(8) << ErrorCode::FileTruncated;
        QTest::newRow("a newer version") << newer << ErrorCode::NewerVersion;
        QTest::newRow("an older version") << older << ErrorCode::WrongKind;
        QTest::newRow("no tooth") << good.left(200) << ErrorCode::FileTruncated;
        QTest::newRow("noughts") << good.left(12) + QByteArray(5000, '\0') << ErrorCode::FileTruncated;
        QTest::newRow("a frame of 4 GiB") << good.left(16) + QByteArray(100, '\xFF') << ErrorCode::FileTruncated;
    }

    void strangersAreRefused()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(ErrorCode, code);
        QVERIFY(support::isRefused(recording::attemptFrom(bytes.toStdString()), code));
        // If the bytes are in a file, the error names the file.
        const fs::path path = m_path / "1-1.cuspjournal";
        support::write(path, bytes.toStdString());
        QVERIFY(support::isRefused(recording::findAttempt(path), "1-1.cuspjournal"));
    }

    /// The newer program may still resume the attempt, so it must not be cut short at the unknown bur.
    void aBurOfANewerProgramIsSaidToBeNewer()
    {
        const fs::path path = m_path / "1-2.cuspjournal";
        {
            const auto journal = recording::JournalFile::create(path, Recording({}, support::smallBlock()), 0);
            QVERIFY(support::succeeds(journal));
            const ServoEvent tick{ServoEvent::Kind::Tick, 1000, {0.0F, 0.0F, 5.0F}, 0};
            const ServoEvent bur{ServoEvent::Kind::Bur, 0, {}, bur::burs().size()};
            QVERIFY((*journal)->append(std::array{tick, bur, tick}));
            QVERIFY((*journal)->sync());
        }
        QVERIFY(support::isRefused(recording::findAttempt(path), ErrorCode::NewerVersion));
        QVERIFY(fs::exists(path));
    }

    void aFullDiskIsToldOnceAndCaughtUpWith()
    {
        Work work(m_path);
        JournalLoop& journal = *work.journal;
        work.cut(400);
        const std::uint64_t before = journal.eventsWritten();
        QVERIFY(before > 300 && !journal.failure());
        {
            const support::FullDisk full(fs::file_size(files().front()) + 100);
            work.cut(400);
            pass(journal);
            const auto told = journal.failure();
            QVERIFY(told);
            QCOMPARE(told->code, ErrorCode::FileUnwritable);
            QVERIFY(!journal.failure());
            QCOMPARE(journal.eventsWritten(), before);
            QVERIFY(!journal.isWell());
        }
        pass(journal);
        work.cut(400);
        work.settle();
        QVERIFY(!journal.failure());
        QVERIFY(journal.isWell());
        holdsAllOf(work);
        // Resuming without room on the disk leaves the old file as the only one.
        journal.end();
        const std::string old = support::bytesOf(files().front());
        const fs::path path = m_path / "taken up" / "1-1.cuspjournal";
        fs::create_directories(path.parent_path());
        fs::copy_file(files().front(), path);
        {
            FoundAttempt found = std::move(recording::findAttempt(path).value().value());
            Work again(path.parent_path(), nullptr);
            const Recording leftOff = found.recording;
            again.journal->takeUp(2, std::move(found));
            const support::FullDisk full(1000);
            again.rig.resume(leftOff, 2);
            again.cut(100);
            QVERIFY(again.journal->failure());
        }
        QCOMPARE(recording::journalsIn(path.parent_path()), std::vector<fs::path>{path});
        QVERIFY(support::bytesOf(path) == old);
        // The disk is full from the beginning.
        Work other(m_path / "other");
        JournalLoop& nowhere = *other.journal;
        {
            const support::FullDisk full(500);
            other.cut(400);
            QVERIFY(nowhere.failure());
            QVERIFY(fs::is_empty(m_path / "other"));
        }
        pass(nowhere);
        other.cut(100);
        QVERIFY(!nowhere.failure());
        QCOMPARE(recording::journalsIn(m_path / "other").size(), 1U);
    }

    void aFolderThatCannotBeIsTold()
    {
        support::write(m_path, {});  // a file in place of the folder
        Work work(m_path);
        work.cut(400);
        const auto told = work.journal->failure();
        QVERIFY(told);
        QVERIFY(told->detail.ends_with('.'));
        QVERIFY(files().empty());
        QVERIFY(work.rig.session->recordingSoFar()->ticks() > 390);  // the work continues
        work.journal->end();
        work.journal->putAway();
    }

    void whatIsLateIsCaughtUpWith()
    {
        Work work(m_path);
        work.cut(200);
        for (int n = 0; n < 20; ++n) {  // the disk does not respond for twenty seconds
            work.rig.lean(0.1 * n, 0.0, 2.0, 700);
            work.rig.lift();
            work.rig.run(100);
        }
        work.settle();
        QVERIFY(work.journal->eventsWritten() > 20000);
        holdsAllOf(work);
    }

    void discardedOnesAreKeptForAWeek()
    {
        const std::string bytes = shortJournal();
        const fs::path first = m_path / "1-1.cuspjournal";
        const fs::path second = m_path / "2-1.cuspjournal";
        support::write(first, bytes);
        support::write(second, bytes);
        fs::last_write_time(first, fs::file_time_type::clock::now() - std::chrono::hours(24 * 30));
        QCOMPARE(files(), (std::vector<fs::path>{second, first}));  // newest first
        recording::discardJournal(first);
        recording::tidyJournals(m_path);
        QCOMPARE(files(), std::vector<fs::path>{second});
        const fs::path kept = m_path / "discarded" / first.filename();
        QVERIFY(fs::exists(kept));
        fs::last_write_time(kept, fs::file_time_type::clock::now() - std::chrono::hours(24 * 7 - 1));
        recording::tidyJournals(m_path);
        QVERIFY(fs::exists(kept));
        fs::last_write_time(kept, fs::file_time_type::clock::now() - std::chrono::hours(24 * 7 + 1));
        recording::tidyJournals(m_path);
        QVERIFY(!fs::exists(kept));
        QVERIFY(fs::exists(second));
    }

    void beforeTheDiskHasItThereAreTwo()
    {
        Work work(m_path);
        std::unique_ptr<JournalLoop>& journal = work.journal;
        const auto cutUnsynced = [&](int ticks) {
            work.rig.lean(0.0, 0.0, 2.0, ticks);
            work.rig.settle();
            journal->tick(40ms);
        };
        cutUnsynced(200);
        QCOMPARE(files().size(), 1U);
        const fs::path path = files().front();
        const fs::path part = path.string() + ".part";
        QVERIFY(fs::exists(part) && !fs::exists(path));
        QVERIFY(!recording::findAttempt(path)->has_value());  // the program that writes it is still running
        const std::string young = support::bytesOf(part);
        journal->syncing().tick(40ms);
        QVERIFY(!fs::exists(part) && fs::exists(path));
        cutUnsynced(200);
        journal->syncing().tick(40ms);
        const std::string old = support::bytesOf(path);
        journal.reset();
        const auto events = [](const std::string& bytes) { return recording::attemptFrom(bytes)->recording.events(); };
        // The program was killed after resuming: the new file holds less than the old one, as much, or more.
        for (const auto& [first, second] : {std::pair(old, young), std::pair(old, old), std::pair(young, old)}) {
            support::write(path, first);
            support::write(part, second);
            QCOMPARE(files(), std::vector<fs::path>{path});
            const auto found = recording::findAttempt(path);
            QVERIFY(found && *found);
            QCOMPARE((*found)->recording.events(), events(old));
            QVERIFY(!fs::exists(part));
            QCOMPARE(recording::attemptFrom(support::bytesOf(path))->recording.events(), events(old));
            QVERIFY(!recording::findAttempt(path)->has_value());  // locked, whichever file it was read from
        }
        // The very first file was never synced. It is used nevertheless.
        fs::remove(path);
        support::write(part, young);
        QCOMPARE((*recording::findAttempt(path))->recording.events(), events(young));
        QVERIFY(fs::exists(path));
        // A valid new file next to a damaged old one, and the other way round.
        support::write(path, "rubbish");
        support::write(part, young);
        QCOMPARE((*recording::findAttempt(path))->recording.events(), events(young));
        support::write(path, young);
        support::write(part, "rubbish");
        QCOMPARE((*recording::findAttempt(path))->recording.events(), events(young));
    }

    void whatAnInterruptedStartLeftIsCleared()
    {
        support::write(m_path / "1-1.cuspjournal.part", "CUSPJRN");
        QCOMPARE(files().size(), 1U);
        const auto found = recording::findAttempt(files().front());
        QVERIFY(found && !*found);  // it has no moment, so there is nothing to report
        QVERIFY(files().empty());
        recording::tidyJournals(m_path / "none");  // a missing folder is no error
    }

    void whatIsLeftOutIsNotWritten()
    {
        Work work(m_path, nullptr);
        support::Rig& rig = work.rig;
        work.journal->leaveOut(1);
        rig.drill(support::smallBlock(), 1);
        work.cut(130);
        rig.settle();
        work.journal->tick(JournalLoop::kPeriod);
        QVERIFY(rig.session->recordedSince(1, 0).isWorthKeeping);
        QVERIFY(files().empty());
        // The next attempt has a journal again.
        rig.lift();
        rig.drill(support::smallBlock(), 2);
        work.cut(130);
        rig.settle();
        work.journal->tick(JournalLoop::kPeriod);
        QCOMPARE(files().size(), 1U);
        work.journal->putAway();
    }

    void aMinuteIsUnderAMegabyte()
    {
        // The hand of TestRecording::minuteIsUnderAMegabyte, with the journal written along the way.
        Work work(m_path);
        work.cut(100);
        work.settle();
        const auto before = fs::file_size(files().front());
        Rng rng(1);
        for (int n = 0; n < 60000; ++n) {
            const double t = n * 0.001;
            const glm::dvec3 stroke(2.0 * std::sin(1.7 * t), 1.5 * std::sin(0.9 * t + 1.0),
                                    1.0 + 0.6 * std::sin(2.3 * t));
            const glm::dvec3 tremor = 0.01 * glm::dvec3(std::sin(57.0 * t), std::cos(63.0 * t), std::sin(71.0 * t));
            const glm::dvec3 noise = 0.001 * glm::dvec3(rng.normal(), rng.normal(), rng.normal());
            work.rig.device.tipMm = glm::vec3(stroke + tremor + noise);
            work.rig.run(1);
            if (n % 40 == 39)
                beat(*work.journal);
        }
        const auto bytes = fs::file_size(files().front()) - before;
        qInfo("one minute at 1 kHz, 25 frames a second: %llu bytes (before it: %llu)",
              static_cast<unsigned long long>(bytes), static_cast<unsigned long long>(before));
        QVERIFY(bytes < 1024 * 1024);
    }

    /// With CUSP_REWRITE_CORPUS=1, writes the seed of the fuzzer again.
    void corpusOfTheFuzzerIsHarmless()
    {
        if (support::rewritesSeeds())
            support::writeSeed("journal", "short", shortJournal());
        QVERIFY(support::forEachSeed("journal", fuzz::exerciseJournal));
    }

private:
    /// Checks that the only file holds each event of the attempt, and that the journal reports it.
    void holdsAllOf(const Work& work) const
    {
        const Recording made = work.rig.session->recordingSoFar().value();
        QCOMPARE(work.journal->eventsWritten(), made.events());
        const auto read = recording::attemptFrom(support::bytesOf(files().front()));
        QVERIFY(eventsOf(read->recording) == eventsOf(made));
    }

    [[nodiscard]] std::vector<fs::path> files() const { return recording::journalsIn(m_path); }
    /// Returns the bytes of the journal of a short attempt.
    [[nodiscard]] std::string shortJournal() const
    {
        Work work(m_path, "lesson");
        work.cut(130);
        work.rig.lift();
        work.rig.send(Undo{});
        work.rig.send(AddNote{3});
        work.cut(130, 1.0);
        work.rig.settle();
        work.journal->end();
        std::string bytes = support::bytesOf(files().front());
        work.journal->putAway();
        return bytes;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    fs::path m_path;
};

CUSP_TEST(TestJournal)
#include "tst_journal.moc"
