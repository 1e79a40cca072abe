#include "patch/chart.h"
#include "io/srgb.h"
#include "sheet/contact.h"
#include <cmath>
#include <fmt/format.h>

namespace nacre::patch {
namespace {

constexpr int side = 96; // pixels of either half of a tile

/// 8-bit sRGB of the ColorChecker's patches as its maker gave them (X-Rite 2005, "ColorChecker Classic").
constexpr std::array<std::array<int, 3>, 24> color_checker = {
    {{115, 82, 68},   {194, 150, 130}, {98, 122, 157},  {87, 108, 67},   {133, 128, 177}, {103, 189, 170},
     {214, 126, 44},  {80, 91, 166},   {193, 90, 99},   {94, 60, 108},   {157, 188, 64},  {224, 163, 46},
     {56, 61, 150},   {70, 148, 73},   {175, 54, 60},   {231, 199, 31},  {187, 86, 149},  {8, 133, 161},
     {243, 243, 242}, {200, 200, 200}, {160, 160, 160}, {122, 122, 121}, {85, 85, 85},    {52, 52, 52}}};

double code(double linear) { return 255 * io::linear_to_srgb(linear); }

/// The colour asked for on the left, the rendered patch on the right.
io::Picture side_by_side(const Vec3 &asked, const io::Picture &got) {
    io::Picture both;
    both.width = 2 * side;
    both.height = side;
    both.channels = {"R", "G", "B"};
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < 2 * side; ++x)
            for (int c = 0; c < 3; ++c)
                both.pixels.push_back(
                    x < side ? float(asked[c])
                             : got.pixels[std::size_t(y * side + x - side) * got.channels.size() + std::size_t(c)]);
    return both;
}

} // namespace

Chart color_chart(const device::Device &device, const scene::Material &material, std::uint32_t spp,
                  const std::string &title, const std::function<void(double)> &report) {
    Chart chart{};
    std::vector<sheet::Tile> tiles;
    for (const std::array<int, 3> &codes : color_checker) {
        scene::Material colored = material;
        Vec3 asked;
        for (std::size_t c = 0; c < 3; ++c) asked[Eigen::Index(c)] = io::srgb_to_linear(codes[c] / 255.0);
        colored[shared::PARAMETER_subsurface_color].value = asked;
        render::Session session(device, patch_scene(colored, 5e5, side), {});
        session.render(spp);
        const io::Picture got = session.picture();
        const Color mean = mean_color(got);
        double worst = 0;
        std::array<double, 3> shown;
        for (std::size_t c = 0; c < 3; ++c) {
            shown[c] = code(mean.value[c]);
            worst = std::max(worst, std::abs(shown[c] - codes[c]));
        }
        chart.worst = std::max(chart.worst, worst);
        tiles.push_back({side_by_side(asked, got),
                         0,
                         fmt::format("{} {} {}", codes[0], codes[1], codes[2]),
                         {fmt::format("got {:.1f} {:.1f} {:.1f}", shown[0], shown[1], shown[2])},
                         fmt::format("off by {:.2f}", worst)});
        report(double(tiles.size()) / double(color_checker.size()));
    }
    chart.picture = sheet::contact_sheet(title, 6, tiles);
    return chart;
}

} // namespace nacre::patch
