// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <string>

#include <zstd.h>

#include "core/base/Bytes.h"
#include "core/bur/Bur.h"
#include "core/recording/Format.h"
#include "core/recording/Replay.h"
#include "core/servo/ServoParameters.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "tests/fuzz/Exercises.h"
#include "tests/support/Checks.h"
#include "tests/support/Files.h"
#include "tests/support/FullDisk.h"
#include "tests/support/Rig.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticMolar.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"

using namespace core;
using core::servo::ServoEvent;
using recording::Recording;

namespace {

constexpr std::size_t kFileHeaderBytes = 12;
using Spoil = std::function<void(terrain::ToothAnatomy&)>;

/// Records a short attempt: a few ticks of cutting, another bur and handpiece, a lost reading, an undo, a lesson, an
/// aid, a note.
Recording shortAttempt(core::servo::ServoSettings settings = {})
{
    settings.handpieces.push_back(settings::findHandpiece("low-speed").value());
    support::Rig rig(settings);
    rig.drill(support::smallBlock(), 1, "lesson 1");
    rig.send(session::SetAids{core::servo::kSectionAid});
    rig.lean(0.0, 0.0, 2.0, 120);
    rig.send(session::AddNote{7});
    rig.device.present = false;
    rig.run(5);
    rig.device.present = true;
    rig.lift();
    rig.send(core::servo::SetBur{3});
    rig.send(core::servo::SetHandpiece{1});
    rig.lean(1.0, 0.5, 2.0, 60);
    rig.lift();
    rig.give(session::Undo{});
    return rig.session->recordingSoFar().value();
}

/// Records the same attempt with settings from before flat ends and full loads existed.
Recording attemptAsBefore()
{
    core::servo::ServoSettings settings;
    settings.hardness = settings::withoutEndsAndFullLoad(settings.hardness);
    return shortAttempt(settings);
}

/// Returns the recording of an attempt at a small block with these events.
Recording recordingOf(const std::vector<ServoEvent>& events)
{
    Recording made({}, support::smallBlock());
    for (const ServoEvent& event : events)
        made.append(event);
    return made;
}

std::vector<ServoEvent> allEvents(const Recording& recording)
{
    std::vector<ServoEvent> events;
    recording.forEach([&](const ServoEvent& event) { events.push_back(event); });
    return events;
}

std::array<std::uint32_t, 3> bitsOf(const glm::vec3& v)
{
    return {std::bit_cast<std::uint32_t>(v.x), std::bit_cast<std::uint32_t>(v.y), std::bit_cast<std::uint32_t>(v.z)};
}

/// Returns whether all events are equal, every position to the last bit, NaN included.
bool sameBits(const Recording& a, const Recording& b)
{
    const std::vector<ServoEvent> one = allEvents(a);
    const std::vector<ServoEvent> other = allEvents(b);
    return std::equal(one.begin(), one.end(), other.begin(), other.end(), [](const auto& x, const auto& y) {
        return x.kind == y.kind && x.dtUs == y.dtUs && x.value == y.value && bitsOf(x.deviceMm) == bitsOf(y.deviceMm);
    });
}

/// Returns one section of the file in the layout of Recording.cpp.
std::string section(std::uint32_t kind, std::string_view payload)
{
    ByteWriter out;
    out.put(kind);
    out.put(static_cast<std::uint64_t>(payload.size()));
    out.put(fnv1a(payload));
    out.putAll(std::span(payload.data(), payload.size()));
    return out.bytes();
}

/// Returns the same file with another payload in one of its sections.
std::string withSection(std::string_view file, std::uint32_t kind, std::string_view payload)
{
    std::string bytes(file.substr(0, kFileHeaderBytes));
    file.remove_prefix(kFileHeaderBytes);
    while (!file.empty()) {
        ByteReader in(file);
        const auto here = in.take<std::uint32_t>();
        const auto size = in.take<std::uint64_t>();
        bytes += here == kind ? section(kind, payload) : std::string(file.substr(0, 20 + size));
        file.remove_prefix(20 + size);
    }
    return bytes;
}

std::string zstd(const std::string& raw)
{
    std::string out(ZSTD_compressBound(raw.size()), '\0');
    out.resize(ZSTD_compress(out.data(), out.size(), raw.data(), raw.size(), 19));
    return out;
}

}  // namespace

