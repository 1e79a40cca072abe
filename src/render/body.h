#pragma once
#include "scene/scene.h"

namespace nacre::render {

/// Mean of 2 x volume / surface over what `mesh` encloses, in the scene's units: the thickness of a slab, 2/3 of a
/// ball's radius.
double thickness(const scene::Mesh &mesh);

/// Whether a body is a plate or a shell, whose other side is about parallel where light gets through: by far the most
/// of a plate's surface faces two opposite ways, shells are larger than 20 times their thickness.
bool is_plate(const scene::Mesh &mesh);

/// Whether a body's surface is nearly flat to its walks: it is larger than 500 lengths of light_path, or a plate.
bool is_flat(const scene::Scene &scene, const scene::Object &object);

/// How far light gets in a medium, in the scene's units: as a diffusion length its longest mean free path grows with
/// 1 / sqrt(1 - g).
double light_path(const scene::Scene &scene, const scene::Material &material);

/// Length of the longest edge of the box about a mesh.
double extent(const scene::Mesh &mesh);

/// Whether a material shows so little colour (.05) that walks below it are over before anything could steer them.
bool is_dark(const scene::Scene &scene, const scene::Material &material);

/// How far light gets before it is an e-fold weaker deep in a medium, per channel, in the scene's units: of the medium
/// of the material's mean colours, in the diffusion limit. With s = sqrt((1 - albedo) / (1 - albedo g)), by van de
/// Hulst's inversion of the colour, that is (1 - albedo g)^-1 mean free paths over sqrt(3) s. Infinite in white.
Vec3 diffusion_length(const scene::Scene &scene, const scene::Material &material);

} // namespace nacre::render
