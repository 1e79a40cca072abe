// Closest hits in the blob of 786,432 triangles, on the ray sets of bench/rays. An item is a ray.
#include "accel/probe.h"
#include "bench.h"
#include "meshes.h"
#include "rays/ray_sets.h"
#include <fmt/format.h>

namespace nacre::bench {
namespace {

constexpr const char *sets[] = {"0.2%", "1%", "10%", "primary", "diffuse"};

/// What all sets share; made when the first one is measured.
struct Blob {
    Blob() {
        const scene::Mesh mesh = make_blob(256);
        for (const auto &t : mesh.triangles) {
            accel::Triangle &triangle = triangles.emplace_back();
            for (std::size_t k = 0; k < 3; k++) triangle.v[k] = mesh.positions[t[k]].cast<float>();
        }
        bvh.width = the_device().quirks.bvh_width;
        root = accel::append_tree(bvh, triangles, 0);
        rays = make_ray_sets(triangles, EmbreeScene(triangles, true), 100000);
    }

    std::vector<accel::Triangle> triangles;
    accel::Bvh bvh;
    std::uint32_t root;
    std::vector<RaySet> rays;
};

void measure(benchmark::State &state, std::size_t set) {
    static const Blob blob;
    static RayProbe probe(the_device(), blob.bvh);
    probe.upload(blob.root, blob.rays[set].rays);
    probe.run_closest(); // PoCL generates code at the first launch
    for (auto _ : state) state.SetIterationTime(probe.run_closest());
    state.SetItemsProcessed(state.iterations() * std::int64_t(blob.rays[set].rays.size()));
}

} // namespace

void register_traversal() {
    for (std::size_t set = 0; set < std::size(sets); ++set)
        benchmark::RegisterBenchmark(fmt::format("traversal/closest/{}", sets[set]).c_str(), measure, set)
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond);
}

} // namespace nacre::bench
