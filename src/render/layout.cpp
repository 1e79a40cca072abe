#include "render/layout.h"
#include "base/error.h"
#include "shared/guide.h"
#include "shared/path.h"
#include "shared/returned.h"
#include "shared/scene.h"
#include <array>

namespace nacre::render {
namespace {

using namespace shared;

static_assert(sizeof(Camera) == 96 && offsetof(Camera, kind) == 64);
static_assert(sizeof(Material) == 16 * (PARAMETER_COUNT + 1) + 4 * PARAMETER_COUNT + 72 && sizeof(Material) % 16 == 0);
static_assert(sizeof(Texture) == 48 && sizeof(Object) == 80 && sizeof(AliasEntry) == 8);
static_assert(sizeof(Light) == 112 && offsetof(Light, kind) == 80);
static_assert(sizeof(Frame) % 16 == 0 && offsetof(Frame, width) == 96);
static_assert(sizeof(Path) % 16 == 0 && offsetof(Path, bleed) == 224);
static_assert(sizeof(Batch) == 32 && sizeof(GuideMode) == 64 && sizeof(LightSides) == 48 && sizeof(Slab) == 32);

struct Size {
    const char *name;
    std::size_t bytes;
};

// In the order of the kernel `layout`.
constexpr std::array<Size, 13> sizes = {{{"Camera", sizeof(Camera)},
                                         {"Material", sizeof(Material)},
                                         {"Texture", sizeof(Texture)},
                                         {"Object", sizeof(Object)},
                                         {"Light", sizeof(Light)},
                                         {"AliasEntry", sizeof(AliasEntry)},
                                         {"Frame", sizeof(Frame)},
                                         {"Path", sizeof(Path)},
                                         {"Batch", sizeof(Batch)},
                                         {"Clearance", sizeof(Clearance)},
                                         {"GuideMode", sizeof(GuideMode)},
                                         {"LightSides", sizeof(LightSides)},
                                         {"Slab", sizeof(Slab)}}};

} // namespace

void check_layout(const device::Device &device, const device::Program &program, device::Recorder &recorder) {
    cl::Kernel kernel(program.program, "layout");
    const cl::Buffer buffer(device.context, CL_MEM_WRITE_ONLY, sizes.size() * sizeof(uint));
    kernel.setArg(0, buffer);
    recorder.run(device, kernel, 1);
    std::array<uint, sizes.size()> found{};
    device.queue.enqueueReadBuffer(buffer, true, 0, sizeof found, found.data());
    for (std::size_t i = 0; i < sizes.size(); ++i)
        if (found[i] != sizes[i].bytes)
            throw Error(Exit::device, device.info.name,
                        fmt::format("lays out struct {} in {} bytes, the program in {}; this device cannot be used",
                                    sizes[i].name, found[i], sizes[i].bytes));
}

} // namespace nacre::render
