#include "render/lights.h"
#include "render/alias.h"
#include "render/convert.h"
#include "scene/mean.h"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace nacre::render {
namespace {

using namespace shared;
using std::numbers::pi;

double luminance(const Vec3 &c) { return 0.2126 * c.x() + 0.7152 * c.y() + 0.0722 * c.z(); }

/// A light under construction: radiance still in the scene's units, and its power.
struct Draft {
    Light light;
    Vec3 radiance;
    double power = 0;
};

/// Mean over a texel of the bilinear interpolant is separable: 1/8, 6/8, 1/8 of the neighbours. Drawing texels by it,
/// and not by their own value, keeps the pixels beside a small sun from being drawn too rarely.
std::vector<double> texel_weights(const scene::Light &source) {
    const std::uint32_t w = source.width, h = source.height;
    std::vector<double> value(std::size_t(w) * h), across(value.size()), weights(value.size());
    for (std::size_t i = 0; i < value.size(); ++i)
        value[i] = luminance({source.pixels[3 * i], source.pixels[3 * i + 1], source.pixels[3 * i + 2]});
    for (std::uint32_t y = 0; y < h; ++y)
        for (std::uint32_t x = 0; x < w; ++x)
            across[std::size_t(y) * w + x] =
                (value[std::size_t(y) * w + (x + w - 1) % w] + 6 * value[std::size_t(y) * w + x] +
                 value[std::size_t(y) * w + (x + 1) % w]) /
                8;
    for (std::uint32_t y = 0; y < h; ++y) {
        const double solid_angle = std::cos(pi * y / h) - std::cos(pi * (y + 1) / h); // of the row, / (2 pi / w)
        const std::uint32_t above = y > 0 ? y - 1 : 0, below = std::min(y + 1, h - 1);
        for (std::uint32_t x = 0; x < w; ++x)
            weights[std::size_t(y) * w + x] = solid_angle *
                                              (across[std::size_t(above) * w + x] + 6 * across[std::size_t(y) * w + x] +
                                               across[std::size_t(below) * w + x]) /
                                              8;
    }
    return weights;
}

Draft environment_image(const scene::Light &source, double radius, LightSet &set) {
    Draft draft{.light = {}, .radiance = source.radiance};
    const double turn = source.rotate * pi / 180;
    draft.light.position = {float(std::cos(turn)), float(std::sin(turn)), 0, 0};
    draft.light.width = source.width;
    draft.light.height = source.height;
    draft.light.first_texel = std::uint32_t(set.environment.size());
    const std::vector<double> weights = texel_weights(source);
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    const auto table = alias_table(weights);
    set.environment_table.insert(set.environment_table.end(), table.begin(), table.end());
    for (std::size_t i = 0; i < weights.size(); ++i)
        set.environment.push_back({source.pixels[3 * i], source.pixels[3 * i + 1], source.pixels[3 * i + 2],
                                   total > 0 ? float(weights[i] / total) : 0});
    draft.power = pi * radius * radius * luminance(source.radiance) * total * 2 * pi / source.width;
    return draft;
}

Draft rect(const scene::Light &source, const scene::Frame &frame) {
    const Vec3 cross = source.u.cross(source.v) / (frame.size * frame.size);
    Draft draft{.light = {}, .radiance = source.radiance};
    draft.light.position = to_float4(frame.point(source.position - 0.5 * (source.u + source.v)));
    draft.light.u = to_float4(frame.vector(source.u));
    draft.light.v = to_float4(frame.vector(source.v));
    draft.light.normal = to_float4(cross.normalized(), cross.norm());
    draft.power = pi * cross.norm() * luminance(source.radiance);
    return draft;
}

Draft far_or_small(const scene::Light &source, const scene::Frame &frame, double radius) {
    Draft draft{.light = {}, .radiance = source.radiance};
    if (source.kind == LIGHT_POINT) {
        draft.radiance /= frame.size * frame.size; // intensity: irradiance is intensity / distance^2
        draft.light.position = to_float4(frame.point(source.position));
        draft.power = 4 * pi * luminance(draft.radiance);
    } else {
        draft.light.u = to_float4(-source.direction.normalized());
        draft.power = pi * radius * radius * luminance(source.radiance);
    }
    return draft;
}

void triangles(const scene::Scene &scene, const scene::Object &object, const scene::Frame &frame,
               std::uint32_t first_primitive, std::vector<Draft> &drafts) {
    const scene::Material &material = scene.materials[object.material];
    const Vec3 emission = scene::mean_color(scene, material[PARAMETER_emission_color])
                              .cwiseProduct(scene::mean_color(scene, material[PARAMETER_emission_luminance]));
    for (std::size_t i = 0; i < object.mesh.triangles.size(); ++i) {
        const auto &corner = object.mesh.triangles[i];
        const Vec3 a = frame.point(object.mesh.positions[corner[0]]), b = frame.point(object.mesh.positions[corner[1]]),
                   c = frame.point(object.mesh.positions[corner[2]]);
        const Vec3 cross = (b - a).cross(c - a);
        Draft draft{.light = {}, .radiance = emission};
        draft.light.kind = LIGHT_TRIANGLE;
        draft.light.primitive = first_primitive + std::uint32_t(i);
        draft.light.position = to_float4(a);
        draft.light.u = to_float4(b - a);
        draft.light.v = to_float4(c - a);
        draft.light.normal = to_float4(cross.normalized(), 0.5 * cross.norm());
        draft.power = pi * 0.5 * cross.norm() * luminance(emission);
        drafts.push_back(draft);
    }
}

bool emits(const scene::Material &material) {
    const auto dark = [&](Parameter p) { return material[p].texture < 0 && material[p].value == Vec3(0, 0, 0); };
    return !dark(PARAMETER_emission_luminance) && !dark(PARAMETER_emission_color);
}

} // namespace

