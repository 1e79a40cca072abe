// Walks per second of the renderer's kernel on an OpenCL CPU device against a C++ walk with Embree's rtcIntersect1: the
// same walks from the same entries, as many threads, in turns.
#include "base/error.h"
#include "measure.h"
#include "meshes.h"
#include "walks/embree_walk.h"
#include "walks/megakernel.h"
#include <CLI/CLI.hpp>
#include <fmt/format.h>

using namespace nacre;
using namespace nacre::bench;

namespace {

struct Options {
    std::string json, device = "cpu", kernels;
    int pairs = 7;
    unsigned threads = 2;
    std::size_t walks = 300000;
    double triangles = 0, anisotropy = 0;
};

struct Result {
    std::string name;
    double ratio, cpu_ratio, robust_ratio; // nacre : Embree, in walks per second (cpu: of CPU time)
    double nacre, embree;                  // million walks per second
    double steps;                          // flights per walk, nacre's
    double different;                      // largest relative difference of flights and radiance
};

double largest_difference(const Outcome &a, const Outcome &b) {
    double largest = std::abs(a.steps / b.steps - 1);
    for (int c = 0; c < 3; c++) largest = std::max(largest, std::abs(a.radiance[c] / b.radiance[c] - 1));
    return largest;
}

Result measure(const std::string &name, Megakernel &megakernel, const EmbreeScene &fast, const EmbreeScene &robust,
               std::span<const shared::Path> paths, const Options &options) {
    std::vector<shared::float4> radiance(paths.size());
    std::uint64_t steps = 0;
    const auto embree = [&](const EmbreeScene &scene) {
        return seconds([&] { steps = walk_with_embree(scene, paths, radiance, options.threads); });
    };
    megakernel.upload(paths);
    megakernel.run(); // PoCL generates code at the first launch
    const Outcome ours = outcome(megakernel.radiance(), double(megakernel.steps()));
    Result result{name, 0, 0, 0, 0, 0, ours.steps / double(paths.size()), 0};
    for (const EmbreeScene *scene : {&fast, &robust}) {
        embree(*scene);
        result.different = std::max(result.different, largest_difference(ours, outcome(radiance, double(steps))));
    }

    std::vector<double> ratio, cpu_ratio, robust_ratio, nacre_seconds, embree_seconds;
    for (int pair = 0; pair < options.pairs; pair++) {
        const Seconds theirs = embree(fast);
        const Seconds mine = seconds([&] { megakernel.run(); });
        const Seconds careful = embree(robust);
        nacre_seconds.push_back(mine.wall);
        embree_seconds.push_back(theirs.wall);
        ratio.push_back(theirs.wall / mine.wall);
        cpu_ratio.push_back(theirs.cpu / mine.cpu);
        robust_ratio.push_back(careful.wall / mine.wall);
    }
    result.ratio = median(ratio);
    result.cpu_ratio = median(cpu_ratio);
    result.robust_ratio = median(robust_ratio);
    result.nacre = 1e-6 * double(paths.size()) / median(nacre_seconds);
    result.embree = 1e-6 * double(paths.size()) / median(embree_seconds);
    return result;
}

void measure_mesh(const std::string &name, const scene::Mesh &mesh, const device::Device &device,
                  const Options &options, std::vector<Result> &results) {
    const std::vector<accel::Triangle> triangles = walk_triangles(walk_scene(mesh, 1, 0));
    const EmbreeScene fast(triangles, false), robust(triangles, true);
    for (const auto &[medium, mean_free_path] : {std::pair{"0.2%", 0.002}, {"1%", 0.01}, {"5%", 0.05}}) {
        const scene::Scene scene = walk_scene(mesh, mean_free_path, options.anisotropy);
        Megakernel megakernel(device, scene);
        const std::vector<shared::Path> paths = walk_entries(scene, triangles, options.walks);
        const Result r = measure(fmt::format("{}/{}", name, medium), megakernel, fast, robust, paths, options);
        fmt::print("{:12} {:8.3f} {:8.3f} {:7.1f} {:7.1f} {:6.1f} {:7.2f} {:7.2f} {:7.2f} {:9.1e}\n", r.name, r.nacre,
                   r.embree, r.nacre * r.steps, r.embree * r.steps, r.steps, r.ratio, r.cpu_ratio, r.robust_ratio,
                   r.different);
        std::fflush(stdout);
        results.push_back(r);
    }
}

nlohmann::json to_json(const std::vector<Result> &results, double geomean, double least) {
    nlohmann::json json{{"geomean", geomean}, {"min", least}, {"results", nlohmann::json::array()}};
    for (const Result &r : results)
        json["results"].push_back({{"name", r.name},
                                   {"ratio", r.ratio},
                                   {"cpu_ratio", r.cpu_ratio},
                                   {"robust_ratio", r.robust_ratio},
                                   {"nacre_mwalks", r.nacre},
                                   {"embree_mwalks", r.embree},
                                   {"nacre_msteps", r.nacre * r.steps},
                                   {"embree_msteps", r.embree * r.steps},
                                   {"steps", r.steps},
                                   {"different", r.different}});
    return json;
}

int run(const Options &options) {
    setenv("POCL_MAX_PTHREAD_COUNT", std::to_string(options.threads).c_str(), 1); // before the first OpenCL call
    device::Device device = device::open_device(options.device);
    device.kernel_folder = options.kernels;
    fmt::print("{}; {} threads, {} walks, g = {}, medians of {} pairs\n", device.info.name, options.threads,
               options.walks, options.anisotropy, options.pairs);
    fmt::print("{:12} {:^17} {:^15} {:>6} {:^23} {:>9}\n", "", "Mwalks/s", "Msteps/s", "steps", "ratio", "");
    fmt::print("{:12} {:>8} {:>8} {:>7} {:>7} {:>6} {:>7} {:>7} {:>7} {:>9}\n", "", "nacre", "Embree", "nacre",
               "Embree", "/walk", "wall", "CPU", "robust", "different");

    const auto triangles = [&](double usual) { return options.triangles > 0 ? options.triangles : usual; };
    std::vector<Result> results;
    measure_mesh("blob", make_blob(std::max(2, int(std::sqrt(triangles(786432) / 12)))), device, options, results);
    measure_mesh("knot", make_knot(std::max(8, int(std::sqrt(triangles(1048576) / 16)))), device, options, results);
    const std::size_t large = results.size();
    measure_mesh("small", make_blob(10), device, options, results);

    std::vector<double> ratios;
    double different = 0;
    for (std::size_t i = 0; i < results.size(); i++) {
        if (i < large) ratios.push_back(results[i].ratio);
        different = std::max(different, results[i].different);
    }
    const double geomean = geometric_mean(ratios), least = *std::min_element(ratios.begin(), ratios.end());
    fmt::print("blob and knot: geometric mean {:.2f}, least {:.2f}\n", geomean, least);
    if (!options.json.empty()) write_json(options.json, to_json(results, geomean, least));
    if (different > 3e-3) throw Error(Exit::failed, "walks", "the two sides do not walk the same walks");
    return 0;
}

} // namespace

int main(int argc, char **argv) {
    Options options;
    CLI::App app("nacre's walks per second against a C++ walk with Embree, on generated meshes");
    app.add_option("--json", options.json, "write the results to this file");
    app.add_option("--pairs", options.pairs, "measurements per row; their median counts")->check(CLI::Range(1, 1000));
    app.add_option("--walks", options.walks, "walks per measurement")->check(CLI::Range(100, 10000000));
    app.add_option("--threads", options.threads, "of each side")->check(CLI::Range(1, 1024));
    app.add_option("--anisotropy", options.anisotropy, "mean cosine g of a scatter")->check(CLI::Range(-0.99, 0.99));
    app.add_option("--triangles", options.triangles, "of blob and knot, about (default 786432 and 1048576)");
    app.add_option("--device", options.device, "OpenCL device");
    app.add_option("--kernels", options.kernels, "folder of kernels to take in place of the embedded ones");
    CLI11_PARSE(app, argc, argv);
    try {
        return run(options);
    } catch (const Error &error) {
        fmt::print(stderr, "walks: error: {}\n", error.what());
        return int(error.code);
    }
}
