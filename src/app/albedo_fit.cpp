#include "app/albedo_commands.h"
#include "app/interrupt.h"
#include "app/output.h"
#include "app/progress.h"
#include "base/error.h"
#include "io/atomic_file.h"
#include "patch/fit.h"
#include "patch/plot.h"

namespace nacre::app {
namespace {

struct Interrupted {};

struct FitOptions : AlbedoOptions {
    std::string folder;
};

std::string coefficients(const albedo::MemoFit &fit) {
    const auto polynomial = [](const albedo::Polynomial &p) { return fmt::format("{{{:.10g}}}", fmt::join(p, ", ")); };
    const auto exponential = [](const albedo::ExponentialOfPolynomial &p) {
        return fmt::format("{{{:.10g}, {:.10g}, {{{:.10g}}}}}", p.offset, p.factor, fmt::join(p.power, ", "));
    };
    return fmt::format("A {}\nB {}\nC {}\nD {}\nE {}\nF {}\n", polynomial(fit.a), exponential(fit.b), polynomial(fit.c),
                       polynomial(fit.d), exponential(fit.e), polynomial(fit.f));
}

int fit(const FitOptions &options) {
    const std::filesystem::path folder = options.folder;
    check_output_folder(folder, options.folder);
    const device::Device device = options.open_device();
    catch_interrupts();
    ProgressBar bar(options.quiet);
    patch::Survey survey;
    try {
        survey = patch::survey_albedos(device, folder / "albedo_survey.csv", [&](double share) {
            if (interrupted) throw Interrupted{};
            bar.show(share, "patches");
        });
        bar.finish();
    } catch (const Interrupted &) {
        bar.finish();
        fmt::print(stderr, "nacre: stopped; the same command goes on from here\n");
        return int(Exit::interrupted);
    }
    const std::pair<const char *, albedo::MemoFit> fits[] = {
        {"two stages", patch::fit_in_two_stages(survey, albedo::published_fit)},
        {"jointly", patch::fit_jointly(survey, albedo::published_fit)}};
    for (const auto &[name, found] : fits) {
        const patch::FitError error = patch::fit_error(found);
        fmt::print("{}: error in colour at most {:.4f}, {:.4f} in the mean\n{}\n", name, error.largest, error.mean,
                   coefficients(found));
        const std::string file = fmt::format("albedo_fit_{}.svg", name == fits[0].first ? "two_stages" : "jointly");
        io::write_text(folder / file,
                       patch::plot_fit(survey, found, fmt::format("Eq 9, fitted {}: lines; rendered: dots", name)));
    }
    return int(Exit::done);
}

} // namespace

Run add_albedo_fit(CLI::App &albedo) {
    CLI::App *command = albedo.add_subcommand(
        "fit", "Render slabs of 40 x 40 albedos and anisotropies and fit the memo's eqs 6 to 9 to them, in two stages "
               "as it does and jointly. Prints coefficients and errors in colour, plots fit against data (SVG).");
    const auto options = std::make_shared<FitOptions>();
    command
        ->add_option("-o,--output", options->folder,
                     "Folder for albedo_survey.csv, from which a stopped survey goes "
                     "on, and for the plots")
        ->required()
        ->type_name("DIR");
    options->add_device_to(*command);
    command->footer("Example:\n  nacre albedo fit -o .");
    return [options] { return fit(*options); };
}

} // namespace nacre::app