class TestRecording : public QObject
{
    Q_OBJECT
private slots:
    /// With CUSP_REWRITE_CORPUS=1, writes the seeds of the fuzzer again: as saved, and with the sections unpacked.
    void initTestCase()
    {
        if (!support::rewritesSeeds())
            return;
        const std::string bytes = shortAttempt().toBytes();
        support::writeSeed("recording", "saved", bytes);
        support::writeSeed("recording", "unpacked", fuzz::unpacked(bytes));
    }

    void bytesComeBackEqual()
    {
        const Recording made = shortAttempt();
        QVERIFY(made.witness().has_value());
        const auto read = Recording::fromBytes(made.toBytes());
        QVERIFY(support::succeeds(read));
        QVERIFY(sameBits(made, *read));
        QCOMPARE(read->ticks(), made.ticks());
        QCOMPARE(read->duration().count(), made.duration().count());
        QVERIFY(read->witness() == made.witness());
        QVERIFY(read->settings() == made.settings());
        QCOMPARE(read->anatomy()->name, made.anatomy()->name);
        QCOMPARE(read->anatomy()->grid, made.anatomy()->grid);
        QCOMPARE(read->anatomy()->top, made.anatomy()->top);
        QCOMPARE(read->anatomy()->bottom, made.anatomy()->bottom);
        QCOMPARE(read->anatomy()->layers, made.anatomy()->layers);
        QCOMPARE(read->anatomy()->areaMm2, made.anatomy()->areaMm2);
        QCOMPARE(QByteArray::fromStdString(read->toBytes()), QByteArray::fromStdString(made.toBytes()));
    }

    void oddEventsComeBackEqual()
    {
        const Recording made =
            recordingOf({{ServoEvent::Kind::Tick, 65535, {std::nanf("7"), -0.0F, 1.0e-42F}, 0},
                         {ServoEvent::Kind::Tick, 0, {INFINITY, -INFINITY, 3.4e38F}, 0},
                         {ServoEvent::Kind::NoDevice, 1, {1.0F, 2.0F, 3.0F}, 0},
                         {ServoEvent::Kind::Drill, 0, {}, 1},
                         {ServoEvent::Kind::Bur, 0, {}, 3},
                         {ServoEvent::Kind::Restore, 0, {}, 2},
                         {ServoEvent::Kind::Aids, 0, {}, core::servo::kSectionAid | core::servo::kIdealAid},
                         {ServoEvent::Kind::Note, 0, {}, 0xFEDCBA9876543210},
                         {ServoEvent::Kind::Resume, 0, {}, 0}});
        const auto read = Recording::fromBytes(made.toBytes());
        QVERIFY(support::succeeds(read));
        QVERIFY(sameBits(made, *read));
        // Such positions must not disturb a replay either.
        const auto outcome = recording::replay(*read);
        QVERIFY(outcome);
        QCOMPARE(outcome->stateHash, terrain::stateHash(terrain::Tooth(made.anatomy())));
    }

    void longAttemptComesBackEqual()
    {
        // More events than two packed chunks, and a rest.
        Recording made({}, support::smallBlock());
        support::RestlessHand hand(5);
        for (int n = 0; n < 10000; ++n) {
            made.append({ServoEvent::Kind::Tick, 1000, hand.next(), 0});
            if (n % 700 == 0)
                made.append({ServoEvent::Kind::Bur, 0, {}, static_cast<std::uint64_t>(n / 700 % 4)});
        }
        const auto read = Recording::fromBytes(made.toBytes());
        QVERIFY(read);
        QCOMPARE(read->ticks(), 10000U);
        QVERIFY(sameBits(made, *read));
    }

    void lessonComesBackEqual_data()
    {
        QTest::addColumn<QByteArray>("lesson");
        QTest::newRow("none") << QByteArray();
        QTest::newRow("a letter") << QByteArray("x");
        QTest::newRow("with a nought in it") << QByteArray("a\0b", 3);
        QTest::newRow("all lengths of code point")
            << QByteArray("z\xC3\xA9\xE2\x82\xAC\xF4\x8F\xBF\xBF\xED\x9F\xBF\xF0\x90\x80\x80");
        QTest::newRow("as long as may be") << QByteArray(int(recording::kMaxLessonBytes), 'l');
    }

