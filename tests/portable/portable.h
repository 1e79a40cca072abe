#pragma once
#include "cli/cli.h"
#include "io/load.h"

namespace nacre {

/// A scene of scenes/features/ with what is set in it: together they need every feature.
struct SmallScene {
    std::string name;
    std::vector<io::Override> set = {};
    std::string size = "10x6", spp = "2"; // a ray takes Oclgrind milliseconds
    std::string layers = "albedo,N,depth,subsurface.zero,walk.steps";
    int rays = 0; // that it takes at least

    friend void PrintTo(const SmallScene &scene, std::ostream *out) { *out << scene.name; }
    std::string file() const { return NACRE_SCENES "/features/" + name + ".json"; }
};

std::vector<SmallScene> small_scenes();

/// What `nacre render` is asked to make of the scene.
std::vector<std::string> options_of(const SmallScene &scene);
std::string test_name(const testing::TestParamInfo<SmallScene> &info);

/// Seconds after which a program is killed. They take a few, but compiling for rusticl the better part of a minute, and
/// much more where others use this machine.
constexpr double patience = 1200;

/// How far one picture is from another of the same scene.
struct Difference {
    double share = 0; // of pixels with a channel that is off by more than 1e-3 of its value, or of its mean
    double mean = 0;  // largest difference of a channel's means, in standard errors of it over the pixels
};

Difference difference(const PictureFile &a, const PictureFile &b);

/// Tests that run those of tests/device on another implementation.
class Probes : public Cli {
  protected:
    static void expect_ran(const Outcome &outcome);
};

/// Tests that render a scene on PoCL and again on another implementation.
class Portable : public Cli, public testing::WithParamInterface<SmallScene> {
  protected:
    /// `render` of the scene.
    std::vector<std::string> arguments(const std::string &name, const std::vector<std::string> &more) const;

    /// Renders on PoCL and expects the picture `name` to be as that. Random numbers are the same everywhere and
    /// built-ins differ by some ulp: that shows in the fifth digit, except on paths that go another way for it, of
    /// which a picture as small as this has hardly any.
    /// `stats`: of that render.
    void expect_as_on_pocl(const std::string &name, const std::string &stats) const;
};

} // namespace nacre
