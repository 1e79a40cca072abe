// The functions of kernels/exact/builtins.h and kernels/lanes/scalar.h against double: what --exact renders with is no
// worse than the built-ins.
#include "device/exact.h"
#include "device/program.h"
#include "shared/types.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace nacre::test {
namespace {

using shared::float4;

std::vector<float> run_exact(std::vector<float4> vectors) {
    const device::Device device = device::open_device();
    device::Variant variant;
    variant.entry = "probe_exact.cl";
    variant.exact = true;
    cl::Kernel kernel(device::build(device, variant).program, "probe_exact");
    const std::size_t group = std::size_t(device.quirks.work_group);
    const std::size_t items = (vectors.size() / 2 + group - 1) / group * group;
    vectors.resize(2 * items); // with zeros, unheeded
    const cl::Buffer from(device.context, CL_MEM_READ_ONLY, vectors.size() * sizeof(float4));
    const cl::Buffer to(device.context, CL_MEM_WRITE_ONLY, 7 * items * sizeof(float));
    device.queue.enqueueWriteBuffer(from, true, 0, vectors.size() * sizeof(float4), vectors.data());
    kernel.setArg(0, from);
    kernel.setArg(1, to);
    device.queue.enqueueNDRangeKernel(kernel, cl::NullRange, items, group);
    std::vector<float> out(7 * items);
    device.queue.enqueueReadBuffer(to, true, 0, out.size() * sizeof(float), out.data());
    return out;
}

/// Components of any sign and of sizes 1e-12 to 1e12, all three of about the same one; w in [0, 1].
std::vector<float4> vectors(std::size_t count) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(-1, 1);
    std::vector<float4> all(count);
    for (float4 &v : all) {
        const float size = std::pow(10.0f, 12 * unit(random));
        v = {size * unit(random), size * unit(random), size * unit(random), std::abs(unit(random))};
    }
    return all;
}

TEST(Exact, Functions) {
    const std::vector<float4> in = vectors(1 << 17);
    const std::vector<float> out = run_exact(in);
    constexpr double u = 0x1p-24;
    std::array<double, 7> worst{};
    const auto note = [&](std::size_t k, float found, double exact, double scale) {
        worst[k] = std::max(worst[k], std::abs(found - exact) / scale);
    };
    for (std::size_t i = 0; i < in.size() / 2; ++i) {
        const float4 &a = in[2 * i], &b = in[2 * i + 1];
        const double ax = a.x, ay = a.y, az = a.z, bx = b.x, by = b.y, bz = b.z;
        const float *found = &out[7 * i];
        const double length = std::sqrt(ax * ax + ay * ay + az * az);
        note(0, found[0], ax * bx + ay * by + az * bz, std::abs(ax * bx) + std::abs(ay * by) + std::abs(az * bz));
        note(1, found[1], length, length);
        note(2, found[2], 1, 1);
        const double across = std::hypot(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx);
        if (across > 1e-3 * length * std::hypot(bx, by, bz) && across * across > 1e-30 && across * across < 1e30)
            note(3, found[3], across * across, across * across);
        note(4, found[4], std::atan2(ay, ax), std::abs(std::atan2(ay, ax)));
        note(5, found[5], ax / length, 1);
        note(6, found[6], ax + (bx - ax) * a.w, std::abs(ax) + std::abs(bx));
    }
    const std::array<double, 7> bounds{3 * u, 4 * u, 8 * u, 4000 * u, 6 * u, 4 * u, 3 * u};
    for (std::size_t k = 0; k < 7; ++k)
        EXPECT_LE(worst[k], bounds[k]) << "number " << k << ", " << worst[k] / u << " u";
}

TEST(Exact, Edges) {
    const std::vector<float> out = run_exact({{0, 0, 0, 0}, {1, 1, 1, 1}, {0, -2, 0, 1}, {0, 0, 0, 0}});
    const std::array<float, 7> nothing{};
    for (std::size_t k = 0; k < 7; ++k) EXPECT_EQ(out[k], nothing[k]) << k;
    EXPECT_EQ(out[8], 2);
    EXPECT_FLOAT_EQ(out[11], float(-std::numbers::pi / 2));
}

} // namespace
} // namespace nacre::test
