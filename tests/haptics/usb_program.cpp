// SPDX-License-Identifier: GPL-3.0-or-later
// A program that uses a Falcon through libusb, for tst_preloaded_falcon. It opens the first device, sends one request
// with motor commands, prints the number of bytes received, and waits to be killed.
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include <libusb-1.0/libusb.h>
#include <unistd.h>

namespace {

constexpr unsigned kWaitMs = 1000;

void control(libusb_device_handle* handle, std::uint8_t request, std::uint16_t value)
{
    libusb_control_transfer(handle, 0x40, request, value, 0, nullptr, 0, kWaitMs);
}

int say(const char* what, int code)
{
    std::printf("%s %s\n", what, libusb_error_name(code));
    return 1;
}

}  // namespace

int main()
{
    libusb_context* context = nullptr;
    if (const int code = libusb_init(&context); code != LIBUSB_SUCCESS)
        return say("init", code);
    libusb_device** devices = nullptr;
    if (libusb_get_device_list(context, &devices) < 1)
        return say("list", LIBUSB_ERROR_NOT_FOUND);
    libusb_device_handle* handle = nullptr;
    if (const int code = libusb_open(devices[0], &handle); code != LIBUSB_SUCCESS)
        return say("open", code);
    if (const int code = libusb_claim_interface(handle, 0); code != LIBUSB_SUCCESS)
        return say("claim", code);
    control(handle, 9, 1);
    control(handle, 3, 2);
    char request[] = "<FAAAGAAAHAAAEA>";  // commands 5, 6 and 7, blue LED
    int answer = 0;
    int code = libusb_bulk_transfer(handle, 0x02, reinterpret_cast<unsigned char*>(request),
                                    static_cast<int>(std::strlen(request)), nullptr, kWaitMs);
    while (code == LIBUSB_SUCCESS && answer < 16) {
        std::array<unsigned char, 64> packet{};
        int size = 0;
        code = libusb_bulk_transfer(handle, 0x81, packet.data(), static_cast<int>(packet.size()), &size, kWaitMs);
        answer += size - 2;
    }
    std::printf("answer %d\n", answer);
    std::fflush(stdout);
    pause();
}
