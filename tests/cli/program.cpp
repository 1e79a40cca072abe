#include "cli/program.h"
#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace nacre {
namespace {

namespace fs = std::filesystem;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

std::string text_of(const fs::path &file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

fs::path scratch_file() {
    static std::atomic<int> count{0};
    return fs::temp_directory_path() / ("nacre-cli-" + std::to_string(getpid()) + "-" + std::to_string(count++));
}

void redirect(const fs::path &file, int descriptor) {
    const int opened = open(file.c_str(), O_CREAT | O_RDWR | O_APPEND, 0600);
    dup2(opened, descriptor);
    close(opened);
}

// In the child, up to exec. CAP_DAC_OVERRIDE, with number 1 for ever, is what lets root ignore modes.
[[noreturn]] void become(const std::vector<std::string> &arguments, const Surroundings &surroundings) {
    for (const auto &[name, value] : surroundings.environment) setenv(name.c_str(), value.c_str(), 1);
    if (surroundings.largest_file >= 0) {
        const rlimit limit{rlim_t(surroundings.largest_file), rlim_t(surroundings.largest_file)};
        setrlimit(RLIMIT_FSIZE, &limit);
        std::signal(SIGXFSZ, SIG_IGN); // a full disk is an error of write, not a signal
    }
    if (surroundings.obey_modes) prctl(PR_CAPBSET_DROP, 1, 0, 0, 0);
    if (!surroundings.folder.empty() && chdir(surroundings.folder.c_str()) != 0) _exit(126);
    std::vector<char *> list;
    const auto say = [&](const std::string &word) { list.push_back(const_cast<char *>(word.c_str())); };
    std::for_each(surroundings.under.begin(), surroundings.under.end(), say);
    say(surroundings.program);
    std::for_each(arguments.begin(), arguments.end(), say);
    list.push_back(nullptr);
    execvp(list[0], list.data());
    _exit(127);
}

} // namespace

Program::Program(const std::vector<std::string> &arguments, const Surroundings &surroundings)
    : output(scratch_file()), errors(scratch_file()), started(now()) {
    process = fork();
    if (process > 0) return;
    redirect("/dev/null", STDIN_FILENO);
    redirect(output, STDOUT_FILENO);
    redirect(errors, STDERR_FILENO);
    become(arguments, surroundings);
}

Program::~Program() {
    if (running()) {
        send(SIGKILL);
        waitpid(process, &status, 0);
    }
    std::error_code ignored;
    fs::remove(output, ignored);
    fs::remove(errors, ignored);
}

void Program::send(int signal) const { kill(process, signal); }

bool Program::poll() {
    if (!ended) ended = waitpid(process, &status, WNOHANG) == process;
    return ended;
}

bool Program::running() { return !poll(); }

Outcome Program::wait(double limit) {
    while (!poll() && now() - started < limit) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (!ended) {
        send(SIGKILL);
        ended = waitpid(process, &status, 0) == process;
    }
    return {.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
            .signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0,
            .out = text_of(output),
            .err = text_of(errors),
            .seconds = now() - started};
}

bool Program::prints(const std::string &text, double limit) {
    const double until = now() + limit;
    while (text_of(errors).find(text) == std::string::npos) {
        if (poll() || now() > until) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
}

Outcome run(const std::vector<std::string> &arguments, const Surroundings &surroundings, double limit) {
    return Program(arguments, surroundings).wait(limit);
}

} // namespace nacre
