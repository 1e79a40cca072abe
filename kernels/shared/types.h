// The vocabulary of every struct that crosses to the device: float, uint, int, float4, uint4 and nothing else
// (a vector of three is 16 bytes in OpenCL C, bool has no fixed size). Included by the host and by the kernels.
#ifndef NACRE_SHARED_TYPES_H
#define NACRE_SHARED_TYPES_H

#ifdef __OPENCL_C_VERSION__
#define SHARED_BEGIN
#define SHARED_END
#else
#define SHARED_BEGIN namespace nacre::shared {
#define SHARED_END }
#include <cstdint>
SHARED_BEGIN
using uint = std::uint32_t;
struct alignas(16) float4 {
    float x = 0, y = 0, z = 0, w = 0;
};
struct alignas(16) uint4 {
    uint x = 0, y = 0, z = 0, w = 0;
};
SHARED_END
#endif

#endif
