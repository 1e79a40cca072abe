// `nacre albedo`: what it prints, charts, and what it refuses.
#include "cli/cli.h"
#include <cmath>
#include <fstream>

namespace nacre {
namespace {

class Albedo : public Cli {
  protected:
    static Outcome albedo(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "albedo");
        return run(arguments);
    }
};

TEST_F(Albedo, SaysWhatGivesAColor) {
    const Outcome outcome = albedo({"--color", "0.8,0.5,0", "--g", "0.8", "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const nlohmann::json answer = nlohmann::json::parse(outcome.out);
    const double asked[] = {.8, .5, 0};
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(double(answer["expected_color"][c]), asked[c], 2e-4);
    EXPECT_EQ(answer["albedo"][2], 0);
    EXPECT_GT(double(answer["albedo"][0]), double(answer["albedo"][1]));
    EXPECT_FALSE(answer.contains("measured_color"));
}

// Bleed, flights and entry are those of the material, in the albedo as in the colour that is expected of it.
TEST_F(Albedo, KnowsFlightsAndEntry) {
    std::vector<double> albedos;
    for (const auto &[flight, entry] :
         {std::pair("renewal", "lambert"), {"reciprocal", "lambert"}, {"renewal", "uniform"}}) {
        const Outcome outcome =
            albedo({"--color", "0.6", "--g", "0.3", "--bleed", "0.8", "--flight", flight, "--entry", entry, "--json"});
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        const nlohmann::json answer = nlohmann::json::parse(outcome.out);
        EXPECT_NEAR(double(answer["expected_color"][0]), .6, 2e-4);
        albedos.push_back(answer["albedo"][0]);
    }
    EXPECT_GT(albedos[1], albedos[0] + .001);
    EXPECT_LT(albedos[2], albedos[0] - .001);
}

// Chiang's formula does not know g: at .8 it is far off, and the answer says so.
TEST_F(Albedo, OtherInversionsAreOff) {
    const Outcome outcome = albedo({"--color", "0.5", "--g", "0.8", "--inversion", "chiang", "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_LT(double(nlohmann::json::parse(outcome.out)["expected_color"][0]), .4);
}

TEST_F(Albedo, RendersAPatchToCheck) {
    const Outcome outcome =
        albedo({"--color", "0.7", "--g", "0.5", "--check", "--error", "0.003", "--json", "--quiet"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const nlohmann::json answer = nlohmann::json::parse(outcome.out);
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_LE(double(answer["standard_error"][c]), .003);
        EXPECT_NEAR(double(answer["measured_color"][c]), .7, 4 * double(answer["standard_error"][c]));
    }
}

// Noise alone is in the chart of the table, of some two codes at so few samples; Chiang's is off by dozens.
TEST_F(Albedo, DrawsAChart) {
    const auto off = [&](const std::string &inversion, const std::string &spp) {
        const Outcome outcome =
            albedo({"chart", "-o", path("chart.png"), "--spp", spp, "--g", "0.8", "--inversion", inversion, "--quiet"});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        const std::string says = "off by at most ";
        const std::size_t at = outcome.out.find(says);
        return at == std::string::npos ? -1 : std::stod(outcome.out.substr(at + says.size()));
    };
    EXPECT_GT(off("chiang", "1"), 20);
    const double table = off("table", "4");
    EXPECT_GE(table, 0);
    EXPECT_LT(table, 6);
    const auto picture = read_picture(path("chart.png"));
    ASSERT_TRUE(picture);
    EXPECT_GT(picture->width, 6 * 192);
    // The second row's first patch is orange (214, 126, 44): 96 pixels of what was asked for in one row, exactly.
    int longest = 0;
    for (int y = 0; y < picture->height; ++y)
        for (int x = 0, run = 0; x < picture->width; ++x) {
            const float *pixel =
                picture->pixels.data() +
                (std::size_t(y) * std::size_t(picture->width) + std::size_t(x)) * picture->channels.size();
            const auto is = [&](int c, int code) { return std::lround(255 * pixel[c]) == code; };
            run = is(0, 214) && is(1, 126) && is(2, 44) ? run + 1 : 0;
            longest = std::max(longest, run);
        }
    EXPECT_GE(longest, 96);
    EXPECT_LT(longest, 192);
}

TEST_F(Albedo, RefusesWhatItCannotAnswer) {
    expect_error(albedo({}), 2, "--color: is missing");
    expect_error(albedo({"--color", "red"}), 2, "neither one number nor three");
    expect_error(albedo({"--color", "0.1,0.2"}), 2, "neither one number nor three");
    expect_error(albedo({"--color", "1.5"}), 2, "out of range");
    expect_error(albedo({"--color", "0.5", "--g", "1"}), 2, "out of range");
    expect_error(albedo({"--color", "0.5", "--inversion", "tables"}), 2, "did you mean 'table'");
    expect_error(albedo({"chart", "-o", path("chart.txt")}), 2, ".png");
    expect_error(albedo({"chart", "-o", path("no/chart.png")}), 5, "does not exist");
    expect_error(albedo({"build", "-o", path("no/table")}), 5, "does not exist");
    expect_error(albedo({"fit", "-o", path("no")}), 5, "does not exist");
    std::ofstream(path("albedo_survey.csv")) << "something else\n";
    expect_error(albedo({"fit", "-o", folder.string(), "--quiet"}), 3, "is no survey of albedos");
}

} // namespace
} // namespace nacre
