#pragma once
#include "accel/bvh.h"
#include "shared/clearance.h"

namespace nacre::accel {

/// The clearance field of one object, in the layout of kernels/shared/clearance.h. `info.first` is 0: whoever puts the
/// bricks of several objects into one buffer sets it.
struct ClearanceField {
    shared::Clearance info{};         // bricks_x == 0: no field
    std::vector<std::uint8_t> bricks; // CLEARANCE_BRICK_BYTES per brick
};

/// Bytes that the fields of all objects of a scene may take together. Two objects of 256^3 cells; as much as a mesh of
/// 150,000 triangles takes in its BVH and vertices.
inline constexpr std::size_t clearance_budget = std::size_t(32) << 20;

/// Distances to the triangles, on a grid around them with cells of `wanted_cell`, or of the least size whose bricks fit
/// into `budget` bytes. Triangles that no ray can hit are left out. No triangle, no budget or a cell that is not > 0
/// gives no field. Uses all cores; takes 8 bytes per cell while it builds.
ClearanceField build_clearance(std::span<const Triangle> triangles, float wanted_cell, std::size_t budget);

/// The size of cells for walks with the mean free paths `free_path` (per channel) in an object of `size` (largest
/// extent).
float clearance_cell(const Vec3f &free_path, float size);

/// Whether walks with these mean free paths can skip enough rays in an object of this size to pay for the look-ups.
bool clearance_pays(const Vec3f &free_path, float size);

} // namespace nacre::accel
