// The specialised kernel and the generic one: the same image to the bit, for every scene under scenes/.
#include "image/rendered.h"
#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>

namespace nacre {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> scenes() {
    std::vector<std::string> found;
    for (const auto &entry : fs::recursive_directory_iterator(NACRE_SCENES)) {
        if (entry.path().extension() != ".json") continue;
        if (entry.path().stem().string().rfind("figure", 0) == 0) continue; // a contact sheet, no scene
#ifndef NACRE_HEAD
        if (entry.path().stem() == "head") continue; // its mesh is not in this repository
#endif
        found.push_back(fs::relative(entry.path(), NACRE_SCENES).string());
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::string test_name(const testing::TestParamInfo<std::string> &info) {
    std::string name = fs::path(info.param).replace_extension().string();
    std::replace(name.begin(), name.end(), '/', '_');
    return name;
}

class Generic : public testing::TestWithParam<std::string> {};

TEST_P(Generic, SameImage) {
#ifdef NACRE_HEAD
    setenv("NACRE_ASSETS", NACRE_HEAD, 0);
#endif
    scene::Scene scene = io::load_scene(fs::path(NACRE_SCENES) / GetParam());
    scene.image = {40, 40 * scene.image.height / scene.image.width};
    scene.render.spp = 3;
    render::Options options;
    options.layers = {.albedo = true,
                      .normal = true,
                      .depth = true,
                      .variance = true,
                      .samples = true,
                      .zero = true,
                      .single = true,
                      .multiple = true,
                      .steps = true};
    const Rendered specialised = rendered(scene, options);
    options.generic = true;
    const Rendered generic = rendered(scene, options);

    EXPECT_FALSE(specialised.statistics.generic);
    EXPECT_TRUE(generic.statistics.generic);
    expect_same_pixels(specialised.picture, generic.picture);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Generic, testing::ValuesIn(scenes()), test_name);

} // namespace
} // namespace nacre