    void lessonComesBackEqual()
    {
        QFETCH(QByteArray, lesson);
        Recording made({}, support::smallBlock(), lesson.toStdString());
        made.append({ServoEvent::Kind::Tick, 1000, {1.0F, 2.0F, 3.0F}, 0});
        const auto read = Recording::fromBytes(made.toBytes());
        QVERIFY(support::succeeds(read));
        QCOMPARE(QByteArray::fromStdString(read->lesson()), lesson);
        QCOMPARE(QByteArray::fromStdString(read->toBytes()), QByteArray::fromStdString(made.toBytes()));
    }

    void refusesImpossibleLessons_data()
    {
        QTest::addColumn<QByteArray>("lesson");
        QTest::newRow("too long") << QByteArray(int(recording::kMaxLessonBytes) + 1, 'l');
        QTest::newRow("empty, but there") << QByteArray();
        QTest::newRow("Latin 1") << QByteArray("caf\xE9");
        QTest::newRow("cut short") << QByteArray("\xE2\x82");
        QTest::newRow("a byte that begins nothing") << QByteArray("\x80");
        QTest::newRow("overlong") << QByteArray("\xC0\xAF");
        QTest::newRow("overlong in three") << QByteArray("\xE0\x9F\xBF");
        QTest::newRow("overlong in four") << QByteArray("\xF0\x8F\xBF\xBF");
        QTest::newRow("surrogate") << QByteArray("\xED\xA0\x80");
        QTest::newRow("beyond Unicode") << QByteArray("\xF4\x90\x80\x80");
        QTest::newRow("far beyond Unicode") << QByteArray("\xF5\x80\x80\x80");
    }

    void refusesImpossibleLessons()
    {
        QFETCH(QByteArray, lesson);
        if (!lesson.isEmpty())
            QVERIFY(!recording::checkLesson(lesson.toStdString()));
        const std::string good = Recording({}, support::smallBlock(), "good").toBytes();
        QVERIFY(support::isRefused(Recording::fromBytes(withSection(good, 5, zstd(lesson.toStdString()))),
                                   "damaged in its lesson"));
    }

    void cutAnywhereIsAnError()
    {
        const std::string whole = shortAttempt().toBytes();
        for (std::size_t length = 0; length < whole.size(); ++length) {
            const auto read = Recording::fromBytes(std::string_view(whole).substr(0, length));
            QVERIFY2(!read, qPrintable(QString("cut to %1 of %2 bytes").arg(length).arg(whole.size())));
            QCOMPARE(read.error().code, length == 0  ? ErrorCode::FileEmpty
                                        : length < 8 ? ErrorCode::WrongKind
                                                     : ErrorCode::FileTruncated);
        }
        QVERIFY(!Recording::fromBytes(whole + '\0'));
    }

    void flippedByteIsAnErrorOrHarmless()
    {
        std::string bytes = shortAttempt().toBytes();
        const std::uint64_t whole = recording::replay(Recording::fromBytes(bytes).value())->stateHash;
        int accepted = 0;
        constexpr std::size_t kVersionAt = 8;
        for (std::size_t at = 0; at < bytes.size(); ++at) {
            for (const char flip : {char(1), char(-128), char(-1)}) {
                // A supported newer version reads the same, because its additions are optional.
                if (at == kVersionAt && (bytes[at] ^ flip) <= int(recording::kFormatVersion) &&
                    (bytes[at] ^ flip) > bytes[at])
                    continue;
                bytes[at] = static_cast<char>(bytes[at] ^ flip);
                if (const auto read = Recording::fromBytes(bytes)) {
                    ++accepted;
                    QCOMPARE(recording::replay(*read)->stateHash, whole);
                }
                bytes[at] = static_cast<char>(bytes[at] ^ flip);
            }
        }
        QCOMPARE(accepted, 0);  // every byte is protected by a checksum or has a meaning
    }

