#include "app/commands.h"
#include "app/interrupt.h"
#include "app/progress.h"
#include "app/render_options.h"
#include "base/error.h"
#include "io/atomic_file.h"
#include "io/image.h"
#include <chrono>
#include <unistd.h>

namespace nacre::app {
namespace {

/// Finds out before the work, and not after, that the picture could not be written.
void check_output(const std::filesystem::path &file) {
    const std::string extension = file.extension().string();
    if (extension != ".exr" && extension != ".png")
        throw Error(Exit::usage, file.string(), "pictures are written as .exr or .png; choose one of these endings");
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    if (!std::filesystem::is_directory(folder))
        throw Error(Exit::output, file.string(), "its folder does not exist; create it first");
    if (access(folder.c_str(), W_OK) != 0)
        throw Error(Exit::output, file.string(), "its folder cannot be written to; choose another place");
}

void write_text(const std::filesystem::path &name, const std::string &text) {
    io::AtomicFile file(name);
    file.write(text.data(), text.size(), 0);
    file.commit();
}

int render_scene(const RenderOptions &options) {
    const auto start = std::chrono::steady_clock::now();
    check_output(options.output);
    const render::Layers layers = options.layers();
    scene::Scene scene = io::load_scene(options.scene.file, options.scene.overrides());
    options.apply(scene);
    const render::Crop crop = options.parse_crop(scene);
    const double load_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!options.quiet)
        for (const std::string &warning : scene.warnings) fmt::print(stderr, "nacre: warning: {}\n", warning);

    device::Device device = device::open_device(options.device);
    device.kernel_folder = options.kernels;
    render::Session session(std::move(device), scene, {layers, crop, options.generic});
    catch_interrupts();
    ProgressBar bar(options.quiet);
    const bool complete = session.render(
        scene.render.spp, [&](const render::Progress &progress) { bar.show(progress); }, &interrupted);
    bar.finish();
    io::write_picture(options.output, session.picture(), scene.render.exposure);

    render::Statistics statistics = session.statistics();
    statistics.load = load_seconds;
    statistics.first_pixel += load_seconds;
    statistics.total = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!options.stats.empty()) write_text(options.stats, statistics.json());
    if (!options.quiet)
        for (const std::string &remark : statistics.remarks()) fmt::print(stderr, "nacre: warning: {}\n", remark);
    if (options.strict && statistics[shared::COUNTER_non_finite] > 0)
        throw Error(Exit::failed, options.output,
                    fmt::format("{} samples were NaN or infinite (--strict)", statistics[shared::COUNTER_non_finite]));
    return int(complete ? Exit::done : Exit::interrupted);
}

} // namespace

Run add_render(CLI::App &program) {
    CLI::App *command = program.add_subcommand("render", "Render a scene to a picture.");
    const auto options = std::make_shared<RenderOptions>();
    options->add_to(*command);
    command->footer(
        "Examples:\n"
        "  nacre render scenes/bear/bear.json -o bear.png\n"
        "  nacre render head.glb -o head.exr --spp 256 --size 1024x1024 --stats head.json\n"
        "  nacre render scene.json -o crop.exr --crop 100,100,200,200 --set render.channel_sampling=throughput");
    return [options] { return render_scene(*options); };
}

} // namespace nacre::app
