#pragma once
#include "base/error.h"
#include "image/scratch.h"
#include "io/load.h"

namespace nacre {

/// A test with a folder to write scenes to, and to load them from.
class SceneFolder : public Scratch {
  protected:
    scene::Scene load(const std::string &name, const std::vector<io::Override> &overrides = {}) const {
        return io::load_scene(folder / name, overrides);
    }

    scene::Scene load_text(const std::string &json, const std::vector<io::Override> &overrides = {}) const {
        put(folder / "scene.json", json);
        return load("scene.json", overrides);
    }

    /// The message of the Error that loading throws, "" where it throws none. Its exit code must be that of bad input.
    std::string error_of(const std::string &name, const std::vector<io::Override> &overrides = {}) const {
        try {
            load(name, overrides);
        } catch (const Error &error) {
            EXPECT_EQ(error.code, Exit::input) << error.what();
            return error.what();
        }
        return "";
    }
};

/// Picture of one red pixel, in a text format.
inline const std::string red_pixel = "P3\n1 1\n255\n255 0 0\n";

} // namespace nacre
