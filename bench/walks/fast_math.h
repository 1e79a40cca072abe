// Elementary functions for the walk with Embree: branch-free, so that the compiler puts them into vectors. Polynomials
// from Moshier's Cephes (logf, expf, sinf, cosf), within 2 ulp; arguments are those of a walk, special ones are left
// out.
#pragma once
#include <bit>
#include <cmath>
#include <cstdint>

namespace nacre::bench {

// Registers of four floats; GCC's and Clang's extension, on any machine.
typedef float Four __attribute__((vector_size(16)));
typedef std::int32_t FourInts __attribute__((vector_size(16)));

/// x in (0, 1), normal.
inline float fast_log(float x) {
    const std::int32_t shifted = std::bit_cast<std::int32_t>(x) - 0x3f3504f3; // mantissa from sqrt(1/2) to sqrt(2)
    const float exponent = float(shifted >> 23);
    const float f = std::bit_cast<float>((shifted & 0x007fffff) + 0x3f3504f3) - 1, f2 = f * f;
    float p = 7.0376836292e-2f;
    p = p * f - 1.1514610310e-1f;
    p = p * f + 1.1676998740e-1f;
    p = p * f - 1.2420140846e-1f;
    p = p * f + 1.4249322787e-1f;
    p = p * f - 1.6668057665e-1f;
    p = p * f + 2.0000714765e-1f;
    p = p * f - 2.4999993993e-1f;
    p = p * f + 3.3333331174e-1f;
    return (f + (f * f2 * p - 0.5f * f2)) + exponent * 0.693147181f;
}

/// Sine and cosine of 2 pi u, u in (0, 1).
inline void fast_sincos_turns(float u, float &sine, float &cosine) {
    const float shifted = u * 4 + 12582912.0f; // 1.5 * 2^23: the lowest bits are u * 4, rounded
    const float r = (u - (shifted - 12582912.0f) * 0.25f) * 6.28318530717959f, r2 = r * r;
    const std::int32_t k = std::bit_cast<std::int32_t>(shifted);
    const float s = r + r * r2 * (-1.6666654611e-1f + r2 * (8.3321608736e-3f - r2 * 1.9515295891e-4f));
    const float c =
        1 - 0.5f * r2 + r2 * r2 * (4.166664568298827e-2f + r2 * (-1.388731625493765e-3f + r2 * 2.443315711809948e-5f));
    const float a = k & 1 ? c : s, b = k & 1 ? s : c;
    sine = std::bit_cast<float>(std::bit_cast<std::int32_t>(a) ^ (k & 2) << 30);
    cosine = std::bit_cast<float>(std::bit_cast<std::int32_t>(b) ^ ((k + 1) & 2) << 30);
}

/// x <= 0; below -87 it stays at exp(-87).
inline Four fast_exp(Four x) {
    const Four least = {-87, -87, -87, -87};
    x = x < least ? least : x;
    const Four shifted = x * 1.44269504088896f + 12582912.0f, n = shifted - 12582912.0f;
    const Four r = (x - n * 0.693359375f) + n * 2.12194440e-4f;
    Four p = r * 1.9875691500e-4f + 1.3981999507e-3f;
    p = p * r + 8.3334519073e-3f;
    p = p * r + 4.1665795894e-2f;
    p = p * r + 1.6666665459e-1f;
    p = p * r + 5.0000001201e-1f;
    return (Four)((FourInts)(p * (r * r) + r + 1.0f) + ((FourInts)shifted << 23)); // times 2^n
}

} // namespace nacre::bench
