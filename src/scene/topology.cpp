#include "scene/topology.h"
#include "scene/weld.h"
#include <algorithm>
#include <map>
#include <numeric>

namespace nacre::scene {

namespace {

struct Edge {
    std::uint32_t low, high; // welded vertices
    bool forward;            // the triangle goes from low to high
    bool operator<(const Edge &other) const {
        return low != other.low ? low < other.low : high != other.high ? high < other.high : forward < other.forward;
    }
};

// Sets of vertices that hang together; each is named by one of its members.
class Sets {
  public:
    explicit Sets(std::size_t count) : parents(count) { std::iota(parents.begin(), parents.end(), 0u); }

    std::uint32_t find(std::uint32_t i) {
        while (parents[i] != i) i = parents[i] = parents[parents[i]]; // halves the path as it goes
        return i;
    }

    void join(std::uint32_t a, std::uint32_t b) { parents[find(a)] = find(b); }

  private:
    std::vector<std::uint32_t> parents;
};

std::vector<Edge> sorted_edges(const Mesh &mesh, const std::vector<std::uint32_t> &first) {
    std::vector<Edge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (const auto &triangle : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t a = first[triangle[corner]], b = first[triangle[(corner + 1) % 3]];
            edges.push_back({std::min(a, b), std::max(a, b), a < b});
        }
    std::sort(edges.begin(), edges.end());
    return edges;
}

} // namespace

Topology find_topology(const Mesh &mesh) {
    const std::vector<std::uint32_t> first = weld(mesh.positions);
    Topology topology;
    Sets sets(mesh.positions.size());
    std::vector<std::uint32_t> open; // a vertex of each open edge

    const std::vector<Edge> edges = sorted_edges(mesh, first);
    for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
        std::size_t forward = 0;
        for (end = i; end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high; ++end)
            forward += edges[end].forward;
        const std::size_t count = end - i;
        topology.open_edges += count == 1;
        topology.non_manifold_edges += count > 2;
        topology.inconsistent_edges += count == 2 && forward != 1;
        if (count == 1) open.push_back(edges[i].low);
        sets.join(edges[i].low, edges[i].high);
    }

    Vec3 centre(0, 0, 0); // volumes about the middle: a far offset costs digits
    if (!mesh.triangles.empty()) centre = bounds(mesh).center();
    std::map<std::uint32_t, Shell> shells;
    for (const auto &triangle : mesh.triangles) {
        Shell &shell = shells[sets.find(first[triangle[0]])];
        const Vec3 a = mesh.positions[triangle[0]] - centre, b = mesh.positions[triangle[1]] - centre;
        const Vec3 c = mesh.positions[triangle[2]] - centre;
        ++shell.triangles;
        shell.volume += a.dot(b.cross(c)) / 6;
        for (const std::uint32_t vertex : triangle) shell.box.extend(mesh.positions[vertex]);
    }
    for (const std::uint32_t vertex : open) shells[sets.find(vertex)].closed = false;
    for (const auto &[name, shell] : shells) topology.shells.push_back(shell);
    return topology;
}

std::size_t count_opposed_normals(const Mesh &mesh) {
    if (mesh.normals.empty()) return 0;
    return std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto &triangle) {
        const Vec3 &a = mesh.positions[triangle[0]], &b = mesh.positions[triangle[1]], &c = mesh.positions[triangle[2]];
        const Vec3 side = (b - a).cross(c - a);
        return std::any_of(triangle.begin(), triangle.end(),
                           [&](std::uint32_t vertex) { return mesh.normals[vertex].cast<double>().dot(side) < 0; });
    });
}

} // namespace nacre::scene
