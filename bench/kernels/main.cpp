// Items per second of the kernels' rooms on an OpenCL device, each alone: `build/bench/kernels --benchmark_filter=log`.
#include "base/error.h"
#include "bench.h"
#include <cstdlib>
#include <fmt/format.h>

namespace nacre::bench {

const device::Device &the_device() {
    static const device::Device device = device::open_device();
    return device;
}

double kernel_seconds(const cl::Kernel &kernel, std::size_t items) {
    cl::Event event;
    the_device().queue.enqueueNDRangeKernel(kernel, cl::NullRange, items, std::size_t(the_device().quirks.work_group),
                                            nullptr, &event);
    event.wait();
    return 1e-9 * double(event.getProfilingInfo<CL_PROFILING_COMMAND_END>() -
                         event.getProfilingInfo<CL_PROFILING_COMMAND_START>());
}

} // namespace nacre::bench

int main(int argc, char **argv) {
    setenv("POCL_MAX_PTHREAD_COUNT", "1", 1); // before the first OpenCL call: figures are of one thread
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    try {
        benchmark::AddCustomContext("device", nacre::bench::the_device().info.name);
        nacre::bench::register_lanes();
        nacre::bench::register_clearance();
        nacre::bench::register_traversal();
        benchmark::RunSpecifiedBenchmarks();
    } catch (const nacre::Error &error) {
        fmt::print(stderr, "kernels: error: {}\n", error.what());
        return int(error.code);
    }
    benchmark::Shutdown();
    return 0;
}
