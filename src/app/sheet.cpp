#include "app/commands.h"
#include "app/interrupt.h"
#include "app/output.h"
#include "app/progress.h"
#include "app/render_options.h"
#include "base/error.h"
#include "render/session.h"
#include "sheet/caption.h"
#include "sheet/contact.h"
#include "sheet/text.h"

namespace nacre::app {
namespace {

struct SheetOptions : RenderOptions {
    std::vector<std::string> sheets;
};

/// Where each sheet goes. Throws Error where that cannot be.
std::vector<std::filesystem::path> outputs(const SheetOptions &options) {
    const std::filesystem::path output = options.output;
    if (output.extension() == ".png" && !std::filesystem::is_directory(output)) {
        if (options.sheets.size() > 1)
            throw Error(Exit::usage, output.string(),
                        fmt::format("is one file for {} sheets; name a folder", options.sheets.size()));
        check_output(output);
        return {output};
    }
    check_output_folder(output, output.string());
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::path sheet : options.sheets) {
        files.push_back(output / sheet.stem().concat(".png"));
        if (std::count(files.begin(), files.end(), files.back()) > 1)
            throw Error(Exit::usage, sheet.string(),
                        fmt::format("there are two sheets for {}; give them other names", files.back().string()));
    }
    return files;
}

/// Renders one panel; what there is of it if `interrupted` is set meanwhile.
sheet::Tile render_panel(const sheet::Sheet &what, std::size_t index, const SheetOptions &options,
                         const device::Device &device) {
    scene::Scene scene = sheet::load_panel(what, index);
    options.apply(scene);
    const std::optional<double> seconds = options.spp ? std::nullopt : what.seconds;
    render::Options how;
    how.layers.variance = true;
    how.generic = options.generic;
    how.seconds = seconds.value_or(0);
    render::Session session(device, scene, how);

    ProgressBar bar(options.quiet);
    session.render(
        seconds ? unlimited_spp : scene.render.spp, [&](const render::Progress &progress) { bar.show(progress); },
        &interrupted);
    bar.finish();
    const render::Statistics statistics = session.statistics();
    if (!options.quiet)
        for (const std::string &remark : statistics.remarks()) fmt::print(stderr, "nacre: warning: {}\n", remark);
    io::Picture picture = session.picture();
    std::string cost = sheet::cost_line(picture, statistics.sampling, statistics.samples);
    if (interrupted) cost += ", interrupted";
    return {std::move(picture), scene.render.exposure, what.panels[index].label, sheet::differing_settings(what, index),
            std::move(cost)};
}

/// A panel that an interrupt left no time for.
sheet::Tile empty_panel(const sheet::Sheet &what, std::size_t index, const io::Picture &like) {
    io::Picture picture;
    picture.width = like.width;
    picture.height = like.height;
    return {std::move(picture), 0, what.panels[index].label, sheet::differing_settings(what, index),
            "interrupted, not rendered"};
}

void render_sheet(sheet::Sheet what, const std::filesystem::path &output, const SheetOptions &options,
                  const device::Device &device) {
    const std::string missing = sheet::check_panels(what);
    if (!missing.empty()) {
        const std::string used = what.scene.filename().string();
        what.title += fmt::format(" ({}: files of the scene are missing)", used);
        if (!options.quiet) fmt::print(stderr, "nacre: warning: {}; rendering {} instead\n", missing, used);
    }
    std::vector<sheet::Tile> tiles;
    for (std::size_t i = 0; i < what.panels.size(); ++i) {
        if (!options.quiet && !interrupted)
            fmt::print(stderr, "nacre: {}, panel {} of {}: {}\n", what.file.filename().string(), i + 1,
                       what.panels.size(), what.panels[i].label);
        tiles.push_back(interrupted && i > 0 ? empty_panel(what, i, tiles[0].picture)
                                             : render_panel(what, i, options, device));
    }
    io::write_picture(output, sheet::contact_sheet(what.title, what.columns.value_or(what.panels.size()), tiles), 0);
}

int render_sheets(const SheetOptions &options) {
    const std::vector<std::filesystem::path> files = outputs(options);
    std::vector<sheet::Sheet> sheets;
    for (const std::string &file : options.sheets) sheets.push_back(sheet::read_sheet(file));
    sheet::check_text();
    const device::Device device = options.open_device();
    catch_interrupts();
    for (std::size_t i = 0; i < sheets.size() && !interrupted; ++i) render_sheet(sheets[i], files[i], options, device);
    return int(interrupted ? Exit::interrupted : Exit::done);
}

} // namespace

Run add_sheet(CLI::App &program) {
    CLI::App *command = program.add_subcommand(
        "sheet",
        "Render the panels of sheets, one labelled contact sheet (PNG) for each: a scene several times, side by "
        "side, with different settings.");
    const auto options = std::make_shared<SheetOptions>();
    command->add_option("sheets", options->sheets, "Sheets in JSON, see scenes/README.md")
        ->required()
        ->type_name("SHEET.json...");
    options->add_settings_to(*command);
    command->get_option("--spp")->description(
        "Samples per pixel of every panel (default: the sheet's, or its seconds)");
    command->get_option("--size")->description("Size of every panel in pixels");
    command
        ->add_option("-o,--output", options->output,
                     "Contact sheet to write (.png), or folder for one NAME.png per "
                     "NAME.json")
        ->required()
        ->type_name("DIR|FILE.png");
    command->add_flag("--quiet", options->quiet, "No progress, no remarks");
    command->footer(
        "Captions say what differs from the other panels, the seconds of sampling (kernels alone), the samples per\n"
        "pixel (their mean), and the error: the relative RMS error of a pixel, by the spread of its own samples. That\n"
        "is sqrt(mean of the variance of the mean) / mean, over the three channels of pixels that are not black.\n"
        "Samples are spread more evenly than chance would, so pictures are somewhat better than that.\n\n"
        "Examples:\n"
        "  nacre sheet scenes/figures/figure5.json -o figure5.png\n"
        "  nacre sheet scenes/figures/figure*.json -o .\n"
        "  nacre sheet scenes/figures/figure4.json -o figure4.png --size 512x512 --spp 64");
    return [options] { return render_sheets(*options); };
}

} // namespace nacre::app
