// Rays per second of nacre's traversal on an OpenCL CPU device against Embree's rtcIntersect1, on the same rays and as
// many threads, in turns. Time is wall time; that of one thread is CPU time, so that other programs on the machine do
// not count.
#include "accel/probe.h"
#include "base/error.h"
#include "measure.h"
#include "meshes.h"
#include "rays/ray_sets.h"
#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <fmt/format.h>
#include <thread>

using namespace nacre;
using namespace nacre::bench;

namespace {

struct Options {
    std::string json, device = "cpu", kernels, defines;
    int pairs = 7;
    int threads = 2;
    int width = 0;
    std::size_t rays = 1000000; // some 30 ms: threads take one or two to wake
    double triangles = 0;
};

struct Result {
    std::string name;
    double ratio, robust_ratio; // nacre : Embree, in rays per second
    double nacre, embree;       // million rays per second
    double hits, different;     // shares of the rays
};

double elapsed(int threads, const Seconds &time) { return threads == 1 ? time.cpu : time.wall; }

/// Threads pick up as many rays at a time as nacre's work-items take.
void embree_closest(const EmbreeScene &scene, std::span<const ProbeRay> rays, std::span<ProbeHit> hits, int threads) {
    constexpr std::size_t chunk = 1024;
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t begin; (begin = next.fetch_add(chunk)) < rays.size();) {
            const std::size_t count = std::min(chunk, rays.size() - begin);
            scene.closest(rays.subspan(begin, count), hits.subspan(begin, count));
        }
    };
    std::vector<std::jthread> others;
    for (int i = 1; i < threads; i++) others.emplace_back(work);
    work();
}

/// Grazing rays and rays that end at a surface may differ; a hit elsewhere may not.
double share_of_different(std::span<const ProbeHit> ours, std::span<const ProbeHit> theirs) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < ours.size(); i++) {
        const bool same_t = std::abs(ours[i].t - theirs[i].t) <= 1e-4f * std::max(1e-3f, theirs[i].t);
        different += ours[i].hit() != theirs[i].hit() || (ours[i].hit() && !same_t);
    }
    return double(different) / double(ours.size());
}

Result measure(const std::string &name, RayProbe &probe, std::uint32_t root, const EmbreeScene &fast,
               const EmbreeScene &robust, std::span<const ProbeRay> rays, int pairs, int threads) {
    std::vector<ProbeHit> expected(rays.size());
    probe.upload(root, rays);
    probe.run_closest(); // PoCL generates code at the first launch of a size
    embree_closest(robust, rays, expected, threads);
    Result result{name, 0, 0, 0, 0, 0, share_of_different(probe.hits(), expected)};
    for (const ProbeHit &hit : expected) result.hits += hit.hit() / double(rays.size());

    std::vector<double> ratio, robust_ratio, ours, theirs;
    for (int pair = 0; pair < pairs; pair++) {
        theirs.push_back(elapsed(threads, seconds([&] { embree_closest(fast, rays, expected, threads); })));
        ours.push_back(elapsed(threads, seconds([&] { probe.run_closest(); })));
        ratio.push_back(theirs.back() / ours.back());
        robust_ratio.push_back(elapsed(threads, seconds([&] { embree_closest(robust, rays, expected, threads); })) /
                               ours.back());
    }
    result.ratio = median(ratio);
    result.robust_ratio = median(robust_ratio);
    result.nacre = 1e-6 * double(rays.size()) / median(ours);
    result.embree = 1e-6 * double(rays.size()) / median(theirs);
    return result;
}

