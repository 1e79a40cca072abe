#include "app/commands.h"
#include "app/compare_report.h"
#include "app/output.h"
#include "base/error.h"
#include "compare/flip.h"
#include "compare/heat_map.h"
#include <algorithm>
#include <numeric>

namespace nacre::app {
namespace {

struct CompareOptions {
    std::string a, b, heat_map;
    double alpha = 1e-3;
    bool json = false;
};

double mean_of(const std::vector<float> &values) {
    return values.empty() ? 0 : std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

/// What about the pictures makes the test mean less than it seems to.
std::vector<std::string> remarks_on(const Comparison &c, const compare::Estimate &a, const compare::Estimate &b) {
    std::vector<std::string> remarks;
    const auto seed_a = c.a.metadata.find("seed"), seed_b = c.b.metadata.find("seed");
    if (a.mean == b.mean) {
        remarks.push_back("the pictures are equal to the bit");
    } else if (seed_a != c.a.metadata.end() && seed_b != c.b.metadata.end() && seed_a->second == seed_b->second) {
        remarks.push_back(fmt::format("both pictures have seed {}: their noise is much the same, which may hide "
                                      "differences from the test; render one of them with another --seed",
                                      seed_a->second));
    }
    const auto least = [](const compare::Estimate &e) { return *std::min_element(e.samples.begin(), e.samples.end()); };
    if (c.verdict && c.verdict->pixels.tested > 0) {
        // z^2 < 2n - 1
        const double needed = std::ceil((c.verdict->pixels.limit * c.verdict->pixels.limit + 1) / 2);
        if (std::min(least(a), least(b)) < needed)
            remarks.push_back(
                fmt::format("single pixels can be told apart from {:.0f} samples on; with fewer it is tiles "
                            "and the whole picture that are tested",
                            needed));
    }
    return remarks;
}

void add_flip(Comparison &c, const compare::Estimate &a, const compare::Estimate &b) {
    const compare::Plane flip = compare::hdr_flip(a, b);
    const auto largest = std::max_element(flip.values.begin(), flip.values.end()) - flip.values.begin();
    c.flip = mean_of(flip.values);
    c.flip_largest = flip.values[std::size_t(largest)];
    c.flip_x = c.a.crop_x + int(largest) % c.a.width;
    c.flip_y = c.a.crop_y + int(largest) / c.a.width;
}

int compare_pictures(const CompareOptions &options) {
    if (!options.heat_map.empty()) check_output(options.heat_map);
    Comparison c;
    c.file_a = options.a;
    c.file_b = options.b;
    c.a = io::read_picture(options.a);
    c.b = io::read_picture(options.b);
    compare::check_same_window(c.a, options.a, c.b, options.b);
    const compare::Estimate a = compare::estimate_of(c.a, options.a), b = compare::estimate_of(c.b, options.b);
    c.samples_a = mean_of(a.samples);
    c.samples_b = mean_of(b.samples);
    c.metrics = compare::metrics(a, b);
    add_flip(c, a, b);
    const bool testable = a.has_noise() && b.has_noise();
    if (testable) c.verdict = compare::test(a, b, options.alpha);
    c.remarks = remarks_on(c, a, b);

    fmt::print("{}", options.json ? as_json(c) : as_text(c));
    for (const std::string &remark : c.remarks) fmt::print(stderr, "nacre: warning: {}\n", remark);
    if (!testable)
        input_error(a.has_noise() ? options.b : options.a,
                    "has no layers 'variance' and 'samples', so that there are metrics, but no test; render it with "
                    "--aov variance,samples, or with its default layers");
    if (!options.heat_map.empty()) {
        const bool as_numbers = std::filesystem::path(options.heat_map).extension() == ".exr";
        io::write_picture(options.heat_map, as_numbers ? compare::score_map(a, b) : compare::heat_map(a, b, *c.verdict),
                          0);
    }
    return int(c.verdict->different() ? Exit::failed : Exit::done);
}

} // namespace

Run add_compare(CLI::App &program) {
    CLI::App *command = program.add_subcommand(
        "compare", "Say how far two renders are apart, and test whether that is more than their noise.");
    const auto options = std::make_shared<CompareOptions>();
    command->add_option("a", options->a, "Picture (EXR with the layers variance and samples)")
        ->required()
        ->type_name("A.exr");
    command->add_option("b", options->b, "Picture to hold it against: the reference of relMSE, PSNR and FLIP")
        ->required()
        ->type_name("B.exr");
    command->add_option("--alpha", options->alpha, "How often pictures that are alike may be called different")
        ->check(CLI::Range(1e-12, 0.5))
        ->capture_default_str();
    command
        ->add_option(
            "--heatmap", options->heat_map,
            "Write where they differ: .png in colours (red: A is brighter, blue: B is, yellow and cyan: beyond "
            "the limit, frames: tiles beyond it), .exr as z of pixels and tiles")
        ->type_name("FILE");
    command->add_flag("--json", options->json, "Print JSON.");
    command->footer(
        "Three tests share alpha: every pixel, every tile of 16 x 16 pixels, and the whole picture, each of them\n"
        "channel by channel and corrected for their number (Sidak). z is a difference in standard errors, `limit`\n"
        "what it may reach, `beyond` how many go further, p how likely the worst of them is by chance, at most.\n"
        "Heavy tails of noise, few samples and unlike numbers of samples are allowed for. Give the two pictures\n"
        "different seeds. Where their settings of sampling are the same, alpha is a bound, otherwise an estimate.\n\n"
        "MSE, relMSE: mean of (A - B)^2 and of (A - B)^2 / (B^2 + (mean of B / 10)^2). PSNR: against the largest\n"
        "value of B. FLIP: HDR-FLIP of Andersson et al. 2021, its mean, 0 to 1.\n\n"
        "Exit codes: 0 alike, 1 different (or a pixel is not finite), 3 no test: files that cannot be read, other\n"
        "sizes, no variance.\n\n"
        "Examples:\n"
        "  nacre compare new.exr reference.exr\n"
        "  nacre compare new.exr reference.exr --heatmap where.png --alpha 1e-4\n"
        "  nacre compare new.exr reference.exr --json > compare.json");
    return [options] { return compare_pictures(*options); };
}

} // namespace nacre::app
