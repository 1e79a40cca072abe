#pragma once
#include "device/context.h"
#include <span>

namespace nacre::device {

/// A read-only buffer that holds `bytes` of `data`; a null buffer for none. Where the device's memory is the host's it
/// lies in huge pages, as far as the system has them: rays jump about in a tree far larger than the reach of 4 KiB
/// pages.
cl::Buffer constant_buffer(const Device &device, const void *data, std::size_t bytes);

template <typename T> cl::Buffer constant_buffer(const Device &device, std::span<const T> list) {
    return constant_buffer(device, list.data(), list.size_bytes());
}

} // namespace nacre::device
