// SPDX-License-Identifier: GPL-3.0-or-later
// libusb's functions for transfers and events, as libusb 1.0.26 documents them.
#include <sys/time.h>

#include <algorithm>
#include <cstdlib>
#include <span>
#include <utility>

#include "tests/support/falcon/UsbObjects.h"

using support::abortFor;
using support::usb;
using support::UsbAccess;
using support::UsbTransfer;
using support::falcon::Clock;
using support::falcon::FtdiChip;
using support::falcon::kNever;
using support::falcon::Time;
using State = UsbTransfer::State;

namespace support {
namespace {

constexpr unsigned char kIn = 0x81;
constexpr unsigned char kOut = 0x02;
/// libusb_handle_events returns after this time at the latest.
constexpr std::chrono::seconds kLongestWait{60};

falcon::Hardware* hardwareOf(const UsbTransfer& transfer)
{
    EmulatedFalcon* const device = transfer.usb->dev_handle->device->falcon;
    return device == nullptr ? nullptr : &UsbAccess::hardware(*device);
}

bool isIn(const UsbTransfer& transfer)
{
    return transfer.usb->endpoint == kIn;
}

void checkBulk(const libusb_device_handle& handle, unsigned char endpoint, const unsigned char* buffer, int length)
{
    if (!handle.claimed)
        abortFor("a transfer is submitted without a claim of interface 0");
    if (endpoint != kIn && endpoint != kOut)
        abortFor("a transfer is submitted to an endpoint other than 0x81 and 0x02");
    if (buffer == nullptr || length < 0)
        abortFor("a transfer is submitted without a buffer");
    if (endpoint == kIn && (length == 0 || length % static_cast<int>(FtdiChip::kPacketBytes) != 0))
        abortFor("the buffer of an IN transfer is not a multiple of 64 bytes, so that it can overflow");
}

/// Takes the packets that are ready. Returns true if the transfer is complete.
bool readInto(libusb_transfer& transfer, falcon::Hardware& hardware, Time now)
{
    while (hardware.chip.nextPacket() <= now) {
        const std::span<std::uint8_t> buffer(transfer.buffer, static_cast<std::size_t>(transfer.length));
        const auto got =
            hardware.chip.takePacket(buffer.subspan(static_cast<std::size_t>(transfer.actual_length)), now);
        transfer.actual_length += static_cast<int>(got);
        if (got < FtdiChip::kPacketBytes || transfer.actual_length == transfer.length)
            return true;
    }
    return false;
}

/// Returns how the transfer has ended; empty if it has not ended yet.
std::optional<libusb_transfer_status> outcome(UsbTransfer& transfer, Time now)
{
    falcon::Hardware* const hardware = hardwareOf(transfer);
    if (hardware == nullptr)
        return LIBUSB_TRANSFER_NO_DEVICE;
    if (transfer.cancelled)
        return LIBUSB_TRANSFER_CANCELLED;
    if (isIn(transfer) ? readInto(*transfer.usb, *hardware, now) : transfer.sent <= now)
        return LIBUSB_TRANSFER_COMPLETED;
    if (transfer.deadline <= now)
        return LIBUSB_TRANSFER_TIMED_OUT;
    return std::nullopt;
}

/// Moves transfers that have ended from `active` to `done`.
void collect(libusb_context& context, Time now)
{
    UsbAccess::advance(now);
    std::erase_if(context.active, [&](UsbTransfer* transfer) {
        const auto status = outcome(*transfer, now);
        if (!status)
            return false;
        transfer->usb->status = *status;
        transfer->state = State::Done;
        context.done.push_back(transfer);
        return true;
    });
}

/// Calls the callbacks of the transfers that have ended, without the lock. Transfers that end during the calls wait for
/// the next round.
bool callBack(libusb_context& context, UsbAccess::Lock& lock)
{
    const std::size_t count = context.done.size();
    for (std::size_t n = 0; n < count; ++n) {
        UsbTransfer* const transfer = context.done.front();
        context.done.erase(context.done.begin());
        transfer->state = State::Idle;
        libusb_transfer* const usbTransfer = transfer->usb;
        const unsigned flags = usbTransfer->flags;
        lock.unlock();
        usbTransfer->callback(usbTransfer);
        if ((flags & LIBUSB_TRANSFER_FREE_TRANSFER) != 0)
            libusb_free_transfer(usbTransfer);
        lock.lock();
    }
    return count > 0;
}

/// Returns the time of the next event for collect(), if the program does nothing.
Time nextEvent(const libusb_context& context)
{
    Time next = kNever;
    for (UsbTransfer* const transfer : context.active) {
        next = std::min(next, transfer->deadline);
        if (falcon::Hardware* const hardware = hardwareOf(*transfer))
            next = std::min(next, isIn(*transfer) ? hardware->nextEvent() : transfer->sent);
    }
    return next;
}

/// Handles events until the deadline.
/// @param completed  returns as soon as it is not 0; may be null
int handleEvents(libusb_context& context, Time deadline, const int* completed)
{
    auto lock = UsbAccess::lock();
    const auto isDone = [&] { return completed != nullptr && *completed != 0; };
    if (context.handler == std::this_thread::get_id())
        return LIBUSB_ERROR_BUSY;
    while (context.handler != std::thread::id()) {
        if (isDone() || std::exchange(context.interrupted, false))
            return LIBUSB_SUCCESS;
        if (UsbAccess::changed().wait_until(lock, deadline) == std::cv_status::timeout)
            return LIBUSB_SUCCESS;
    }
    context.handler = std::this_thread::get_id();
    while (!isDone() && !std::exchange(context.interrupted, false)) {
        const Time now = Clock::now();
        collect(context, now);
        const bool toldHotplug = tellHotplug(context, lock);
        if (callBack(context, lock) || toldHotplug || now >= deadline)
            break;
        UsbAccess::changed().wait_until(lock, std::min(deadline, nextEvent(context)));
    }
    context.handler = std::thread::id();
    UsbAccess::changed().notify_all();
    return LIBUSB_SUCCESS;
}

int errorOf(libusb_transfer_status status)
{
    switch (status) {
    case LIBUSB_TRANSFER_COMPLETED:
        return LIBUSB_SUCCESS;
    case LIBUSB_TRANSFER_TIMED_OUT:
        return LIBUSB_ERROR_TIMEOUT;
    case LIBUSB_TRANSFER_STALL:
        return LIBUSB_ERROR_PIPE;
    case LIBUSB_TRANSFER_NO_DEVICE:
        return LIBUSB_ERROR_NO_DEVICE;
    case LIBUSB_TRANSFER_OVERFLOW:
        return LIBUSB_ERROR_OVERFLOW;
    case LIBUSB_TRANSFER_ERROR:
    case LIBUSB_TRANSFER_CANCELLED:
        break;
    }
    return LIBUSB_ERROR_IO;
}

Time after(const timeval& wait)
{
    return Clock::now() + std::chrono::seconds(wait.tv_sec) + std::chrono::microseconds(wait.tv_usec);
}

libusb_context& contextFor(libusb_context* pointer)
{
    const auto lock = UsbAccess::lock();
    return usb().context(pointer);
}

}  // namespace

UsbTransfer& UsbAccess::transfer(libusb_transfer* pointer)
{
    const auto found = transfers.find(pointer);
    if (found == transfers.end() || found->second.state == State::Freed)
        abortFor("a transfer is used that libusb_alloc_transfer did not make or that is free");
    return found->second;
}

}  // namespace support

