// The random numbers of kernels/random/ for C++, the walk's in blocks of consecutive flights: they depend on counters
// alone, so a block is one pass of vector instructions.
#pragma once
#include "walks/fast_math.h"

namespace nacre::bench {

struct Words {
    std::uint32_t x, y, z, w;
};

/// kernels/random/hash.h: PCG4D.
inline Words random_hash(Words v) {
    v.x = v.x * 1664525u + 1013904223u;
    v.y = v.y * 1664525u + 1013904223u;
    v.z = v.z * 1664525u + 1013904223u;
    v.w = v.w * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v.x ^= v.x >> 16;
    v.y ^= v.y >> 16;
    v.z ^= v.z >> 16;
    v.w ^= v.w >> 16;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

inline float random_unit(std::uint32_t bits) { return (float(std::int32_t(bits >> 9)) + 0.5f) * 0x1p-23f; }

/// kernels/random/sampler.h: the names of draws that a walk and its exit make, and their number.
enum Draw : std::uint32_t { DRAW_DIRECTION = 4, DRAW_WALK = 11, DRAW_COUNT = 14 };

struct Sampler {
    std::uint32_t key, sample, vertex;
};

inline std::uint32_t sampler_key(std::uint32_t pixel) { return random_hash({0, pixel, 0x85ebca6bu, 0xc2b2ae35u}).x; }

inline std::uint32_t reverse_bits(std::uint32_t x) {
    x = __builtin_bswap32(x);
    x = (x >> 4 & 0x0f0f0f0fu) | (x & 0x0f0f0f0fu) << 4;
    x = (x >> 2 & 0x33333333u) | (x & 0x33333333u) << 2;
    return (x >> 1 & 0x55555555u) | (x & 0x55555555u) << 1;
}

inline std::uint32_t scramble_reversed(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= seed >> 16 | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

/// draw_pair of an early vertex: kernels/random/sobol.h.
inline void sobol_pair(const Sampler &sampler, Draw name, float &first, float &second) {
    const Words seed = random_hash({sampler.key, sampler.vertex * DRAW_COUNT + name, 0x9e3779b9u, 0x7f4a7c15u});
    const std::uint32_t index = reverse_bits(scramble_reversed(reverse_bits(sampler.sample), seed.x));
    std::uint32_t other = index;
    other ^= other >> 1 & 0x55555555u;
    other ^= other >> 2 & 0x33333333u;
    other ^= other >> 4 & 0x0f0f0f0fu;
    other ^= other >> 8 & 0x00ff00ffu;
    other ^= other >> 16 & 0x0000ffffu;
    first = random_unit(reverse_bits(scramble_reversed(index, seed.y)));
    second = random_unit(reverse_bits(scramble_reversed(other, seed.z)));
}

/// What flights [first, first + size) of a walk draw. x, y, z: new directions (isotropic), or sine and cosine of the
/// deflection and azimuth (its sine in z, its cosine in w).
struct Draws {
    static constexpr int size = 16;
    alignas(64) float depth[size], roulette[size], x[size], y[size], z[size], w[size];

    template <bool Anisotropic> void fill(const Sampler &sampler, std::uint32_t first, float g) {
        const float h = std::fabs(g);
        for (int k = 0; k < size; k++) {
            const Words word = random_hash(
                {sampler.key, sampler.sample, sampler.vertex * DRAW_COUNT + DRAW_WALK, first + std::uint32_t(k)});
            depth[k] = -fast_log(random_unit(word.x));
            roulette[k] = random_unit(word.w);
            const float xi = random_unit(word.y);
            float s, c;
            fast_sincos_turns(random_unit(word.z), s, c);
            if constexpr (Anisotropic) { // kernels/phase/henyey_greenstein.h
                const float u = 2 * xi - 1, d = h * u + 1, scale = 1 / (d * d);
                const float away = (1 - h) * (1 - h) * (1 - u) * (h * 0.5f * (1 + u) + 1) * scale;
                const float along = (1 + h) * (1 + h) * (1 + u) * (1 - h * 0.5f * (1 - u)) * scale;
                x[k] = std::sqrt(away * along);
                const float cosine = away < along ? 1 - away : along - 1;
                y[k] = g < 0 ? -cosine : cosine;
                z[k] = s;
                w[k] = c;
            } else {
                const float sine = 2 * std::sqrt(xi * (1 - xi));
                x[k] = sine * c;
                y[k] = sine * s;
                z[k] = 2 * xi - 1;
            }
        }
    }
};

} // namespace nacre::bench
