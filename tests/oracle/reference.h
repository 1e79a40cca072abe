#pragma once
#include "scene/scene.h"
#include <cstdint>
#include <vector>

namespace nacre::reference {

/// A picture and how well it is known. Row 0 at the top; three numbers per pixel, in the scene's units of radiance.
struct Image {
    int width = 0, height = 0;
    std::vector<double> mean, variance; // variance: of the mean
};

/// Renders a scene in float64 on the host: an answer for whole pictures that shares no code with the kernels and does
/// as little as it can. Every colour channel is a path of its own, so there is nothing to weigh between wavelengths;
/// walks are classical and analog (flights and directions are drawn as the medium has them, only absorption is a
/// weight); each lobe finds each kind of light in one way, so there is nothing to weigh there either. Embree (robust)
/// finds the triangles, in float; where rays meet them is computed in double. `samples` paths per pixel and channel;
/// the result depends on the scene, `samples` and `seed` alone. Throws Error{Exit::input} that names what it does not
/// know: reference_known.h.
Image render(const scene::Scene &scene, std::uint32_t samples, std::uint64_t seed);

} // namespace nacre::reference
