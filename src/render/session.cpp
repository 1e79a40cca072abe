#include "render/session.h"
#include "base/error.h"
#include "device/cache.h"
#include "device/error.h"
#include "device/kernel_info.h"
#include "render/layout.h"
#include "render/light_sides.h"
#include "render/tracer.h"
#include "scene/features.h"
#include <algorithm>
#include <chrono>

namespace nacre::render {
namespace {

using namespace shared;
using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// A launch should take about this long: progress and Ctrl-C answer, watchdogs of GPUs do not bite.
constexpr double launch_seconds = 0.1;
constexpr std::uint32_t smallest_batch = 64, first_batch = 4096, largest_batch = 1 << 18;

/// The part of the image to render. Throws Error{Exit::device} if the device cannot hold its film in one buffer.
Crop crop_that_fits(const Options &options, const scene::Scene &scene, const device::Device &device) {
    Crop crop = options.crop;
    if (crop.x1 == 0) crop = {0, 0, std::uint32_t(scene.image.width), std::uint32_t(scene.image.height)};
    const std::uint64_t columns = (crop.width() + TILE - 1) / TILE, rows = (crop.height() + TILE - 1) / TILE;
    const std::uint64_t bytes = columns * rows * TILE * TILE * options.layers.planes() * sizeof(float4);
    const std::uint64_t limit = device.info.device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
    if (bytes > limit)
        throw Error(
            Exit::device, device.info.name,
            fmt::format("a picture of {} x {} pixels needs {} MB in one buffer, this device allows {} MB; render it in "
                        "parts with --crop",
                        crop.width(), crop.height(), bytes >> 20, limit >> 20));
    return crop;
}

/// Throws Error{Exit::device} for lanes within lanes.
device::Device with_lanes(device::Device device, int wanted) {
    if (wanted > 1 && device.quirks.work_group > 1)
        throw Error(Exit::device, device.info.name,
                    fmt::format("walks one path per work-item, its work-items are lanes already; use device.lanes 0 or "
                                "1, not {}",
                                wanted));
    if (wanted > 0) device.quirks.lanes = wanted;
    return device;
}

} // namespace

struct Session::Impl {
    device::Device device;
    Layers layers;
    Crop crop;
    Clock::time_point start = Clock::now();
    Statistics statistics;
    DeviceScene scene;
    device::Program program;
    Film film;
    Timeline *timeline;
    device::Recorder recorder;
    std::unique_ptr<Tracer> tracer;
    std::uint32_t batch_size = first_batch;
    std::uint32_t full_width, full_height;
    std::uint32_t taken = 0; // samples that every pixel has

    Impl(device::Device opened, const scene::Scene &source, const Options &options)
        : device(with_lanes(std::move(opened), source.lanes)), layers(options.layers),
          crop(crop_that_fits(options, source, device)), film(crop, layers.planes()), timeline(options.timeline),
          recorder(timeline), full_width(std::uint32_t(source.image.width)),
          full_height(std::uint32_t(source.image.height)) {
        scene = upload(device, source, scene::features(source, layers.surface(), layers.scatter()), crop, timeline);
        const std::uint32_t features = scene.frame.features; // with those that only the geometry shows
        device::Variant variant;
        variant.features = options.generic ? std::uint32_t(FEATURE_ALL) : features;
        variant.generic = options.generic;
        variant.bvh_stack = scene.bvh_stack;
        variant.lanes = device.quirks.lanes;
        variant.exact = options.exact;
        variant.profile = options.profile;
        {
            const Span span(timeline, "compile");
            program = device::build(device, variant);
        }
        tracer = std::make_unique<Tracer>(device, program, scene, layers, film.pixels(),
                                          std::min(largest_batch, std::max(smallest_batch, film.pixels() * FILM_BLOCK)),
                                          options.profile, recorder);
        // Last: Oclgrind takes a buffer that comes in the place of a released one to be initialised no further than
        // that was.
        check_layout(device, program, recorder);
        measure_light_sides(device, program, scene, recorder);
        statistics.startup = scene.startup;
        statistics.startup.compile = program.seconds;
        statistics.profiled = options.profile;
        statistics.lanes = variant.lanes;
        statistics.device = device.info.name;
        statistics.program_options = device::options(device, variant);
        statistics.generic = options.generic;
        statistics.features = scene::feature_names(features);
        for (const auto &entry : scene.buffers) statistics.memory.emplace_back(entry.name, entry.bytes);
        for (const auto &entry : tracer->memory()) statistics.memory.push_back(entry);
    }

