// SPDX-License-Identifier: GPL-3.0-or-later
// libusb's functions for contexts, devices, handles and hot-plug, as libusb 1.0.26 documents them.
#include <algorithm>
#include <cstring>
#include <string_view>
#include <utility>

#include "tests/support/falcon/UsbObjects.h"

using support::abortFor;
using support::usb;
using support::UsbAccess;
using support::falcon::Clock;

namespace support {
namespace {

constexpr std::uint16_t kVendor = 0x0403;
constexpr std::uint16_t kProduct = 0xCB48;
constexpr std::uint8_t kBus = 1;
constexpr int kMaxPacket = 64;

template <typename T>
bool owns(const std::vector<std::unique_ptr<T>>& all, const T* pointer)
{
    return std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.get() == pointer; });
}

bool matches(const HotplugCallback& callback, libusb_hotplug_event event)
{
    return (callback.events & event) != 0 &&
           (callback.vendor == LIBUSB_HOTPLUG_MATCH_ANY || callback.vendor == kVendor) &&
           (callback.product == LIBUSB_HOTPLUG_MATCH_ANY || callback.product == kProduct);
}

void forgetCallback(libusb_context& context, int number)
{
    std::erase_if(context.callbacks, [&](const HotplugCallback& callback) { return callback.number == number; });
}

/// Calls the callbacks for an event, without the lock.
void callFor(libusb_context& context, const HotplugEvent& event, UsbAccess::Lock& lock, int onlyNumber = 0)
{
    const auto callbacks = context.callbacks;
    for (const HotplugCallback& callback : callbacks) {
        const bool still = std::any_of(context.callbacks.begin(), context.callbacks.end(),
                                       [&](const HotplugCallback& one) { return one.number == callback.number; });
        if (!still || !matches(callback, event.event) || (onlyNumber != 0 && callback.number != onlyNumber))
            continue;
        lock.unlock();
        const int finished = callback.function(&context, event.device, event.event, callback.user);
        lock.lock();
        if (finished != 0)
            forgetCallback(context, callback.number);
    }
}

void queueFor(libusb_device& device, libusb_hotplug_event event)
{
    if (device.context->callbacks.empty())
        return;
    ++device.references;
    device.context->events.push_back({&device, event});
}

}  // namespace

UsbAccess& usb()
{
    static auto* const access = new UsbAccess;
    return *access;
}

libusb_context& UsbAccess::context(libusb_context* pointer)
{
    if (pointer == nullptr)
        pointer = defaultContext;
    if (pointer == nullptr || !owns(contexts, pointer))
        abortFor("a libusb context is used before libusb_init or after libusb_exit");
    return *pointer;
}

libusb_device& UsbAccess::device(libusb_device* pointer)
{
    if (!owns(devices, pointer))
        abortFor("a libusb_device is used after its last reference was given back");
    return *pointer;
}

libusb_device_handle& UsbAccess::handle(libusb_device_handle* pointer)
{
    if (!owns(handles, pointer) || !pointer->open)
        abortFor("a device handle is used that is not open");
    return *pointer;
}

void UsbAccess::dropUnusedDevices()
{
    std::erase_if(devices, [](const auto& device) { return device->references == 0 && device->falcon == nullptr; });
}

libusb_device& UsbAccess::addDevice(libusb_context& context, EmulatedFalcon& falcon)
{
    devices.push_back(std::make_unique<libusb_device>(
        libusb_device{&context, &falcon, falcon.serial(), falcon.m_port, falcon.m_address}));
    return *devices.back();
}

void UsbAccess::addDevices(libusb_context& context)
{
    for (const auto& falcon : emulatedBus().m_devices)
        if (falcon->m_plugged)
            addDevice(context, *falcon);
}

void usbArrived(EmulatedFalcon& falcon)
{
    for (const auto& context : usb().contexts)
        queueFor(usb().addDevice(*context, falcon), LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED);
}

