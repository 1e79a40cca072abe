// Ctrl-C: what was rendered is saved, and a second one does not wait.
#include "cli/cli.h"
#include <csignal>
#include <thread>

namespace nacre {
namespace {

class Interrupt : public Cli {
  protected:
    // Hours of work.
    std::vector<std::string> endless() const {
        return {"render",  NACRE_SCENES "/bear/bear.json",
                "-o",      path("out.exr"),
                "--spp",   "100000",
                "--size",  "256x256",
                "--stats", path("stats.json")};
    }

    // Lets it compile and start: the first line of progress comes with the first launch.
    void wait_until_rendering(Program &program) const { ASSERT_TRUE(program.prints("samples")); }

    void expect_saved(const Outcome &outcome) const {
        EXPECT_EQ(outcome.code, 130) << "signal " << outcome.signal << "\n" << outcome.err;
        const auto picture = read_picture(folder / "out.exr");
        ASSERT_TRUE(picture);
        EXPECT_EQ(picture->width, 256);
        const double samples = json_of("stats.json")["samples"];
        EXPECT_GT(samples, 0);
        EXPECT_LT(samples, 256.0 * 256 * 100000);
        EXPECT_EQ(files(), 2u) << "the picture and the statistics";
    }
};

TEST_F(Interrupt, SavesWhatThereIs) {
    Program program(endless());
    wait_until_rendering(program);
    program.send(SIGINT);
    expect_saved(program.wait(30));
}

TEST_F(Interrupt, TerminateIsTheSame) {
    Program program(endless());
    wait_until_rendering(program);
    program.send(SIGTERM);
    expect_saved(program.wait(30));
}

TEST_F(Interrupt, TwiceEndsAtOnce) {
    Program program(endless());
    wait_until_rendering(program);
    program.send(SIGINT);
    // Signals of one kind that are both pending are one: the second has to wait until the first is taken.
    while (program.running()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        program.send(SIGINT);
    }
    const Outcome outcome = program.wait(10);
    EXPECT_TRUE(outcome.signal == SIGINT || outcome.code == 130) << outcome.code << " " << outcome.signal;
}

// Before the first sample there is nothing to save and nothing to wait for.
TEST_F(Interrupt, WhileCompiling) {
    Program program(endless(), {.environment = {{"XDG_CACHE_HOME", path("cache")}}});
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    program.send(SIGINT);
    const Outcome outcome = program.wait(20);
    EXPECT_TRUE(outcome.signal == SIGINT || outcome.code == 130) << outcome.code << "\n" << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "out.exr"));
}

} // namespace
} // namespace nacre
