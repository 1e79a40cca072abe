// Rooms that are written over lanes: mathematics, phase, flight. An item is one lane's call.
#include "bench.h"
#include "shared/features.h"
#include <fmt/format.h>
#include <map>

namespace nacre::bench {
namespace {

using namespace shared;

constexpr std::size_t work_items = 4096, repeats = 256;

struct Case {
    const char *name, *kernel;
    float anisotropy = 0, bleed = 0;
};

constexpr Case cases[] = {
    {"loop", "bench_nothing"}, // what the loop around every other one takes
    {"math/log", "bench_log"},
    {"math/exp", "bench_exp"},
    {"math/log1p", "bench_log1p"},
    {"math/expm1", "bench_expm1"},
    {"math/sincos", "bench_sincos"},
    {"math/hash", "bench_hash"},
    {"phase/sample/g=0", "bench_phase_sample"},
    {"phase/sample/g=.8", "bench_phase_sample", .8f},
    {"phase/pdf/g=.8", "bench_phase_pdf", .8f},
    {"flight/sample/b=0", "bench_flight_sample"},
    {"flight/sample/b=.5", "bench_flight_sample", 0, .5f},
    {"flight/density/b=0", "bench_flight_density"},
    {"flight/density/b=.5", "bench_flight_density", 0, .5f},
};

/// Compiled for the features that the case needs and no more, as for a scene.
cl::Kernel kernel_for(const Case &c, int lanes) {
    static std::map<std::pair<int, std::uint32_t>, cl::Program> programs;
    device::Variant variant;
    variant.entry = "probe_bench.cl";
    variant.features = FEATURE_SUBSURFACE | (c.anisotropy != 0 ? std::uint32_t(FEATURE_ANISOTROPY) : 0) |
                       (c.bleed > 0 ? std::uint32_t(FEATURE_BLEED) : 0);
    variant.lanes = lanes;
    variant.extra = fmt::format("-DREPEATS={}", repeats);
    cl::Program &program = programs[{lanes, variant.features}];
    if (!program()) program = device::build(the_device(), variant).program;
    return cl::Kernel(program, c.kernel);
}

void measure(benchmark::State &state, const Case &c, int lanes) {
    const device::Device &device = the_device();
    std::vector<float> numbers(work_items * std::size_t(lanes));
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = (float(i) + .5f) / float(2 * numbers.size());
    const cl::Buffer in(device.context, CL_MEM_READ_ONLY, numbers.size() * sizeof(float));
    const cl::Buffer out(device.context, CL_MEM_WRITE_ONLY, numbers.size() * sizeof(float));
    device.queue.enqueueWriteBuffer(in, true, 0, numbers.size() * sizeof(float), numbers.data());
    cl::Kernel kernel = kernel_for(c, lanes);
    kernel.setArg(0, in);
    kernel.setArg(1, out);
    kernel.setArg(2, c.anisotropy);
    kernel.setArg(3, c.bleed);
    kernel_seconds(kernel, work_items); // PoCL generates code at the first launch
    for (auto _ : state) state.SetIterationTime(kernel_seconds(kernel, work_items));
    state.SetItemsProcessed(state.iterations() * std::int64_t(numbers.size() * repeats));
}

} // namespace

void register_lanes() {
    for (const Case &c : cases)
        for (const int lanes : {1, 4, 8, 16})
            benchmark::RegisterBenchmark(fmt::format("{}/{}", c.name, lanes).c_str(), measure, c, lanes)
                ->UseManualTime()
                ->Unit(benchmark::kMillisecond);
}

} // namespace nacre::bench