void usbLeft(EmulatedFalcon& falcon)
{
    for (const auto& device : usb().devices)
        if (device->falcon == &falcon) {
            device->falcon = nullptr;
            queueFor(*device, LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT);
        }
    usb().dropUnusedDevices();
}

UsbObjects usbObjects()
{
    UsbObjects objects;
    for (const auto& context : usb().contexts) {
        ++objects.contexts;
        objects.hotplugCallbacks += static_cast<int>(context->callbacks.size());
        objects.deviceReferences -= static_cast<int>(context->events.size());
    }
    for (const auto& handle : usb().handles)
        if (handle->open) {
            ++objects.handles;
            --objects.deviceReferences;
        }
    for (const auto& [pointer, transfer] : usb().transfers)
        objects.transfers += transfer.state == UsbTransfer::State::Freed ? 0 : 1;
    for (const auto& device : usb().devices)
        objects.deviceReferences += device->references;
    return objects;
}

bool tellHotplug(libusb_context& context, UsbAccess::Lock& lock)
{
    if (context.events.empty())
        return false;
    while (!context.events.empty()) {
        const HotplugEvent event = context.events.front();
        context.events.pop_front();
        callFor(context, event, lock);
        --event.device->references;
    }
    usb().dropUnusedDevices();
    return true;
}

}  // namespace support

