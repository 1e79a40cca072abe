#include "albedo/table.h"
#include "app/albedo_commands.h"
#include "app/interrupt.h"
#include "app/output.h"
#include "app/progress.h"
#include "base/error.h"
#include "io/atomic_file.h"

namespace nacre::app {
namespace {

struct Interrupted {};

int build(const std::string &output, bool quiet) {
    check_output_file(output);
    catch_interrupts();
    ProgressBar bar(quiet);
    try {
        const std::vector<float> table = albedo::build_table([&](double share) {
            if (interrupted) throw Interrupted{};
            bar.show(share, "media");
        });
        bar.finish();
        io::write_text(output, albedo::table_file(table));
    } catch (const Interrupted &) {
        bar.finish();
        return int(Exit::interrupted);
    }
    return int(Exit::done);
}

} // namespace

Run add_albedo_build(CLI::App &albedo) {
    CLI::App *command = albedo.add_subcommand(
        "build", "Make the table of inversions that the program carries (src/albedo/inversion.table), from the solver "
                 "of half-spaces; some minutes.");
    const auto output = std::make_shared<std::string>();
    const auto quiet = std::make_shared<bool>(false);
    command->add_option("-o,--output", *output, "File to write")->required()->type_name("FILE");
    command->add_flag("--quiet", *quiet, "No progress");
    command->footer("Example:\n  nacre albedo build -o src/albedo/inversion.table");
    return [=] { return build(*output, *quiet); };
}

} // namespace nacre::app
