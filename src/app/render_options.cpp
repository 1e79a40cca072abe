#include "app/render_options.h"
#include "base/error.h"
#include <algorithm>
#include <charconv>
#include <filesystem>

namespace nacre::app {
namespace {

// Where --error ends without --spp: a picture is as good as it gets, or something in it is hopeless.
constexpr std::uint32_t most_adaptive_spp = 1 << 16;

/// A number in (0, `most`]; CLI::Range takes NaN.
CLI::Validator positive(double most, const std::string &advice) {
    return {[most, advice](const std::string &text) {
                double value = 0;
                const bool number = CLI::detail::lexical_cast(text, value);
                return number && value > 0 && value <= most ? std::string() : text + " is not " + advice;
            },
            ""};
}

/// Whole numbers separated by `separator`, exactly `count` of them; empty if `text` is anything else.
std::vector<std::uint32_t> numbers(const std::string &text, char separator, std::size_t count) {
    std::vector<std::uint32_t> result;
    const char *at = text.data(), *end = at + text.size();
    for (;;) {
        std::uint32_t value = 0;
        const auto [next, failure] = std::from_chars(at, end, value);
        if (failure != std::errc() || next == at) return {};
        result.push_back(value);
        if (next == end) break;
        if (*next != separator) return {};
        at = next + 1;
    }
    return result.size() == count ? result : std::vector<std::uint32_t>{};
}

} // namespace

void RenderOptions::add_common_to(CLI::App &command) {
    scene.add_to(command);
    add_settings_to(command);
}

void RenderOptions::add_settings_to(CLI::App &command) {
    command.add_option("--spp", spp, "Samples per pixel")->check(CLI::Range(1u, 0xffffffffu));
    command.add_option("--size", size, "Size of the picture in pixels")->type_name("WxH");
    command.add_option("--seed", seed, "Another seed gives other noise");
    command.add_option("--device", device, "OpenCL device: index, cpu, gpu, or part of its name (see `nacre devices`)");
    command.add_option("--kernels", kernels, "Read the kernels from this folder, not from the program")
        ->type_name("DIR");
    command.add_flag("--generic", generic, "One kernel for every scene, to compare with the specialised one");
}

void RenderOptions::add_to(CLI::App &command) {
    add_common_to(command);
    command.add_option("-o,--output", output, "Picture to write: .exr (float, with layers) or .png (sRGB)")
        ->required()
        ->type_name("FILE");
    command
        .add_option("--error", error,
                    "Give tiles of 8 x 8 pixels as many samples as they need until the picture's noise is this small: "
                    "the root of its relMSE (0.02: 2 %), errors against what each pixel shows and a tenth of the mean. "
                    "--spp is then the most that a pixel gets (default: 65536)")
        ->check(positive(1, "a fraction above 0 and up to 1, for example 0.02 for 2 %"))
        ->type_name("E");
    command
        .add_option("--time", seconds,
                    "Stop after so many seconds of sampling, or when --spp or --error is reached if they are given")
        ->check(positive(1e9, "a number of seconds above 0"))
        ->type_name("S");
    command.add_option("--crop", crop, "Render only pixels X0 <= x < X1, Y0 <= y < Y1")->type_name("X0,Y0,X1,Y1");
    command
        .add_option("--aov", aov,
                    "Layers: albedo,N,depth,variance,samples (the default in EXR), subsurface.zero,subsurface.single,"
                    "subsurface.multiple (light by how often it scattered), walk.steps, or none (the default in PNG)")
        ->type_name("LIST");
    command.add_option("--stats", stats, "Write what was done and what it cost as JSON")->type_name("FILE");
    command.add_option("--trace", trace, "Write what happened when, for Perfetto or chrome://tracing")
        ->type_name("FILE");
    command
        .add_option("--dump-kernel", dump_kernel,
                    "Write the kernel's source as it is compiled, its options, binary and build log into this folder")
        ->type_name("DIR");
    command.add_flag("--exact", exact, "The same picture to the bit on every device that can; takes a little longer");
    command.add_flag("--strict", strict, "Fail if a sample is NaN or infinite");
    command.add_flag("--quiet", quiet, "No progress, no remarks");
}

device::Device RenderOptions::open_device() const {
    device::Device opened = device::open_device(device);
    opened.kernel_folder = kernels;
    opened.dump_folder = dump_kernel;
    return opened;
}

void RenderOptions::apply(scene::Scene &target) const {
    if (spp) target.render.spp = *spp;
    if (seed) target.render.seed = *seed;
    if (size.empty()) return;
    const auto parts = numbers(size, 'x', 2);
    if (parts.empty() || parts[0] < 1 || parts[1] < 1 || parts[0] > 65536 || parts[1] > 65536)
        throw Error(Exit::usage, "--size " + size, "is not WIDTHxHEIGHT with sides of 1 to 65536, for example 512x512");
    target.image.width = int(parts[0]);
    target.image.height = int(parts[1]);
}

render::Layers RenderOptions::layers() const {
    render::Layers layers;
    if (!aov) {
        const bool exr = std::filesystem::path(output).extension() == ".exr";
        layers.albedo = layers.normal = layers.depth = layers.variance = layers.samples = exr;
        return layers;
    }
    bool none = false;
    const std::pair<const char *, bool *> known[] = {{"albedo", &layers.albedo},
                                                     {"N", &layers.normal},
                                                     {"depth", &layers.depth},
                                                     {"variance", &layers.variance},
                                                     {"samples", &layers.samples},
                                                     {"subsurface.zero", &layers.zero},
                                                     {"subsurface.single", &layers.single},
                                                     {"subsurface.multiple", &layers.multiple},
                                                     {"walk.steps", &layers.steps},
                                                     {"none", &none}};
    for (std::size_t from = 0; from <= aov->size();) {
        const std::size_t comma = std::min(aov->find(',', from), aov->size());
        const std::string name = aov->substr(from, comma - from);
        const auto found =
            std::find_if(std::begin(known), std::end(known), [&](const auto &layer) { return layer.first == name; });
        if (found == std::end(known)) {
            std::vector<std::string> names;
            for (const auto &layer : known) names.push_back(layer.first);
            throw Error(Exit::usage, "--aov " + *aov,
                        fmt::format("'{}' is no layer; there are {}", name, fmt::join(names, ", ")));
        }
        *found->second = true;
        from = comma + 1;
    }
    return layers;
}

std::uint32_t RenderOptions::most_samples(const scene::Scene &target) const {
    if (error && spp && *spp < 2)
        throw Error(Exit::usage, "--error", "compares two halves of the samples; give it --spp 2 or more");
    if (spp || !(error || seconds)) return target.render.spp;
    return error ? most_adaptive_spp : unlimited_spp;
}

render::Crop RenderOptions::parse_crop(const scene::Scene &target) const {
    const std::uint32_t width = std::uint32_t(target.image.width), height = std::uint32_t(target.image.height);
    if (crop.empty()) return {0, 0, width, height};
    const auto parts = numbers(crop, ',', 4);
    if (parts.empty() || parts[0] >= parts[2] || parts[1] >= parts[3] || parts[2] > width || parts[3] > height)
        throw Error(Exit::usage, "--crop " + crop,
                    fmt::format("is not X0,Y0,X1,Y1 with X0 < X1 <= {} and Y0 < Y1 <= {}", width, height));
    return {parts[0], parts[1], parts[2], parts[3]};
}

} // namespace nacre::app
