#include "stress/bodies.h"
#include "image/rendered.h"
#include "io/object.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace nacre::stress {

using namespace shared;

bool Seen::sound(double slack) const {
    return finite && ((mean - 4 * error).array() <= 1 + slack).all() && (mean.array() >= 0).all();
}

bool Seen::is(const Vec3 &exact, double slack) const {
    return finite && ((mean - exact).cwiseAbs() - 4 * error).maxCoeff() <= slack;
}

std::string Seen::text() const {
    return fmt::format("found {:.6g} {:.6g} {:.6g} +- {:.2g} {:.2g} {:.2g}, largest {:.6g}{}", mean.x(), mean.y(),
                       mean.z(), error.x(), error.y(), error.z(), largest, finite ? "" : ", not finite");
}

scene::Material material_of(const Body &body) {
    scene::Material material;
    const auto set = [&](Parameter parameter, const Vec3 &value) { material[parameter].value = value; };
    set(PARAMETER_specular_weight, Vec3::Zero());
    set(PARAMETER_subsurface_weight, Vec3::Ones());
    set(PARAMETER_subsurface_color, body.albedo);
    set(PARAMETER_subsurface_radius, Vec3::Constant(body.free_path));
    set(PARAMETER_subsurface_radius_scale, body.scale);
    set(PARAMETER_subsurface_scatter_anisotropy, Vec3::Constant(body.g));
    set(PARAMETER_subsurface_bleed, Vec3::Constant(body.bleed));
    material.inversion = INVERSION_NONE;
    material.flight = body.flight;
    material.entry = body.entry;
    material.max_depth = body.max_depth;
    return material;
}

Seen seen(const io::Picture &picture, int x0, int y0, int x1, int y1) {
    const std::size_t channels = picture.channels.size();
    const auto variance = std::size_t(std::find(picture.channels.begin(), picture.channels.end(), "variance.R") -
                                      picture.channels.begin());
    const double pixels = double(x1 - x0) * (y1 - y0);
    Seen seen;
    Vec3 squares(0, 0, 0);
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            const float *pixel =
                picture.pixels.data() + (std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) * channels;
            for (std::size_t c = 0; c < channels; ++c) seen.finite = seen.finite && std::isfinite(pixel[c]);
            for (std::size_t c = 0; c < 3; ++c) {
                seen.mean[Eigen::Index(c)] += pixel[c] / pixels;
                seen.error[Eigen::Index(c)] += pixel[variance + c] / (pixels * pixels);
                squares[Eigen::Index(c)] += double(pixel[c]) * pixel[c] / pixels;
                seen.largest = std::max(seen.largest, double(pixel[c]));
            }
        }
    // A spread of less than 1e-4 is lost in the sums of squares, which are floats; that of the pixels is not.
    const Vec3 spread = (squares - seen.mean.cwiseAbs2()).cwiseMax(0) / std::max(1.0, pixels - 1);
    seen.error = seen.error.cwiseMax(spread).cwiseSqrt();
    return seen;
}

Shown show(const std::vector<Body> &bodies, const Look &look) {
    std::vector<Body> all = bodies;
    all.push_back({.g = .5, .bleed = .5}); // so that all pictures need the same features, and one program serves them
    const int columns = int(std::ceil(std::sqrt(double(all.size())))), rows = (int(all.size()) + columns - 1) / columns;
    const int cell = look.pixels + 1; // with a gap of one pixel
    const double pitch = double(cell) / look.pixels;
    scene::Scene scene;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Vec3 corner(pitch * (int(i) % columns), pitch * (rows - 1 - int(i) / columns), -1);
        scene.materials.push_back(material_of(all[i]));
        scene.materials.back()[PARAMETER_subsurface_radius].value *= look.scale;
        std::vector<std::string> warnings;
        scene.objects.push_back(io::make_object(std::to_string(i), scene::make_box(corner, corner + Vec3::Ones()),
                                                Eigen::Translation3d(look.offset) * Eigen::Scaling(look.scale), {},
                                                "body", warnings));
        scene.objects.back().material = std::uint32_t(i);
    }
    scene.lights.emplace_back();
    scene.lights.back().visible = true;
    scene.camera.kind = CAMERA_ORTHOGRAPHIC;
    scene.camera.target = look.offset + look.scale * Vec3(pitch * columns / 2, pitch * rows / 2, 0);
    scene.camera.position = scene.camera.target + Vec3(0, 0, 2 * look.scale);
    scene.camera.height = pitch * rows * look.scale;
    scene.image = {cell * columns, cell * rows};
    scene.render.spp = look.spp;
    scene.render.seed = look.seed;
    scene.render.max_depth = 0;
    scene.render.guiding = look.guiding;
    scene.render.channel_sampling = look.sampling;
    scene.render.clearance = false; // a field for each of hundreds of bodies would take longer than the walks

    const Rendered found = rendered(scene, with_variance());
    Shown shown{{}, found.statistics};
    for (int i = 0; i < int(bodies.size()); ++i) {
        const int x = i % columns * cell, y = i / columns * cell + 1;
        shown.bodies.push_back(seen(found.picture, x, y, x + look.pixels, y + look.pixels));
    }
    return shown;
}

render::Options with_variance() {
    render::Options options;
    options.layers.variance = true;
    return options;
}

} // namespace nacre::stress
