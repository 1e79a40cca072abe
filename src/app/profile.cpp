#include "app/commands.h"
#include "app/interrupt.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/stopwatch.h"
#include "base/error.h"
#include "io/atomic_file.h"
#include "render/session.h"

namespace nacre::app {
namespace {

constexpr std::uint32_t default_spp = 16;

struct ProfileOptions : RenderOptions {
    std::string json;
};

int profile_scene(const ProfileOptions &options) {
    Stopwatch watch(false);
    const scene::Scene scene = watch.load(options);
    for (const std::string &warning : scene.warnings) fmt::print(stderr, "nacre: warning: {}\n", warning);
    render::Options what;
    what.generic = options.generic;
    what.profile = true;
    render::Session session(watch.open_device(options), scene, what);
    catch_interrupts();
    ProgressBar bar(false);
    const bool complete = session.render(
        options.spp.value_or(default_spp), [&](const render::Progress &progress) { bar.show(progress); }, &interrupted);
    bar.finish();

    const render::Statistics statistics = watch.complete(session.statistics());
    fmt::print("{}, {} x {} pixels, {} samples, {}\n\n{}", options.scene.file, scene.image.width, scene.image.height,
               statistics.samples, statistics.device, report(statistics));
    if (!options.json.empty()) io::write_text(options.json, statistics.json());
    return int(complete ? Exit::done : Exit::interrupted);
}

} // namespace

Run add_profile(CLI::App &program) {
    CLI::App *command = program.add_subcommand(
        "profile", "Render a scene with kernels that count what they do, and say where the time went. No picture.");
    const auto options = std::make_shared<ProfileOptions>();
    options->add_common_to(*command);
    command->get_option("--spp")->description("Samples per pixel (default: 16)");
    command->add_option("--json", options->json, "Write it as JSON too: that of `render --stats`, and `profile`")
        ->type_name("FILE");
    command->footer("Examples:\n"
                    "  nacre profile scenes/bear/bear.json\n"
                    "  nacre profile head.glb --size 256x256 --spp 64 --json head.json");
    return [options] { return profile_scene(*options); };
}

} // namespace nacre::app