    void refusesStrangers_data()
    {
        support::columns<QByteArray, ErrorCode>("bytes", "code");
        const QByteArray good = QByteArray::fromStdString(shortAttempt().toBytes());
        const QByteArray header = good.left(int(kFileHeaderBytes));
        const auto ofVersion = [&](int version) {
            QByteArray bytes = good;
            bytes[8] = static_cast<char>(version);
            return bytes;
        };
        const auto begunWith = [&](std::uint32_t kind, std::string_view payload) {
            return header + QByteArray::fromStdString(section(kind, payload));
        };
        QByteArray lie = good;
        lie.replace(int(kFileHeaderBytes) + 4, 8, QByteArray(8, '\xFF'));
        QTest::newRow("empty") << QByteArray() << ErrorCode::FileEmpty;
        QTest::newRow("text") << QByteArray("t_s,x_mm,y_mm,z_mm,drill\n") << ErrorCode::WrongKind;
        QTest::newRow("a picture") << QByteArray("\x89PNG\r\n\x1A\n\0\0\0\rIHDR", 16) << ErrorCode::WrongKind;
        QTest::newRow("magic alone") << good.left(8) << ErrorCode::FileTruncated;
        QTest::newRow("no section") << header << ErrorCode::FileTruncated;
        QTest::newRow("a newer version") << ofVersion(recording::kFormatVersion + 1) << ErrorCode::NewerVersion;
        QTest::newRow("version 0") << ofVersion(0) << ErrorCode::WrongKind;
        QTest::newRow("an older version") << ofVersion(recording::kOldestVersion - 1) << ErrorCode::WrongKind;
        QTest::newRow("a section of 2^64 bytes") << lie << ErrorCode::FileTruncated;
        QTest::newRow("end first") << begunWith(4, std::string(25, '\0')) << ErrorCode::BadStructure;
        QTest::newRow("events first") << begunWith(3, zstd(std::string(4, '\0'))) << ErrorCode::BadStructure;
        QTest::newRow("unknown section") << begunWith(77, "hello") << ErrorCode::BadStructure;
        QTest::newRow("twice") << good + good << ErrorCode::BadStructure;
    }

