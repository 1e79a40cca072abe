#include "portable/portable.h"
#include <cmath>

namespace nacre {

std::vector<SmallScene> small_scenes() {
    return {
        {"skin",
         {{"materials.thing.subsurface_bleed", "0.5"},
          {"materials.thing.subsurface_scatter_anisotropy", "[0.7, 0.5, -0.2]"}}},
        {"reciprocal",
         {{"render.channel_sampling", "throughput"},
          {"render.guiding", "dwivedi"},
          {"materials.thing.subsurface_radius", "0.03"}}},
        {"depth_cap", {{"render.guiding", "none"}}},
        {"internal_reflection"},
        {"nested_shells"},
        // Walks with a control variate, which pictures of scattering orders have none of.
        {.name = "subsurface", .set = {{"materials.thing.subsurface_radius", "0.05"}}, .layers = "albedo"},
        {.name = "plate", .layers = "albedo"},
        {"dipole"},
        {"texture"},
        {"normal_map"},
        {"metal"},
        {"emissive_mesh"},
        {"environment_image"},
        {"directional"},
        {"point"},
        {"lens"},
        // One path inside a white ball, of more steps than a launch takes: it is suspended on the way.
        {.name = "diffuse",
         .set = {{"camera.position", "[0, 0, 0]"},
                 {"camera.target", "[0, 0, 1]"},
                 {"materials.thing.base_color", "0.999"},
                 {"render.max_depth", "0"},
                 {"render.seed", "30"},
                 {"lights.1.center", "[0, 0.5, 0]"},
                 {"lights.1.u", "[0.2, 0, 0]"},
                 {"lights.1.v", "[0, 0, 0.2]"}},
         .size = "1x1",
         .spp = "1",
         .rays = 513},
    };
}

std::string test_name(const testing::TestParamInfo<SmallScene> &info) { return info.param.name; }

namespace {

bool is_close(double a, double b, double mean) {
    return std::abs(a - b) <= 1e-3 * std::max({std::abs(a), std::abs(b), std::abs(mean)});
}

} // namespace

Difference difference(const PictureFile &a, const PictureFile &b) {
    const std::size_t channels = a.channels.size(), pixels = a.pixels.size() / channels;
    std::vector<bool> off(pixels);
    Difference found;
    for (std::size_t c = 0; c < channels; ++c) {
        double mean = 0, other = 0, variance = 0;
        for (std::size_t i = 0; i < pixels; ++i) {
            mean += a.pixels[i * channels + c] / double(pixels);
            other += b.pixels[i * channels + c] / double(pixels);
        }
        for (std::size_t i = 0; i < pixels; ++i) {
            const double value = a.pixels[i * channels + c];
            variance += (value - mean) * (value - mean) / double(pixels - 1);
            if (!is_close(value, b.pixels[i * channels + c], mean)) off[i] = true;
        }
        // A channel that is the same everywhere (alpha) has no error to compare with.
        if (variance > 0)
            found.mean = std::max(found.mean, std::abs(mean - other) / std::sqrt(variance / double(pixels)));
    }
    found.share = double(std::count(off.begin(), off.end(), true)) / double(pixels);
    return found;
}

void Probes::expect_ran(const Outcome &outcome) {
    EXPECT_EQ(outcome.code, 0) << "signal " << outcome.signal << "\n" << outcome.err << outcome.out;
    EXPECT_EQ(outcome.out.find("Running 0 tests"), std::string::npos) << outcome.out;
}

std::vector<std::string> options_of(const SmallScene &scene) {
    std::vector<std::string> all{"--size", scene.size,   "--spp",    scene.spp,
                                 "--aov",  scene.layers, "--strict", "--quiet"};
    for (const auto &[what, value] : scene.set) all.insert(all.end(), {"--set", what + "=" + value});
    return all;
}

std::vector<std::string> Portable::arguments(const std::string &name, const std::vector<std::string> &more) const {
    std::vector<std::string> all = options_of(GetParam());
    all.insert(all.end(), more.begin(), more.end());
    return small_render(GetParam().file(), name, all);
}

void Portable::expect_as_on_pocl(const std::string &name, const std::string &stats) const {
    EXPECT_GE(json_of(stats)["counters"]["rays"], GetParam().rays);
    const Outcome outcome =
        run(arguments("pocl.exr", {"--device", "Portable Computing Language", "--generic"}), {}, patience);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto here = read_picture(folder / name), pocl = read_picture(folder / "pocl.exr");
    ASSERT_TRUE(here && pocl);
    ASSERT_EQ(here->channels, pocl->channels);
    ASSERT_EQ(here->pixels.size(), pocl->pixels.size());
    EXPECT_GT(*std::max_element(here->pixels.begin(), here->pixels.end()), 0) << "a black picture shows nothing";
    const Difference found = difference(*pocl, *here);
    EXPECT_LE(found.share, 0.05) << "of the pixels differ";
    EXPECT_LE(found.mean, 0.1) << "standard errors";
}

} // namespace nacre
