#pragma once
#include <fmt/format.h>
#include <stdexcept>
#include <string>

namespace nacre {

/// Exit codes of the program; the one list of them (README and `--help` refer to it).
enum class Exit : int {
    done = 0,
    failed = 1,        // the render or the comparison failed
    usage = 2,         // bad command line
    input = 3,         // bad scene or input file
    device = 4,        // no device, or the device failed
    output = 5,        // a file cannot be written
    interrupted = 130, // stopped by the user, what was rendered is saved
};

/// Everything that can go wrong and that a user can mend. `main` prints it as one line
/// `nacre: error: SUBJECT: what, where, what to do` and leaves with `code`.
class Error : public std::runtime_error {
  public:
    Error(Exit code, const std::string &subject, const std::string &message)
        : std::runtime_error(subject.empty() ? message : subject + ": " + message), code(code) {}
    const Exit code;
};

/// A scene names a file that is not there: its assets are elsewhere, or were never fetched.
class MissingFile : public Error {
  public:
    MissingFile(const std::string &subject, const std::string &message) : Error(Exit::input, subject, message) {}
};

/// Throws `Error{Exit::input}`; `subject` is the file (or the option) at fault.
template <typename... Args>
[[noreturn]] void input_error(const std::string &subject, fmt::format_string<Args...> format, Args &&...args) {
    throw Error(Exit::input, subject, fmt::format(format, std::forward<Args>(args)...));
}

} // namespace nacre
