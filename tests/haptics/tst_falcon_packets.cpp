// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/base/Rng.h"
#include "haptics/falcon/Packets.h"
#include "tests/support/Allocations.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"

using namespace haptics::falcon;

namespace {

using Bytes = std::vector<std::uint8_t>;

/// Encodes a signed number as four letters, without the code under test.
std::string letters(int number)
{
    std::string four;
    for (int rest = number < 0 ? number + 65536 : number; four.size() < 4; rest /= 16)
        four += "ABCDEFGHIJKLMNOP"[rest % 16];
    return four;
}

/// Returns the bytes of an answer as the controller sends them.
Bytes answerBytes(const Answer& answer, int unknown = 0)
{
    std::string text = "<";
    for (const int count : answer.counts)
        text += letters(count);
    int status = answer.buttons;
    for (int leg = 0; leg < 3; ++leg)
        status += answer.homed[static_cast<std::size_t>(leg)] ? 16 << leg : 0;
    text += static_cast<char>('A' + status);
    text += static_cast<char>('A' + unknown);
    text += '>';
    return {text.begin(), text.end()};
}

std::string text(const Frame& frame)
{
    return {frame.begin(), frame.end()};
}

std::int16_t anyNumber(core::Rng& rng)
{
    return static_cast<std::int16_t>(rng.below(65536) - 32768);
}

Answer anyAnswer(core::Rng& rng)
{
    return {{anyNumber(rng), anyNumber(rng), anyNumber(rng)},
            static_cast<std::uint8_t>(rng.below(16)),
            {rng.below(2) == 1, rng.below(2) == 1, rng.below(2) == 1}};
}

void append(Bytes& stream, const Bytes& more)
{
    stream.insert(stream.end(), more.begin(), more.end());
}

/// Returns all answers of a stream that is read in pieces of at most this many bytes.
std::vector<Answer> answersIn(FrameReader& reader, const Bytes& stream, std::size_t readBytes)
{
    std::vector<Answer> answers;
    for (std::size_t at = 0; at < stream.size(); at += readBytes) {
        std::span<const std::uint8_t> bytes(stream.data() + at, std::min(readBytes, stream.size() - at));
        while (const auto answer = reader.next(bytes))
            answers.push_back(*answer);
    }
    return answers;
}

/// Returns whether the bytes begin with a valid answer.
bool isAnswer(const std::uint8_t* bytes)
{
    return bytes[0] == 0x3C && bytes[15] == 0x3E &&
           std::all_of(bytes + 1, bytes + 13, [](int byte) { return byte >= 0x41 && byte <= 0x50; }) &&
           bytes[13] >= 0x41 && bytes[13] <= 0xC0 && bytes[14] >= 0x41;
}

/// Returns a transfer of the FTDI chip: packets of 64 bytes, of which two are status.
/// @param firstBytes  data in the first packet
Bytes transferOf(const Bytes& data, std::size_t firstBytes = 62, std::uint8_t modem = 0x01, std::uint8_t line = 0x60)
{
    Bytes transfer;
    std::size_t at = 0;
    do {
        const std::size_t count = std::min(at == 0 ? firstBytes : 62, data.size() - at);
        transfer.push_back(modem);
        transfer.push_back(line);
        transfer.insert(transfer.end(), data.begin() + static_cast<std::ptrdiff_t>(at),
                        data.begin() + static_cast<std::ptrdiff_t>(at + count));
        at += count;
    } while (at < data.size() && transfer.size() % 64 == 0);
    return transfer;
}

}  // namespace

class TestFalconPackets : public QObject
{
    Q_OBJECT
private slots:
    void requestsAreThoseOfLibnifalcon_data()
    {
        support::columns<int, int, int, int, bool, QString>("first", "second", "third", "leds", "homing", "bytes");
        QTest::newRow("zero force, homing, red") << 0 << 0 << 0 << 8 << true << "<AAAAAAAAAAAAJA>";
        QTest::newRow("zero force") << 0 << 0 << 0 << 0 << false << "<AAAAAAAAAAAAAA>";
        QTest::newRow("1447 and back") << 1447 << -1447 << 0 << 2 << true << "<HKFAJFKPAAAADA>";
        QTest::newRow("limits") << 4095 << -4095 << -1 << 4 << false << "<PPPABAAPPPPPEA>";
        QTest::newRow("extremes") << 32767 << -32768 << 1 << 14 << true << "<PPPHAAAIBAAAPA>";
    }

