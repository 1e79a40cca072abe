#include "rays/ray_sets.h"
#include "entries.h"
#include <cmath>

namespace nacre::bench {
namespace {

class Generator {
  public:
    Generator(std::span<const accel::Triangle> triangles, const EmbreeScene &scene)
        : triangles(triangles), scene(scene) {
        Eigen::AlignedBox3f box;
        for (const accel::Triangle &t : triangles) box.extend(t.v[0]).extend(t.v[1]).extend(t.v[2]);
        centre = box.center();
        size = box.sizes().maxCoeff();
    }

    std::vector<ProbeRay> walk(float mean_free_path, std::size_t count) {
        std::vector<ProbeRay> rays;
        Entries entries(triangles);
        while (rays.size() < count) {
            const Entries::Entry entry = entries.next(random);
            Vec3f p = entry.position - entry.normal * (2e-5f * size), d = entry.direction;
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
                Vec3f n = triangle_normal(triangles[hit.primitive]);
                if (n.dot(d) > 0) n = -n;
                diffuse.push_back({eye + d * hit.t + n * (1e-5f * size), 1e30f, cosine_direction(random, n), 0});
            }
    }

  private:
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
