#include "oracle/adding_doubling.h"
#include <gtest/gtest.h>

namespace nacre::test {
namespace {

// Against the H-function (g = 0) and discrete ordinates (g != 0), known to eight digits and more.
TEST(AddingDoubling, KnownReflectances) {
    EXPECT_NEAR(half_space_reflectance(.5, 0), .1465443807, 1e-6);
    EXPECT_NEAR(half_space_reflectance(.9, 0), .4780244892, 1e-6);
    EXPECT_NEAR(half_space_reflectance(.99, 0), .7945636529, 1e-6);
    EXPECT_NEAR(half_space_reflectance(.9, .5), .36015164, 1e-6);
    EXPECT_NEAR(half_space_reflectance(.9, .8), .21672348, 1e-6);
    EXPECT_NEAR(half_space_reflectance(.99, .8), .60264779, 1e-6);
}

} // namespace
} // namespace nacre::test
