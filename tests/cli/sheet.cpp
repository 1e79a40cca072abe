// Contact sheets: what is drawn where, what captions say, what is refused, and that an interrupt saves whole files.
#include "cli/cli.h"
#include <csignal>

namespace nacre {
namespace {

// The layout of src/sheet/contact.cpp: pixels around, between, and of the title's line with the gap below it.
constexpr int margin = 16, gap = 12, title = 28 + 12;

class Sheet : public Cli {
  protected:
    Sheet() {
        std::filesystem::create_directory(folder / "in");
        scene("ball.json", R"({"sphere": {"segments": 24}, "material": "skin"})");
    }

    /// A scene of one object, its material "skin", in a white sky that the camera does not see.
    void scene(const std::string &name, const std::string &object) const {
        put(folder / "in" / name, R"({"materials": {"skin": {"subsurface_weight": 1, "subsurface_radius": 0.3}},
            "lights": [{"type": "environment", "visible": false}], "objects": [)" +
                                      object + "]}");
    }

    /// A sheet of `panels` over ball.json, 200 x 100 pixels each; `more` are further fields of it.
    void sheet(const std::string &panels, const std::string &more = R"("spp": 4)") const {
        put(folder / "in" / "sheet.json",
            R"({"title": "A sheet", "scene": "ball.json", "image": {"width": 200, "height": 100},
            "panels": [)" +
                panels + "], " + more + "}");
    }

