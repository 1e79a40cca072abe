#include "render/guides.h"
#include "base/parallel.h"
#include "guide/eigenmode.h"
#include "render/body.h"
#include "render/light_sides.h"
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

/// How light fares across a body.
struct Across {
    double scatters; // thickness in transport mean free paths, of the channel with the longest
    double folds;    // e-folds by which deep light falls, of the channel that loses most
};

Across across(const scene::Scene &scene, const scene::Material &material, double thickness) {
    const Vec3 radius = scene::mean_color(scene, material[PARAMETER_subsurface_radius]);
    const Vec3 scale = scene::mean_color(scene, material[PARAMETER_subsurface_radius_scale]);
    const Vec3 g = scene::mean_color(scene, material[PARAMETER_subsurface_scatter_anisotropy]);
    const Vec3 transport = radius.array() * scale.array() / (1 - g.array());
    return {thickness / transport.maxCoeff(), thickness / diffusion_length(scene, material).minCoeff()};
}

/// Bodies that light hardly notices: every way through them is short, and a guide only costs. Light from everywhere
/// needs scatters for a guide to save some: slabs of .2 transport mean free paths are .7 to 1.2 times as noisy with one
/// as without, of .25 1.6 times, all of 1 and more twice and more. Where light has to get through, the noise is that of
/// whether it does: e-folds count. Slabs of .04 to .19 gain 1.0 to 1.4 in variance, from .3 on more than 1.7
/// (build/bench/guiding without these limits; a guided walk takes 1.2 times as long).
constexpr double least_scatters = .22, least_folds = .2;

bool is_thin(const Across &a, double lost, bool even_light) {
    return even_light ? a.scatters < least_scatters + 2.5 * lost : a.folds < least_folds;
}

/// What a guide loses under bleed: flights are no longer those of its mode, and the more they go forward, the less does
/// a turn save. Slabs of one transport mean free path in light from everywhere (g .8) are .8 times as good with one at
/// bleed .5 and 1, half-spaces 2.6 and 1.1 times, balls of 30 mean free paths 1.2 and .8 times; at g 0 all gain.
double lost_under_bleed(const scene::Scene &scene, const scene::Material &material) {
    const Vec3 g = scene::mean_color(scene, material[PARAMETER_subsurface_scatter_anisotropy]);
    return std::max(0., g.maxCoeff()) * scene::mean_color(scene, material[PARAMETER_subsurface_bleed]).x();
}

/// With more lost than this only flat bodies gain.
constexpr double most_lost = .42;

/// Through other than flat bodies that lose less than this, light goes on to sides of which a slab knows nothing: balls
/// of 30 mean free paths are .57 times as good guided at .5 e-folds (grey .8, g .8), .72 at .4 (grey .98, g 0), bright
/// ones of 15 to 100 .6 to .7 times at 1.1 to 1.8, grey ones 1.2 to 1.4 times at 2.2.
constexpr double least_curved_folds = 2;

/// The more forward a medium scatters, the more directions does a guide refuse: at g = .95 a guided walk takes 1.3
/// times as long, and through the memo's head it is .79 times as good (.97 at .8). Flat bodies gain there, too.
constexpr double most_forward = .9;

} // namespace

bool choose_guided(const scene::Scene &scene, Geometry &geometry) {
    const bool even_light = !has_sides(scene);
    bool some = false;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const scene::Object &object = scene.objects[i];
        const scene::Material &material = scene.materials[object.material];
        if (scene.render.guiding == GUIDING_NONE || !scene::walks_below(material)) continue;
        // Where a surface bends a control variate takes the noise that a guide would, and more: without one, balls of
        // skin are 1.1 (g 0) to 2.2 times as good, the memo's head .9 to 1.05 (g 0) and 1.3 to 1.6 times (g .8).
        const bool flat = is_flat(scene, object);
        if (!flat && geometry.objects[i].control_thickness < GUIDE_THICK) continue;
        const double thick = thickness(object.mesh);
        if (extent(object.mesh) < least_size * light_path(scene, material)) continue;
        if (is_dark(scene, material)) continue; // half-spaces of .02 are .85 times as good (g .8)
        const double lost = lost_under_bleed(scene, material);
        const Across body = across(scene, material, thick);
        if (geometry.objects[i].closed && is_thin(body, lost, even_light)) continue;
        const double g = scene::mean_color(scene, material[PARAMETER_subsurface_scatter_anisotropy]).maxCoeff();
        if (!flat && (lost > most_lost || g > most_forward)) continue;
        if (!flat && geometry.objects[i].closed && body.folds < least_curved_folds) continue;
        geometry.objects[i].guided = flat ? GUIDE_SHARE : GUIDE_SHARE_CURVED;
        some = true;
    }
    return some;
}

void add_guides(const scene::Scene &scene, bool isotropic, std::vector<Material> &materials,
                std::vector<GuideMode> &modes) {
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
    tables.fill(isotropic || scene.render.guiding == GUIDING_DWIVEDI);
}

} // namespace nacre::render
