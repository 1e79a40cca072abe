#include "render/slabs.h"
#include "render/body.h"
#include "render/light_sides.h"
#include "render/returned_layer.h"
#include "scene/mean.h"
#include <algorithm>
#include <cmath>

namespace nacre::render {
namespace {

using namespace shared;

/// Slabs of an object. Where it is a slab one will do.
constexpr std::size_t most_slabs = 8;

/// Lengths are in the kernels' units.
struct Plate {
    const scene::Mesh &mesh;
    const float *thickness; // below each triangle
    double mean_thickness;
    double longest;              // about the way on which light falls to 1 / e
    double color;                // what a half-space of the medium returns, at most
    double least_for_half_space; // thickness from which on twins may be in half-spaces
};

/// A part of a plate through which light may get, or that is too thin for a twin in a half-space: how thick, and how
/// much it may show, about.
struct Part {
    double thickness, weight;
};

/// In order of their thickness. None of a body whose surface is mostly thicker than its volume says: of twigs, which
/// are as thick everywhere, twice that, of plates no more than 1.5 times.
std::vector<Part> parts_of(const Plate &plate, const LightSides &sides) {
    constexpr double most = 1.6;
    const double least = 0.1 * plate.color / double(CONTROL_MOST_LIGHT);
    const scene::Mesh &mesh = plate.mesh;
    std::vector<Part> parts;
    double all = 0, thin = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto &[a, b, c] = mesh.triangles[i];
        const Vec3 across = (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
        const double area = across.norm(), thick = double(plate.thickness[i]);
        const double through = std::exp(-thick / plate.longest);
        all += area;
        if (thick < most * plate.mean_thickness) thin += area;
        if (!(area * through > 0)) continue;
        if (thick < plate.least_for_half_space || through * far_light(sides, across / area) > least)
            parts.push_back({thick, area * through});
    }
    if (thin < all / 2) return {};
    std::sort(parts.begin(), parts.end(), [](const Part &a, const Part &b) { return a.thickness < b.thickness; });
    return parts;
}

/// Of `parts` that are in order, about as much for each slab. No slab is thinner than its parts.
std::vector<double> thicknesses(const std::vector<Part> &parts) {
    double all = 0, sum = 0;
    for (const Part &part : parts) all += part.weight;
    std::vector<double> found;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        sum += parts[i].weight;
        const bool last = i + 1 == parts.size();
        if (!last && sum * double(most_slabs) < all * double(found.size() + 1)) continue;
        constexpr double alike = 1.01;
        if (found.empty() || parts[i].thickness > alike * found.back())
            found.push_back(parts[i].thickness);
        else
            found.back() = parts[i].thickness;
    }
    return found;
}

/// Appends the tables of one channel of a slab, the same for both similarities about its own.
int add_tables(const albedo::Returned &returned, double similarity, double thickness, Eigen::Index cosines,
               std::vector<float> &tables) {
    std::vector<double> depths;
    for (int i = 0; i < RETURNED_SLAB_DEPTHS; ++i) {
        const double x = double(i) / (RETURNED_SLAB_DEPTHS - 1);
        depths.push_back(thickness * (x < 0.5 ? 2 * x * x : 1 - 2 * (1 - x) * (1 - x)));
    }
    constexpr double least_share = 1e-30;
    Rows layer(RETURNED_SLAB_ROWS, cosines);
    layer.topRows(RETURNED_SLAB_DEPTHS) = returned_layer(returned, depths, cosines);
    layer.row(RETURNED_SLAB_DEPTHS).setConstant(std::log(std::max(least_share, returned.reflected())));
    layer.row(RETURNED_SLAB_DEPTHS + 1).setConstant(std::log(std::max(least_share, returned.transmitted())));
    const int node = std::min(int(similarity * (RETURNED_SIMILARITIES - 1)), RETURNED_SIMILARITIES - 2);
    const int first = int(tables.size()) - node * int(layer.size());
    for (int copy = 0; copy < 2; ++copy) tables.insert(tables.end(), layer.data(), layer.data() + layer.size());
    return first;
}

/// Per channel, in the scene's units. Of one medium everywhere.
Vec3 free_path(const scene::Material &source) {
    return source[PARAMETER_subsurface_radius].value.cwiseProduct(source[PARAMETER_subsurface_radius_scale].value);
}

/// `scale`: the kernels' unit of length in the scene's.
Slab slab_of(const scene::Material &source, const float4 &albedos, double thickness, double scale, Eigen::Index cosines,
             std::vector<float> &tables) {
    constexpr double least_albedo = 1e-9;
    constexpr double least_free_path = 1e-7; // in the kernels' units: medium_at (kernels/walk/medium.h)
    const Vec3 radius = free_path(source);
    Slab slab{float(thickness), 0, {}, {}};
    double back = 0, through = 0;
    for (int c = 0; c < 3; ++c) {
        const double g = source[PARAMETER_subsurface_scatter_anisotropy].value[c];
        const double albedo = double((&albedos.x)[c]), paths = thickness / std::max(radius[c] / scale, least_free_path);
        const albedo::Returned returned(
            returned_ordinates(g, source[PARAMETER_subsurface_bleed].value.x(), source.flight), g,
            std::clamp(albedo, least_albedo, 1 - least_albedo), paths);
        slab.first[c] = add_tables(returned, std::sqrt((1 - albedo) / (1 - albedo * g)), paths, cosines, tables);
        back += returned.reflected();
        through += returned.transmitted();
    }
    slab.through = float(through / back);
    return slab;
}

} // namespace

Slabs choose_slabs(const scene::Scene &scene, const DeviceScene &uploaded, const std::vector<float> &thickness,
                   std::vector<LightSides> &sides) {
    Slabs out;
    const Eigen::Index cosines = uploaded.frame.features & FEATURE_ANISOTROPY ? RETURNED_COSINES : 1;
    for (const DeviceScene::Measured &measured : uploaded.measured) {
        if (!measured.plate) continue;
        const scene::Object &object = scene.objects[measured.object];
        const scene::Material &source = scene.materials[object.material];
        LightSides &light = sides[measured.object];
        light.first_slab = uint(out.slabs.size());
        // In dark media what has not scattered yet goes farther than what diffuses.
        const Vec3 ways = diffusion_length(scene, source).cwiseMax(free_path(source));
        const Plate plate{.mesh = object.mesh,
                          .thickness = thickness.data() + measured.first_primitive,
                          .mean_thickness = render::thickness(object.mesh) / uploaded.length,
                          .longest = ways.maxCoeff() / uploaded.length,
                          .color = scene::mean_color(scene, source[PARAMETER_subsurface_color]).maxCoeff(),
                          .least_for_half_space = double(measured.control_thickness)};
        for (const double thick : thicknesses(parts_of(plate, light)))
            out.slabs.push_back(slab_of(source, uploaded.materials[object.material].albedo, thick, uploaded.length,
                                        cosines, out.transmitted));
        light.slab_count = uint(out.slabs.size()) - light.first_slab;
    }
    return out;
}

} // namespace nacre::render
