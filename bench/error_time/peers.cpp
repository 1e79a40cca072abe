#include "error_time/peers.h"
#include "app/interrupt.h"
#include "base/error.h"
#include "io/image.h"
#include "measure.h"
#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace nacre::bench {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Peer {
    const char *name;
    const char *found; // a shell command that says whether it is on this machine
    const char *run;   // with the script's name and the folder as arguments of format
    const char *missing;
};

// Mitsuba comes from PyPI and wants a Python of its own: NACRE_PYTHON.
constexpr Peer peers[] = {
    {"cycles", "command -v blender", "blender -b --factory-startup --python-exit-code 1 --python '{}' -- '{}'",
     "peer cycles skipped: no `blender` on this machine (Debian: apt install --no-install-recommends blender)"},
    {"mitsuba", "${NACRE_PYTHON:-python3} -c 'import mitsuba'", "${{NACRE_PYTHON:-python3}} '{}' '{}'",
     "peer mitsuba skipped: NACRE_PYTHON, or python3, has no module mitsuba (PyPI: pip install mitsuba, in a venv)"},
};

constexpr int reference_renders = 8;
constexpr std::uint32_t reference_factor = 2, reference_seed = 1000;

/// A folder that goes with this object.
class Scratch {
  public:
    Scratch() : path(fs::temp_directory_path() / fmt::format("nacre_peer_{}", getpid())) {
        fs::create_directories(path);
    }
    ~Scratch() { fs::remove_all(path); }
    const fs::path path;
};

/// In a process group of its own: of Ctrl-C a peer could make a picture that is cut short, which would count.
bool succeeds(const std::string &command, Pace &pace) {
    const pid_t shell = fork();
    if (shell == 0) {
        setpgid(0, 0);
        execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        _exit(127);
    }
    if (shell < 0) return false;
    setpgid(shell, shell); // by whoever comes first, so that the group is there to be killed
    int status = 0;
    while (waitpid(shell, &status, WNOHANG) == 0) {
        if (app::interrupted) {
            kill(-shell, SIGKILL);
            waitpid(shell, &status, 0);
            throw Interrupted{};
        }
        pace.show();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Every picture to make, in this order; after one to warm up.
void write_job(const fs::path &folder, const std::vector<std::uint32_t> &budgets, std::uint32_t seeds) {
    Json renders = Json::array();
    const auto add = [&](std::uint32_t spp, std::uint32_t seed) { renders.push_back({{"spp", spp}, {"seed", seed}}); };
    add(budgets.front(), 0);
    for (std::uint32_t seed = 1; seed <= seeds; ++seed)
        for (const std::uint32_t spp : budgets) add(spp, seed);
    for (std::uint32_t i = 0; i < reference_renders; ++i) add(reference_factor * budgets.back(), reference_seed + i);
    write_json(folder / "job.json", {{"threads", std::thread::hardware_concurrency()}, {"renders", renders}});
}

Json read_json(const fs::path &file) {
    std::ifstream in(file);
    return Json::parse(in);
}

} // namespace

std::vector<std::string> peer_names() {
    std::vector<std::string> names;
    for (const Peer &peer : peers) names.push_back(peer.name);
    return names;
}

PeerShots shoot_peer(const std::string &name, const Scenario &scenario, const std::vector<std::uint32_t> &budgets,
                     std::uint32_t seeds, Pace &pace) {
    pace.next("peer " + name, 0);
    const Peer &peer = *std::find_if(std::begin(peers), std::end(peers), [&](const Peer &p) { return name == p.name; });
    PeerShots out;
    if (!succeeds(fmt::format("({}) > /dev/null 2>&1", peer.found), pace)) {
        out.why_not = peer.missing;
        return out;
    }
    const Scratch scratch;
    const std::string folder = scratch.path.string();
    if (const std::string why = export_scene(folder, scenario.scene); !why.empty()) {
        out.why_not = fmt::format("peer {} skipped for {}: it has {}", name, scenario.name, why);
        return out;
    }
    write_job(folder, budgets, seeds);
    const std::string script = fmt::format("{}/{}.py", NACRE_PEERS, name);
    if (!succeeds(fmt::format("{} > '{}/log' 2>&1", fmt::format(fmt::runtime(peer.run), script, folder), folder),
                  pace)) {
        std::ifstream log(folder + "/log");
        throw Error(Exit::failed, name, "failed:\n" + std::string(std::istreambuf_iterator<char>(log), {}));
    }
    out.series.name = name;
    for (const Json &render : read_json(scratch.path / "times.json")) {
        const std::string file = render["file"];
        Shot shot{render["spp"], render["seed"], render["seconds"],
                  render["cpu"], render["spp"],  compare::estimate_of(io::read_picture(file), file)};
        if (shot.seed >= reference_seed)
            out.references.push_back(std::move(shot.picture));
        else if (shot.seed > 0)
            out.series.shots.push_back(std::move(shot));
    }
    take_slopes(out.series.shots, budgets.size(), &Shot::seconds);
    take_slopes(out.series.shots, budgets.size(), &Shot::cpu);
    return out;
}

} // namespace nacre::bench