extern "C" {

struct libusb_transfer* libusb_alloc_transfer(int isoPackets)
{
    const std::size_t bytes =
        sizeof(libusb_transfer) + static_cast<std::size_t>(isoPackets) * sizeof(libusb_iso_packet_descriptor);
    auto* const made = static_cast<libusb_transfer*>(std::calloc(1, bytes));
    if (made == nullptr)
        return nullptr;
    made->num_iso_packets = isoPackets;
    const auto lock = UsbAccess::lock();
    usb().transfers[made].usb = made;
    return made;
}

void libusb_free_transfer(struct libusb_transfer* pointer)
{
    if (pointer == nullptr)
        return;
    const auto lock = UsbAccess::lock();
    UsbTransfer& transfer = usb().transfer(pointer);
    if (transfer.state != State::Idle)
        abortFor("a transfer is freed that has not completed");
    if ((pointer->flags & LIBUSB_TRANSFER_FREE_BUFFER) != 0)
        std::free(pointer->buffer);
    transfer.state = State::Freed;
}

int libusb_submit_transfer(struct libusb_transfer* pointer)
{
    const auto lock = UsbAccess::lock();
    UsbTransfer& transfer = usb().transfer(pointer);
    if (transfer.state != State::Idle)
        abortFor("a transfer is submitted that has not completed");
    if (pointer->type != LIBUSB_TRANSFER_TYPE_BULK)
        abortFor("a transfer is submitted that is not a bulk transfer");
    if (pointer->callback == nullptr)
        abortFor("a transfer is submitted without a callback");
    const libusb_device_handle& handle = usb().handle(pointer->dev_handle);
    if (handle.device->falcon == nullptr)
        return LIBUSB_ERROR_NO_DEVICE;
    support::checkBulk(handle, pointer->endpoint, pointer->buffer, pointer->length);
    const Time now = Clock::now();
    UsbAccess::advance(now);
    support::falcon::Hardware* const hardware = support::hardwareOf(transfer);
    if (hardware == nullptr)
        return LIBUSB_ERROR_NO_DEVICE;
    pointer->actual_length = 0;
    pointer->status = LIBUSB_TRANSFER_COMPLETED;
    transfer.cancelled = false;
    transfer.deadline = pointer->timeout == 0 ? kNever : now + std::chrono::milliseconds(pointer->timeout);
    if (!support::isIn(transfer)) {
        transfer.sent = hardware->chip.write({pointer->buffer, static_cast<std::size_t>(pointer->length)}, now);
        pointer->actual_length = pointer->length;
        UsbAccess::advance(now);
    }
    transfer.state = State::Active;
    handle.device->context->active.push_back(&transfer);
    UsbAccess::changed().notify_all();
    return LIBUSB_SUCCESS;
}

int libusb_cancel_transfer(struct libusb_transfer* pointer)
{
    const auto lock = UsbAccess::lock();
    UsbTransfer& transfer = usb().transfer(pointer);
    if (transfer.state != State::Active || transfer.cancelled)
        return LIBUSB_ERROR_NOT_FOUND;
    transfer.cancelled = true;
    UsbAccess::changed().notify_all();
    return LIBUSB_SUCCESS;
}

int libusb_control_transfer(libusb_device_handle* pointer, uint8_t type, uint8_t request, uint16_t value,
                            uint16_t index, unsigned char* data, uint16_t length, unsigned int /*timeout*/)
{
    libusb_context* context = nullptr;
    std::optional<std::size_t> answered;
    {
        const auto lock = UsbAccess::lock();
        const libusb_device_handle& handle = usb().handle(pointer);
        context = handle.device->context;
        if (context->handler == std::this_thread::get_id())
            return LIBUSB_ERROR_BUSY;
        const Time now = Clock::now();
        UsbAccess::advance(now);
        if (handle.device->falcon == nullptr)
            return LIBUSB_ERROR_NO_DEVICE;
        answered = UsbAccess::hardware(*handle.device->falcon)
                       .control(type, request, value, index, std::span<std::uint8_t>(data, length), now);
        UsbAccess::changed().notify_all();
    }
    // libusb handles events while it waits, so that callbacks of other transfers can be called from here.
    support::handleEvents(*context, Clock::now(), nullptr);
    return answered ? static_cast<int>(*answered) : LIBUSB_ERROR_PIPE;
}

int libusb_bulk_transfer(libusb_device_handle* pointer, unsigned char endpoint, unsigned char* data, int length,
                         int* transferred, unsigned int timeout)
{
    libusb_context* context = nullptr;
    {
        const auto lock = UsbAccess::lock();
        context = usb().handle(pointer).device->context;
        if (context->handler == std::this_thread::get_id())
            return LIBUSB_ERROR_BUSY;
    }
    int completed = 0;
    libusb_transfer* const transfer = libusb_alloc_transfer(0);
    libusb_fill_bulk_transfer(
        transfer, pointer, endpoint, data, length,
        [](libusb_transfer* ended) {
            const auto lock = UsbAccess::lock();
            *static_cast<int*>(ended->user_data) = 1;
        },
        &completed, timeout);
    int result = libusb_submit_transfer(transfer);
    if (result == LIBUSB_SUCCESS) {
        const auto isCompleted = [&] {
            const auto lock = UsbAccess::lock();
            return completed != 0;
        };
        while (!isCompleted())
            support::handleEvents(*context, Clock::now() + support::kLongestWait, &completed);
        result = support::errorOf(transfer->status);
        if (transferred != nullptr)
            *transferred = transfer->actual_length;
    }
    libusb_free_transfer(transfer);
    const auto lock = UsbAccess::lock();
    usb().transfers.erase(transfer);
    std::free(transfer);
    return result;
}

int libusb_handle_events_timeout_completed(libusb_context* context, struct timeval* wait, int* completed)
{
    return support::handleEvents(support::contextFor(context), support::after(*wait), completed);
}

int libusb_handle_events_timeout(libusb_context* context, struct timeval* wait)
{
    return libusb_handle_events_timeout_completed(context, wait, nullptr);
}

int libusb_handle_events_completed(libusb_context* context, int* completed)
{
    return support::handleEvents(support::contextFor(context), Clock::now() + support::kLongestWait, completed);
}

int libusb_handle_events(libusb_context* context)
{
    return libusb_handle_events_completed(context, nullptr);
}

void libusb_interrupt_event_handler(libusb_context* pointer)
{
    const auto lock = UsbAccess::lock();
    usb().context(pointer).interrupted = true;
    UsbAccess::changed().notify_all();
}

}  // extern "C"
