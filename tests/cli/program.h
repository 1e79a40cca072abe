#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <sys/types.h>
#include <vector>

namespace nacre {

/// How the program is started: what differs from this process.
struct Surroundings {
    std::map<std::string, std::string> environment = {};
    long largest_file = -1;              // bytes a file may have (RLIMIT_FSIZE), < 0: any
    bool obey_modes = false;             // root is bound by the modes of files and folders like anybody else
    std::filesystem::path folder = {};   // working folder, empty: this process's
    std::vector<std::string> under = {}; // a program that runs it, with its options
    std::string program = NACRE_PROGRAM;
};

/// What came out.
struct Outcome {
    int code = -1;  // exit code, -1: ended by a signal
    int signal = 0; // that signal
    std::string out = {}, err = {};
    double seconds = 0;
};

/// The real nacre as a process of its own. One that is still running when this goes out of scope is killed.
class Program {
  public:
    explicit Program(const std::vector<std::string> &arguments, const Surroundings &surroundings = {});
    ~Program();
    Program(const Program &) = delete;

    void send(int signal) const;
    bool running();
    /// Waits for the end; a program that takes longer than `limit` seconds is killed, which is an outcome by signal.
    Outcome wait(double limit = 60);
    /// Waits until it has printed `text` on stderr, at most `limit` seconds.
    bool prints(const std::string &text, double limit = 60);

  private:
    std::filesystem::path output, errors;
    pid_t process = -1;
    int status = 0;
    bool ended = false;
    double started;

    bool poll();
};

/// `limit` as for Program::wait.
Outcome run(const std::vector<std::string> &arguments, const Surroundings &surroundings = {}, double limit = 60);

} // namespace nacre