void measure_mesh(const std::string &name, const scene::Mesh &mesh, const device::Device &device,
                  const Options &options, std::vector<Result> &results) {
    std::vector<accel::Triangle> triangles;
    for (const auto &t : mesh.triangles) {
        accel::Triangle &triangle = triangles.emplace_back();
        for (std::size_t k = 0; k < 3; k++) triangle.v[k] = mesh.positions[t[k]].cast<float>();
    }
    accel::Bvh bvh;
    bvh.width = device.quirks.bvh_width;
    const std::uint32_t root = accel::append_tree(bvh, triangles, 0);
    RayProbe probe(device, bvh, options.defines);
    fmt::print("{}: {:.1f} bytes of nodes and {:.1f} of blocks per triangle\n", name,
               double(std::span(bvh.nodes).size_bytes()) / double(triangles.size()),
               double(std::span(bvh.blocks).size_bytes()) / double(triangles.size()));
    const EmbreeScene fast(triangles, false), robust(triangles, true);
    for (const RaySet &set : make_ray_sets(triangles, robust, options.rays)) {
        const Result r =
            measure(name + "/" + set.name, probe, root, fast, robust, set.rays, options.pairs, options.threads);
        fmt::print("{:14} {:7.2f} {:7.2f} {:8.2f} {:8.2f} {:7.1f} {:9.1e}\n", r.name, r.nacre, r.embree, r.ratio,
                   r.robust_ratio, 100 * r.hits, r.different);
        std::fflush(stdout);
        results.push_back(r);
    }
}

nlohmann::json to_json(const std::vector<Result> &results, double geomean, double least) {
    nlohmann::json json{{"geomean", geomean}, {"min", least}, {"results", nlohmann::json::array()}};
    for (const Result &r : results)
        json["results"].push_back({{"name", r.name},
                                   {"ratio", r.ratio},
                                   {"robust_ratio", r.robust_ratio},
                                   {"nacre_mrays", r.nacre},
                                   {"embree_mrays", r.embree},
                                   {"different", r.different}});
    return json;
}

int run(const Options &options) {
    setenv("POCL_MAX_PTHREAD_COUNT", std::to_string(options.threads).c_str(), 1); // before the first OpenCL call
    device::Device device = device::open_device(options.device);
    device.kernel_folder = options.kernels;
    if (options.width) device.quirks.bvh_width = options.width;
    fmt::print("{}: {} wide, {}; {} thread(s), medians of {} pairs\n", device.info.name, device.quirks.bvh_width,
               device.quirks.bvh_vector ? "vectors" : "scalar", options.threads, options.pairs);
    fmt::print("{:14} {:>7} {:>7} {:>8} {:>8} {:>7} {:>9}\n", "Mrays/s", "nacre", "Embree", "ratio", "robust", "hit %",
               "different");

    const double blob = options.triangles > 0 ? options.triangles : 786432;
    const double knot = options.triangles > 0 ? options.triangles : 1048576;
    std::vector<Result> results;
    measure_mesh("blob", make_blob(std::max(2, int(std::sqrt(blob / 12)))), device, options, results);
    measure_mesh("knot", make_knot(std::max(8, int(std::sqrt(knot / 16)))), device, options, results);

    std::vector<double> ratios;
    bool agree = true;
    for (const Result &r : results) {
        ratios.push_back(r.ratio);
        agree = agree && r.different < 1e-3;
    }
    const double geomean = geometric_mean(ratios), least = *std::min_element(ratios.begin(), ratios.end());
    fmt::print("geometric mean {:.2f}, least {:.2f}\n", geomean, least);
    if (!options.json.empty()) write_json(options.json, to_json(results, geomean, least));
    if (!agree) throw Error(Exit::failed, "rays", "hits differ from Embree's");
    return 0;
}

} // namespace

int main(int argc, char **argv) {
    Options options;
    CLI::App app("nacre's rays per second against Embree's, on generated meshes");
    app.add_option("--json", options.json, "write the results to this file");
    app.add_option("--pairs", options.pairs, "measurements per ray set; their median counts")
        ->check(CLI::Range(1, 1000));
    app.add_option("--threads", options.threads, "threads on both sides")->check(CLI::Range(1, 1024));
    app.add_option("--rays", options.rays, "rays per set")->check(CLI::Range(1000, 100000000));
    app.add_option("--triangles", options.triangles, "triangles per mesh, about (default 786432 and 1048576)");
    app.add_option("--width", options.width, "children per node")->check(CLI::IsMember({0, 4, 8, 16}));
    app.add_option("--device", options.device, "OpenCL device");
    app.add_option("--kernels", options.kernels, "folder of kernels to take in place of the embedded ones");
    app.add_option("--options", options.defines, "further OpenCL compiler options, to compare variants");
    CLI11_PARSE(app, argc, argv);
    try {
        return run(options);
    } catch (const Error &error) {
        fmt::print(stderr, "rays: error: {}\n", error.what());
        return int(error.code);
    }
}
