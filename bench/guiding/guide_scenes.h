#pragma once
#include "scene/scene.h"
#include <string>
#include <vector>

namespace nacre::bench {

/// What walks go through; the red channel's mean free path is the unit of length.
struct Medium {
    std::string name; // of the colour
    Vec3 color, radius_scale;
    double anisotropy = 0, bleed = 0;
};

/// Skin and greys, with variations of one thing at a time about g 0 and g .8; `full`: every colour with every g and
/// bleed.
std::vector<Medium> media(bool full);

/// A picture to measure.
struct Scenario {
    std::string name; // body/colour/g/bleed
    scene::Scene scene;
    bool flat = false; // every pixel shows the same
};

/// Half-space, slabs and spheres of every medium.
std::vector<Scenario> body_scenarios(bool full);

/// The memo's head where the folders of NACRE_ASSETS have it, else the bear, in several media.
std::vector<Scenario> model_scenarios(bool full);

/// `scene` with Lambertian surfaces of the same colours in place of its media: what variance is left is that of the
/// lights and of what lies above the medium.
scene::Scene without_media(scene::Scene scene);

} // namespace nacre::bench
