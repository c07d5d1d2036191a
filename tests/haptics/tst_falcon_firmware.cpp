// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCryptographicHash>
#include <QTest>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/Rng.h"
#include "haptics/falcon/FirmwareImage.h"
#include "tests/support/Checks.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"

using core::ErrorCode;
using haptics::falcon::FirmwareImage;

namespace {

/// Builds a boot stream, because the vendor's firmware may not be part of the repository.
class BootStream
{
public:
    explicit BootStream(std::uint32_t entryPoint = 0x003F8002)
    {
        word(0x08AA);
        for (int n = 0; n < 8; ++n)
            word(0);
        address(entryPoint);
    }
    BootStream& block(std::uint32_t destination, int words, std::uint64_t seed = 1)
    {
        core::Rng rng(seed);
        word(static_cast<std::uint32_t>(words));
        address(destination);
        for (int n = 0; n < words; ++n)
            word(static_cast<std::uint32_t>(rng.below(65536)));
        return *this;
    }
    std::vector<std::uint8_t> ended()
    {
        word(0);
        return m_bytes;
    }

private:
    void word(std::uint32_t value)
    {
        m_bytes.push_back(static_cast<std::uint8_t>(value & 0xFFU));
        m_bytes.push_back(static_cast<std::uint8_t>(value >> 8U));
    }
    void address(std::uint32_t value)
    {
        word(value >> 16U);
        word(value & 0xFFFFU);
    }

    std::vector<std::uint8_t> m_bytes;
};

std::vector<std::uint8_t> soundStream()
{
    return BootStream().block(0x003F8000, 40).block(0x00008000, 1, 2).block(0x003F9000, 300, 3).ended();
}

std::string qtSha256(const std::vector<std::uint8_t>& bytes)
{
    const QByteArray all(reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size()));
    return QCryptographicHash::hash(all, QCryptographicHash::Sha256).toHex().toStdString();
}

}  // namespace

class TestFalconFirmware : public QObject
{
    Q_OBJECT
private slots:
    void aSoundImageIsDescribed()
    {
        const auto bytes = soundStream();
        const auto image = FirmwareImage::check(bytes);
        QVERIFY(support::succeeds(image));
        QCOMPARE(image->entryPoint(), 0x003F8002U);
        QCOMPARE(image->blockCount(), 3);
        QVERIFY(std::equal(bytes.begin(), bytes.end(), image->bytes().begin(), image->bytes().end()));
        QCOMPARE(image->sha256(), qtSha256(bytes));
        QVERIFY(image->name().empty());
    }

    void limitsAreAccepted()
    {
        const auto smallest = FirmwareImage::check(BootStream(0x3FFFFF).block(0, 1).ended());
        QVERIFY(support::succeeds(smallest));
        QCOMPARE(smallest->bytes().size(), std::size_t{32});
        QCOMPARE(smallest->entryPoint(), 0x3FFFFFU);
        constexpr int kWords = (FirmwareImage::kLargestBytes - 22 - 6 - 2) / 2;
        QVERIFY(support::succeeds(FirmwareImage::check(BootStream().block(0x8000, kWords).ended())));
        QVERIFY(support::isRefused(FirmwareImage::check(BootStream().block(0x8000, kWords + 1).ended()),
                                   ErrorCode::FileTooLarge));
    }