    void refusesStrangers()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(ErrorCode, code);
        const auto read = Recording::fromBytes({bytes.constData(), static_cast<std::size_t>(bytes.size())});
        QVERIFY(support::isRefused(read, code));
        QVERIFY(read.error().detail.ends_with('.'));
    }

    void refusesBombs_data()
    {
        support::columns<int, QByteArray>("kind", "payload");
        // 256 MiB of zeros pack into some ten kilobytes. A header may also state a false size.
        const QByteArray bomb = QByteArray::fromStdString(zstd(std::string(std::size_t{256} * 1024 * 1024, '\0')));
        QByteArray lie = QByteArray::fromStdString(zstd(std::string(100, '\0')));
        // Frame header: descriptor with an 8-byte size, 2^62 bytes.
        const QByteArray huge =
            QByteArray("\x28\xB5\x2F\xFD\xE0", 5) + QByteArray(7, '\0') + QByteArray("\x40", 1) + lie;
        for (const int kind : {1, 2, 3, 5}) {
            QTest::addRow("section %d unpacks to 256 MiB", kind) << kind << bomb;
            QTest::addRow("section %d says 2^62 bytes", kind) << kind << huge;
            QTest::addRow("section %d is not packed", kind) << kind << QByteArray(1000, 'x');
            QTest::addRow("section %d is empty", kind) << kind << QByteArray();
        }
    }

    void refusesBombs()
    {
        QFETCH(int, kind);
        QFETCH(QByteArray, payload);
        const std::string bytes =
            withSection(shortAttempt().toBytes(), static_cast<std::uint32_t>(kind), payload.toStdString());
        QVERIFY(support::isRefused(Recording::fromBytes(bytes), ErrorCode::BadStructure));
    }

    /// An older program still reads recordings without the new features. A recording with them is reported as newer,
    /// not as damaged.
    void onlyAChangedFeelNeedsTheNewVersion()
    {
        Recording made = attemptAsBefore();
        const std::string plain = made.toBytes();
        QCOMPARE(plain[8], static_cast<char>(recording::kOldestVersion));
        std::string called = plain;
        called[8] = static_cast<char>(recording::kFormatVersion);
        QVERIFY(Recording::fromBytes(called));
        ServoEvent number{ServoEvent::Kind::Number, 0, glm::vec3(0.0F), core::servo::packNumber({9, 1.5F})};
        made.append(number);
        const std::string changed = made.toBytes();
        QCOMPARE(changed[8], static_cast<char>(6));
        const auto read = Recording::fromBytes(changed);
        QVERIFY(support::succeeds(read));
        QVERIFY(read->isRetuned());
        QCOMPARE(allEvents(*read), allEvents(made));
        for (const std::uint64_t bad :
             {std::uint64_t{core::servo::kServoNumbers} << 32U, core::servo::packNumber({9, 1.0e9F}),
              core::servo::packNumber({0, -1.0F}), ~std::uint64_t{0}}) {
            Recording wrong = shortAttempt();
            number.value = bad;
            wrong.append(number);
            QVERIFY(support::isRefused(Recording::fromBytes(wrong.toBytes()), ErrorCode::BadStructure));
        }
    }

    /// A recording from before flat ends and full loads existed does not contain them, and replays without them.
    void onlyFlatEndsAndAFullLoadNeedTheirVersion()
    {
        const Recording before = attemptAsBefore();
        const auto old = Recording::fromBytes(before.toBytes());
        QVERIFY(support::succeeds(old));
        QVERIFY(old->settings() == before.settings());
        QCOMPARE(old->settings().hardness.flatEndShare, 1.0);
        QCOMPARE(old->settings().hardness.fullLoadN, settings::kNoFullLoadN);
        const Recording made = shortAttempt();
        QCOMPARE(made.toBytes()[8], static_cast<char>(8));
        const auto read = Recording::fromBytes(made.toBytes());
        QVERIFY(support::succeeds(read));
        QVERIFY(read->settings() == made.settings());
        // A parameter that older programs do not know.
        Recording retuned = attemptAsBefore();
        retuned.append({ServoEvent::Kind::Number, 0, glm::vec3(0.0F),
                        core::servo::packNumber({static_cast<std::uint8_t>(core::servo::kServoNumbers - 1), 1.5F})});
        QCOMPARE(retuned.toBytes()[8], static_cast<char>(8));
    }

    void onlyAPedalNeedsTheVersionWithSpeeds()
    {
        Recording made = attemptAsBefore();
        made.append({ServoEvent::Kind::Speed, 0, glm::vec3(0.0F), 37});
        const std::string bytes = made.toBytes();
        QCOMPARE(bytes[8], static_cast<char>(7));
        const auto read = Recording::fromBytes(bytes);
        QVERIFY(support::succeeds(read));
        QVERIFY(!read->isRetuned());
        QCOMPARE(allEvents(*read), allEvents(made));
        QCOMPARE(read->toBytes(), bytes);
    }

    void eventsAreChecked_data()
    {
        support::columns<std::vector<ServoEvent>, bool>("events", "isAllowed");
        const ServoEvent tick{ServoEvent::Kind::Tick, 1000, {0.0F, 0.0F, 5.0F}, 0};
        const auto row = [](const char* name, std::vector<ServoEvent> events, ServoEvent::Kind kind,
                            std::uint64_t value, bool isAllowed) {
            events.push_back({kind, 0, {}, value});
            QTest::newRow(name) << events << isAllowed;
        };
        row("the last bur", {}, ServoEvent::Kind::Bur, bur::burs().size() - 1, true);
        row("no bur's number", {}, ServoEvent::Kind::Bur, bur::kMostBurs, false);
        row("the only handpiece", {}, ServoEvent::Kind::Handpiece, 0, true);
        row("no such handpiece", {}, ServoEvent::Kind::Handpiece, 1, false);
        row("no such aid", {}, ServoEvent::Kind::Aids, core::servo::kAllAids + 1U, false);
        row("slowest", {}, ServoEvent::Kind::Speed, 1, true);
        row("full speed", {}, ServoEvent::Kind::Speed, 100, true);
        row("no speed", {}, ServoEvent::Kind::Speed, 0, false);
        row("faster than full speed", {}, ServoEvent::Kind::Speed, 101, false);
        row("undo to this tick", {tick, tick}, ServoEvent::Kind::Restore, 2, true);
        row("undo into the future", {tick, tick}, ServoEvent::Kind::Restore, 3, false);
    }

    void eventsAreChecked()
    {
        QFETCH(std::vector<ServoEvent>, events);
        QFETCH(bool, isAllowed);
        Recording made = recordingOf(events);
        made.append({ServoEvent::Kind::Tick, 1000, {0.0F, 0.0F, 5.0F}, 0});
        const auto read = Recording::fromBytes(made.toBytes());
        QVERIFY(isAllowed ? support::succeeds(read) : support::isRefused(read, ErrorCode::BadStructure));
    }

    /// A program with fewer burs must not report a valid recording as damaged.
    void aBurOfANewerProgramIsSaidToBeNewer()
    {
        Recording made = recordingOf({{ServoEvent::Kind::Bur, 0, {}, bur::burs().size()}});
        made.append({ServoEvent::Kind::Tick, 1000, {0.0F, 0.0F, 5.0F}, 0});
        const auto read = Recording::fromBytes(made.toBytes());
        QVERIFY(support::isRefused(read, ErrorCode::NewerVersion));
        QVERIFY(support::isRefused(read, "uses bur " + std::to_string(bur::burs().size() + 1)));
    }

    void refusesMoreUndoThanAnyoneMakes()
    {
        // A few kilobytes that would take hours to replay.
        Recording made = recordingOf({{ServoEvent::Kind::Tick, 1000, {0.0F, 0.0F, 5.0F}, 0}});
        const std::uint64_t many = 1'000'000'000 / made.anatomy()->grid.count();
        for (std::uint64_t n = 0; n < many; ++n)
            made.append({ServoEvent::Kind::Restore, 0, {}, 1});
        QVERIFY(Recording::fromBytes(made.toBytes()));
        made.append({ServoEvent::Kind::Restore, 0, {}, 1});
        const auto read = Recording::fromBytes(made.toBytes());
        QVERIFY(support::isRefused(read, ErrorCode::BadStructure));
        QVERIFY(support::isRefused(read, "undo steps"));
    }

    /// A few hundred kilobytes that unpack to days: they are refused before they are unpacked.
    void refusesMoreThanSixHours()
    {
        constexpr std::size_t kEvents = 3;  // number of the section
        const ServoEvent tick{ServoEvent::Kind::Tick, 1000, {0.0F, 0.0F, 5.0F}, 0};
        const std::string made = recordingOf(std::vector(recording::kChunkEvents, tick)).toBytes();
        const std::size_t end = made.size() - section(4, std::string(25, '\0')).size();
        const std::string chunk =
            section(kEvents, zstd(recording::eventBytes(std::vector(recording::kChunkEvents, tick))));
        std::string bytes = made.substr(0, end);
        for (std::uint64_t events = 0; events < 2 * recording::kMaxEvents; events += recording::kChunkEvents)
            bytes += chunk;
        QVERIFY(bytes.size() < 1024 * 1024);
        QVERIFY(support::isRefused(Recording::fromBytes(bytes + made.substr(end)), ErrorCode::FileTooLarge));
        QVERIFY(support::isRefused(Recording::fromBytes(bytes), "six hours"));
        QVERIFY(Recording::fromBytes(made));
    }

    void isFullAfterSixHours()
    {
        constexpr std::uint16_t kStepUs = 60'000;
        constexpr int kSteps = 6 * 60 * 60 * 1000 / 60;
        Recording made({}, support::smallBlock());
        for (int n = 0; n < kSteps; ++n) {
            QVERIFY(!made.isFull());
            made.append({ServoEvent::Kind::Tick, kStepUs, {0.0F, 0.0F, 5.0F}, 0});
        }
        QVERIFY(made.isFull());
        QVERIFY(Recording::fromBytes(made.toBytes())->isFull());
    }

    void refusesImpossibleTooth_data()
    {
        QTest::addColumn<Spoil>("spoil");
        const auto add = [](const char* name, const Spoil& spoil) { QTest::newRow(name) << spoil; };
        add("NaN height", [](auto& tooth) { tooth.top[100] = NAN; });
        add("infinite bottom", [](auto& tooth) { tooth.bottom[100] = -INFINITY; });
        add("NaN layer", [](auto& tooth) { tooth.layers[100].pulpRoof = NAN; });
        add("negative area", [](auto& tooth) { tooth.areaMm2[100] = -1.0F; });
        add("cell of no size", [](auto& tooth) { tooth.grid.cellMm = 0.0; });
        add("NaN cell", [](auto& tooth) { tooth.grid.cellMm = NAN; });
        add("origin far away", [](auto& tooth) { tooth.grid.originMm.x = 1.0e9; });
        add("grid too small", [](auto& tooth) { tooth.grid.side = 2; });
    }

    void refusesImpossibleTooth()
    {
        QFETCH(Spoil, spoil);
        auto tooth = std::make_shared<terrain::ToothAnatomy>(*support::smallBlock());
        spoil(*tooth);
        QVERIFY(support::isRefused(Recording::fromBytes(Recording({}, tooth).toBytes()), ErrorCode::BadStructure));
    }

    void refusesSettingsOutOfRange()
    {
        core::servo::ServoSettings strong;
        strong.force.clampN = 1.0e6;
        core::servo::ServoSettings magic;
        magic.method = "magic";
        core::servo::ServoSettings soft;
        soft.hardness.material[1].rateMm3PerNs = NAN;
        const auto read = [](const core::servo::ServoSettings& settings) {
            return Recording::fromBytes(Recording(settings, support::smallBlock()).toBytes());
        };
        QVERIFY(support::isRefused(read(strong), ErrorCode::OutOfRange));
        QVERIFY(support::isRefused(read(magic), ErrorCode::UnknownName));
        QVERIFY(!read(soft));
    }

    void wrongFilesAreExplained()
    {
        const QTemporaryDir folder;
        const auto read = [&](const QString& path) { return recording::readRecording(path.toStdString()); };
        QVERIFY(support::isRefused(read(folder.filePath("none.cusprec")), ErrorCode::FileMissing));
        QVERIFY(support::isRefused(read(folder.path()), ErrorCode::FileUnreadable));
        support::write(folder.filePath("empty.cusprec"), {});
        QVERIFY(support::isRefused(read(folder.filePath("empty.cusprec")), ErrorCode::FileEmpty));
        QVERIFY(support::isRefused(read(folder.filePath("empty.cusprec")), "empty.cusprec"));
    }

    /// The tests of writeWhole() cover the other failures.
    void failedWriteKeepsTheOlderFile()
    {
        const QTemporaryDir folder;
        const std::filesystem::path target = folder.filePath("attempt.cusprec").toStdString();
        const Recording older({}, support::smallBlock());
        QVERIFY(recording::writeRecording(target, older));
        const Recording newer = shortAttempt();
        {
            const support::FullDisk full(100);
            QVERIFY(support::isRefused(recording::writeRecording(target, newer), ErrorCode::FileUnwritable));
        }
        QCOMPARE(recording::readRecording(target)->ticks(), older.ticks());
        QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
                 QStringList{"attempt.cusprec"});
        QVERIFY(recording::writeRecording(target, newer));
        QCOMPARE(recording::readRecording(target)->ticks(), newer.ticks());
    }

    void minuteIsUnderAMegabyte()
    {
        // The motion of a typical device: slow strokes, tremor of some 10 um at 8 to 12 Hz, noise of a micrometre.
        Recording made({}, support::syntheticMolar());
        const std::size_t before = made.toBytes().size();
        Rng rng(1);
        for (int n = 0; n < 60000; ++n) {
            const double t = n * 0.001;
            const glm::dvec3 stroke(2.0 * std::sin(1.7 * t), 1.5 * std::sin(0.9 * t + 1.0),
                                    -1.0 + 0.6 * std::sin(2.3 * t));
            const glm::dvec3 tremor = 0.01 * glm::dvec3(std::sin(57.0 * t), std::cos(63.0 * t), std::sin(71.0 * t));
            const glm::dvec3 noise = 0.001 * glm::dvec3(rng.normal(), rng.normal(), rng.normal());
            made.append({ServoEvent::Kind::Tick, 1000, glm::vec3(stroke + tremor + noise), 0});
        }
        const std::size_t bytes = made.toBytes().size() - before;
        QVERIFY2(bytes < 1024 * 1024, qPrintable(QString::number(bytes)));
    }

    void corpusOfTheFuzzerIsHarmless() { QVERIFY(support::forEachSeed("recording", fuzz::exerciseRecording)); }
};

CUSP_TEST(TestRecording)
#include "tst_recording.moc"
