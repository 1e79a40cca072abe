// What was tried, in flights per second of one thread of a Zen 4 (blob at 0.2, 1, 5 %; small at the same):
//   - random numbers, logarithms and directions of sixteen flights at once, before their rays: +17 to +20 % against one
//   at
//     a time, +1 to +2 % against eight, +4 % against four; 512 bit registers for it: -1 %
//   - a ray's halves as whole registers, weights as registers of four: in all of these figures
//   - RTC_BUILD_QUALITY_HIGH in place of MEDIUM: within 1 % (spatial splits find nothing in meshes of even triangles)
//   - isa=avx512 in place of Embree's choice, AVX2: within 1 %; SSE4.2: -20 %
//   - bvh4.triangle4 in place of Embree's choice, bvh8.triangle4: -10 to -20 %; triangle4i, triangle4v: -12 to -30 %
//   - huge pages are Embree's default; without: -2 to -3 %
#include "walks/embree_walk.h"
#include "walks/embree_draws.h"
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <thread>
#include <vector>

namespace nacre::bench {
namespace {

using shared::Path;

// As in kernels/path/walk.h, for a scene of radius 1/2.
constexpr float beyond = 2, outside2 = 1.01f * 0.25f;
constexpr float roulette_below = 0.2f; // WALK_ROULETTE

// Scatters are kept this far (2 ulp of the largest coordinate) on the inner side of a surface, the last ray starts a
// little farther on the outer side: Embree's hits round to about this.
constexpr float rounding = 0x1p-23f, off_surface = 2e-6f;

constexpr std::size_t paths_at_once = 100; // a quarter of the cluster they enter in

Four load(const shared::float4 &v) { return Four{v.x, v.y, v.z, v.w}; }
float sum3(Four v) { return v[0] + v[1] + v[2]; }
float largest3(Four v) { return std::max(std::max(v[0], v[1]), v[2]); }

/// d.x * t + d.y * b + d.z * n, in the basis of Duff et al. 2017 about the unit vector n.
Four to_world(float x, float y, float z, Four n) {
    const float s = std::copysign(1.0f, n[2]), a = -1 / (s + n[2]), c = n[0] * n[1] * a;
    const Four t = {1 + s * n[0] * n[0] * a, s * c, -s * n[0], 0}, b = {c, s + n[1] * n[1] * a, -n[1], 0};
    return t * x + b * y + n * z;
}

/// One thread's walker: Embree's query and what it keeps from walk to walk.
class Walker {
  public:
    explicit Walker(RTCScene scene) : scene(scene) {
        rtcInitIntersectContext(&context);
        query.ray.mask = ~0u;
        query.ray.id = query.ray.flags = 0;
        query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    }

    template <bool Anisotropic> std::uint64_t walk(const Path &path, shared::float4 &radiance) {
        const Sampler sampler{path.key, path.sample, path.vertex};
        const Four sigma = load(path.sigma), albedo = load(path.albedo);
        const float free_path = 1 / sigma[path.channel];
        weight = load(path.weight);
        Four position = load(path.position), direction = load(path.direction), share = load(path.share);
        radiance = {};
        std::uint32_t depth = path.depth;
        for (std::uint32_t step = 0;; step++) {
            const std::uint32_t k = step % Draws::size;
            if (k == 0) draws.fill<Anisotropic>(sampler, step, path.anisotropy.x);
            if (step > 0) {
                if constexpr (Anisotropic) {
                    direction = to_world(draws.x[k] * draws.w[k], draws.x[k] * draws.z[k], draws.y[k], direction);
                    direction *= 1 / std::sqrt(sum3(direction * direction));
                } else {
                    direction = Four{draws.x[k], draws.y[k], draws.z[k], 0};
                }
            }
            const float length = (step == 0 ? -fast_log(path.first_number) : draws.depth[k]) * free_path;
            if (leaves(position, direction, std::min(length, beyond) + rounding, depth)) {
                weigh(share, fast_exp(sigma * -query.ray.tfar));
                const Four normal = hit_normal();
                leave(sampler, path, position + direction * query.ray.tfar,
                      normal * (1 / std::sqrt(sum3(normal * normal))), radiance);
                return step + 1;
            }
            if (length >= beyond || sum3(position * position) > outside2) { // slipped through by rounding
                leave(sampler, path, position, direction, radiance);
                return step + 1;
            }
            weigh(share, sigma * fast_exp(sigma * -length));
            weight *= albedo;
            position += direction * length;
            const float heaviest = largest3(weight);
            if (heaviest < roulette_below) {
                if (!(draws.roulette[k] * roulette_below < heaviest)) return step + 1;
                weight *= roulette_below / heaviest;
            }
        }
    }

