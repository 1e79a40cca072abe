#include "app/commands.h"
#include "app/interrupt.h"
#include "app/output.h"
#include "app/progress.h"
#include "app/render_options.h"
#include "app/stopwatch.h"
#include "base/error.h"
#include "io/atomic_file.h"
#include "io/image.h"

namespace nacre::app {
namespace {

int render_scene(const RenderOptions &options) {
    Stopwatch watch(!options.trace.empty());
    check_output(options.output);
    const render::Layers layers = options.layers();
    scene::Scene scene = watch.load(options);
    const render::Crop crop = options.parse_crop(scene);
    const std::uint32_t spp = options.most_samples(scene);
    if (!options.quiet)
        for (const std::string &warning : scene.warnings) fmt::print(stderr, "nacre: warning: {}\n", warning);

    render::Session session(watch.open_device(options), scene,
                            {.layers = layers,
                             .crop = crop,
                             .generic = options.generic,
                             .exact = options.exact,
                             .error = options.error.value_or(0),
                             .seconds = options.seconds.value_or(0),
                             .timeline = watch.timeline()});
    catch_interrupts();
    ProgressBar bar(options.quiet);
    const bool complete = session.render(
        spp, [&](const render::Progress &progress) { bar.show(progress); }, &interrupted);
    bar.finish();
    {
        const Span span(watch.timeline(), "write picture");
        io::write_picture(options.output, session.picture(), scene.render.exposure);
    }

    const render::Statistics statistics = watch.complete(session.statistics());
    if (!options.stats.empty()) io::write_text(options.stats, statistics.json());
    if (!options.trace.empty()) {
        io::write_text(options.trace, watch.timeline()->json());
        if (const std::size_t dropped = watch.timeline()->dropped(); dropped > 0 && !options.quiet)
            fmt::print(stderr, "nacre: warning: the trace ends early, {} more spans did not fit\n", dropped);
    }
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
        "  nacre render scenes/bear/bear.json -o bear.exr --error 0.02\n"
        "  nacre render scenes/bear/bear.json -o bear.exr --error 0.01 --spp 4096 --time 60\n"
        "  nacre render scene.json -o crop.exr --crop 100,100,200,200 --set render.channel_sampling=throughput");
    return [options] { return render_scene(*options); };
}

} // namespace nacre::app
