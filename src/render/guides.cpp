#include "render/guides.h"
#include "base/parallel.h"
#include "guide/eigenmode.h"
#include "scene/mean.h"
#include <map>

namespace nacre::render {
namespace {

using namespace shared;

/// Albedo of entry i of a table for media with anisotropy g, as mode_of (kernels/guide/load.h) looks it up.
double albedo_of(int i, double g) {
    const double similarity2 = std::pow(double(i) / (GUIDE_ALBEDOS - 1), 4);
    return (1 - similarity2) / (1 - similarity2 * g);
}

/// Tables that are asked for, each once.
class Tables {
  public:
    explicit Tables(std::vector<GuideMode> &modes) : modes(modes) {}

    uint of(double g) { return at({g}); }

    uint of_any() {
        std::vector<double> all;
        for (int j = -GUIDE_ANISOTROPIES; j <= GUIDE_ANISOTROPIES; ++j)
            all.push_back(double(GUIDE_LARGEST_ANISOTROPY) * j / GUIDE_ANISOTROPIES);
        return at(all);
    }

    void fill(bool isotropic) const {
        for (const auto &[anisotropies, first] : tables)
            parallel_for(anisotropies.size() * GUIDE_ALBEDOS, [&, first = first](std::size_t k) {
                const double g = anisotropies[k / GUIDE_ALBEDOS];
                modes[first + k] = guide::guide_mode(albedo_of(int(k % GUIDE_ALBEDOS), g), g, isotropic);
            });
    }

  private:
    uint at(const std::vector<double> &anisotropies) {
        const auto [entry, fresh] = tables.try_emplace(anisotropies, uint(modes.size()));
        if (fresh) modes.resize(modes.size() + anisotropies.size() * GUIDE_ALBEDOS);
        return entry->second;
    }

    std::vector<GuideMode> &modes;
    std::map<std::vector<double>, uint> tables; // anisotropies and the first mode
};

/// Size of an object, in lengths of light_path, from which on guiding pays. In variance times time, balls of skin at 27
/// are 2.1 times better guided (g .8), at 60 4.3 times (g 0), at 13 neither (g .95); at 4 they are .6 times, at 6 dark
/// ones .45 times as good (build/bench/guiding with the limit at 0).
constexpr double least_size = 20;

/// How far light gets in a medium: as a diffusion length its longest mean free path grows with 1 / sqrt(1 - g).
double light_path(const scene::Scene &scene, const scene::Material &material) {
    const Vec3 radius = scene::mean_color(scene, material[PARAMETER_subsurface_radius]);
    const Vec3 scale = scene::mean_color(scene, material[PARAMETER_subsurface_radius_scale]);
    const Vec3 g = scene::mean_color(scene, material[PARAMETER_subsurface_scatter_anisotropy]);
    return (radius.array() * scale.array() / (1 - g.array()).sqrt()).maxCoeff();
}

} // namespace

bool choose_guided(const scene::Scene &scene, Geometry &geometry) {
    bool some = false;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const scene::Object &object = scene.objects[i];
        const scene::Material &material = scene.materials[object.material];
        if (scene.render.guiding == GUIDING_NONE || !scene::walks_below(material)) continue;
        Eigen::AlignedBox3d box;
        for (const Vec3 &vertex : object.mesh.positions) box.extend(vertex);
        if (box.sizes().maxCoeff() < least_size * light_path(scene, material)) continue;
        geometry.objects[i].guided = 1;
        some = true;
    }
    return some;
}

void add_guides(const scene::Scene &scene, std::vector<Material> &materials, std::vector<GuideMode> &modes) {
    if (scene.render.guiding == GUIDING_NONE) return;
    Tables tables(modes);
    for (std::size_t i = 0; i < materials.size(); ++i) {
        const scene::Material &source = scene.materials[i];
        if (!scene::walks_below(source)) continue;
        const scene::Value &g = source[PARAMETER_subsurface_scatter_anisotropy];
        Material &material = materials[i];
        material.guide_anisotropies = g.texture < 0 ? 1 : 2 * GUIDE_ANISOTROPIES + 1;
        for (int c = 0; c < 3; ++c) material.guide_first[c] = g.texture < 0 ? tables.of(g.value[c]) : tables.of_any();
    }
    tables.fill(scene.render.guiding == GUIDING_DWIVEDI);
}

} // namespace nacre::render
