#include "device/probe.h"
#include "device/buffer.h"
#include "guide/eigenmode.h"
#include "shared/features.h"
#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace nacre::test {
namespace {

using namespace shared;

static_assert(sizeof(Probe) == 96, "as in probe.cl");

// Neither it nor programs are ever released: when static objects go, Oclgrind has gone.
const device::Device &the_device() {
    static const auto *const device = new device::Device(device::open_device());
    return *device;
}

const cl::Program &program_for(std::uint32_t features) {
    static auto &programs = *new std::map<std::uint32_t, cl::Program>;
    const auto found = programs.find(features);
    if (found != programs.end()) return found->second;
    device::Variant variant;
    variant.entry = "probe.cl";
    variant.features = features;
    return programs[features] = device::build(the_device(), variant).program;
}

Estimate estimate(const std::vector<float> &values, std::size_t width, std::size_t at, double scale) {
    const std::size_t n = values.size() / width;
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < n; ++i) sum += values[i * width + at] * scale;
    const double mean = sum / double(n);
    for (std::size_t i = 0; i < n; ++i) squares += std::pow(values[i * width + at] * scale - mean, 2);
    return {mean, std::sqrt(squares / double(n - 1) / double(n))};
}

} // namespace

std::vector<float> run_probe(const char *name, const Probe &probe, std::size_t items, std::size_t width,
                             ChannelSampling sampling, std::uint32_t features, const std::vector<float> &initial,
                             const std::vector<GuideMode> &modes) {
    const device::Device &device = the_device();
    features |= FEATURE_SUBSURFACE;
    if (probe.bleed > 0) features |= FEATURE_BLEED;
    if (probe.anisotropy != 0) features |= FEATURE_ANISOTROPY;
    Frame frame{};
    frame.features = features;
    frame.channel_sampling = sampling;
    const cl::Buffer frames(device.context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, sizeof frame, &frame);
    const cl::Buffer out(device.context, CL_MEM_READ_WRITE, items * width * sizeof(float));
    if (!initial.empty()) device.queue.enqueueWriteBuffer(out, true, 0, initial.size() * sizeof(float), initial.data());
    cl::Kernel kernel(program_for(features), name);
    kernel.setArg(0, frames);
    kernel.setArg(1, sizeof probe, &probe);
    kernel.setArg(2, out);
    const cl::Buffer guide = device::constant_buffer<GuideMode>(device, modes);
    if (kernel.getInfo<CL_KERNEL_NUM_ARGS>() > 3) kernel.setArg(3, guide);
    const std::size_t group = std::size_t(device.quirks.work_group);
    device.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange((items + group - 1) / group * group),
                                      cl::NDRange(group));
    std::vector<float> values(items * width);
    device.queue.enqueueReadBuffer(out, true, 0, values.size() * sizeof(float), values.data());
    return values;
}

Walks run_walks(Probe probe, std::uint32_t walks, ChannelSampling sampling, Guiding guiding) {
    constexpr std::size_t items = 2048, width = 24;
    probe.count = std::max<std::uint32_t>(1, walks / items);
    if (probe.walk_anisotropy.w == 0) probe.walk_anisotropy = {probe.anisotropy, probe.anisotropy, probe.anisotropy, 0};
    if (probe.a == 0) probe.a = 1;
    const float4 albedo = probe.albedo, g = probe.walk_anisotropy;
    std::uint32_t features = 0;
    if (g.x != g.y || g.x != g.z) features = FEATURE_ANISOTROPY | FEATURE_ANISOTROPY_RGB;
    std::vector<GuideMode> modes;
    if (guiding != GUIDING_NONE) {
        features |= guiding == GUIDING_EIGEN ? FEATURE_GUIDE_EIGEN : FEATURE_GUIDE_DWIVEDI;
        for (const auto &[alpha, anisotropy] : {std::pair{albedo.x, g.x}, {albedo.y, g.y}, {albedo.z, g.z}})
            modes.push_back(guide::guide_mode(double(alpha), double(anisotropy), guiding == GUIDING_DWIVEDI));
    }
    const std::vector<float> values = run_probe("probe_walk", probe, items, width, sampling, features, {}, modes);
    const double scale = 1.0 / probe.count;
    Walks result;
    for (std::size_t c = 0; c < 3; ++c) {
        result.near[c] = estimate(values, width, c, scale);
        result.far[c] = estimate(values, width, 8 + c, scale);
    }
    result.unscattered = estimate(values, width, 3, scale);
    result.length = estimate(values, width, 15, scale);
    for (std::size_t n = 0; n < 8; ++n) result.by_scatters[n] = estimate(values, width, 16 + n, scale);
    for (std::size_t i = 0; i < items; ++i) result.largest = std::max(result.largest, double(values[i * width + 11]));
    return result;
}

Walks run_walks_to(Probe probe, double largest_error, ChannelSampling sampling, Guiding guiding) {
    constexpr double most_variance = 25; // of a walk that is no bug: a broken one would have us walk for ever
    const double most_rounds = 16 + most_variance / (largest_error * largest_error) / (1 << 17);
    Walks sum = run_walks(probe, 1 << 17, sampling, guiding);
    for (int rounds = 1;; ++rounds) {
        double worst = 0;
        for (const auto &side : {sum.near, sum.far})
            for (const Estimate &channel : side) worst = std::max(worst, channel.error);
        if (worst <= largest_error || rounds > most_rounds) return sum;
        ++probe.seed;
        const Walks more = run_walks(probe, 1 << 17, sampling, guiding);
        for (const auto side : {&Walks::near, &Walks::far})
            for (std::size_t c = 0; c < 3; ++c) {
                Estimate &total = (sum.*side)[c];
                const Estimate &part = (more.*side)[c];
                total.mean += (part.mean - total.mean) / (rounds + 1);
                total.error = std::hypot(total.error * rounds, part.error) / (rounds + 1);
            }
        sum.largest = std::max(sum.largest, more.largest);
    }
}

void expect_exact(const Estimate &found, double exact, double largest_error, const char *what) {
    EXPECT_LE(std::abs(found.mean - exact), 4 * found.error)
        << what << ": found " << found.mean << " +- " << found.error << ", exact " << exact;
    EXPECT_LE(found.error, largest_error) << what << ": too few walks";
}

} // namespace nacre::test
