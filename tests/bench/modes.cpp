// Modes of error_time that compile kernels with definitions of their own render the light that the default does.
#include "error_time/modes.h"
#include "compare/significance.h"
#include "image/rendered.h"
#include <algorithm>
#include <gtest/gtest.h>

namespace nacre::bench {

void PrintTo(const Mode &mode, std::ostream *out) { *out << mode.name; }

namespace {

constexpr double alpha = 1e-3; // of all tests of a picture together: pixels, tiles and the whole

/// Skin, a lamp and a floor, on which light goes back and forth.
Rendered shown(const Mode &mode, std::uint32_t seed) {
    Setup setup{io::load_scene(NACRE_SCENES "/features/skin.json", {{"camera.fov", "24"}}), {}, 256, 0};
    setup.options.layers.variance = setup.options.layers.samples = true;
    setup.scene.image = {48, 48};
    setup.scene.render.spp = setup.spp;
    setup.scene.render.seed = seed;
    mode.apply(setup);
    return rendered(setup.scene, setup.options);
}

std::vector<Mode> defined() {
    std::vector<Mode> found;
    for (const Mode &mode : modes()) {
        Setup setup;
        mode.apply(setup);
        if (!setup.options.definitions.empty()) found.push_back(mode);
    }
    return found;
}

class DefinedModes : public testing::TestWithParam<Mode> {};

TEST_P(DefinedModes, ShowTheSame) {
    static const Rendered usual = shown(modes().front(), 1);
    const Rendered same_seed = shown(GetParam(), 1), other_seed = shown(GetParam(), 2);
    EXPECT_NE(same_seed.picture.pixels, usual.picture.pixels) << "its definitions change nothing";
    EXPECT_NE(same_seed.picture.metadata.at("kernel"), usual.picture.metadata.at("kernel"))
        << "caches would mix the two";
    const compare::Verdict verdict = compare::test(compare::estimate_of(other_seed.picture, GetParam().name),
                                                   compare::estimate_of(usual.picture, "default"), alpha);
    EXPECT_FALSE(verdict.different()) << verdict.p;
}

INSTANTIATE_TEST_SUITE_P(Modes, DefinedModes, testing::ValuesIn(defined()), [](const auto &info) {
    std::string name = info.param.name;
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
});

} // namespace
} // namespace nacre::bench
