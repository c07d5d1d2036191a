// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace support::falcon {

/// Deviations of the boot loader. All of them have been reported of real devices.
struct BootOptions
{
    bool leadingZero = false;  ///< a 00 before the answer to the query
    int answersAtTry = 1;      ///< number of the first query that is answered
    bool strayByte = false;    ///< a 13 before the 'A'
    long wrongEchoAt = -1;     ///< number of the image byte that is echoed wrongly, once; -1: none
};

/// A few bytes that the controller sends at once.
struct Reply
{
    std::array<std::uint8_t, 8> bytes{};
    std::size_t size = 0;
    double baud = 0.0;

    void add(std::uint8_t byte) { bytes[size++] = byte; }
};

/// The Falcon's controller without firmware: the query at 9600 baud, then the SCI boot loader of TI's C28x processors
/// (SPRUI07). 'A' measures the baud rate, every byte is echoed, and the stream itself marks its end.
///
/// A byte out of order or at another baud rate gets no answer.
class BootLoader
{
public:
    BootLoader();

    void setOptions(const BootOptions& options);
    /// Resets the loader, as after power-up or a pulse of DTR.
    void reset();
    void setDtr(bool high);
    [[nodiscard]] Reply receive(std::uint8_t byte, double baud);

    /// Returns whether the image is complete: the processor starts it.
    [[nodiscard]] bool isFinished() const { return m_stage == Stage::Finished; }
    [[nodiscard]] const std::vector<std::uint8_t>& image() const { return m_image; }
    [[nodiscard]] int queries() const { return m_queries; }

    // The kind of the byte just received.
    [[nodiscard]] bool tookQuery() const { return m_tookQuery; }
    [[nodiscard]] bool tookAutobaud() const { return m_tookAutobaud; }
    [[nodiscard]] bool tookImageByte() const { return m_tookImageByte; }

private:
    enum class Stage {
        Query,
        Answered,
        Autobaud,
        Image,
        Finished,
        Silent,  ///< until the next reset
    };

    void takeQueryByte(std::uint8_t byte, Reply& reply);
    void takeWord(unsigned word);

    BootOptions m_options;
    Stage m_stage = Stage::Query;
    bool m_dtr = false;
    double m_baud = 0.0;  ///< of the 'A'
    unsigned m_last = 0;  ///< the last three bytes at 9600 baud
    int m_queries = 0;
    std::vector<std::uint8_t> m_image;
    long m_headerWords = 0;
    long m_blockWords = 0;  ///< still to come in this block, its destination included
    bool m_tookQuery = false;
    bool m_tookAutobaud = false;
    bool m_tookImageByte = false;
};

}  // namespace support::falcon
