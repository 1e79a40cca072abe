// What the options of render do to the picture.
#include "cli/cli.h"
#include <algorithm>

namespace nacre {
namespace {

using Names = std::vector<std::string>;

Names sorted(Names names) { // EXR files may hold them in any order
    std::sort(names.begin(), names.end());
    return names;
}

TEST_F(Cli, ExrHasEveryLayerByDefault) {
    ASSERT_EQ(run(small_render(ball, "out.exr")).code, 0);
    const auto picture = read_picture(folder / "out.exr");
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->width, 16);
    EXPECT_EQ(picture->height, 12);
    const Names names = sorted(picture->channels);
    EXPECT_EQ(names, (Names{"A", "B", "G", "N.X", "N.Y", "N.Z", "R", "albedo.B", "albedo.G", "albedo.R", "depth.Z",
                            "samples", "variance.B", "variance.G", "variance.R"}));
    // The ball fills the middle; its front is 1 nearer than its centre, which is about 5.2 away.
    const std::size_t middle = (6 * 16 + 8) * names.size();
    const auto value = [&](const char *name) {
        const auto at = std::find(picture->channels.begin(), picture->channels.end(), name) - picture->channels.begin();
        return picture->pixels[middle + std::size_t(at)];
    };
    EXPECT_EQ(value("A"), 1);
    EXPECT_NEAR(value("R"), 1, 1e-4);
    EXPECT_NEAR(value("depth.Z"), 4.2, 0.1);
    EXPECT_GT(value("N.Z"), 0.7);
    EXPECT_EQ(value("samples"), 1);
    EXPECT_EQ(picture->pixels[3], 0) << "nothing in the corner";
}

TEST_F(Cli, AovChoosesLayers) {
    ASSERT_EQ(run(small_render(ball, "two.exr", {"--aov", "depth,samples"})).code, 0);
    EXPECT_EQ(sorted(read_picture(folder / "two.exr")->channels), (Names{"A", "B", "G", "R", "depth.Z", "samples"}));
    ASSERT_EQ(run(small_render(ball, "none.exr", {"--aov", "none"})).code, 0);
    EXPECT_EQ(sorted(read_picture(folder / "none.exr")->channels), (Names{"A", "B", "G", "R"}));
}

TEST_F(Cli, AovOfScatteringOrders) {
    const std::string all = "subsurface.zero,subsurface.single,subsurface.multiple,walk.steps";
    ASSERT_EQ(run(small_render(ball, "orders.exr", {"--aov", all, "--spp", "4"})).code, 0);
    const auto picture = read_picture(folder / "orders.exr");
    EXPECT_EQ(sorted(picture->channels),
              (Names{"A", "B", "G", "R", "subsurface.multiple.B", "subsurface.multiple.G", "subsurface.multiple.R",
                     "subsurface.single.B", "subsurface.single.G", "subsurface.single.R", "subsurface.zero.B",
                     "subsurface.zero.G", "subsurface.zero.R", "walk.steps"}));
    const std::size_t middle = (6 * 16 + 8) * picture->channels.size();
    double light = 0, steps = 0;
    for (std::size_t i = 0; i < picture->channels.size(); ++i) {
        const std::string &name = picture->channels[i];
        if (name.rfind("subsurface.", 0) == 0 && name.back() == 'G') light += picture->pixels[middle + i];
        if (name == "walk.steps") steps = picture->pixels[middle + i];
    }
    EXPECT_NEAR(light, 1, 1e-4) << "a furnace is white, and all its light came through the ball";
    EXPECT_GT(steps, 0);
    ASSERT_EQ(run(small_render(ball, "one.exr", {"--aov", "walk.steps"})).code, 0);
    EXPECT_EQ(sorted(read_picture(folder / "one.exr")->channels), (Names{"A", "B", "G", "R", "walk.steps"}));
}

TEST_F(Cli, ExrSaysWhereItComesFrom) {
    ASSERT_EQ(run(small_render(ball, "out.exr", {"--seed", "7", "--spp", "3"})).code, 0);
    const auto metadata = read_picture(folder / "out.exr")->metadata;
    for (const char *key : {"scene", "kernel", "device", "seed", "samples", "features", "seconds"})
        ASSERT_TRUE(metadata.contains(std::string("nacre:") + key)) << key;
    EXPECT_EQ(metadata.at("nacre:seed"), "7");
    EXPECT_EQ(metadata.at("nacre:samples"), "0:3");
    EXPECT_NE(metadata.at("nacre:features").find("subsurface"), std::string::npos);
}

TEST_F(Cli, PngIsEightBitColour) {
    ASSERT_EQ(run(small_render(ball, "out.png")).code, 0);
    EXPECT_EQ(bytes_of(folder / "out.png").substr(0, 4), "\x89PNG");
    const auto picture = read_picture(folder / "out.png");
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->channels.size(), 3u);
    EXPECT_EQ(picture->pixels, std::vector<float>(16 * 12 * 3, 1)) << "a furnace is white";
}

TEST_F(Cli, CropIsAPartOfTheWhole) {
    const Names plain{"--aov", "none", "--quiet"};
    ASSERT_EQ(run(small_render(ball, "whole.exr", plain)).code, 0);
    ASSERT_EQ(run(small_render(ball, "part.exr", {"--aov", "none", "--crop", "5,3,12,9"})).code, 0);
    const auto whole = read_picture(folder / "whole.exr"), part = read_picture(folder / "part.exr");
    EXPECT_EQ(part->width, 7);
    EXPECT_EQ(part->height, 6);
    EXPECT_EQ(part->x, 5);
    EXPECT_EQ(part->y, 3);
    EXPECT_EQ(part->full_width, 16);
    EXPECT_EQ(part->full_height, 12);
    for (std::size_t y = 0; y < 6; ++y)
        for (std::size_t i = 0; i < 7 * 4; ++i)
            ASSERT_EQ(part->pixels[y * 28 + i], whole->pixels[((y + 3) * 16 + 5) * 4 + i]);
}

TEST_F(Cli, SeedAndSetChangeThePicture) {
    const std::string skin = NACRE_SCENES "/features/skin.json";
    const auto pixels = [&](const std::string &name, const Names &more) {
        EXPECT_EQ(run(small_render(skin, name, more)).code, 0);
        return read_picture(folder / name)->pixels;
    };
    const auto first = pixels("a.exr", {"--aov", "none"});
    EXPECT_EQ(first, pixels("b.exr", {"--aov", "none"}));
    EXPECT_NE(first, pixels("c.exr", {"--aov", "none", "--seed", "2"}));
    EXPECT_EQ(pixels("d.exr", {"--aov", "none", "--seed", "2"}),
              pixels("e.exr", {"--aov", "none", "--set", "render.seed=2"}));
    EXPECT_NE(first, pixels("f.exr", {"--aov", "none", "--set", "materials.thing.subsurface_color=[0.1,0.9,0.1]"}));
    EXPECT_EQ(first, pixels("g.exr", {"--aov", "none", "--generic"}));
}

TEST_F(Cli, BareMeshRenders) {
    ASSERT_EQ(run(small_render(NACRE_SCENES "/bear/bear.ply", "out.png")).code, 0);
    const auto picture = read_picture(folder / "out.png");
    const auto [darkest, brightest] = std::minmax_element(picture->pixels.begin(), picture->pixels.end());
    EXPECT_LT(*darkest, *brightest) << "there is something to see";
}

} // namespace
} // namespace nacre
