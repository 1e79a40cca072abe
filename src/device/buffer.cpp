#include "device/buffer.h"
#include <cstdint>
#include <cstring>
#include <sys/mman.h>

namespace nacre::device {
namespace {

constexpr std::uintptr_t huge_page = 2 << 20;

/// Asks for huge pages before the memory is touched. Only a hint: without them everything is as before, but slower.
void advise_huge_pages(void *memory, std::size_t bytes) {
    const std::uintptr_t begin = (std::uintptr_t(memory) + huge_page - 1) / huge_page * huge_page;
    const std::uintptr_t end = (std::uintptr_t(memory) + bytes) / huge_page * huge_page;
    if (begin < end) madvise(reinterpret_cast<void *>(begin), end - begin, MADV_HUGEPAGE);
}

} // namespace

cl::Buffer constant_buffer(const Device &device, const void *data, std::size_t bytes) {
    if (bytes == 0) return {};
    cl::Buffer buffer(device.context, CL_MEM_READ_ONLY | CL_MEM_ALLOC_HOST_PTR, bytes);
    void *mapped = device.queue.enqueueMapBuffer(buffer, true, CL_MAP_WRITE_INVALIDATE_REGION, 0, bytes);
    advise_huge_pages(mapped, bytes);
    std::memcpy(mapped, data, bytes);
    device.queue.enqueueUnmapMemObject(buffer, mapped);
    return buffer;
}

} // namespace nacre::device
