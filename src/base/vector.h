#pragma once
#include <Eigen/Geometry>

namespace nacre {

// Host geometry is double until it is uploaded: transforms and the centring of the scene lose nothing.
using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec2f = Eigen::Vector2f;
using Vec3f = Eigen::Vector3f;
using Transform = Eigen::Affine3d;

} // namespace nacre