LightSet build_lights(const scene::Scene &scene, const scene::Frame &frame) {
    LightSet set;
    const double radius = 0.5; // of the sphere about the normalised scene
    std::vector<Draft> drafts;
    const auto add = [&](bool wanted(LightKind)) {
        const std::size_t before = drafts.size();
        for (const scene::Light &source : scene.lights) {
            if (!wanted(source.kind)) continue;
            Draft draft;
            if (source.kind == LIGHT_ENVIRONMENT)
                draft.radiance = source.radiance; // power 0: never drawn
            else if (source.kind == LIGHT_ENVIRONMENT_IMAGE)
                draft = environment_image(source, radius, set);
            else if (source.kind == LIGHT_RECT)
                draft = rect(source, frame);
            else
                draft = far_or_small(source, frame, radius);
            draft.light.kind = source.kind;
            draft.light.visible = source.visible;
            drafts.push_back(draft);
        }
        return std::uint32_t(drafts.size() - before);
    };
    set.environment_count = add([](LightKind k) { return k == LIGHT_ENVIRONMENT || k == LIGHT_ENVIRONMENT_IMAGE; });
    set.rect_count = add([](LightKind k) { return k == LIGHT_RECT; });
    add([](LightKind k) { return k == LIGHT_POINT || k == LIGHT_DIRECTIONAL; });
    std::uint32_t primitive = 0;
    for (const scene::Object &object : scene.objects) {
        const bool lit = emits(scene.materials[object.material]);
        set.first_light.push_back(lit ? std::uint32_t(drafts.size()) : NO_LIGHT);
        if (lit) triangles(scene, object, frame, primitive, drafts);
        primitive += std::uint32_t(object.mesh.triangles.size());
    }

    std::vector<double> power;
    double total = 0, ambient = 0;
    for (const Draft &draft : drafts) {
        power.push_back(draft.power);
        total += draft.power;
        if (draft.light.kind == LIGHT_ENVIRONMENT) ambient += draft.radiance.mean();
    }
    set.unit = ambient + total / (pi * pi * radius * radius);
    if (!(set.unit > 0)) set.unit = 1;
    for (std::size_t i = 0; i < drafts.size(); ++i) {
        drafts[i].light.radiance = to_float4(drafts[i].radiance / set.unit);
        drafts[i].light.probability = total > 0 ? float(power[i] / total) : 0;
        set.lights.push_back(drafts[i].light);
    }
    if (total > 0) set.table = alias_table(power);
    return set;
}

} // namespace nacre::render
