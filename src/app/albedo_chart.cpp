#include "app/albedo_commands.h"
#include "app/interrupt.h"
#include "app/output.h"
#include "app/progress.h"
#include "base/error.h"
#include "patch/chart.h"
#include "sheet/text.h"

namespace nacre::app {
namespace {

struct Interrupted {};

struct ChartOptions : AlbedoOptions {
    std::string output;
    std::uint32_t spp = 64;
};

int draw(const ChartOptions &options) {
    check_output(options.output);
    sheet::check_text();
    const scene::Material material = options.material();
    const device::Device device = options.open_device();
    catch_interrupts();
    ProgressBar bar(options.quiet);
    try {
        const std::string title = fmt::format("asked | got: {}, g {}, bleed {}, {} spp", options.inversion, options.g,
                                              options.bleed, options.spp);
        const patch::Chart chart = patch::color_chart(device, material, options.spp, title, [&](double share) {
            if (interrupted) throw Interrupted{};
            bar.show(share, "patches");
        });
        bar.finish();
        io::write_picture(options.output, chart.picture, 0);
        fmt::print("{}: off by at most {:.2f} of 255\n", options.output, chart.worst);
    } catch (const Interrupted &) {
        bar.finish();
        return int(Exit::interrupted);
    }
    return int(Exit::done);
}

} // namespace

Run add_albedo_chart(CLI::App &albedo) {
    CLI::App *command =
        albedo.add_subcommand("chart", "Render a chart of 24 patches, each beside the colour that was asked for.");
    const auto options = std::make_shared<ChartOptions>();
    command->add_option("-o,--output", options->output, "Picture to write: .png, or .exr")
        ->required()
        ->type_name("FILE");
    options->add_medium_to(*command);
    command->add_option("--spp", options->spp, "Samples per pixel (default 64)")->check(CLI::Range(1u, 65536u));
    options->add_device_to(*command);
    command->footer("Examples:\n"
                    "  nacre albedo chart -o chart.png --g 0.8\n"
                    "  nacre albedo chart -o memo.png --g 0.8 --inversion memo --max-depth 256");
    return [options] { return draw(*options); };
}

} // namespace nacre::app
