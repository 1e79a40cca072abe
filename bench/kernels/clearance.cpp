// Look-ups in the clearance field of the blob, at two sizes. An item is one lane's look-up.
#include "accel/clearance.h"
#include "bench.h"
#include "device/buffer.h"
#include "meshes.h"
#include <Eigen/Geometry>
#include <fmt/format.h>

namespace nacre::bench {
namespace {

using namespace shared;

constexpr std::size_t work_items = 4096, repeats = 256;

std::vector<accel::Triangle> blob() {
    const scene::Mesh mesh = make_blob(64);
    std::vector<accel::Triangle> triangles;
    for (const auto &corner : mesh.triangles) {
        accel::Triangle &triangle = triangles.emplace_back();
        for (std::size_t k = 0; k < 3; k++) triangle.v[k] = mesh.positions[corner[k]].cast<float>();
    }
    return triangles;
}

void measure(benchmark::State &state, int cells, int lanes) {
    const device::Device &device = the_device();
    const std::vector<accel::Triangle> triangles = blob();
    Eigen::AlignedBox3f box;
    for (const accel::Triangle &triangle : triangles)
        for (const Vec3f &vertex : triangle.v) box.extend(vertex);
    const Vec3f size = box.sizes();
    const accel::ClearanceField field =
        accel::build_clearance(triangles, size.maxCoeff() / float(cells), std::size_t(1) << 30);
    std::vector<float> numbers(work_items * std::size_t(lanes));
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = (float(i) + .5f) / float(2 * numbers.size());

    device::Variant variant;
    variant.entry = "probe_bench.cl";
    variant.features = 0;
    variant.lanes = lanes;
    variant.extra = fmt::format("-DREPEATS={}", repeats);
    cl::Kernel kernel(device::build(device, variant).program, "bench_clearance");
    const cl::Buffer in = device::constant_buffer<float>(device, numbers);
    const cl::Buffer out(device.context, CL_MEM_WRITE_ONLY, numbers.size() * sizeof(float));
    const cl::Buffer info = device::constant_buffer(device, &field.info, sizeof field.info);
    const cl::Buffer bricks = device::constant_buffer<std::uint8_t>(device, field.bricks);
    kernel.setArg(0, in);
    kernel.setArg(1, out);
    kernel.setArg(2, info);
    kernel.setArg(3, bricks);
    kernel.setArg(4, float4{size.x(), size.y(), size.z(), 0});
    kernel_seconds(kernel, work_items); // PoCL generates code at the first launch
    for (auto _ : state) state.SetIterationTime(kernel_seconds(kernel, work_items));
    state.SetItemsProcessed(state.iterations() * std::int64_t(numbers.size() * repeats));
}

} // namespace

void register_clearance() {
    for (const int cells : {64, 256})
        for (const int lanes : {1, 4, 8, 16})
            benchmark::RegisterBenchmark(fmt::format("clearance/{}/{}", cells, lanes).c_str(), measure, cells, lanes)
                ->UseManualTime()
                ->Unit(benchmark::kMillisecond);
}

} // namespace nacre::bench