    Outcome render(const std::vector<std::string> &more = {}) const {
        std::vector<std::string> arguments{"sheet", path("in/sheet.json"), "-o", path("out.png"), "--quiet"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }

    PictureFile picture(const std::string &name = "out.png") const {
        auto read = read_picture(folder / name);
        if (!read) throw std::runtime_error("no picture " + name);
        return *read;
    }

    /// What is written below panel `index`.
    static std::string caption(const PictureFile &picture, int index) {
        const auto found = picture.metadata.find(fmt::format("nacre:panel.{}", index));
        return found == picture.metadata.end() ? "" : found->second;
    }

    /// Pixels of [x0, x1) x [y0, y1) that differ from the picture's corner, which is background.
    static int drawn(const PictureFile &picture, int x0, int y0, int x1, int y1) {
        int count = 0;
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x)
                count += picture.pixels[3 * std::size_t(y * picture.width + x)] != picture.pixels[0];
        return count;
    }
};

const std::string two = R"({"label": "one", "set": {"materials.skin.subsurface_bleed": 0, "render.guiding": "none"}},
                           {"label": "other", "set": {"materials.skin.subsurface_bleed": 1, "render.guiding": "none"}})";

TEST_F(Sheet, PanelsAndTheirCaptionsLieWhereTheyShould) {
    sheet(two);
    const Outcome outcome = render();
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const PictureFile sheet = picture();
    // A tile is as wide as its panel or as its longest line of text, which is about 300 pixels.
    const int cell = (sheet.width - 2 * margin - gap) / 2;
    EXPECT_GE(cell, 200);
    EXPECT_LT(cell, 400);
    const int top = margin + title, below = top + 100;
    EXPECT_GT(sheet.height, below + 40 + margin);
    EXPECT_LT(sheet.height, below + 100 + margin);
    EXPECT_GT(drawn(sheet, margin, margin, sheet.width, top - gap), 50) << "the title";
    for (const int left : {margin, margin + cell + gap}) {
        EXPECT_EQ(drawn(sheet, left, top, left + 200, below), 200 * 100) << "black sky, grey ball: no background";
        EXPECT_GT(drawn(sheet, left, below, left + cell, sheet.height - margin), 200) << "the caption";
        const auto *middle = &sheet.pixels[3 * std::size_t((top + 50) * sheet.width + left + 100)];
        EXPECT_GT(middle[0], 0.3f) << "the ball";
        EXPECT_EQ(sheet.pixels[3 * std::size_t((top + 2) * sheet.width + left + 2)], 0) << "the sky";
    }
    EXPECT_EQ(drawn(sheet, 0, 0, sheet.width, margin), 0);
    EXPECT_EQ(drawn(sheet, 0, 0, margin, sheet.height), 0);
    EXPECT_EQ(drawn(sheet, 0, sheet.height - margin, sheet.width, sheet.height), 0);
}

TEST_F(Sheet, CaptionsSayWhatDiffersAndWhatItCost) {
    sheet(two);
    ASSERT_EQ(render().code, 0);
    const std::string first = caption(picture(), 0), second = caption(picture(), 1);
    EXPECT_EQ(first.rfind("one; subsurface_bleed 0; ", 0), 0u) << first;
    EXPECT_EQ(second.rfind("other; subsurface_bleed 1; ", 0), 0u) << second;
    EXPECT_EQ(first.find("guiding"), std::string::npos) << "both have the same: " << first;
    for (const char *text : {" s, ", " 4 spp, ", "error ", " %"})
        EXPECT_NE(first.find(text), std::string::npos) << text << " in " << first;
    ASSERT_EQ(render({"--spp", "1"}).code, 0);
    EXPECT_NE(caption(picture(), 0).find("error unknown"), std::string::npos) << "one sample has no spread";
}

// The error is that of the mean: 16 times the samples, a quarter of it. 4,000 lit pixels know their mean variance to a
// few per cent.
TEST_F(Sheet, ErrorFallsWithTheRootOfSamples) {
    sheet(R"({"label": "noisy", "set": {}})");
    const auto error = [&](const char *spp) {
        EXPECT_EQ(render({"--spp", spp}).code, 0);
        const std::string text = caption(picture(), 0);
        return std::stod(text.substr(text.find("error ") + 6));
    };
    const double few = error("16"), many = error("256");
    EXPECT_GT(few, 0);
    EXPECT_NEAR(few / many, 4, 0.4);
}

TEST_F(Sheet, ColumnsAndSize) {
    sheet(two + R"(, {"label": "third"})", R"("columns": 2, "spp": 1)");
    ASSERT_EQ(render().code, 0);
    const PictureFile large = picture();
    ASSERT_EQ(render({"--size", "100x60"}).code, 0);
    EXPECT_EQ(large.height - picture().height, 2 * 40) << "two rows";
    EXPECT_EQ(drawn(large, large.width / 2 + gap, large.height - 60, large.width, large.height), 0) << "no fourth tile";
}

TEST_F(Sheet, SecondsAreTheSameForAll) {
    sheet(two, R"("seconds": 0.6)");
    ASSERT_EQ(render().code, 0);
    for (const int index : {0, 1}) {
        const std::string text = caption(picture(), index);
        const double seconds = std::stod(text.substr(text.rfind(' ', text.find(" s, ") - 1)));
        EXPECT_GE(seconds, 0.6) << text;
        EXPECT_LT(seconds, 6) << "a launch more, which is to take 0.1 s: " << text;
    }
    ASSERT_EQ(render({"--spp", "2"}).code, 0);
    EXPECT_NE(caption(picture(), 0).find(", 2 spp"), std::string::npos) << "--spp is in their place";
}

TEST_F(Sheet, FallbackIsUsedAndSaidWhereFilesAreMissing) {
    scene("head.json", R"({"mesh": "none.ply", "material": "skin"})");
    const auto with = [&](const std::string &fallback) {
        put(folder / "in" / "sheet.json",
            R"({"scene": "head.json", "title": "A head", "spp": 1, "panels": [{"label": "one"}])" + fallback + "}");
    };
    with("");
    expect_error(render(), 3, "none.ply");
    with(R"(, "fallback": "ball.json")");
    const Outcome outcome = run({"sheet", path("in/sheet.json"), "-o", path("out.png"), "--size", "32x32"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("none.ply"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("rendering ball.json"), std::string::npos) << outcome.err;
    EXPECT_EQ(picture().metadata.at("nacre:title"), "A head (ball.json: files of the scene are missing)");
}

TEST_F(Sheet, FolderTakesOnePictureForEachSheet) {
    sheet(R"({"label": "one"})");
    put(folder / "in/second.json", R"({"title": "Another", "scene": "ball.json", "panels": [{"label": "one"}]})");
    std::filesystem::create_directory(folder / "out");
    std::vector<std::string> arguments{
        "sheet",  path("in/sheet.json"), path("in/second.json"), "-o", path("out"), "--size", "16x16", "--spp", "1",
        "--quiet"};
    ASSERT_EQ(run(arguments).code, 0);
    EXPECT_EQ(picture("out/sheet.png").metadata.at("nacre:title"), "A sheet");
    EXPECT_EQ(picture("out/second.png").metadata.at("nacre:title"), "Another");
    arguments[4] = path("out/one.png");
    expect_error(run(arguments), 2, "one file for 2 sheets");
    arguments[4] = path("none");
    expect_error(run(arguments), 5, "folder does not exist");
}

// The memo's figures, on the bear. Figure 4's time is replaced by a number of samples.
TEST_F(Sheet, FiguresRenderWithoutTheHead) {
    std::vector<std::string> arguments{"sheet", "-o", folder.string(), "--size", "24x24", "--spp", "1"};
    for (const char *name : {"figure1", "figure2", "figure3", "figure4", "figure5"})
        arguments.push_back(fmt::format(NACRE_SCENES "/figures/{}.json", name));
    const Outcome outcome = run(arguments, {.environment = {{"NACRE_ASSETS", ""}}}, 300);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const auto &[name, panels] :
         {std::pair{"figure2.png", 4}, {"figure3.png", 2}, {"figure4.png", 4}, {"figure5.png", 3}}) {
        EXPECT_NE(caption(picture(name), panels - 1), "") << name;
        EXPECT_EQ(caption(picture(name), panels), "") << name;
    }
}

struct Refused {
    const char *name, *panels, *more;
    std::vector<const char *> says;
};

void PrintTo(const Refused &c, std::ostream *out) { *out << c.name; }

class BadSheet : public Sheet, public testing::WithParamInterface<Refused> {};

TEST_P(BadSheet, ExitThree) {
    sheet(GetParam().panels, GetParam().more);
    const Outcome outcome = render();
    for (const char *text : GetParam().says) expect_error(outcome, 3, text);
    EXPECT_FALSE(std::filesystem::exists(path("out.png")));
}

INSTANTIATE_TEST_SUITE_P(
    Cases, BadSheet,
    testing::Values(
        Refused{"UnknownField", R"({"label": "one"})", R"("colums": 2)", {"sheet.json", "colums", "'columns'"}},
        Refused{"UnknownFieldOfPanel",
                R"({"label": "a"}, {"label": "b", "sets": {}})",
                R"("spp": 1)",
                {"panels.1.sets", "'set'"}},
        Refused{"NoLabel", R"({"set": {}})", R"("spp": 1)", {"panels.0.label"}},
        Refused{"NoPanels", "", R"("spp": 1)", {"panels"}},
        Refused{"SppAndSeconds", R"({"label": "one"})", R"("spp": 1, "seconds": 1)", {"seconds", "spp"}},
        Refused{"BadPath",
                R"({"label": "a"}, {"label": "b", "set": {"materials.skim.subsurface_bleed": 1}})",
                R"("spp": 1)",
                {"sheet.json: panels.1.set: ", "materials.skim", "'skin'"}},
        Refused{"BadField",
                R"({"label": "a", "set": {"materials.skin.subsurface_bled": 1}})",
                R"("spp": 1)",
                {"sheet.json: panels.0.set: ", "'subsurface_bleed'"}},
        Refused{"BadValue",
                R"({"label": "a", "set": {"render.guiding": "eigne"}})",
                R"("spp": 1)",
                {"sheet.json: panels.0.set: ", "'eigen'"}}),
    [](const auto &info) { return info.param.name; });

TEST_F(Sheet, MissingSceneIsNamed) {
    put(folder / "in/sheet.json", R"({"scene": "none.json", "fallback": "ball.json", "panels": [{"label": "one"}]})");
    expect_error(render(), 3, "none.json: there is no such file");
}

TEST_F(Sheet, InterruptSavesWhatThereIs) {
    sheet(two, R"("spp": 1000000)");
    put(folder / "out.png", "the sheet of yesterday");
    Program program({"sheet", path("in/sheet.json"), "-o", path("out.png")});
    ASSERT_TRUE(program.prints("M samples")); // the first launch is over
    program.send(SIGINT);
    const Outcome outcome = program.wait(30);
    EXPECT_EQ(outcome.code, 130) << outcome.err;
    EXPECT_NE(caption(picture(), 0).find(", interrupted"), std::string::npos);
    EXPECT_EQ(caption(picture(), 1), "other; subsurface_bleed 1; interrupted, not rendered");
    EXPECT_EQ(files(), 2u) << "the inputs and the sheet";
}

TEST_F(Sheet, KilledLeavesTheOldOne) {
    sheet(two, R"("spp": 1000000)");
    put(folder / "out.png", "the sheet of yesterday");
    {
        Program program({"sheet", path("in/sheet.json"), "-o", path("out.png")});
        ASSERT_TRUE(program.prints("M samples"));
        program.send(SIGKILL);
        program.wait(30);
    }
    EXPECT_EQ(bytes_of(folder / "out.png"), "the sheet of yesterday");
}

} // namespace
} // namespace nacre
