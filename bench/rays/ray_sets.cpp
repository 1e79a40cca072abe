#include "rays/ray_sets.h"
#include <cmath>
#include <numbers>
#include <random>

namespace nacre::bench {
namespace {

using Random = std::mt19937;

float uniform(Random &random) { return float(random() >> 8) * 0x1p-24f; }

Vec3f sphere_direction(Random &random) {
    const float z = 1 - 2 * uniform(random), phi = 2 * std::numbers::pi_v<float> * uniform(random);
    const float r = std::sqrt(std::max(0.0f, 1 - z * z));
    return {r * std::cos(phi), r * std::sin(phi), z};
}

/// Cosine-weighted around the unit vector n.
Vec3f cosine_direction(Random &random, const Vec3f &n) {
    const Vec3f d = n + sphere_direction(random);
    return d.squaredNorm() > 1e-8f ? d.normalized() : n;
}

class Generator {
  public:
    Generator(std::span<const accel::Triangle> triangles, const EmbreeScene &scene)
        : triangles(triangles), scene(scene) {
        Eigen::AlignedBox3f box;
        for (const accel::Triangle &t : triangles) box.extend(t.v[0]).extend(t.v[1]).extend(t.v[2]);
        centre = box.center();
        size = box.sizes().maxCoeff();
    }

    /// Walks enter in clusters of 400 over a few hundred neighbouring triangles, as the pixels of a tile do.
    std::vector<ProbeRay> walk(float mean_free_path, std::size_t count) {
        std::vector<ProbeRay> rays;
        std::size_t cluster = 0;
        for (std::size_t walk = 0; rays.size() < count; walk++) {
            if (walk % 400 == 0) cluster = random() % triangles.size();
            const std::size_t triangle = (cluster + random() % 256) % triangles.size();
            const Vec3f n = normal(triangle);
            Vec3f p = point(triangle) - n * (2e-5f * size), d = cosine_direction(random, -n);
            for (int step = 0; step < 256 && rays.size() < count; step++) {
                const float length = -std::log(1 - uniform(random)) * mean_free_path * size;
                rays.push_back({p, length, d, 0});
                if (closest(rays.back()).hit()) break;
                p += d * length;
                d = sphere_direction(random);
            }
        }
        return rays;
    }

    void camera(std::size_t count, std::vector<ProbeRay> &primary, std::vector<ProbeRay> &diffuse) {
        const int side = int(std::sqrt(double(count)));
        const Vec3f eye = centre + Vec3f(0.6f, 0.5f, 1).normalized() * (1.6f * size);
        const Vec3f forward = (centre - eye).normalized(), right = forward.cross(Vec3f(0, 1, 0)).normalized();
        const Vec3f up = right.cross(forward);
        for (int y = 0; y < side; y++)
            for (int x = 0; x < side; x++) {
                const float a = (2 * (float(x) + uniform(random)) / float(side) - 1) * 0.38f;
                const float b = (2 * (float(y) + uniform(random)) / float(side) - 1) * 0.38f;
                primary.push_back({eye, 1e30f, (forward + right * a + up * b).normalized(), 0});
                const ProbeHit hit = closest(primary.back());
                if (!hit.hit()) continue;
                const Vec3f d = primary.back().direction;
                Vec3f n = normal(hit.primitive);
                if (n.dot(d) > 0) n = -n;
                diffuse.push_back({eye + d * hit.t + n * (1e-5f * size), 1e30f, cosine_direction(random, n), 0});
            }
    }

  private:
    const Vec3f &vertex(std::size_t triangle, int k) const { return triangles[triangle].v[k]; }
    Vec3f normal(std::size_t triangle) const {
        const Vec3f a = vertex(triangle, 0);
        return (vertex(triangle, 1) - a).cross(vertex(triangle, 2) - a).normalized();
    }
    Vec3f point(std::size_t triangle) {
        const float s = std::sqrt(uniform(random)), b = s * uniform(random);
        return vertex(triangle, 0) * (1 - s) + vertex(triangle, 1) * (s - b) + vertex(triangle, 2) * b;
    }
    ProbeHit closest(const ProbeRay &ray) const {
        ProbeHit hit;
        scene.closest({&ray, 1}, {&hit, 1});
        return hit;
    }

    const std::span<const accel::Triangle> triangles;
    const EmbreeScene &scene;
    Random random{12345};
    Vec3f centre;
    float size;
};

} // namespace

std::vector<RaySet> make_ray_sets(std::span<const accel::Triangle> triangles, const EmbreeScene &scene,
                                  std::size_t count) {
    Generator generator(triangles, scene);
    std::vector<RaySet> sets{{"0.2%", generator.walk(0.002f, count)},
                             {"1%", generator.walk(0.01f, count)},
                             {"10%", generator.walk(0.1f, count)},
                             {"primary", {}},
                             {"diffuse", {}}};
    generator.camera(count, sets[3].rays, sets[4].rays);
    return sets;
}

} // namespace nacre::bench
