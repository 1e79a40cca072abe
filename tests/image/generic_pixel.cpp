// A pixel depends on scene, seed, pixel and sample alone (design rule 7).
#include "image/rendered.h"
#include <atomic>
#include <cstring>
#include <gtest/gtest.h>

namespace nacre {
namespace {

// Walks under a coat; odd sizes, so that tiles hang over the edges.
scene::Scene skin(std::uint32_t spp = 20) {
    scene::Scene scene = io::load_scene(NACRE_SCENES "/features/skin.json");
    scene.image = {45, 37};
    scene.render.spp = spp;
    return scene;
}

bool same(const Rendered &a, const Rendered &b) {
    return a.picture.pixels.size() == b.picture.pixels.size() &&
           std::memcmp(a.picture.pixels.data(), b.picture.pixels.data(), a.picture.pixels.size() * sizeof(float)) == 0;
}

TEST(Pixel, SeedDecides) {
    scene::Scene scene = skin();
    const Rendered once = rendered(scene);
    EXPECT_TRUE(same(once, rendered(scene)));
    scene.render.seed = 1;
    EXPECT_FALSE(same(once, rendered(scene)));
}

TEST(Pixel, CropIsPartOfTheWhole) {
    const scene::Scene scene = skin();
    const Rendered whole = rendered(scene);
    const render::Crop crop{11, 5, 30, 36};
    const Rendered part = rendered(scene, {.layers = {}, .crop = crop});
    ASSERT_EQ(part.picture.width, 19);
    ASSERT_EQ(part.picture.height, 31);
    for (int y = 0; y < part.picture.height; ++y)
        for (int x = 0; x < part.picture.width; ++x)
            for (std::size_t c = 0; c < 4; ++c)
                ASSERT_EQ(part.at(x, y, c), whole.at(x + 11, y + 5, c)) << "pixel " << x << ", " << y;
}

// Launches follow the time they take: a bigger picture around the same pixels is cut up otherwise.
TEST(Pixel, LaunchesDoNotMatter) {
    const scene::Scene scene = skin(70); // past the first block of samples
    const render::Crop small{20, 15, 21, 16};
    const Rendered whole = rendered(scene), one = rendered(scene, {.layers = {}, .crop = small});
    for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(one.at(0, 0, c), whole.at(20, 15, c));
}

// A render that is stopped keeps what every pixel has by then, which is the picture of as many samples.
TEST(Pixel, StoppedIsShorter) {
    render::Options options;
    options.layers.samples = true;
    std::atomic<bool> stop{false};
    render::Session session(device::open_device(), skin(64), options);
    const auto stop_soon = [&](const render::Progress &progress) { stop = progress.samples > progress.wanted * 2 / 5; };
    ASSERT_FALSE(session.render(64, stop_soon, &stop));
    const Rendered stopped{session.picture(), session.statistics()};

    double samples = 0;
    for (std::size_t i = 4; i < stopped.picture.pixels.size(); i += 5) samples += stopped.picture.pixels[i];
    EXPECT_EQ(samples, double(stopped.statistics.samples));
    for (const std::uint32_t x : {0u, 22u, 44u}) {
        const render::Crop pixel{x, x / 2, x + 1, x / 2 + 1};
        const float count = stopped.at(int(x), int(x / 2), 4);
        ASSERT_GT(count, 0);
        ASSERT_LT(count, 64);
        const Rendered shorter = rendered(skin(std::uint32_t(count)), {.layers = {}, .crop = pixel});
        for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(shorter.at(0, 0, c), stopped.at(int(x), int(x / 2), c)) << x;
    }
}

} // namespace
} // namespace nacre
