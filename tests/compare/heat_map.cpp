// Where pictures differ is where the heat map says.
#include "compare/heat_map.h"
#include "compare/noise.h"
#include <gtest/gtest.h>
#include <limits>

namespace nacre {
namespace {

using Pixel = std::array<float, 3>;

class HeatMap : public testing::Test {
  protected:
    compare::Estimate a = noisy({40, 36}, 64, 1), b = a;
    HeatMap() {
        for (compare::Estimate *picture : {&a, &b})
            for (std::size_t i = 0; i < picture->mean.size(); ++i) {
                picture->mean[i] = {1, 1, 1};
                picture->variance[i] = {1e-4f, 1e-4f, 1e-4f};
            }
    }
    Pixel color(int x, int y) const {
        const io::Picture map = compare::heat_map(a, b, compare::test(a, b, 1e-3));
        const float *pixel = map.pixels.data() + 3 * std::size_t(y * 40 + x);
        return {pixel[0], pixel[1], pixel[2]};
    }
};

constexpr Pixel black{0, 0, 0}, yellow{1, 0.9f, 0}, cyan{0, 0.9f, 1}, magenta{1, 0, 1};

TEST_F(HeatMap, IsBlackWhereNothingDiffers) { EXPECT_EQ(color(7, 7), black); }

TEST_F(HeatMap, ShowsPixelsBeyondTheLimit) {
    a.mean[20 * 40 + 25][2] = 1.3f;
    b.mean[20 * 40 + 5][0] = 1.3f;
    EXPECT_EQ(color(25, 20), yellow) << "A is brighter";
    EXPECT_EQ(color(5, 20), cyan) << "B is";
    EXPECT_GT(color(27, 18)[0], 0) << "around it the mean differs, not so much";
    EXPECT_EQ(color(15, 20), black);
}

TEST_F(HeatMap, FramesTilesBeyondTheLimit) {
    for (int y = 16; y < 32; ++y)
        for (int x = 16; x < 32; ++x) a.mean[std::size_t(y * 40 + x)][1] = 0.988f;
    EXPECT_EQ(color(16, 16), cyan);
    EXPECT_EQ(color(31, 20), cyan);
    EXPECT_GT(color(24, 24)[2], 0.5f) << "blue within";
    EXPECT_EQ(color(24, 24)[0], 0);
    EXPECT_EQ(color(8, 24), black);
    EXPECT_EQ(color(39, 35), black) << "the tile beside it, which is cut off";
}

TEST_F(HeatMap, ShowsWhatIsNoNumber) {
    a.mean[3][0] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(color(3, 0), magenta);
}

TEST_F(HeatMap, NumbersAreThoseOfTheTest) {
    a.mean[20 * 40 + 25][2] = 1.3f;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) b.mean[std::size_t(y * 40 + x)][0] = 1.02f;
    const compare::Verdict verdict = compare::test(a, b, 1e-3);
    const io::Picture map = compare::score_map(a, b);
    EXPECT_EQ(map.channels, (std::vector<std::string>{"R", "G", "B", "tile.R", "tile.G", "tile.B"}));
    EXPECT_FLOAT_EQ(map.pixels[(20 * 40 + 25) * 6 + 2], float(verdict.pixels.z));
    EXPECT_FLOAT_EQ(map.pixels[(9 * 40 + 15) * 6 + 3], float(verdict.tiles.z));
    EXPECT_EQ(map.pixels[(9 * 40 + 16) * 6 + 3], 0);
}

} // namespace
} // namespace nacre
