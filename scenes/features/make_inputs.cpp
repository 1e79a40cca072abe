// Makes the pictures and meshes of the feature scenes. Small, ours, and the same on every machine.
//   make_inputs FOLDER
#include <OpenImageIO/imageio.h>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace {

constexpr double PI = 3.14159265358979323846;
using Color = std::vector<double>;

/// `at` gives the encoded value of a pixel, 0..1 for PNG.
void picture(const std::string &file, int width, int height, int channels, const std::function<Color(int, int)> &at) {
    const bool png = file.ends_with(".png");
    OIIO::ImageSpec spec(width, height, channels, png ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
    std::vector<float> values;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const double value : at(x, y)) values.push_back(float(value));
    const auto out = OIIO::ImageOutput::create(file);
    if (!out || !out->open(file, spec) || !out->write_image(OIIO::TypeDesc::FLOAT, values.data()) || !out->close())
        std::exit((std::fprintf(stderr, "make_inputs: %s cannot be written\n", file.c_str()), 5));
}

/// A dusk: blue above, warm at the horizon, dark below, and a sun of one pixel that holds about half of the light.
Color sky(int x, int y) {
    const double up = std::cos((y + 0.5) / 32 * PI);
    if (x == 40 && y == 10) return {900, 760, 520};
    if (up < 0) return {0.08, 0.07, 0.06};
    const double glow = std::exp(-6 * up);
    return {0.25 + 0.9 * glow, 0.45 + 0.35 * glow, 0.9 - 0.5 * glow};
}

Color checker(int x, int y) { return (x / 8 + y / 8) % 2 ? Color{0.91, 0.64, 0.51} : Color{0.35, 0.52, 0.61}; }

/// Stripes that go from a mirror to chalk.
Color roughness(int x, int) { return {0.1 + 0.2 * (x / 16)}; }

/// Tangent-space normals of a waffle, z = .1 cos(2 pi 4 u) cos(2 pi 4 v) with u, v over the picture; green is up.
Color waffle(int x, int y) {
    const double u = (x + 0.5) / 64 * 8 * PI, v = (y + 0.5) / 64 * 8 * PI, steep = 0.6;
    const double n[3] = {steep * std::sin(u) * std::cos(v), -steep * std::cos(u) * std::sin(v), 1};
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    return {n[0] / length * 0.5 + 0.5, n[1] / length * 0.5 + 0.5, n[2] / length * 0.5 + 0.5};
}

struct Mesh {
    std::vector<std::array<double, 3>> points;
    std::vector<std::array<std::size_t, 3>> triangles;

    /// A closed sphere, outward. `open` leaves out that many rings of triangles at the top.
    void sphere(std::array<double, 3> center, double radius, int open = 0) {
        constexpr int rings = 12, sectors = 24;
        const std::size_t first = points.size();
        const auto add = [&](double y, double r, double angle) {
            points.push_back({center[0] + radius * r * std::cos(angle), center[1] + radius * y,
                              center[2] + radius * r * std::sin(angle)});
        };
        add(1, 0, 0);
        for (int ring = 1; ring < rings; ++ring)
            for (int s = 0; s < sectors; ++s)
                add(std::cos(ring * PI / rings), std::sin(ring * PI / rings), s * 2 * PI / sectors);
        add(-1, 0, 0);
        const auto at = [&](int ring, int s) {
            if (ring == 0) return first;
            if (ring == rings) return points.size() - 1;
            return first + 1 + std::size_t((ring - 1) * sectors + s % sectors);
        };
        for (int ring = open; ring < rings; ++ring)
            for (int s = 0; s < sectors; ++s) {
                if (ring > 0) triangles.push_back({at(ring, s), at(ring, s + 1), at(ring + 1, s)});
                if (ring < rings - 1) triangles.push_back({at(ring, s + 1), at(ring + 1, s + 1), at(ring + 1, s)});
            }
    }

    void write(const std::string &file) const {
        std::ofstream out(file);
        out << "ply\nformat ascii 1.0\ncomment made by make_inputs.cpp\nelement vertex " << points.size()
            << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << triangles.size()
            << "\nproperty list uchar int vertex_indices\nend_header\n";
        for (const auto &p : points) {
            char line[64];
            std::snprintf(line, sizeof line, "%.5f %.5f %.5f\n", p[0], p[1], p[2]);
            out << line;
        }
        for (const auto &t : triangles) out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
        if (!out.flush()) std::exit((std::perror(file.c_str()), 5));
    }
};

} // namespace

int main(int argc, char **argv) {
    if (argc != 2) return std::fputs("usage: make_inputs FOLDER\n", stderr), 2;
    const std::string folder = std::string(argv[1]) + "/";
    picture(folder + "sky.hdr", 64, 32, 3, sky);
    picture(folder + "checker.png", 64, 64, 3, checker);
    picture(folder + "roughness.png", 64, 1, 1, roughness);
    picture(folder + "waffle.png", 64, 64, 3, waffle);
    Mesh shells;
    shells.sphere({0, 0, 0}, 1);
    shells.sphere({0.25, 0.1, 0.2}, 0.5); // wholly within the first
    shells.sphere({-0.9, 0.5, 0}, 0.45);  // across its surface
    shells.write(folder + "shells.ply");
    Mesh open;
    open.sphere({0, 0, 0}, 1, 2);
    open.write(folder + "open.ply");
}
