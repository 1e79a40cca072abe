#include "io/ranges.h"
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <stdexcept>

namespace nacre::io {

namespace {

// What still fits a float after a few multiplications (largest float: 3.4e38).
constexpr double huge = 1e30;
constexpr double tiny = 1e-30;                 // its reciprocal does, too
constexpr double largest_integer = 4294967295; // of 32 bits

constexpr Range any{-huge, huge}, share{0, 1}, not_negative{0, huge}, positive{tiny, huge};

const std::map<std::string, Range> &table() {
    static const std::map<std::string, Range> ranges{
        {"camera.position", any},
        {"camera.target", any},
        {"camera.up", any},
        {"camera.fov", {0, 180, true, true}},
        {"camera.height", positive},
        {"camera.aperture", not_negative},
        {"camera.focus_distance", not_negative}, // 0: the distance to the target
        {"image.width", {1, 65536, false, false, true}},
        {"image.height", {1, 65536, false, false, true}},
        {"render.spp", {1, 2147483648.0, false, false, true}}, // sample indices are 32 bits, blocks of 64
        {"render.seed", {0, largest_integer, false, false, true}},
        {"render.max_depth", {0, largest_integer, false, false, true}},
        {"render.exposure", {-100, 100}}, // 2^100 is a float still
        {"device.lanes", {0, 64, false, false, true}},
        {"material.base_color", share},
        {"material.base_metalness", share},
        {"material.specular_weight", share},
        {"material.specular_roughness", share},
        {"material.specular_ior", {1, 100}},
        {"material.emission_luminance", not_negative},
        {"material.emission_color", not_negative},
        {"material.subsurface_weight", share},
        {"material.subsurface_color", share},
        {"material.subsurface_albedo", share},
        {"material.subsurface_radius", positive},
        {"material.subsurface_radius_scale", positive},
        {"material.subsurface_scatter_anisotropy",
         {-0.9999, 0.9999}}, // (-1, 1): the ends, and what rounds to them, are deltas
        {"material.subsurface_bleed",
         {0, 1e4}}, // flights past float's range end at the surface, so large values do no harm
        {"material.subsurface_max_depth", {0, largest_integer, false, false, true}},
        {"texture.scale", any},
        {"texture.offset", any},
        {"sphere.center", any},
        {"sphere.radius", positive},
        {"sphere.segments", {4, 8192, false, false, true}}, // 8192: 67 million triangles
        {"box.min", any},
        {"box.max", any},
        {"transform.scale", any},
        {"transform.rotate", any},
        {"transform.translate", any},
        {"sheet.spp", {1, 2147483648.0, false, false, true}},
        {"sheet.seconds", positive},
        {"sheet.columns", {1, 64, false, false, true}},
        {"light.radiance", not_negative},
        {"light.irradiance", not_negative},
        {"light.intensity", not_negative},
        {"light.scale", not_negative},
        {"light.rotate", any},
        {"light.direction", any},
        {"light.position", any},
        {"light.center", any},
        {"light.u", any},
        {"light.v", any},
    };
    return ranges;
}

} // namespace

// Written so that NaN is in no range.
bool Range::holds(double value) const {
    const bool above = lower_open ? value > lower : value >= lower;
    const bool below = upper_open ? value < upper : value <= upper;
    return above && below && (!whole || value == std::floor(value));
}

std::string Range::text() const {
    const char *kind = whole ? "a whole number " : "";
    if (upper == huge && lower == -huge) return fmt::format("between {} and {}", lower, upper);
    if (lower == tiny) return "above 0";
    if (upper == huge) return fmt::format("{}at least {}", kind, lower);
    return fmt::format("{}in {}{}, {}{}", kind, lower_open ? '(' : '[', lower, upper, upper_open ? ')' : ']');
}

const Range &range_of(const std::string &field) {
    const auto found = table().find(field);
    if (found == table().end()) throw std::logic_error("no range for " + field);
    return found->second;
}

} // namespace nacre::io
