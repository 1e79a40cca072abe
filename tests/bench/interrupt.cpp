// Ctrl-C in error_time: the scenes that are complete are kept, the one it comes in is left out.
#include "cli/program.h"
#include "image/scratch.h"
#include <csignal>
#include <thread>

namespace nacre {
namespace {

class ErrorTimeInterrupt : public Scratch {};

TEST_F(ErrorTimeInterrupt, KeepsCompleteScenes) {
    const std::filesystem::path csv = folder / "figures.csv";
    Program program({"--scenes", "^(slab|thin)$", "--modes", "^$", "--budgets", "1", "2", "--seeds", "2", "--csv", csv},
                    {.program = NACRE_ERROR_TIME});
    while (program.running() && !std::filesystem::exists(csv))
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const std::string complete = bytes_of(csv);
    EXPECT_NE(complete.find("slab,default,2,2,"), std::string::npos) << complete;
    program.send(SIGINT); // what is left, the other scene, has 21 renders
    const Outcome outcome = program.wait(30);
    EXPECT_EQ(outcome.code, 130) << "signal " << outcome.signal << "\n" << outcome.err;
    EXPECT_NE(outcome.err.find("scene 1 of 2, slab: "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("complete, 1 of 2"), std::string::npos) << outcome.err;
    EXPECT_EQ(bytes_of(csv), complete);
    EXPECT_EQ(files(), 1u) << "nothing half written beside it";
}

} // namespace
} // namespace nacre
