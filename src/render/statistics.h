#pragma once
#include "accel/bvh.h"
#include "device/kernel_info.h"
#include "render/profile.h"
#include "shared/counters.h"
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace nacre::render {

/// Where the time before the first pixels went, in seconds of wall time.
struct Startup {
    double device = 0, load = 0; // opening the device, reading the scene
    double bvh = 0, clearance = 0, lights = 0;
    accel::BuildTimes bvh_parts;
    double upload = 0;
    double compile = 0;         // or loading the binary
    double code_generation = 0; // of kernels by their first launch, as PoCL does it
    double first_pixel = 0;     // from the start to the end of the first launch: all of the above, and that launch
};

/// What a render did and what it cost. Seconds are wall time but for `sampling`, which is that of the kernels alone.
struct Statistics {
    Startup startup;
    double sampling = 0, total = 0;
    std::uint64_t samples = 0;
    std::vector<std::pair<std::string, std::size_t>> memory; // bytes by buffer
    std::vector<std::string> features;
    std::array<std::uint64_t, shared::COUNTER_COUNT> counters{};
    std::string device, program_options;
    bool generic = false;
    int lanes = 1;
    std::uint64_t bad_pixel_x = 0, bad_pixel_y = 0, bad_sample = 0, bad_step = 0; // first NaN or infinity, if any

    struct Kernel {
        device::KernelInfo compiled;
        std::uint64_t launches = 0;
        double seconds = 0; // of all launches
    };
    std::vector<Kernel> kernels;

    /// Of an adaptive render.
    struct Adaptive {
        double target = 0, reached = 0; // relative error: allocation.h, Film::relative_error
        double converged = 0;           // share of the tiles that reach the target within the most samples allowed
        std::uint64_t shown = 0;        // of the samples, those in the picture; the others only helped to decide
    };
    std::optional<Adaptive> adaptive;

    bool profiled = false; // `profile` has been counted
    Profile profile;

    std::uint64_t operator[](shared::Counter counter) const { return counters[counter]; }

    /// All rays that were traced.
    std::uint64_t rays() const;
    /// Of the turns of all lanes, the share that had a walk; 0 if there was none.
    double lane_occupancy() const;
    /// The document of `--stats`.
    std::string json() const;
    /// What a user must know: energy lost, walks that slipped through, NaNs. One line each.
    std::vector<std::string> remarks() const;
};

/// a / b, 0 where b is 0: what there was nothing of has no rate and no mean.
double ratio(double a, double b);

} // namespace nacre::render