    void requestsAreThoseOfLibnifalcon()
    {
        QFETCH(int, first);
        QFETCH(int, second);
        QFETCH(int, third);
        QFETCH(int, leds);
        QFETCH(bool, homing);
        QFETCH(QString, bytes);
        const Request request{
            {static_cast<std::int16_t>(first), static_cast<std::int16_t>(second), static_cast<std::int16_t>(third)},
            {.red = (leds & 8) != 0, .green = (leds & 2) != 0, .blue = (leds & 4) != 0},
            homing};
        QCOMPARE(QString::fromStdString(text(encode(request))), bytes);
    }

    void everyNumberComesBack()
    {
        FrameReader reader;
        for (int number = std::numeric_limits<std::int16_t>::min(); number <= std::numeric_limits<std::int16_t>::max();
             ++number) {
            const auto value = static_cast<std::int16_t>(number);
            const auto other = static_cast<std::int16_t>(~number);
            const Frame frame = encode({{value, other, value}, {}, false});
            QCOMPARE(text(frame).substr(1, 8), letters(value) + letters(other));
            std::span<const std::uint8_t> bytes(frame);
            const auto answer = reader.next(bytes);
            QVERIFY(answer.has_value());
            QVERIFY(answer->counts == (std::array<std::int16_t, 3>{value, other, value}));
        }
        QCOMPARE(reader.droppedBytes(), std::uint64_t{0});
    }

    void statusOfAnAnswerIsRead()
    {
        FrameReader reader;
        for (int status = 0; status < 128; ++status)
            for (const int unknown : {0, 15, 16, 127, 190}) {
                const Answer sent{{1, -2, 3},
                                  static_cast<std::uint8_t>(status & 15),
                                  {(status & 16) != 0, (status & 32) != 0, status >= 64}};
                const auto answers = answersIn(reader, answerBytes(sent, unknown), 16);
                QCOMPARE(answers.size(), std::size_t{1});
                QVERIFY(answers[0] == sent);
                QCOMPARE(answers[0].allHomed(), status >= 112);
                QCOMPARE(answers[0].isDown(Button::Centre), (status & 4) != 0);
            }
        QCOMPARE(reader.droppedBytes(), std::uint64_t{0});
    }

    /// The answers of a stream do not depend on how it is cut into reads.
    void readsMayBeOfAnyLength()
    {
        core::Rng rng(1);
        std::vector<Answer> sent;
        Bytes stream{'>', 'A', '<'};
        for (int n = 0; n < 30; ++n) {
            sent.push_back(anyAnswer(rng));
            append(stream, answerBytes(sent.back()));
        }
        for (std::size_t readBytes = 1; readBytes <= stream.size(); ++readBytes) {
            FrameReader reader;
            QVERIFY(answersIn(reader, stream, readBytes) == sent);
            QCOMPARE(reader.droppedBytes(), std::uint64_t{3});
            QCOMPARE(reader.incompleteBytes(), std::size_t{0});
        }
    }