    /// Traces samples [first, first + count) of pixels [begin, ...) in one launch; returns how many pixels it took.
    std::uint32_t trace_some(std::uint32_t begin, std::uint32_t first, std::uint32_t count) {
        for (;;) {
            // Whole tiles where possible: they are what is close together.
            std::uint32_t pixels = std::max(1u, batch_size / count);
            if (pixels > TILE * TILE) pixels -= pixels % (TILE * TILE);
            pixels = std::min(pixels, film.pixels() - begin);
            try {
                const Clock::time_point launched = Clock::now();
                statistics.sampling += tracer->trace({begin, pixels, first, count, 0, 0, 0, 0});
                if (statistics.startup.first_pixel == 0) {
                    statistics.startup.first_pixel = since(start);
                    device::finish_compiling();
                } else {
                    adapt(since(launched), pixels * count);
                }
                film.count_samples(begin, pixels, count);
                return pixels;
            } catch (const cl::Error &error) {
                if (!device::is_out_of_resources(error) || batch_size <= smallest_batch) throw;
                batch_size /= 2;
            }
        }
    }

    /// Brings launches towards launch_seconds, at most doubling.
    void adapt(double seconds, std::uint32_t paths) {
        const double wanted = paths * std::clamp(launch_seconds / seconds, 0.25, 2.0);
        batch_size = std::uint32_t(std::clamp(wanted, double(smallest_batch), double(largest_batch)));
    }

    bool render(std::uint32_t spp, const std::function<void(const Progress &)> &report, const std::atomic<bool> *stop) {
        const Span span(timeline, "render");
        const Clock::time_point began = Clock::now();
        const double inside =
            double(crop.width()) * crop.height() / film.pixels(); // share of pixels that are in the crop
        Progress progress;
        progress.wanted = std::uint64_t(spp) * crop.width() * crop.height();
        bool stopped = false;
        for (std::uint32_t sample = 0; sample < spp && !stopped;) {
            // A first look soon, then more samples at once: neighbouring paths meet the same geometry. Never across a
            // block.
            const std::uint32_t in_block = sample % FILM_BLOCK;
            const std::uint32_t count =
                std::min({spp - sample, FILM_BLOCK - in_block, in_block == 0 ? sample == 0 ? 1u : 16u : in_block, 16u});
            for (std::uint32_t pixel = 0; pixel < film.pixels() && !stopped;) {
                const std::uint32_t taken = trace_some(pixel, sample, count);
                pixel += taken;
                progress.samples += std::uint64_t(inside * taken * count);
                tracer->take_counters(statistics);
                progress.seconds = since(began);
                progress.sampling = statistics.sampling;
                progress.rays = statistics.rays();
                if (report) report(progress);
                stopped = stop && stop->load();
            }
            sample += count;
            if (!stopped) taken = sample;
            if (stopped || sample == spp || sample % FILM_BLOCK == 0) film.add(tracer->take_film());
        }
        recorder.settle();
        return !stopped;
    }
};

Session::Session(device::Device device, const scene::Scene &scene, const Options &options) {
    const std::string name = device.info.name;
    try {
        impl = std::make_unique<Impl>(std::move(device), scene, options);
    } catch (const cl::Error &error) {
        throw device::device_error(name, error);
    }
}

Session::~Session() = default;

bool Session::render(std::uint32_t spp, const std::function<void(const Progress &)> &report,
                     const std::atomic<bool> *stop) {
    try {
        return impl->render(spp, report, stop);
    } catch (const cl::Error &error) {
        throw device::device_error(impl->device.info.name, error);
    }
}

io::Picture Session::picture() const {
    io::Picture picture = impl->film.picture(impl->layers, impl->scene.unit, impl->scene.length);
    picture.full_width = int(impl->full_width);
    picture.full_height = int(impl->full_height);
    picture.metadata = {{"scene", impl->scene.hash},
                        {"kernel", impl->program.hash},
                        {"device", impl->device.info.name},
                        {"seed", std::to_string(impl->scene.frame.seed)},
                        {"samples", fmt::format("0:{}", impl->taken)},
                        {"features", fmt::format("{}", fmt::join(impl->statistics.features, " "))},
                        {"seconds", fmt::format("{:.3f}", impl->statistics.sampling)}};
    return picture;
}

Statistics Session::statistics() const {
    Statistics statistics = impl->statistics;
    statistics.samples = impl->film.total_samples();
    statistics.total = since(impl->start);
    statistics.startup.code_generation = impl->recorder.code_generation();
    for (const device::KernelInfo &info : device::kernel_infos(impl->device, impl->program)) {
        Statistics::Kernel &kernel = statistics.kernels.emplace_back();
        kernel.compiled = info;
        for (const device::Recorder::Kernel &ran : impl->recorder.kernels())
            if (ran.name == info.name) {
                kernel.launches = ran.launches;
                kernel.seconds = ran.seconds;
            }
    }
    if (statistics[COUNTER_non_finite] > 0) {
        const std::uint64_t pixel = statistics.bad_pixel_x - 1; // the kernel stores the pixel's number + 1
        statistics.bad_pixel_x = pixel % impl->full_width;
        statistics.bad_pixel_y = pixel / impl->full_width;
    }
    return statistics;
}

} // namespace nacre::render
