// `nacre compare`: what it prints, what it writes, and the exit codes that others' tests go by.
#include "cli/cli.h"
#include "io/image.h"
#include <algorithm>
#include <random>

namespace nacre {
namespace {

/// What a test's picture is like.
struct Like {
    int seed = 1;
    double red = 0.5; // G and B are .5
    float samples = 32;
    int width = 16, height = 12, x = 0;
    std::vector<std::string> layers{"variance.R", "variance.G", "variance.B", "samples"};
};

class Compare : public Cli {
  protected:
    /// Writes a picture with noise of .05 (the variance layer says so), which need not be rendered.
    std::string picture(const std::string &name, const Like &like = {}) const {
        io::Picture picture;
        picture.width = like.width;
        picture.height = like.height;
        picture.crop_x = like.x;
        picture.full_width = picture.full_height = 64;
        picture.channels = {"R", "G", "B", "A"};
        picture.channels.insert(picture.channels.end(), like.layers.begin(), like.layers.end());
        picture.metadata = {{"seed", std::to_string(like.seed)}, {"scene", like.red == 0.5 ? "one" : "other"}};
        std::mt19937 random{unsigned(like.seed)};
        std::normal_distribution<float> noise(0, 0.05f);
        for (int i = 0; i < like.width * like.height; ++i) {
            for (const double mean : {like.red, 0.5, 0.5}) picture.pixels.push_back(float(mean) + noise(random));
            picture.pixels.push_back(1);
            for (const std::string &layer : like.layers)
                picture.pixels.push_back(layer == "samples" ? like.samples : 0.0025f);
        }
        io::write_picture(path(name), picture, 0);
        return path(name);
    }

    static Outcome compare(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "compare");
        return run(arguments);
    }
};

const Like redder{.seed = 2, .red = 0.55};

// The one test that renders: the others know their noise.
TEST_F(Compare, RendersOfOtherSeedsAreAlikeAndOfAnotherLightAreNot) {
    const std::string skin = NACRE_SCENES "/features/skin.json";
    const auto render = [&](const std::string &name, std::vector<std::string> more) {
        more.insert(more.end(), {"--spp", "32", "--quiet"});
        EXPECT_EQ(run(small_render(skin, name, more)).code, 0);
        return path(name);
    };
    const std::string a = render("a.exr", {"--seed", "1"}), b = render("b.exr", {"--seed", "2"});
    const std::string sky = render("c.exr", {"--seed", "3", "--set", "lights.0.radiance=[0.5,0.3,0.35]"});
    const Outcome alike = compare({a, b}), different = compare({sky, b});
    EXPECT_EQ(alike.code, 0) << alike.out;
    EXPECT_EQ(alike.err, "") << "32 samples are enough for single pixels";
    EXPECT_EQ(different.code, 1) << different.out;
}

TEST_F(Compare, TextIsToBeRead) {
    const Outcome outcome = compare({picture("a.exr"), picture("b.exr", {.seed = 2})});
    EXPECT_EQ(outcome.code, 0) << outcome.out;
    EXPECT_EQ(outcome.err, "");
    for (const char *text : {"a.exr, 32 samples a pixel", "MSE  ", "relMSE  ", "PSNR  ", " dB", "FLIP  ", "pixels ",
                             "tiles ", "picture ", "\nalike: p ", "alpha 0.001"})
        EXPECT_NE(outcome.out.find(text), std::string::npos) << text << " in\n" << outcome.out;
}

TEST_F(Compare, OthersAreDifferent) {
    const Outcome outcome = compare({picture("a.exr", redder), picture("b.exr")});
    EXPECT_EQ(outcome.code, 1) << outcome.out;
    EXPECT_NE(outcome.out.find("\ndifferent: p "), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.err, "") << "a finding is no error";
}

TEST_F(Compare, JsonHasItAll) {
    const std::string a = picture("a.exr", redder), b = picture("b.exr");
    const Outcome outcome = compare({a, b, "--json", "--alpha", "1e-4"});
    EXPECT_EQ(outcome.code, 1);
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json["a"]["file"], a);
    EXPECT_EQ(json["a"]["samples"], 32);
    EXPECT_EQ(json["a"]["metadata"]["seed"], "2");
    EXPECT_NE(json["a"]["metadata"]["scene"], json["b"]["metadata"]["scene"]);
    EXPECT_EQ(json["size"], nlohmann::json::parse("[16, 12]"));
    for (const char *key : {"mse", "relmse", "psnr"}) EXPECT_GT(json["metrics"][key], 0) << key;
    EXPECT_GT(json["metrics"]["flip"]["mean"], 0);
    EXPECT_EQ(json["test"]["different"], true);
    EXPECT_EQ(json["test"]["alpha"], 1e-4);
    EXPECT_LT(json["test"]["p"], 1e-4);
    EXPECT_EQ(json["test"]["pixels"]["tested"], 16 * 12 * 3);
    EXPECT_EQ(json["test"]["tiles"]["tested"], 3);
    EXPECT_EQ(json["test"]["picture"]["worst"]["channel"], "R");
    EXPECT_GT(json["test"]["channels"][0]["mean_a"], json["test"]["channels"][0]["mean_b"]);
}

