#include "render/session.h"
#include "base/error.h"
#include "device/cache.h"
#include "device/error.h"
#include "device/kernel_info.h"
#include "render/allocation.h"
#include "render/layout.h"
#include "render/measure.h"
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
constexpr double largest_growth = 16;         // of a launch over the one before
constexpr std::uint32_t samples_at_once = 16; // of a pixel: neighbouring paths meet the same geometry
constexpr std::uint32_t smallest_batch = 64, first_batch = 4096, largest_batch = 1 << 18;

std::uint32_t halves_of(const Options &options) { return options.error > 0 ? 2 : 1; }

/// Paths of a launch, where a render takes as many between two looks at its film.
std::uint32_t capacity_for(std::uint64_t paths) { return std::uint32_t(std::min<std::uint64_t>(largest_batch, paths)); }

/// The part of the image to render. Throws Error{Exit::device} if the device cannot hold its film in one buffer.
Crop crop_that_fits(const Options &options, const scene::Scene &scene, const device::Device &device) {
    Crop crop = options.crop;
    if (crop.x1 == 0) crop = {0, 0, std::uint32_t(scene.image.width), std::uint32_t(scene.image.height)};
    const std::uint64_t columns = (crop.width() + TILE - 1) / TILE, rows = (crop.height() + TILE - 1) / TILE;
    const std::uint64_t bytes =
        columns * rows * TILE * TILE * options.layers.planes() * sizeof(float4) * halves_of(options);
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
    std::uint32_t capacity; // paths of a launch
    double target, until;   // Options::error, Options::seconds
    Timeline *timeline;
    device::Recorder recorder;
    std::unique_ptr<Tracer> tracer;
    std::uint32_t batch_size = first_batch;
    std::uint32_t full_width, full_height;
    std::uint32_t taken = 0; // samples that every pixel has

    Impl(device::Device opened, const scene::Scene &source, const Options &options)
        : device(with_lanes(std::move(opened), source.lanes)), layers(options.layers),
          crop(crop_that_fits(options, source, device)), film(crop, layers.planes(), halves_of(options)),
          capacity(capacity_for(std::uint64_t(film.pixels()) * halves_of(options) * FILM_BLOCK)), target(options.error),
          until(options.seconds), timeline(options.timeline), recorder(timeline),
          full_width(std::uint32_t(source.image.width)), full_height(std::uint32_t(source.image.height)) {
        scene = upload(device, source, scene::features(source, layers.surface(), layers.scatter()), crop, timeline);
        const std::uint32_t features = scene.frame.features; // with those that only the geometry shows
        device::Variant variant;
        variant.features = options.generic ? std::uint32_t(FEATURE_ALL) : features;
        variant.generic = options.generic;
        variant.bvh_stack = scene.bvh_stack;
        variant.lanes = device.quirks.lanes;
        variant.exact = options.exact;
        variant.profile = options.profile;
        variant.tile_list = target > 0;
        variant.extra = options.definitions;
        {
            const Span span(timeline, "compile");
            program = device::build(device, variant);
        }
        tracer = std::make_unique<Tracer>(device, program, variant, scene, layers, film.pixels() * halves_of(options),
                                          capacity, recorder);
        // Last: Oclgrind takes a buffer that comes in the place of a released one to be initialised no further than
        // that was.
        check_layout(device, program, recorder);
        if (measure(device, program, source, scene, recorder)) tracer->bind(scene);
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

    /// Traces samples [first, first + count) of pixels [begin, ...) of `all` in one launch; returns how many it took.
    std::uint32_t trace_some(std::uint32_t begin, std::uint32_t all, std::uint32_t first, std::uint32_t count) {
        for (;;) {
            // Whole tiles where possible: they are what is close together.
            std::uint32_t pixels = std::max(1u, batch_size / count);
            if (pixels > TILE * TILE) pixels -= pixels % (TILE * TILE);
            pixels = std::min(pixels, all - begin);
            try {
                const double seconds = tracer->trace({begin, pixels, first, count, 0, 0, 0, 0});
                statistics.sampling += seconds;
                adapt(seconds, pixels * count);
                if (statistics.startup.first_pixel == 0) {
                    statistics.startup.first_pixel = since(start);
                    device::finish_compiling();
                }
                return pixels;
            } catch (const cl::Error &error) {
                if (!device::is_out_of_resources(error) || batch_size <= smallest_batch) throw;
                batch_size /= 2;
            }
        }
    }

    /// Brings launches towards launch_seconds.
    void adapt(double seconds, std::uint32_t paths) {
        const double wanted = paths * std::clamp(launch_seconds / seconds, 0.25, largest_growth);
        batch_size = std::uint32_t(std::clamp(wanted, double(smallest_batch), double(capacity)));
    }

    /// Who is told how far a render is, and may end it.
    struct Run {
        const std::function<void(const Progress &)> &report;
        const std::atomic<bool> *stop;
        Clock::time_point began = Clock::now();
        Progress progress{};
        bool ended = false; // by `stop` or because the time is over
        bool stopped() const { return stop && stop->load(); }
    };

    void advance(Run &run, std::uint64_t paths) {
        const double inside = double(crop.width()) * crop.height() / film.pixels(); // share of pixels in the crop
        run.progress.samples += std::uint64_t(inside * double(paths));
        tracer->take_counters(statistics);
        run.progress.seconds = since(run.began);
        run.progress.sampling = statistics.sampling;
        run.progress.until = until;
        run.progress.rays = statistics.rays();
        if (run.report) run.report(run.progress);
        run.ended = run.stopped() || (until > 0 && statistics.sampling >= until);
    }

    bool render(std::uint32_t spp, const std::function<void(const Progress &)> &report, const std::atomic<bool> *stop) {
        const Span span(timeline, "render");
        Run run{report, stop};
        if (target > 0)
            render_adaptive(spp, run);
        else
            render_evenly(spp, run);
        recorder.settle();
        return !run.stopped();
    }

    /// How many samples of every pixel come next. A first look soon, then more at once, for a small picture as many as
    /// make a launch long: workers run dry at its end. Never across a block.
    std::uint32_t samples_at(std::uint32_t sample, std::uint32_t spp) const {
        const std::uint32_t in_block = sample % FILM_BLOCK;
        const std::uint32_t look = sample == 0     ? 1
                                   : in_block == 0 ? samples_at_once
                                                   : std::min(in_block, samples_at_once);
        return std::min({spp - sample, FILM_BLOCK - in_block, std::max(look, batch_size / film.pixels())});
    }

    void render_evenly(std::uint32_t spp, Run &run) {
        run.progress.wanted = std::uint64_t(spp) * crop.width() * crop.height();
        for (std::uint32_t sample = 0; sample < spp && !run.ended;) {
            const std::uint32_t count = samples_at(sample, spp);
            for (std::uint32_t pixel = 0; pixel < film.pixels() && !run.ended;) {
                const std::uint32_t pixels = trace_some(pixel, film.pixels(), sample, count);
                film.count_samples(pixel, pixels, count);
                pixel += pixels;
                advance(run, std::uint64_t(pixels) * count);
                if (pixel == film.pixels()) taken = sample + count;
            }
            sample += count;
            if (run.ended || sample == spp || sample % FILM_BLOCK == 0) film.add(tracer->take_film(film.pixels()));
        }
    }

    void render_adaptive(std::uint32_t spp, Run &run) {
        const double inside = double(crop.width()) * crop.height() / film.pixels();
        Allocation allocation(crop, layers.planes(), target, std::max(1u, spp / 2));
        while (!allocation.list().empty() && !run.ended) {
            const std::vector<std::uint32_t> &list = allocation.list();
            const auto pixels = std::uint32_t(list.size() * TILE * TILE);
            tracer->list_tiles(list);
            run.progress.wanted = std::uint64_t(inside * double(allocation.expected()));
            std::vector<std::uint32_t> counts(pixels);
            for (std::uint32_t sample = allocation.first(); sample < allocation.end() && !run.ended;) {
                const std::uint32_t count =
                    std::min(allocation.end() - sample, std::max(samples_at_once, batch_size / pixels));
                for (std::uint32_t pixel = 0; pixel < pixels && !run.ended;) {
                    const std::uint32_t some = trace_some(pixel, pixels, sample, count);
                    for (std::uint32_t i = pixel; i < pixel + some; ++i) counts[i] += count;
                    pixel += some;
                    advance(run, std::uint64_t(some) * count);
                }
                sample += count;
            }
            const std::vector<float4> sums = tracer->take_film(pixels);
            for (std::size_t i = 0; i < list.size(); ++i)
                if (allocation.shown(list[i]))
                    film.add_tile(list[i] & ~SECOND_HALF, list[i] & SECOND_HALF ? 1 : 0,
                                  sums.data() + i * TILE * TILE * layers.planes(), counts.data() + i * TILE * TILE);
            if (!run.ended) allocation.add(sums);
        }
        statistics.adaptive = {target, film.relative_error(), allocation.converged(), film.total_samples()};
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
                        {"samples", impl->target > 0 ? fmt::format("adaptive, error {}", impl->target)
                                                     : fmt::format("0:{}", impl->taken)},
                        {"features", fmt::format("{}", fmt::join(impl->statistics.features, " "))},
                        {"seconds", fmt::format("{:.3f}", impl->statistics.sampling)}};
    return picture;
}

Statistics Session::statistics() const {
    Statistics statistics = impl->statistics;
    statistics.samples = impl->target > 0 ? statistics[COUNTER_paths] : impl->film.total_samples();
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