    /// The stream ends in the middle of an answer. The rest comes later or never.
    void aCutAnswerWaitsOrIsDropped()
    {
        core::Rng rng(2);
        const Answer first = anyAnswer(rng);
        const Answer second = anyAnswer(rng);
        const Bytes bytes = answerBytes(first);
        for (std::size_t length = 0; length < bytes.size(); ++length) {
            const Bytes head(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
            const Bytes tail(bytes.begin() + static_cast<std::ptrdiff_t>(length), bytes.end());
            FrameReader reader;
            QVERIFY(answersIn(reader, head, 64).empty());
            QCOMPARE(reader.incompleteBytes(), length);
            QVERIFY(answersIn(reader, tail, 64) == std::vector<Answer>{first});

            QVERIFY(answersIn(reader, head, 64).empty());
            QVERIFY(answersIn(reader, answerBytes(second), 64) == std::vector<Answer>{second});
            QCOMPARE(reader.droppedBytes(), std::uint64_t{length});

            QVERIFY(answersIn(reader, head, 64).empty());
            reader.dropIncomplete();
            QVERIFY(length == 0 || answersIn(reader, tail, 64).empty());
            QCOMPARE(reader.droppedBytes(), std::uint64_t{length == 0 ? 0 : length + 16});
        }
    }

    /// A byte that is lost, added or doubled costs at most one answer, and no wrong answer is accepted.
    void lostAndExtraBytesCostTheirAnswer()
    {
        core::Rng rng(3);
        const std::vector<Answer> sent{anyAnswer(rng), anyAnswer(rng), anyAnswer(rng)};
        Bytes stream;
        for (const Answer& answer : sent)
            append(stream, answerBytes(answer));
        const std::vector<Answer> others{sent[0], sent[2]};
        for (std::ptrdiff_t at = 16; at < 32; ++at) {
            Bytes lost = stream;
            lost.erase(lost.begin() + at);
            FrameReader reader;
            QVERIFY(answersIn(reader, lost, 7) == others);
            QCOMPARE(reader.droppedBytes(), std::uint64_t{15});
            for (int value = 0; value < 256; ++value) {
                Bytes more = stream;
                more.insert(more.begin() + at, static_cast<std::uint8_t>(value));
                FrameReader second;
                // Any byte before an answer leaves the answer intact, and so do a doubled '<' and a doubled '>'.
                const bool whole = at == 16 || (at == 17 && value == '<') || (at == 31 && value == '>');
                const auto found = answersIn(second, more, 7);
                QVERIFY2(found == (whole ? sent : others), qPrintable(QString("%1 at %2").arg(value).arg(at)));
                QCOMPARE(second.droppedBytes(), std::uint64_t{whole ? 1U : 17U});
            }
        }
    }

    /// A changed byte loses its answer, or changes only the value that it encodes.
    void changedBytesCostTheirAnswer()
    {
        core::Rng rng(4);
        const std::vector<Answer> sent{anyAnswer(rng), anyAnswer(rng), anyAnswer(rng)};
        Bytes stream;
        for (const Answer& answer : sent)
            append(stream, answerBytes(answer));
        for (std::size_t at = 16; at < 32; ++at)
            for (int value = 0; value < 256; ++value) {
                Bytes changed = stream;
                changed[at] = static_cast<std::uint8_t>(value);
                FrameReader reader;
                const auto found = answersIn(reader, changed, 64);
                const bool framed = isAnswer(changed.data() + 16);
                QCOMPARE(found.size(), framed ? std::size_t{3} : std::size_t{2});
                QVERIFY(found.front() == sent[0] && found.back() == sent[2]);
                QCOMPARE(reader.droppedBytes(), std::uint64_t{framed ? 0U : 16U});
            }
    }

    /// libnifalcon mistook the end of an answer of 14 bytes for homed bits and buttons.
    void aShortAnswerIsNotAccepted()
    {
        FrameReader reader;
        const Bytes whole = answerBytes({{5, 6, 7}, 0, {}});
        Bytes stream(whole.begin(), whole.begin() + 13);
        stream.push_back('>');
        append(stream, whole);
        QCOMPARE(answersIn(reader, stream, 64).size(), std::size_t{1});
        QCOMPARE(reader.droppedBytes(), std::uint64_t{14});
    }

    void aDoubledAnswerIsTwoAnswers()
    {
        const Answer answer{{5, 6, 7}, 2, {true, true, true}};
        Bytes stream = answerBytes(answer);
        append(stream, answerBytes(answer));
        FrameReader reader;
        const auto received = reader.read(transferOf(stream));
        QCOMPARE(received.answers, 2);
        QVERIFY(received.newest == answer);
        QVERIFY(!received.errors.any());
    }

    void randomBytes_data()
    {
        support::columns<int>("kind");
        QTest::newRow("any byte") << 0;
        QTest::newRow("bytes of answers") << 1;
        QTest::newRow("damaged answers") << 2;
    }

    /// The reader accepts exactly the valid answers and counts the other bytes.
    void randomBytes()
    {
        QFETCH(int, kind);
        constexpr std::size_t kCount = 1'000'000;
        core::Rng rng(static_cast<std::uint64_t>(kind) + 10);
        Bytes stream;
        stream.reserve(kCount + 32);
        while (stream.size() < kCount) {
            if (kind == 0) {
                stream.push_back(static_cast<std::uint8_t>(rng.below(256)));
            } else if (kind == 1) {
                const bool isLetter = rng.below(16) > 1;
                stream.push_back(static_cast<std::uint8_t>(isLetter ? 'A' + rng.below(16) : "<>"[rng.below(2)]));
            } else {
                Bytes bytes = answerBytes(anyAnswer(rng), rng.below(128));
                if (rng.below(3) == 0)
                    bytes[static_cast<std::size_t>(rng.below(16))] = static_cast<std::uint8_t>(rng.below(256));
                if (rng.below(8) == 0)
                    bytes.erase(bytes.begin() + rng.below(16));
                if (rng.below(8) == 0)
                    bytes.insert(bytes.begin() + rng.below(15), static_cast<std::uint8_t>("<>AP"[rng.below(4)]));
                append(stream, bytes);
            }
        }
        std::vector<std::size_t> expected;  // ends of answers
        for (std::size_t end = kFrameBytes; end <= stream.size(); ++end)
            if (isAnswer(stream.data() + end - kFrameBytes))
                expected.push_back(end);
        std::vector<std::size_t> found;
        found.reserve(stream.size() / kFrameBytes);
        FrameReader reader;
        const long before = support::allocationsOnThisThread();
        for (std::size_t at = 0; at < stream.size();) {
            const std::size_t count = std::min(static_cast<std::size_t>(1 + rng.below(40)), stream.size() - at);
            std::span<const std::uint8_t> bytes(stream.data() + at, count);
            at += count;
            while (reader.next(bytes))
                found.push_back(at - bytes.size());
        }
        QCOMPARE(support::allocationsOnThisThread() - before, 0L);
        QVERIFY(found == expected);
        QVERIFY(kind != 2 || found.size() > 20'000);
        QCOMPARE(reader.droppedBytes() + reader.incompleteBytes() + kFrameBytes * found.size(),
                 std::uint64_t{stream.size()});
    }

    /// Packets end at every position of an answer, with status bytes that could be part of one.
    void statusBytesAreRemovedAtEveryBoundary()
    {
        core::Rng rng(5);
        std::vector<Answer> sent;
        Bytes data;
        for (int n = 0; n < 12; ++n) {
            sent.push_back(anyAnswer(rng));
            append(data, answerBytes(sent.back()));
        }
        for (const int modem : {0x01, 0x31, 0x3C, 0x41})
            for (const int line : {0x60, 0x61, 0x41, 0x00})
                for (std::size_t firstBytes = 0; firstBytes <= 62; ++firstBytes) {
                    FrameReader reader;
                    std::vector<Answer> answers;
                    Bytes left = data;
                    for (std::size_t first = firstBytes; !left.empty(); first = 62) {
                        const Bytes transfer =
                            transferOf(left, first, static_cast<std::uint8_t>(modem), static_cast<std::uint8_t>(line));
                        std::span<const std::uint8_t> rest(transfer);
                        while (const auto packet = takePacket(rest)) {
                            QVERIFY(!packet->errors.any());
                            auto bytes = packet->data;
                            left.erase(left.begin(), left.begin() + static_cast<std::ptrdiff_t>(bytes.size()));
                            while (const auto answer = reader.next(bytes))
                                answers.push_back(*answer);
                        }
                    }
                    QVERIFY(answers == sent);
                    QCOMPARE(reader.droppedBytes(), std::uint64_t{0});
                }
    }

    void packetsWithoutDataAreEmpty()
    {
        const Bytes idle{0x01, 0x60};
        for (std::size_t length = 0; length <= 2; ++length) {
            std::span<const std::uint8_t> rest(idle.data(), length);
            const auto packet = takePacket(rest);
            QCOMPARE(packet.has_value(), length > 0);
            QVERIFY(!packet || (packet->data.empty() && !packet->errors.any()));
            QVERIFY(!takePacket(rest).has_value());
        }
        FrameReader reader;
        const Bytes bytes = answerBytes({{5, 6, 7}, 0, {}});
        QCOMPARE(reader.read(transferOf(Bytes(bytes.begin(), bytes.begin() + 5))).answers, 0);
        for (int n = 0; n < 100; ++n)
            QCOMPARE(reader.read(idle).answers, 0);
        QCOMPARE(reader.read(transferOf(Bytes(bytes.begin() + 5, bytes.end()))).answers, 1);
    }

    void wholePacketsAreTakenOneByOne()
    {
        Bytes transfer(512, 0x42);
        std::span<const std::uint8_t> rest(transfer);
        for (int n = 0; n < 8; ++n) {
            const auto packet = takePacket(rest);
            QVERIFY(packet.has_value());
            QCOMPARE(packet->data.size(), std::size_t{62});
            QVERIFY(packet->data.data() == transfer.data() + 64 * n + 2);
        }
        QVERIFY(rest.empty());
    }

    void lineErrorsAreReported_data()
    {
        support::columns<int, bool, bool, bool, bool>("line", "overrun", "parity", "framing", "lineBreak");
        QTest::newRow("none") << 0xE1 << false << false << false << false;
        QTest::newRow("overrun") << 0x62 << true << false << false << false;
        QTest::newRow("parity") << 0x64 << false << true << false << false;
        QTest::newRow("framing") << 0x68 << false << false << true << false;
        QTest::newRow("break") << 0x70 << false << false << false << true;
        QTest::newRow("all") << 0xFF << true << true << true << true;
    }

    void lineErrorsAreReported()
    {
        QFETCH(int, line);
        QFETCH(bool, overrun);
        QFETCH(bool, parity);
        QFETCH(bool, framing);
        QFETCH(bool, lineBreak);
        const LineErrors errors{overrun, parity, framing, lineBreak};
        const auto status = static_cast<std::uint8_t>(line);
        const Bytes bytes = answerBytes({{5, 6, 7}, 0, {}});
        const Bytes transfer = transferOf(bytes, 62, 0x01, status);
        std::span<const std::uint8_t> rest(transfer);
        const auto packet = takePacket(rest);
        QVERIFY(packet.has_value());
        QVERIFY(packet->errors == errors);
        QCOMPARE(packet->data.size(), bytes.size());

        FrameReader reader;
        const auto received = reader.read(transfer);
        QVERIFY(received.errors == errors);
        QCOMPARE(received.answers, errors.any() ? 0 : 1);
        QVERIFY(!reader.read(Bytes{0x01, status}).errors.any());  // without data: reports an old error
    }

    /// Data received with an error may lack bytes. It completes no answer, and the next answer is read.
    void dataWithALineErrorIsDropped()
    {
        const Answer answer{{-5, 6, 7}, 1, {true, false, true}};
        const Bytes bytes = answerBytes(answer);
        for (std::ptrdiff_t cut = 1; cut < 16; ++cut) {
            FrameReader reader;
            const Bytes head(bytes.begin(), bytes.begin() + cut);
            const Bytes tail(bytes.begin() + cut, bytes.end());
            QCOMPARE(reader.read(transferOf(head)).answers, 0);
            QCOMPARE(reader.read(transferOf(tail, 62, 0x01, 0x62)).answers, 0);
            QCOMPARE(reader.droppedBytes(), std::uint64_t{16});
            const auto received = reader.read(transferOf(bytes));
            QCOMPARE(received.answers, 1);
            QVERIFY(received.newest == answer);
        }
    }
};

CUSP_TEST(TestFalconPackets)
#include "tst_falcon_packets.moc"
