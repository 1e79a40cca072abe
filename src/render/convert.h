#pragma once
#include "base/vector.h"
#include "shared/types.h"

namespace nacre::render {

inline shared::float4 to_float4(const Vec3 &v, double w = 0) {
    return {float(v.x()), float(v.y()), float(v.z()), float(w)};
}

} // namespace nacre::render
