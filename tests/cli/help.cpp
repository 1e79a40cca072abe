// What the program says of itself.
#include "cli/cli.h"
#include <algorithm>

namespace nacre {
namespace {

TEST_F(Cli, HelpOfEveryCommandHasExamples) {
    for (const std::vector<std::string> &command :
         {std::vector<std::string>{}, {"render"}, {"devices"}, {"check"}, {"profile"}, {"sheet"}, {"compare"}}) {
        std::vector<std::string> arguments = command;
        arguments.push_back("--help");
        const Outcome help = run(arguments);
        const std::string name = command.empty() ? "nacre" : "nacre " + command[0];
        EXPECT_EQ(help.code, 0);
        EXPECT_EQ(help.err, "");
        const std::size_t examples = help.out.find("Example");
        ASSERT_NE(examples, std::string::npos) << name << "\n" << help.out;
        EXPECT_NE(help.out.find("  " + name, examples), std::string::npos) << help.out;
    }
}

TEST_F(Cli, HelpListsExitCodes) {
    const Outcome help = run({"--help"});
    for (const char *code :
         {"0 done", "2 bad command line", "3 bad scene", "4 no device", "5 output", "130 interrupted"})
        EXPECT_NE(help.out.find(code), std::string::npos) << code;
}

TEST_F(Cli, VersionIsANumber) {
    const Outcome version = run({"--version"});
    EXPECT_EQ(version.code, 0);
    EXPECT_EQ(std::count(version.out.begin(), version.out.end(), '.'), 2) << version.out;
}

TEST_F(Cli, DevicesAsJson) {
    const Outcome devices = run({"devices", "--json"});
    ASSERT_EQ(devices.code, 0) << devices.err;
    const auto list = nlohmann::json::parse(devices.out);
    ASSERT_FALSE(list.empty());
    for (const char *key : {"index", "name", "platform", "type", "version", "driver", "memory", "compute_units"})
        EXPECT_TRUE(list[0].contains(key)) << key;
    EXPECT_EQ(list[0]["index"], 0);
}

TEST_F(Cli, DevicesAsText) {
    const Outcome devices = run({"devices"});
    EXPECT_EQ(devices.code, 0) << devices.err;
    EXPECT_EQ(devices.out.rfind("0  ", 0), 0u) << devices.out;
}

TEST_F(Cli, CheckNamesTheOpenMesh) {
    const Outcome check = run({"check", NACRE_SCENES "/features/open_mesh.json"});
    EXPECT_EQ(check.code, 0) << check.err;
    EXPECT_NE(check.out.find("open.ply"), std::string::npos) << check.out;
    EXPECT_NE(check.out.find("open edges"), std::string::npos) << check.out;
}

TEST_F(Cli, CheckHasNothingAgainstAGoodScene) {
    const Outcome check = run({"check", ball});
    EXPECT_EQ(check.code, 0) << check.err;
    EXPECT_NE(check.out.find("nothing to remark"), std::string::npos) << check.out;
}

} // namespace
} // namespace nacre
