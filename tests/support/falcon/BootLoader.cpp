// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/falcon/BootLoader.h"

#include "tests/support/falcon/FtdiChip.h"

namespace support::falcon {
namespace {

constexpr double kQueryBaud = 9600.0;
constexpr unsigned kQuery = 0x0A430D;
constexpr std::array<std::uint8_t, 4> kQueryAnswer{0x0A, 0x44, 0x2C, 0x0D};

// The loader measures the baud rate. Those around the nominal 140000 have been used with devices.
constexpr double kLeastLoadBaud = 130000.0;
constexpr double kMostLoadBaud = 150000.0;
constexpr std::uint8_t kAutobaud = 'A';
constexpr std::uint8_t kXoff = 0x13;
constexpr std::uint8_t kWrongBit = 0x10;

constexpr unsigned kKey = 0x08AA;
constexpr long kHeaderWords = 11;  ///< key, eight reserved words, entry point
constexpr long kDestinationWords = 2;
constexpr std::size_t kMostImageBytes = 256 * 1024;

}  // namespace

BootLoader::BootLoader()
{
    m_image.reserve(kMostImageBytes);
}

void BootLoader::setOptions(const BootOptions& options)
{
    m_options = options;
    m_queries = 0;
}

void BootLoader::reset()
{
    m_stage = Stage::Query;
    m_last = 0;
}

void BootLoader::setDtr(bool high)
{
    m_dtr = high;
    if (m_stage == Stage::Answered && !high)
        m_stage = Stage::Autobaud;
}

Reply BootLoader::receive(std::uint8_t byte, double baud)
{
    m_tookQuery = m_tookAutobaud = m_tookImageByte = false;
    Reply reply;
    reply.baud = baud;
    switch (m_stage) {
    case Stage::Query:
    case Stage::Answered:
        if (m_dtr && isSameBaud(baud, kQueryBaud))
            takeQueryByte(byte, reply);
        break;
    case Stage::Autobaud:
        if (byte != kAutobaud || baud < kLeastLoadBaud || baud > kMostLoadBaud) {
            m_stage = Stage::Silent;
            break;
        }
        m_tookAutobaud = true;
        m_baud = baud;
        m_stage = Stage::Image;
        m_image.clear();
        m_headerWords = 0;
        m_blockWords = 0;
        if (m_options.strayByte)
            reply.add(kXoff);
        reply.add(kAutobaud);
        break;
    case Stage::Image:
        if (!isSameBaud(baud, m_baud) || m_image.size() == kMostImageBytes) {
            m_stage = Stage::Silent;
            break;
        }
        m_tookImageByte = true;
        if (m_options.wrongEchoAt == static_cast<long>(m_image.size())) {
            m_options.wrongEchoAt = -1;
            reply.add(byte ^ kWrongBit);
        } else {
            reply.add(byte);
        }
        m_image.push_back(byte);
        if (m_image.size() % 2 == 0)
            takeWord(m_image[m_image.size() - 2] | static_cast<unsigned>(byte) << 8U);
        break;
    case Stage::Finished:
    case Stage::Silent:
        break;
    }
    return reply;
}

void BootLoader::takeQueryByte(std::uint8_t byte, Reply& reply)
{
    m_last = (m_last << 8U | byte) & 0xFFFFFFU;
    if (m_last != kQuery)
        return;
    m_tookQuery = true;
    if (++m_queries < m_options.answersAtTry)
        return;
    if (m_options.leadingZero)
        reply.add(0);
    for (const std::uint8_t answer : kQueryAnswer)
        reply.add(answer);
    m_stage = Stage::Answered;
}

void BootLoader::takeWord(unsigned word)
{
    if (m_headerWords < kHeaderWords) {
        if (m_headerWords++ == 0 && word != kKey)
            m_stage = Stage::Silent;
    } else if (m_blockWords > 0) {
        --m_blockWords;
    } else if (word == 0) {
        m_stage = Stage::Finished;
    } else {
        m_blockWords = kDestinationWords + static_cast<long>(word);
    }
}

}  // namespace support::falcon
