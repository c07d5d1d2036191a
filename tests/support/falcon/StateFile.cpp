// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/falcon/StateFile.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numeric>

#include "tests/support/falcon/Misuse.h"

namespace support {
namespace {

long millisecondsOf(falcon::Time time)
{
    return static_cast<long>(std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count());
}

long millisecondsOf(const std::optional<falcon::Time>& time)
{
    return time ? millisecondsOf(*time) : -1;
}

/// Text of fixed capacity. Text that does not fit is cut off.
class Text
{
public:
    template <typename... Values>
    void line(const char* format, Values... values)
    {
        const int size = std::snprintf(m_bytes + m_size, sizeof(m_bytes) - m_size, format, values...);
        m_size += std::min(static_cast<std::size_t>(std::max(size, 0)), sizeof(m_bytes) - m_size - 1);
    }
    void vector(const char* name, const glm::dvec3& v)
    {
        // Rounds here, so that a small negative number is not written as -0.000.
        const auto rounded = [](double x) { return std::round(x * 1000.0) / 1000.0 + 0.0; };
        line("%s %.3f %.3f %.3f\n", name, rounded(v.x), rounded(v.y), rounded(v.z));
    }
    /// Fills the rest of the file with empty lines.
    void fill() { std::memset(m_bytes + m_size, '\n', sizeof(m_bytes) - m_size); }
    [[nodiscard]] const char* bytes() const { return m_bytes; }

private:
    char m_bytes[StateFile::kBytes]{};
    std::size_t m_size = 0;
};

}  // namespace

StateFile::StateFile(const std::string& path)
{
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (file < 0 || ::ftruncate(file, 0) != 0 || ::ftruncate(file, kBytes) != 0)
        abortFor("the file \"state\" cannot be written");
    void* const mapped = ::mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    ::close(file);
    if (mapped == MAP_FAILED)
        abortFor("the file \"state\" cannot be mapped");
    m_text = static_cast<char*>(mapped);
}

StateFile::~StateFile()
{
    ::munmap(m_text, kBytes);
}

void StateFile::write(const EmulatedFalcon& device, const FalconState& state)
{
    const falcon::Time now = falcon::Clock::now();
    Text text;
    text.line("begin %lu\n", ++m_written);
    text.line("serial %s\n", device.serial().c_str());
    text.line("plugged %d\nclaimed %d\nmains %d\nfirmware %d\n", state.plugged, state.claimed, state.mains,
              state.firmwareRuns);
    text.line("queries %d\nloads %d\nimage_bytes %zu\n", state.queries, state.loads, state.imageBytes);
    text.line("requests %llu\nanswers %llu\n", static_cast<unsigned long long>(state.requests),
              static_cast<unsigned long long>(state.answers));
    text.line("motors %d %d %d\n", state.motors[0], state.motors[1], state.motors[2]);
    text.line("nonzero_ms_ago %ld\n",
              state.lastNonZero ? millisecondsOf(now) - millisecondsOf(*state.lastNonZero) : -1);
    text.line("nonzero_ms %ld\nrequest_ms %ld\nwritten_ms %ld\n", millisecondsOf(state.lastNonZero),
              millisecondsOf(state.lastRequest), millisecondsOf(now));
    text.line("leds %d %d %d\n", state.leds.red, state.leds.green, state.leds.blue);
    text.line("homing %d\nhomed %d %d %d\n", state.homing, state.homed[0], state.homed[1], state.homed[2]);
    text.line("counts %d %d %d\n", state.counts[0], state.counts[1], state.counts[2]);
    text.vector("grip", state.gripMm);
    text.vector("tip", haptics::falcon::toothFromDevice(state.gripMm));
    text.vector("force", state.forceN);
    text.line("faults %llu\n", static_cast<unsigned long long>(
                                   std::accumulate(state.faults.begin(), state.faults.end(), std::uint64_t{0})));
    text.line("end %lu\n", m_written);
    text.fill();
    std::memcpy(m_text, text.bytes(), kBytes);
}

}  // namespace support
