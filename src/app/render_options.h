#pragma once
#include "app/scene_options.h"
#include "render/session.h"
#include "shared/path.h"
#include <cstdint>
#include <optional>

namespace nacre::app {

/// Samples per pixel where it is time that ends a render.
constexpr std::uint32_t unlimited_spp = SECOND_HALF - 1;

/// The command line of `nacre render`, and those parts of it that other commands have too.
struct RenderOptions {
    SceneOptions scene;
    std::string output, size, crop, device, kernels, dump_kernel, stats, trace;
    std::optional<std::string> aov;
    std::optional<std::uint32_t> spp, seed;
    std::optional<double> error, seconds;
    bool generic = false, exact = false, strict = false, quiet = false;

    void add_to(CLI::App &command);
    /// What is rendered and on what: SCENE, --set, --spp, --size, --seed, --device, --kernels, --generic.
    void add_common_to(CLI::App &command);
    /// The same without SCENE and --set.
    void add_settings_to(CLI::App &command);

    /// Throws Error{Exit::device}.
    device::Device open_device() const;
    /// Writes spp, seed and size into the scene, which they override.
    void apply(scene::Scene &scene) const;
    /// Layers by --aov; without it all in an EXR, none in a PNG. Throws Error{Exit::usage}, as the next one does.
    render::Layers layers() const;
    render::Crop parse_crop(const scene::Scene &scene) const;
    /// Most samples per pixel: the scene's only where nothing else ends the render. Throws Error{Exit::usage} where
    /// --error could not be told from them.
    std::uint32_t most_samples(const scene::Scene &scene) const;
};

} // namespace nacre::app