TEST_F(Compare, EqualPicturesAreAlikeAndSaySo) {
    const std::string a = picture("a.exr");
    const Outcome outcome = compare({a, a, "--json"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "nacre: warning: the pictures are equal to the bit\n");
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json["metrics"]["mse"], 0);
    EXPECT_TRUE(json["metrics"]["psnr"].is_null()) << "infinite";
    EXPECT_EQ(json["test"]["p"], 1);
}

TEST_F(Compare, EqualSeedsAreRemarkedOn) {
    const Outcome outcome = compare({picture("a.exr", {.seed = 2}), picture("b.exr", redder)});
    EXPECT_NE(outcome.err.find("both pictures have seed 2"), std::string::npos) << outcome.err;
}

TEST_F(Compare, FewSamplesAreRemarkedOn) {
    const Outcome outcome =
        compare({picture("a.exr", {.seed = 1, .samples = 4}), picture("b.exr", {.seed = 2, .samples = 4}), "--json"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.err.find("single pixels can be told apart from 15 samples on"), std::string::npos) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["remarks"].size(), 1u);
}

TEST_F(Compare, HeatMaps) {
    const std::string a = picture("a.exr", redder), b = picture("b.exr");
    EXPECT_EQ(compare({a, b, "--heatmap", path("z.png")}).code, 1);
    const auto colors = read_picture(folder / "z.png");
    ASSERT_TRUE(colors);
    EXPECT_EQ(colors->width, 16);
    EXPECT_EQ(colors->channels.size(), 3u);
    EXPECT_EQ(compare({a, b, "--heatmap", path("z.exr")}).code, 1);
    const auto numbers = read_picture(folder / "z.exr");
    ASSERT_TRUE(numbers);
    EXPECT_EQ(numbers->channels.size(), 6u);
    EXPECT_LT(*std::min_element(numbers->pixels.begin(), numbers->pixels.end()), 0) << "z is signed";
}

TEST_F(Compare, CropsLieWhereTheyLay) {
    const std::string a = picture("a.exr", {.x = 4}), b = picture("b.exr", {.seed = 2, .x = 4});
    EXPECT_EQ(nlohmann::json::parse(compare({a, b, "--json"}).out)["test"]["tiles"]["worst"]["x"], 4) << "of the whole";
    expect_error(compare({a, picture("c.exr", {.x = 5})}), 3, "the same size and crop");
}

TEST_F(Compare, OtherSizesAreNoComparison) {
    const std::string a = picture("a.exr"), b = picture("b.exr", {.height = 13});
    expect_error(compare({a, b}), 3, "16 x 13");
    expect_error(compare({a, b}), 3, "a.exr is 16 x 12 pixels");
}

// The metrics are printed, and that there is no test is an error: a test that is silently left out would always pass.
TEST_F(Compare, WithoutVarianceThereAreMetricsOnly) {
    const std::string a = picture("a.exr"), b = picture("b.exr", {.layers = {}});
    const Outcome outcome = compare({a, b});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_NE(outcome.out.find("relMSE"), std::string::npos);
    EXPECT_EQ(outcome.out.find("alike"), std::string::npos);
    EXPECT_NE(outcome.err.find("nacre: error: " + b + ": has no layers 'variance' and 'samples'"), std::string::npos)
        << outcome.err;
    EXPECT_TRUE(nlohmann::json::parse(compare({b, a, "--json"}).out)["test"].is_null());
    EXPECT_EQ(compare({picture("c.exr", {.layers = {"variance.R", "variance.G", "variance.B"}}), a}).code, 3)
        << "nor without samples";
}

TEST_F(Compare, FilesThatAreNoPictures) {
    const std::string a = picture("a.exr");
    expect_error(compare({a, path("none.exr")}), 3, "none.exr: no such picture");
    expect_error(compare({folder.string(), a}), 3, "is a folder");
    put(folder / "text.exr", "not a picture");
    expect_error(compare({a, path("text.exr")}), 3, "text.exr: cannot be read as a picture");
    expect_error(compare({a, picture("b.png")}), 3, "b.png: is no flat EXR");
    const std::string bytes = bytes_of(a);
    put(folder / "cut.exr", bytes.substr(0, bytes.size() / 2));
    expect_error(compare({a, path("cut.exr")}), 3, "cut.exr: cannot be read");
}

TEST_F(Compare, OptionsAreCheckedBeforeTheWork) {
    const std::string a = picture("a.exr");
    expect_error(compare({a}), 2, "b is required");
    expect_error(compare({a, a, "--alpha", "0"}), 2, "--alpha");
    expect_error(compare({a, a, "--alpha", "1"}), 2, "--alpha");
    expect_error(compare({a, a, "--heatmap", path("z.jpg")}), 2, "z.jpg");
    expect_error(compare({a, a, "--heatmap", path("none/z.png")}), 5, "its folder does not exist");
    EXPECT_EQ(files(), 1u);
}

} // namespace
} // namespace nacre