    /// Every truncation is refused, with the reason that the header or a block is incomplete.
    void everyCutIsRefused()
    {
        const auto bytes = soundStream();
        QVERIFY(support::isRefused(FirmwareImage::check({}), ErrorCode::FileEmpty));
        for (std::size_t length = 1; length < bytes.size(); ++length) {
            const auto cut = FirmwareImage::check({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length)});
            QVERIFY2(support::isRefused(cut, ErrorCode::FileTruncated), qPrintable(QString::number(length)));
            const std::string block = length < 22 + 86            ? "block 1 "
                                      : length < 22 + 86 + 8      ? "block 2 "
                                      : length < bytes.size() - 2 ? "block 3 "
                                                                  : "block 4 ";
            QVERIFY2(support::isRefused(cut, length < 22 ? "header" : std::string_view(block)),
                     qPrintable(QString::number(length)));
            QVERIFY(!cut.error().words.english.empty());
        }
    }

    void bytesAfterTheEndAreRefused()
    {
        const auto bytes = soundStream();
        for (const std::size_t more : {std::size_t{1}, std::size_t{2}, std::size_t{62}, std::size_t{1000}}) {
            auto longer = bytes;
            longer.resize(bytes.size() + more, 0);
            const auto image = FirmwareImage::check(longer);
            QVERIFY(support::isRefused(image, ErrorCode::BadStructure));
            QVERIFY(support::isRefused(image, "after " + std::to_string(bytes.size()) + " bytes"));
        }
        auto twice = bytes;
        twice.insert(twice.end(), bytes.begin(), bytes.end());
        QVERIFY(support::isRefused(FirmwareImage::check(twice), ErrorCode::BadStructure));
    }

    /// No other value of the key, the reserved words or the entry point is accepted as firmware.
    void otherHeadersAreRefused()
    {
        for (std::size_t at = 0; at < 18; ++at)
            for (int bit = 0; bit < 8; ++bit) {
                auto bytes = soundStream();
                bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ (1U << static_cast<unsigned>(bit)));
                QVERIFY(support::isRefused(FirmwareImage::check(bytes), ErrorCode::WrongKind));
            }
        QVERIFY(
            support::isRefused(FirmwareImage::check(BootStream(0x400000).block(0, 1).ended()), ErrorCode::WrongKind));
        QVERIFY(support::isRefused(FirmwareImage::check(BootStream().ended()), ErrorCode::WrongKind));
    }

    void otherFilesAreRefused()
    {
        for (const std::string text : {"x", "\xAA", "\xAA\x10", "Hello, this is a letter.\n", "\177ELF\x02\x01\x01",
                                       "%PDF-1.7 and so on and so on and so on"}) {
            const auto image = FirmwareImage::check({text.begin(), text.end()});
            QVERIFY(support::isRefused(image, text == "\xAA" ? ErrorCode::FileTruncated : ErrorCode::WrongKind));
        }
        QVERIFY(support::isRefused(FirmwareImage::check(std::vector<std::uint8_t>(9000, 0)), ErrorCode::WrongKind));
        QVERIFY(support::isRefused(FirmwareImage::check(std::vector<std::uint8_t>(9000, 0xFF)), ErrorCode::WrongKind));
        QVERIFY(support::isRefused(FirmwareImage::check(std::vector<std::uint8_t>(FirmwareImage::kLargestBytes + 1)),
                                   ErrorCode::FileTooLarge));
    }

    /// Damage after the header never causes a crash. An image that is accepted nevertheless ends with its file.
    void damagedImagesDoNoHarm()
    {
        core::Rng rng(7);
        for (int n = 0; n < 5000; ++n) {
            auto bytes = soundStream();
            for (int change = rng.below(4); change >= 0; --change)
                bytes[static_cast<std::size_t>(rng.below(static_cast<int>(bytes.size())))] =
                    static_cast<std::uint8_t>(rng.below(256));
            const auto image = FirmwareImage::check(bytes);
            QVERIFY(!image || (image->bytes().size() == bytes.size() && image->blockCount() > 0 &&
                               image->sha256() == qtSha256(bytes)));
        }
    }

    void knownFilesHaveNames_data()
    {
        support::columns<QString, QString>("sha256", "file");
        QTest::newRow("nVent") << "1119e39c39fab1f37678ea62dfc715b23dd86ee7f13d78f88f707d9f09b896a1"
                               << "nvent_firmware.bin";
        QTest::newRow("test") << "b2700d5cd5ca217e48565fb4de5a502a636c53f6e01ebd0cad193e9f84856c6a"
                              << "test_firmware.bin";
        QTest::newRow("T0") << "ae838730af34b5822c9c3949859b446614af0410730b832cc17a6ad627ea64a4"
                            << "novint_T0.bin";
        QTest::newRow("T2") << "e0ae3598670fa1c8d9277bd6943c99b3152b97c400c46c1c42c60de77ff4e816"
                            << "novint_T2.bin";
        QTest::newRow("another") << QString(64, '0') << "";
    }

    void knownFilesHaveNames()
    {
        QFETCH(QString, sha256);
        QFETCH(QString, file);
        const std::string_view name = haptics::falcon::knownFirmware(sha256.toStdString());
        QCOMPARE(name.empty(), file.isEmpty());
        QVERIFY(name.find(file.toStdString()) != std::string_view::npos);
    }
};

CUSP_TEST(TestFalconFirmware)
#include "tst_falcon_firmware.moc"
