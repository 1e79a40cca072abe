#pragma once
#include "accel/clearance.h"
#include "device/context.h"

namespace nacre {

/// A point, and the index of the field that it is looked up in.
struct ClearancePoint {
    Vec3f position;
    std::uint32_t field = 0;
};

/// What kernels/walk/clearance.h says of `points`, with `lanes` of them side by side. Puts the bricks of the fields
/// into one buffer, and sets Clearance.first.
std::vector<float> look_up(const device::Device &device, std::span<accel::ClearanceField> fields,
                           std::span<const ClearancePoint> points, int lanes);

} // namespace nacre
