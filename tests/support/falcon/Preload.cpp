// SPDX-License-Identifier: GPL-3.0-or-later
// The emulated Falcon for a program that was built without it: build/RELEASE/tests/libemulated_falcon.so, loaded with
//
//     LD_PRELOAD=.../libemulated_falcon.so CUSP_EMULATED_FALCON=FOLDER cusp ...
//
// The program's libusb calls come here. From its first libusb_init on, a thread executes the lines of FOLDER/command, a
// file or FIFO, including lines that are appended later; Commands.h lists them. Without the variable, or with an empty
// file, there is a USB without devices. These files are written:
//
//     FOLDER/state         last state of the device: StateFile.h. Readable after the program was killed
//     FOLDER/firmware.bin  the image that was loaded last
//     FOLDER/unknown       lines of the command file that could not be executed
//
// If several programs run with the same folder, the first one has the device, and the others find it busy.
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <thread>

#include "tests/support/falcon/Commands.h"
#include "tests/support/falcon/Misuse.h"
#include "tests/support/falcon/StateFile.h"
#include "tests/support/falcon/UsbObjects.h"

namespace support {
namespace {

using namespace std::chrono_literals;

constexpr auto kPause = 2ms;

/// Reads a file that grows, or a FIFO, line by line.
class LineReader
{
public:
    explicit LineReader(const std::string& path)
        : m_file(::open(path.c_str(), O_RDWR | O_CREAT | O_NONBLOCK | O_CLOEXEC, 0644))
    {
        if (m_file < 0)
            abortFor("the file \"command\" cannot be read");
    }
    /// Returns the next line, or null if no whole line has arrived.
    std::optional<std::string> next()
    {
        char bytes[512];
        for (ssize_t size = ::read(m_file, bytes, sizeof(bytes)); size > 0; size = ::read(m_file, bytes, sizeof(bytes)))
            m_text.append(bytes, static_cast<std::size_t>(size));
        const auto end = m_text.find('\n');
        if (end == std::string::npos)
            return std::nullopt;
        std::string line = m_text.substr(0, end);
        m_text.erase(0, end + 1);
        return line;
    }

private:
    int m_file;
    std::string m_text;
};

/// Takes the folder for this process. Returns false if another process has it.
bool takeFolder(const std::filesystem::path& folder)
{
    const int file = ::open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    return file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) == 0;  // until the process ends
}

class Controller
{
public:
    explicit Controller(const std::filesystem::path& folder)
        : m_folder(folder), m_first(takeFolder(folder)), m_lines(folder / "command"), m_commands(emulatedBus())
    {
        if (!m_first)
            return;
        m_state.emplace(folder / "state");
        emulatedBus().setObserver([this](const EmulatedFalcon& device, const FalconState& state) {
            if (&device == m_shown)
                m_state->write(device, state);
        });
    }

    void obeyNewLines()
    {
        while (const auto line = m_lines.next()) {
            if (!m_commands.obey(*line))
                std::ofstream(m_folder / "unknown", std::ios::app) << *line << '\n';
            if (m_commands.device() != nullptr && !m_first)
                m_commands.device()->setBusy(true);
        }
    }

    /// Advances the device's time, also while the program does nothing.
    void look()
    {
        EmulatedFalcon* const device = m_commands.device();
        if (device == nullptr || !m_first)
            return;
        m_shown = device;
        if (const int loads = device->state().loads; loads != m_loads) {
            m_loads = loads;
            const auto image = device->image();
            std::ofstream(m_folder / "firmware.bin", std::ios::binary)
                .write(reinterpret_cast<const char*>(image.data()), static_cast<std::streamsize>(image.size()));
        }
    }

private:
    std::filesystem::path m_folder;
    bool m_first;
    LineReader m_lines;
    Commands m_commands;
    std::optional<StateFile> m_state;
    std::atomic<const EmulatedFalcon*> m_shown{nullptr};
    int m_loads = 0;
};

void start()
{
    const char* const folder = std::getenv("CUSP_EMULATED_FALCON");
    if (folder == nullptr)
        return;
    // Never destroyed: the thread runs until the process ends.
    auto* const controller = new Controller(folder);
    controller->obeyNewLines();
    controller->look();
    // A signal to the program must not be handled in this thread, which the program does not know.
    sigset_t all;
    sigset_t before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    std::thread([controller] {
        while (true) {
            std::this_thread::sleep_for(kPause);
            controller->obeyNewLines();
            controller->look();
        }
    }).detach();
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

__attribute__((constructor)) void registerStart()
{
    usb().onFirstInit = start;
}

}  // namespace
}  // namespace support