extern "C" {

int libusb_init(libusb_context** context)
{
    static std::once_flag isStarted;
    std::call_once(isStarted, [] {
        if (usb().onFirstInit != nullptr)
            usb().onFirstInit();
    });
    const auto lock = UsbAccess::lock();
    if (!UsbAccess::usbPresent())
        return LIBUSB_ERROR_OTHER;
    if (context == nullptr && usb().defaultContext != nullptr) {
        ++usb().defaultContext->references;
        return LIBUSB_SUCCESS;
    }
    usb().contexts.push_back(std::make_unique<libusb_context>());
    libusb_context* const made = usb().contexts.back().get();
    made->references = 1;
    made->active.reserve(256);
    made->done.reserve(256);
    usb().addDevices(*made);
    if (context != nullptr)
        *context = made;
    else
        usb().defaultContext = made;
    return LIBUSB_SUCCESS;
}

void libusb_exit(libusb_context* pointer)
{
    const auto lock = UsbAccess::lock();
    libusb_context& context = usb().context(pointer);
    if (--context.references > 0)
        return;
    if (std::any_of(usb().handles.begin(), usb().handles.end(),
                    [&](const auto& handle) { return handle->open && handle->device->context == &context; }))
        abortFor("libusb_exit is called while a device is open");
    if (context.handler != std::thread::id())
        abortFor("libusb_exit is called while events are handled");
    for (const auto& event : context.events)
        --event.device->references;
    for (const auto& device : usb().devices)
        if (device->context == &context)
            device->falcon = nullptr;
    usb().dropUnusedDevices();
    if (usb().defaultContext == &context)
        usb().defaultContext = nullptr;
    std::erase_if(usb().contexts, [&](const auto& one) { return one.get() == &context; });
}

const struct libusb_version* libusb_get_version(void)
{
    static const libusb_version version{1, 0, 26, 11724, "", "emulated by Cusp's tests"};
    return &version;
}

int libusb_has_capability(uint32_t capability)
{
    return capability == LIBUSB_CAP_HAS_CAPABILITY || capability == LIBUSB_CAP_HAS_HOTPLUG ||
                   capability == LIBUSB_CAP_SUPPORTS_DETACH_KERNEL_DRIVER
               ? 1
               : 0;
}

int libusb_set_option(libusb_context* /*context*/, enum libusb_option /*option*/, ...)
{
    return LIBUSB_SUCCESS;
}

ssize_t libusb_get_device_list(libusb_context* pointer, libusb_device*** list)
{
    const auto lock = UsbAccess::lock();
    const libusb_context& context = usb().context(pointer);
    UsbAccess::advance(Clock::now());
    auto** const found = static_cast<libusb_device**>(std::calloc(usb().devices.size() + 1, sizeof(libusb_device*)));
    if (found == nullptr)
        return LIBUSB_ERROR_NO_MEM;
    ssize_t count = 0;
    for (const auto& device : usb().devices)
        if (device->context == &context && device->falcon != nullptr) {
            ++device->references;
            found[count++] = device.get();
        }
    *list = found;
    return count;
}

void libusb_free_device_list(libusb_device** list, int unref)
{
    if (list == nullptr)
        return;
    for (libusb_device** device = list; unref != 0 && *device != nullptr; ++device)
        libusb_unref_device(*device);
    std::free(list);
}

libusb_device* libusb_ref_device(libusb_device* pointer)
{
    const auto lock = UsbAccess::lock();
    ++usb().device(pointer).references;
    return pointer;
}

void libusb_unref_device(libusb_device* pointer)
{
    if (pointer == nullptr)
        return;
    const auto lock = UsbAccess::lock();
    libusb_device& device = usb().device(pointer);
    if (device.references == 0)
        abortFor("libusb_unref_device is called more often than references were taken");
    --device.references;
    usb().dropUnusedDevices();
}

int libusb_get_device_descriptor(libusb_device* pointer, struct libusb_device_descriptor* descriptor)
{
    const auto lock = UsbAccess::lock();
    static_cast<void>(usb().device(pointer));
    *descriptor = {};
    descriptor->bLength = LIBUSB_DT_DEVICE_SIZE;
    descriptor->bDescriptorType = LIBUSB_DT_DEVICE;
    descriptor->bcdUSB = 0x0200;
    descriptor->bMaxPacketSize0 = 8;
    descriptor->idVendor = support::kVendor;
    descriptor->idProduct = support::kProduct;
    descriptor->bcdDevice = 0x0400;
    descriptor->iManufacturer = 1;
    descriptor->iProduct = 2;
    descriptor->iSerialNumber = 3;
    descriptor->bNumConfigurations = 1;
    return LIBUSB_SUCCESS;
}

uint8_t libusb_get_bus_number(libusb_device* pointer)
{
    const auto lock = UsbAccess::lock();
    static_cast<void>(usb().device(pointer));
    return support::kBus;
}

uint8_t libusb_get_device_address(libusb_device* pointer)
{
    const auto lock = UsbAccess::lock();
    return static_cast<uint8_t>(usb().device(pointer).address);
}

int libusb_get_port_numbers(libusb_device* pointer, uint8_t* ports, int length)
{
    const auto lock = UsbAccess::lock();
    if (length < 1)
        return length == 0 ? LIBUSB_ERROR_OVERFLOW : LIBUSB_ERROR_INVALID_PARAM;
    ports[0] = static_cast<uint8_t>(usb().device(pointer).port);
    return 1;
}

int libusb_get_max_packet_size(libusb_device* pointer, unsigned char endpoint)
{
    const auto lock = UsbAccess::lock();
    static_cast<void>(usb().device(pointer));
    return endpoint == 0x81 || endpoint == 0x02 ? support::kMaxPacket : LIBUSB_ERROR_NOT_FOUND;
}

int libusb_open(libusb_device* pointer, libusb_device_handle** handle)
{
    const auto lock = UsbAccess::lock();
    libusb_device& device = usb().device(pointer);
    if (device.falcon != nullptr)
        UsbAccess::hardware(*device.falcon).reach(support::Moment::Open);
    UsbAccess::advance(Clock::now());
    if (device.falcon == nullptr)
        return LIBUSB_ERROR_NO_DEVICE;
    if (UsbAccess::isDenied(*device.falcon))
        return LIBUSB_ERROR_ACCESS;
    auto made = std::make_unique<libusb_device_handle>();
    made->device = &device;
    made->open = true;
    ++device.references;
    *handle = made.get();
    usb().handles.push_back(std::move(made));
    return LIBUSB_SUCCESS;
}

int libusb_release_interface(libusb_device_handle* pointer, int interface)
{
    const auto lock = UsbAccess::lock();
    libusb_device_handle& handle = usb().handle(pointer);
    if (interface != 0 || !handle.claimed)
        return LIBUSB_ERROR_NOT_FOUND;
    handle.claimed = false;
    support::EmulatedFalcon* const falcon = handle.device->falcon;
    if (falcon == nullptr)
        return LIBUSB_ERROR_NO_DEVICE;
    UsbAccess::claimed(*falcon) = false;
    if (std::exchange(handle.detached, false))
        UsbAccess::kernelDriver(*falcon) = true;
    return LIBUSB_SUCCESS;
}

void libusb_close(libusb_device_handle* pointer)
{
    if (pointer == nullptr)
        return;
    {
        const auto lock = UsbAccess::lock();
        libusb_device_handle& handle = usb().handle(pointer);
        for (const auto& [usbTransfer, transfer] : usb().transfers)
            if ((transfer.state == support::UsbTransfer::State::Active ||
                 transfer.state == support::UsbTransfer::State::Done) &&
                usbTransfer->dev_handle == &handle)
                abortFor("a device is closed while a transfer of it has not completed");
    }
    libusb_release_interface(pointer, 0);
    const auto lock = UsbAccess::lock();
    pointer->open = false;
    --pointer->device->references;
    usb().dropUnusedDevices();
}

libusb_device* libusb_get_device(libusb_device_handle* pointer)
{
    const auto lock = UsbAccess::lock();
    return usb().handle(pointer).device;
}

int libusb_get_string_descriptor_ascii(libusb_device_handle* pointer, uint8_t index, unsigned char* data, int length)
{
    const auto lock = UsbAccess::lock();
    const libusb_device_handle& handle = usb().handle(pointer);
    if (index == 0 || length < 1)
        return LIBUSB_ERROR_INVALID_PARAM;
    if (handle.device->falcon == nullptr)
        return LIBUSB_ERROR_NO_DEVICE;
    const std::string_view strings[] = {"Novint", "FALCON HAPTIC", handle.device->serial};
    if (index > std::size(strings))
        return LIBUSB_ERROR_PIPE;
    const std::string_view text = strings[index - 1].substr(0, static_cast<std::size_t>(length) - 1);
    std::copy(text.begin(), text.end(), data);
    data[text.size()] = 0;
    return static_cast<int>(text.size());
}

int libusb_set_auto_detach_kernel_driver(libusb_device_handle* pointer, int enable)
{
    const auto lock = UsbAccess::lock();
    usb().handle(pointer).autoDetach = enable != 0;
    return LIBUSB_SUCCESS;
}

int libusb_kernel_driver_active(libusb_device_handle* pointer, int /*interface*/)
{
    const auto lock = UsbAccess::lock();
    const libusb_device_handle& handle = usb().handle(pointer);
    if (handle.device->falcon == nullptr)
        return LIBUSB_ERROR_NO_DEVICE;
    return UsbAccess::kernelDriver(*handle.device->falcon) ? 1 : 0;
}

int libusb_detach_kernel_driver(libusb_device_handle* pointer, int /*interface*/)
{
    const auto lock = UsbAccess::lock();
    const libusb_device_handle& handle = usb().handle(pointer);
    if (handle.device->falcon == nullptr)
        return LIBUSB_ERROR_NO_DEVICE;
    return std::exchange(UsbAccess::kernelDriver(*handle.device->falcon), false) ? LIBUSB_SUCCESS
                                                                                 : LIBUSB_ERROR_NOT_FOUND;
}

int libusb_set_configuration(libusb_device_handle* pointer, int configuration)
{
    const auto lock = UsbAccess::lock();
    libusb_device_handle& handle = usb().handle(pointer);
    support::EmulatedFalcon* const falcon = handle.device->falcon;
    if (falcon == nullptr)
        return LIBUSB_ERROR_NO_DEVICE;
    if (UsbAccess::claimed(*falcon) || UsbAccess::kernelDriver(*falcon) || UsbAccess::isBusy(*falcon))
        return LIBUSB_ERROR_BUSY;
    if (configuration != 1)
        return LIBUSB_ERROR_NOT_FOUND;
    return LIBUSB_SUCCESS;
}

int libusb_get_configuration(libusb_device_handle* pointer, int* configuration)
{
    const auto lock = UsbAccess::lock();
    const libusb_device_handle& handle = usb().handle(pointer);
    if (handle.device->falcon == nullptr)
        return LIBUSB_ERROR_NO_DEVICE;
    *configuration = handle.configuration;
    return LIBUSB_SUCCESS;
}

int libusb_claim_interface(libusb_device_handle* pointer, int interface)
{
    const auto lock = UsbAccess::lock();
    libusb_device_handle& handle = usb().handle(pointer);
    if (interface != 0)
        return LIBUSB_ERROR_NOT_FOUND;
    if (handle.claimed)
        return LIBUSB_SUCCESS;
    if (handle.device->falcon != nullptr)
        UsbAccess::hardware(*handle.device->falcon).reach(support::Moment::Claim);
    UsbAccess::advance(Clock::now());
    support::EmulatedFalcon* const falcon = handle.device->falcon;
    if (falcon == nullptr)
        return LIBUSB_ERROR_NO_DEVICE;
    if (UsbAccess::isBusy(*falcon) || UsbAccess::claimed(*falcon))
        return LIBUSB_ERROR_BUSY;
    if (UsbAccess::kernelDriver(*falcon)) {
        if (!handle.autoDetach)
            return LIBUSB_ERROR_BUSY;
        UsbAccess::kernelDriver(*falcon) = false;
        handle.detached = true;
    }
    handle.claimed = true;
    UsbAccess::claimed(*falcon) = true;
    return LIBUSB_SUCCESS;
}

int libusb_reset_device(libusb_device_handle* pointer)
{
    const auto lock = UsbAccess::lock();
    return usb().handle(pointer).device->falcon == nullptr ? LIBUSB_ERROR_NOT_FOUND : LIBUSB_SUCCESS;
}

int libusb_clear_halt(libusb_device_handle* pointer, unsigned char /*endpoint*/)
{
    const auto lock = UsbAccess::lock();
    return usb().handle(pointer).device->falcon == nullptr ? LIBUSB_ERROR_NO_DEVICE : LIBUSB_SUCCESS;
}

int libusb_hotplug_register_callback(libusb_context* pointer, int events, int flags, int vendor, int product,
                                     int /*deviceClass*/, libusb_hotplug_callback_fn function, void* user,
                                     libusb_hotplug_callback_handle* number)
{
    auto lock = UsbAccess::lock();
    libusb_context& context = usb().context(pointer);
    constexpr int kBoth = LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT;
    if (events == 0 || (events & ~kBoth) != 0 || function == nullptr)
        return LIBUSB_ERROR_INVALID_PARAM;
    const int made = ++context.lastCallback;
    context.callbacks.push_back({made, events, vendor, product, function, user});
    if (number != nullptr)
        *number = made;
    if ((flags & LIBUSB_HOTPLUG_ENUMERATE) == 0)
        return LIBUSB_SUCCESS;
    // Like libusb, calls the callbacks from here, not from libusb_handle_events.
    std::vector<libusb_device*> present;
    for (const auto& device : usb().devices)
        if (device->context == &context && device->falcon != nullptr) {
            ++device->references;
            present.push_back(device.get());
        }
    for (libusb_device* const device : present) {
        support::callFor(context, {device, LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED}, lock, made);
        --device->references;
    }
    usb().dropUnusedDevices();
    return LIBUSB_SUCCESS;
}

void libusb_hotplug_deregister_callback(libusb_context* pointer, libusb_hotplug_callback_handle number)
{
    const auto lock = UsbAccess::lock();
    support::forgetCallback(usb().context(pointer), number);
}

}  // extern "C"
