#include "app/output.h"
#include "base/error.h"
#include <unistd.h>

namespace nacre::app {

void check_output(const std::filesystem::path &file) {
    const std::string extension = file.extension().string();
    if (extension != ".exr" && extension != ".png")
        throw Error(Exit::usage, file.string(), "pictures are written as .exr or .png; choose one of these endings");
    check_output_file(file);
}

void check_output_file(const std::filesystem::path &file) {
    check_output_folder(file.has_parent_path() ? file.parent_path() : ".", file.string());
}

void check_output_folder(const std::filesystem::path &folder, const std::string &subject) {
    if (!std::filesystem::is_directory(folder))
        throw Error(Exit::output, subject, "its folder does not exist; create it first");
    if (access(folder.c_str(), W_OK) != 0)
        throw Error(Exit::output, subject, "its folder cannot be written to; choose another place");
}

} // namespace nacre::app