  private:
    /// The two halves of a ray go out as whole registers, which Embree's 16 byte loads then find in the store buffer.
    void set_ray(Four origin, Four direction, float t_min, float t_max) {
        static_assert(offsetof(RTCRay, tnear) == 12 && offsetof(RTCRay, dir_x) == 16 && offsetof(RTCRay, time) == 28);
        origin[3] = t_min;
        std::memcpy(&query.ray, &origin, sizeof origin);
        std::memcpy(reinterpret_cast<char *>(&query.ray) + sizeof origin, &direction, sizeof direction); // time is 0
        query.ray.tfar = t_max;
    }

    bool closest(Four origin, Four direction, float t_min, float t_max) {
        set_ray(origin, direction, t_min, t_max);
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene, &context, &query);
        return query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }

    /// Whether a flight leaves the object, and query says where. Shells inside are counted, not stopped at; an entrance
    /// into the surface that the flight starts on is none (kernels/walk/boundary.h).
    bool leaves(Four origin, Four direction, float t_max, std::uint32_t &depth) {
        if (!closest(origin, direction, 0, t_max)) return false;
        for (;;) {
            const Four normal = hit_normal();
            const float cosine = sum3(normal * direction), t = query.ray.tfar;
            if (cosine >= 0) {
                if (--depth == 0) return true;
            } else if (cosine * t < -1e-6f * std::sqrt(sum3(normal * normal))) {
                depth++;
            }
            if (!closest(origin, direction, t * 1.0000003f + 1e-9f, t_max)) return false;
        }
    }

    Four hit_normal() const { return Four{query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z, 0}; }

    void weigh(Four &share, Four density) {
        density *= 1 / sum3(share * density);
        weight *= density;
        share *= density;
    }

    /// Out at `position`: Lambert's direction about the unit normal, and white light if nothing is in its way.
    void leave(const Sampler &sampler, const Path &path, Four position, Four normal, shared::float4 &radiance) {
        float xi, azimuth, s, c;
        sobol_pair(sampler, DRAW_DIRECTION, xi, azimuth);
        fast_sincos_turns(azimuth, s, c);
        const float sine = std::sqrt(1 - xi);
        set_ray(position + normal * off_surface, to_world(sine * c, sine * s, std::sqrt(xi), normal), 0, 1e30f);
        rtcOccluded1(scene, &context, &query.ray);
        if (query.ray.tfar < 0) return;
        const Four light = load(path.throughput) * weight;
        radiance = {light[0], light[1], light[2], 0};
    }

    const RTCScene scene;
    RTCIntersectContext context;
    alignas(64) RTCRayHit query;
    Draws draws;
    Four weight;
};

} // namespace

std::uint64_t walk_with_embree(const EmbreeScene &scene, std::span<const Path> paths,
                               std::span<shared::float4> radiance, unsigned threads) {
    std::atomic<std::size_t> next{0};
    std::atomic<std::uint64_t> steps{0};
    const auto work = [&] {
        const FlushDenormals flush;
        Walker walker(scene.handle());
        std::uint64_t taken = 0;
        for (std::size_t first; (first = next.fetch_add(paths_at_once)) < paths.size();)
            for (const Path &path : paths.subspan(first, std::min(paths_at_once, paths.size() - first)))
                taken += path.anisotropy.x != 0 ? walker.walk<true>(path, radiance[path.slot])
                                                : walker.walk<false>(path, radiance[path.slot]);
        steps += taken;
    };
    std::vector<std::thread> others;
    for (unsigned i = 1; i < threads; i++) others.emplace_back(work);
    work();
    for (std::thread &thread : others) thread.join();
    return steps;
}

} // namespace nacre::bench
