// What is read from a build log of NVIDIA's compiler.
#include "device/kernel_info.h"
#include <gtest/gtest.h>

namespace nacre::device {
namespace {

TEST(RegisterUse, OfEveryKernelInTheLog) {
    const auto use = register_use(R"(
ptxas info    : 0 bytes gmem
ptxas info    : Compiling entry function 'accumulate' for 'sm_90'
ptxas info    : Function properties for accumulate
ptxas         .     0 bytes stack frame, 0 bytes spill stores, 0 bytes spill loads
ptxas info    : Used 24 registers, 404 bytes cmem[0]
ptxas info    : Compiling entry function 'trace_paths' for 'sm_90'
ptxas info    : Function properties for trace_paths
    712 bytes stack frame, 180 bytes spill stores, 196 bytes spill loads
ptxas info    : Used 255 registers, 712 bytes cumulative stack size, 444 bytes cmem[0]
)");
    ASSERT_EQ(use.size(), 2u);
    EXPECT_EQ(use.at("accumulate").registers, 24);
    EXPECT_EQ(use.at("accumulate").spill_bytes, 0);
    EXPECT_EQ(use.at("trace_paths").registers, 255);
    EXPECT_EQ(use.at("trace_paths").spill_bytes, 180 + 196);
}

TEST(RegisterUse, OtherLogsSayNothing) {
    EXPECT_TRUE(register_use("").empty());
    EXPECT_TRUE(register_use("warning: Used 3 registers of a kind\n1 warning generated.\n").empty());
}

} // namespace
} // namespace nacre::device
