#pragma once
#include "accel/bvh.h"

namespace nacre::accel {

/// The grid of a clearance field while it is built. Inside, lengths are in cells: the centre of cell 0, 0, 0 is at
/// (.5, .5, .5), and cell x, y, z is entry (z * size.y + y) * size.x + x.
struct ClearanceGrid {
    Vec3f corner;
    float edge;
    Eigen::Vector3i size; // cells, multiples of CLEARANCE_BRICK

    std::size_t cells() const { return std::size_t(size.x()) * std::size_t(size.y()) * std::size_t(size.z()); }
    std::size_t row(int y, int z) const {
        return (std::size_t(z) * std::size_t(size.y()) + std::size_t(y)) * std::size_t(size.x());
    }
    Vec3 inside(const Vec3f &point) const { return (point.cast<double>() - corner.cast<double>()) / double(edge); }
};

/// Distances from the centres of cells, in cells, where they are at most clearance_band; more elsewhere.
/// `triangles` can all be hit.
inline constexpr double clearance_band = 2;
std::vector<float> near_distances(const ClearanceGrid &grid, std::span<const Triangle> triangles);

/// Lower bounds on the distances from the centres of all cells, in cells: what `near` says where it is exact, and
/// elsewhere the distance to the nearest cell that the surface may pass through.
void extend_distances(const ClearanceGrid &grid, std::vector<float> &near);

} // namespace nacre::accel
