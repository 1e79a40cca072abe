#pragma once
#include "cli/program.h"
#include "image/scratch.h"
#include <nlohmann/json.hpp>
#include <optional>

namespace nacre {

/// A test that runs the program, with an empty folder for what it writes.
class Cli : public Scratch {
  protected:
    /// A scene that takes no time: a ball in a white sky.
    static inline const std::string ball = NACRE_SCENES "/features/furnace.json";

    /// `render SCENE -o FOLDER/NAME` of 16 x 12 pixels and one sample unless `more`, which follows, says otherwise.
    std::vector<std::string> small_render(const std::string &scene, const std::string &name,
                                          const std::vector<std::string> &more = {}) const;

    std::string path(const std::string &name) const { return (folder / name).string(); }
    nlohmann::json json_of(const std::string &name) const { return nlohmann::json::parse(bytes_of(folder / name)); }
};

/// A picture as it was read back: width, height, where it lies, channels, metadata.
struct PictureFile {
    int width = 0, height = 0, x = 0, y = 0, full_width = 0, full_height = 0;
    std::vector<std::string> channels;
    std::map<std::string, std::string> metadata;
    std::vector<float> pixels; // 8-bit ones as 0 to 1
};

/// Nothing where it cannot be read.
std::optional<PictureFile> read_picture(const std::filesystem::path &file);

/// Expects this exit code and exactly one line on stderr, `nacre: error: …`, that has `text` in it.
void expect_error(const Outcome &outcome, int code, const std::string &text);

} // namespace nacre
