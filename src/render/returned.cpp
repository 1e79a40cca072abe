#include "render/returned.h"
#include "albedo/half_space.h"
#include "base/parallel.h"
#include "render/returned_layer.h"
#include "shared/guide.h"
#include "shared/returned.h"
#include <cmath>
#include <map>
#include <tuple>

namespace nacre::render {
namespace {

using namespace shared;

/// The logarithms for one similarity, depths x cosines.
Rows layer_of(const albedo::Ordinates &ordinates, double g, double similarity, Eigen::Index cosines) {
    if (similarity <= 0) return Rows::Zero(RETURNED_DEPTHS, cosines); // white
    constexpr double least_albedo = 1e-9;
    const albedo::Returned returned(ordinates, g, std::max(least_albedo, albedo::albedo_of(similarity, g)));
    std::vector<double> depths;
    for (int i = 0; i < RETURNED_DEPTHS; ++i)
        depths.push_back(double(RETURNED_DEEPEST) * std::pow(double(i) / (RETURNED_DEPTHS - 1), 4) / (1 - g));
    return returned_layer(returned, depths, cosines);
}

/// A table of one channel: of which medium, and from which similarity to which.
using Key = std::tuple<double, double, FlightLaw, int, int>;

/// Similarities that a channel's colours have, as nodes.
std::pair<int, int> range_of(const Material &material, int channel, double g) {
    constexpr int last = RETURNED_SIMILARITIES - 1;
    if (material.albedo_source != ALBEDO_FIXED) return {0, last};
    const float4 &a = material.albedo;
    const double albedo = double(channel == 0 ? a.x : channel == 1 ? a.y : a.z);
    const double at = std::sqrt((1 - albedo) / (1 - albedo * g)) * last, rounding = 1e-3;
    return {std::clamp(int(at - rounding), 0, last - 1), std::clamp(int(at + rounding) + 1, 1, last)};
}

class Tables {
  public:
    Tables(std::vector<float> &returned, bool isotropic)
        : returned(returned), cosines(isotropic ? 1 : RETURNED_COSINES), layer_size(RETURNED_DEPTHS * cosines) {}

    /// Where a table begins, as if it had all similarities.
    int of(const Key &key) {
        const auto [g, bleed, law, first, last] = key;
        const auto [entry, fresh] = begins.try_emplace(key, int(returned.size()) - first * layer_size);
        if (fresh) {
            returned.resize(returned.size() + std::size_t((last - first + 1) * layer_size));
            const albedo::Ordinates ordinates = returned_ordinates(g, bleed, law);
            parallel_for(std::size_t(last - first + 1), [&, first = first, g = g](std::size_t k) {
                const int row = first + int(k);
                const Rows layer = layer_of(ordinates, g, double(row) / (RETURNED_SIMILARITIES - 1), cosines);
                std::copy(layer.data(), layer.data() + layer.size(),
                          returned.begin() + (entry->second + row * layer_size));
            });
        }
        return entry->second;
    }

  private:
    std::vector<float> &returned;
    int cosines, layer_size;
    std::map<Key, int> begins;
};

} // namespace

void add_returned(const scene::Scene &scene, const Geometry &geometry, bool isotropic, std::vector<Material> &materials,
                  std::vector<float> &returned) {
    Tables tables(returned, isotropic);
    for (const Object &object : geometry.objects) {
        if (!(object.control_thickness < GUIDE_THICK)) continue;
        const scene::Material &source = scene.materials[object.material];
        Material &material = materials[object.material];
        for (int c = 0; c < 3; ++c) {
            const double g = source[PARAMETER_subsurface_scatter_anisotropy].value[c];
            const auto [first, last] = range_of(material, c, g);
            const double bleed = source[PARAMETER_subsurface_bleed].value.x();
            material.returned_first[c] = tables.of({g, bleed, source.flight, first, last});
        }
    }
}

} // namespace nacre::render
