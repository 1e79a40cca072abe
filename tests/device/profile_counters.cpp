// What kernels with -DPROFILE count arrives: sums, the histogram of steps per walk, its percentiles.
#include "device/context.h"
#include "device/source.h"
#include "render/profile.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace nacre {
namespace {

using namespace shared;

/// Every work-item notes one walk of steps[i] and counts its index.
constexpr const char *counting = R"(
kernel void count_all(global const uint *steps, volatile global uint *counters) {
    const uint i = (uint)get_global_id(0);
    Counts counts = no_counts();
    COUNT_WALK(&counts, steps[i])
    COUNT_PROFILE(&counts, walk_blocks, i)
    COUNT_PROFILE(&counts, clear_steps, 2u)
    PROFILED(uint *visits = counts.profile + PROFILE_shadow_nodes; visits[0] += 3u; visits[1] += 5u;)
    add_counts(&counts, counters);
})";

render::Profile counted(const std::vector<uint> &steps) {
    const device::Device device = device::open_device();
    cl::Program program(device.context, device::assemble("path/count.h") + counting);
    program.build({device.info.device}, "-cl-std=CL1.2 -DPROFILE");
    cl::Kernel kernel(program, "count_all");
    const cl::Buffer in(device.context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, steps.size() * sizeof(uint),
                        const_cast<uint *>(steps.data()));
    std::vector<uint> words(PROFILE_WORDS);
    const cl::Buffer out(device.context, CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, words.size() * sizeof(uint),
                         words.data());
    kernel.setArg(0, in);
    kernel.setArg(1, out);
    device.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(steps.size()));
    device.queue.enqueueReadBuffer(out, true, 0, words.size() * sizeof(uint), words.data());
    EXPECT_TRUE(std::all_of(words.begin(), words.begin() + PROFILE_TAIL, [](uint word) { return word == 0; }))
        << "nothing was counted but for the profile";
    render::Profile profile;
    profile.add(words);
    return profile;
}

TEST(ProfileCounters, SumsArrive) {
    const std::uint64_t n = 1000;
    const render::Profile profile = counted(std::vector<uint>(n, 7));
    EXPECT_EQ(profile[PROFILE_walk_blocks], n * (n - 1) / 2);
    EXPECT_EQ(profile[PROFILE_clear_steps], 2 * n);
    EXPECT_EQ(profile[PROFILE_shadow_nodes], 3 * n);
    EXPECT_EQ(profile[PROFILE_shadow_blocks], 5 * n);
    EXPECT_EQ(profile[PROFILE_ray_nodes], 0u);
    EXPECT_EQ(profile.walks(), n);
    EXPECT_EQ(profile.most_steps, 7u);
    EXPECT_EQ(profile.percentile(0.5), 7);
}

// Around every edge of a bin: it falls into the bin whose edges the host names.
TEST(ProfileCounters, BinsAreWhatTheHostTakesThemFor) {
    std::vector<uint> steps;
    std::array<std::uint64_t, PROFILE_BINS> expected{};
    for (std::uint32_t bin = 0; bin < PROFILE_BINS; ++bin) {
        const auto first = render::first_of_bin(bin),
                   last = bin + 1 < PROFILE_BINS ? render::first_of_bin(bin + 1) - 1 : 0xffffffffu;
        EXPECT_LE(double(last - first), bin + 1 < PROFILE_BINS ? 0.25 * double(first) : 1e10) << bin;
        for (const auto value : {first, last}) {
            steps.push_back(uint(value));
            ++expected[bin];
        }
    }
    const render::Profile profile = counted(steps);
    EXPECT_EQ(profile.histogram, expected);
    EXPECT_EQ(profile.most_steps, 0xffffffffu);
}

// Against the sorted list; a quarter of an octave is at most a fourth of the value.
TEST(ProfileCounters, Percentiles) {
    std::mt19937 random(5);
    std::lognormal_distribution<double> lengths(2.5, 1.5);
    std::vector<uint> steps(20000);
    for (uint &value : steps) value = uint(lengths(random));
    const render::Profile profile = counted(steps);
    std::sort(steps.begin(), steps.end());
    EXPECT_EQ(profile.most_steps, steps.back());
    for (const double share : {0.01, 0.1, 0.5, 0.9, 0.99, 0.999, 1.0}) {
        const double exact = steps[std::size_t(std::ceil(share * double(steps.size()))) - 1];
        EXPECT_NEAR(profile.percentile(share), exact, exact < 8 ? 0 : 0.1 * exact) << share;
    }
}

TEST(ProfileCounters, NothingWalkedNothingKnown) { EXPECT_EQ(render::Profile().percentile(0.5), 0); }

} // namespace
} // namespace nacre
