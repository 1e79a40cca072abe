// Makes bear.ply, the gummy bear of bear.json: a smooth union of ellipsoids, polygonised by surface nets (Gibson 1998)
// and moved onto the surface. Closed, manifold, outward; stands on y = 0, looks along +z, about 2 units tall.
//   make_bear bear.ply
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

struct V {
    double x, y, z;
};
V operator+(V a, V b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
V operator-(V a, V b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
V operator*(V a, double s) { return {a.x * s, a.y * s, a.z * s}; }
V operator/(V a, V b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }
double dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double length(V a) { return std::sqrt(dot(a, a)); }
V cross(V a, V b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

// Turned about x (nods forward), then about z (leans), degrees.
V turn(V p, double about_x, double about_z) {
    const double a = about_x * M_PI / 180, b = about_z * M_PI / 180;
    p = {p.x * std::cos(b) + p.y * std::sin(b), p.y * std::cos(b) - p.x * std::sin(b), p.z};
    return {p.x, p.y * std::cos(a) + p.z * std::sin(a), p.z * std::cos(a) - p.y * std::sin(a)};
}

// Nearly the distance to an ellipsoid, of the right sign (Quilez, "ellipsoid").
double ellipsoid(V p, V radii) {
    const double k = length(p / radii);
    return k < 1e-9 ? -std::min({radii.x, radii.y, radii.z}) : k * (k - 1) / length(p / radii / radii);
}

// Union whose seam is rounded over a width of k (Quilez, "smooth minimum", cubic: normals are continuous).
double blend(double a, double b, double k) {
    const double h = std::max(k - std::abs(a - b), 0.0) / k;
    return std::min(a, b) - h * h * h * k / 6;
}
double carve(double a, double hole, double k) { return -blend(-a, hole, k); }

double bear(V p) {
    p.x = std::abs(p.x);
    double d = ellipsoid(p - V{0, 0.62, -0.04}, {0.47, 0.60, 0.40});                            // body
    d = blend(d, ellipsoid(p - V{0, 0.54, 0.10}, {0.41, 0.44, 0.37}), 0.16);                    // belly
    d = blend(d, ellipsoid(p - V{0.31, 0.17, 0.36}, {0.19, 0.19, 0.36}), 0.13);                 // leg
    d = blend(d, ellipsoid(turn(p - V{0.34, 0.25, 0.66}, -14, 6), {0.185, 0.235, 0.125}), 0.1); // foot
    d = blend(d, ellipsoid(turn(p - V{0.41, 0.88, 0.17}, 30, -14), {0.14, 0.15, 0.31}), 0.14);  // arm
    d = blend(d, ellipsoid(p - V{0.34, 0.75, 0.45}, {0.135, 0.125, 0.125}), 0.14);              // paw
    double head = ellipsoid(p - V{0, 1.37, 0.04}, {0.44, 0.39, 0.38});
    double ear = ellipsoid(turn(p - V{0.345, 1.71, 0}, 0, 34), {0.19, 0.215, 0.08});
    ear = carve(ear, ellipsoid(turn(p - V{0.35, 1.72, 0.09}, 0, 34), {0.115, 0.13, 0.055}), 0.06);
    head = blend(head, ear, 0.1);
    head = blend(head, ellipsoid(p - V{0, 1.27, 0.37}, {0.20, 0.155, 0.17}), 0.11);    // muzzle
    head = blend(head, ellipsoid(p - V{0, 1.36, 0.50}, {0.09, 0.065, 0.065}), 0.06);   // nose
    head = carve(head, ellipsoid(p - V{0.165, 1.46, 0.40}, {0.06, 0.07, 0.10}), 0.04); // eye
    d = blend(d, head, 0.2);
    return carve(d, p.y, 0.10); // flat where it stands
}

V gradient(V p) {
    const double e = 1e-5;
    return V{bear({p.x + e, p.y, p.z}) - bear({p.x - e, p.y, p.z}),
             bear({p.x, p.y + e, p.z}) - bear({p.x, p.y - e, p.z}),
             bear({p.x, p.y, p.z + e}) - bear({p.x, p.y, p.z - e})} *
           (0.5 / e);
}

V onto_surface(V p) {
    for (int newton = 0; newton < 4; ++newton) {
        const V g = gradient(p);
        p = p - g * (bear(p) / dot(g, g));
    }
    return p;
}

struct Mesh {
    std::vector<V> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;

    void quad(std::array<std::uint32_t, 4> q, bool turned) {
        if (turned) std::swap(q[1], q[3]);
        // The shorter diagonal gives the rounder triangles.
        if (length(points[q[0]] - points[q[2]]) < length(points[q[1]] - points[q[3]]))
            triangles.insert(triangles.end(), {{q[0], q[1], q[2]}, {q[0], q[2], q[3]}});
        else
            triangles.insert(triangles.end(), {{q[0], q[1], q[3]}, {q[1], q[2], q[3]}});
    }

    // Slivers become round: each point goes towards the middle of its neighbours, then back onto the surface.
    void relax() {
        std::vector<V> sums(points.size(), V{0, 0, 0});
        std::vector<double> counts(points.size(), 0);
        for (const auto &t : triangles)
            for (int i = 0; i < 3; ++i) {
                sums[t[i]] = sums[t[i]] + points[t[(i + 1) % 3]] + points[t[(i + 2) % 3]];
                counts[t[i]] += 2;
            }
        for (std::size_t i = 0; i < points.size(); ++i)
            points[i] = onto_surface((points[i] + sums[i] * (1 / counts[i])) * 0.5);
    }

    // Every edge has two triangles, one in each direction.
    bool closed() const {
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (const auto &t : triangles)
            for (int i = 0; i < 3; ++i)
                if (++edges[{t[i], t[(i + 1) % 3]}] > 1) return false;
        return std::all_of(edges.begin(), edges.end(), [&](const auto &e) {
            return edges.count({e.first.second, e.first.first}) == 1;
        });
    }
};

// One vertex per cell the surface crosses, one quad per grid edge it crosses.
Mesh polygonise() {
    const double h = 0.0208;
    const V low{-0.75, -0.1, -0.6};
    const int nx = 74, ny = 106, nz = 72;
    const auto index = [&](int x, int y, int z) { return (std::size_t(z) * ny + y) * nx + x; };
    const auto corner = [&](int x, int y, int z) { return low + V{x * h, y * h, z * h}; };
    std::vector<double> values(std::size_t(nx) * ny * nz);
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) values[index(x, y, z)] = bear(corner(x, y, z));

    Mesh mesh;
    std::vector<std::uint32_t> vertex(values.size());
    for (int z = 0; z + 1 < nz; ++z)
        for (int y = 0; y + 1 < ny; ++y)
            for (int x = 0; x + 1 < nx; ++x) {
                V sum{0, 0, 0};
                int crossings = 0;
                for (int a = 0; a < 8; ++a)
                    for (int axis = 1; axis < 8; axis *= 2) {
                        if (a & axis) continue;
                        const int b = a | axis;
                        const double va = values[index(x + (a & 1), y + (a >> 1 & 1), z + (a >> 2))];
                        const double vb = values[index(x + (b & 1), y + (b >> 1 & 1), z + (b >> 2))];
                        if ((va < 0) == (vb < 0)) continue;
                        const V pa = corner(x + (a & 1), y + (a >> 1 & 1), z + (a >> 2));
                        const V pb = corner(x + (b & 1), y + (b >> 1 & 1), z + (b >> 2));
                        sum = sum + pa + (pb - pa) * (va / (va - vb));
                        ++crossings;
                    }
                if (crossings == 0) continue;
                vertex[index(x, y, z)] = std::uint32_t(mesh.points.size());
                mesh.points.push_back(sum * (1.0 / crossings));
            }
    for (int z = 1; z + 1 < nz; ++z)
        for (int y = 1; y + 1 < ny; ++y)
            for (int x = 1; x + 1 < nx; ++x) {
                const bool inside = values[index(x, y, z)] < 0;
                const auto at = [&](int i, int j, int k) { return vertex[index(x - i, y - j, z - k)]; };
                if (inside != (values[index(x + 1, y, z)] < 0))
                    mesh.quad({at(0, 1, 1), at(0, 0, 1), at(0, 0, 0), at(0, 1, 0)}, !inside);
                if (inside != (values[index(x, y + 1, z)] < 0))
                    mesh.quad({at(1, 0, 1), at(1, 0, 0), at(0, 0, 0), at(0, 0, 1)}, !inside);
                if (inside != (values[index(x, y, z + 1)] < 0))
                    mesh.quad({at(1, 1, 0), at(0, 1, 0), at(0, 0, 0), at(1, 0, 0)}, !inside);
            }
    return mesh;
}

void write(const Mesh &mesh, std::ofstream out) { // little-endian, like the machines this runs on
    out << "ply\nformat binary_little_endian 1.0\ncomment made by make_bear.cpp\nelement vertex " << mesh.points.size()
        << "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\n"
        << "property float nz\nelement face " << mesh.triangles.size()
        << "\nproperty list uchar int vertex_indices\nend_header\n";
    const auto lower = [](const V &a, const V &b) { return a.y < b.y; };
    const double ground = std::min_element(mesh.points.begin(), mesh.points.end(), lower)->y;
    for (const V &p : mesh.points) {
        const V g = gradient(p), n = g * (1 / length(g));
        const float f[6] = {float(p.x), float(p.y - ground), float(p.z), float(n.x), float(n.y), float(n.z)};
        out.write(reinterpret_cast<const char *>(f), sizeof f);
    }
    for (const auto &t : mesh.triangles) out.put(3).write(reinterpret_cast<const char *>(t.data()), 12);
    if (!out.flush()) std::exit((std::perror("make_bear: cannot write"), 5));
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 2) return std::fputs("usage: make_bear OUT.ply\n", stderr), 2;
    Mesh mesh = polygonise();
    for (int round = 0; round < 4; ++round) mesh.relax();
    double volume = 0; // positive: outward
    for (const auto &t : mesh.triangles)
        volume += dot(mesh.points[t[0]], cross(mesh.points[t[1]], mesh.points[t[2]])) / 6;
    std::printf("%zu triangles, volume %.3f\n", mesh.triangles.size(), volume);
    if (!mesh.closed() || volume < 0) return std::fputs("make_bear: the mesh is not closed and outward\n", stderr), 1;
    write(mesh, std::ofstream(argv[1], std::ios::binary));
}
