#include "render/body.h"
#include "scene/mean.h"
#include <Eigen/Eigenvalues>

namespace nacre::render {

double thickness(const scene::Mesh &mesh) {
    double volume = 0, surface = 0;
    const Vec3 origin = mesh.positions[mesh.triangles[0][0]];
    for (const auto &corner : mesh.triangles) {
        const Vec3 a = mesh.positions[corner[0]] - origin, b = mesh.positions[corner[1]] - origin,
                   c = mesh.positions[corner[2]] - origin;
        volume += a.dot(b.cross(c)) / 6;
        surface += (b - a).cross(c - a).norm() / 2;
    }
    return surface > 0 ? 2 * std::abs(volume) / surface : 0;
}

double extent(const scene::Mesh &mesh) {
    Eigen::AlignedBox3d box;
    for (const Vec3 &vertex : mesh.positions) box.extend(vertex);
    return box.sizes().maxCoeff();
}

double light_path(const scene::Scene &scene, const scene::Material &material) {
    const Vec3 radius = scene::mean_color(scene, material[shared::PARAMETER_subsurface_radius]);
    const Vec3 scale = scene::mean_color(scene, material[shared::PARAMETER_subsurface_radius_scale]);
    const Vec3 g = scene::mean_color(scene, material[shared::PARAMETER_subsurface_scatter_anisotropy]);
    return (radius.array() * scale.array() / (1 - g.array()).sqrt()).maxCoeff();
}

bool is_flat(const scene::Scene &scene, const scene::Object &object) {
    constexpr double flat_size = 500;
    return extent(object.mesh) > flat_size * light_path(scene, scene.materials[object.material]) ||
           is_plate(object.mesh);
}

bool is_plate(const scene::Mesh &mesh) {
    constexpr double shell_ratio = 20, least_alike = 0.65; // cubes and balls 1/3, a box of 4 x 4 x 1 2/3
    if (extent(mesh) > shell_ratio * thickness(mesh)) return true;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero(); // of the normals
    for (const auto &[a, b, c] : mesh.triangles) {
        const Vec3 area = (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
        if (area.norm() > 0) spread += area * area.transpose() / area.norm();
    }
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread, Eigen::EigenvaluesOnly).eigenvalues()[2] >
           least_alike * spread.trace();
}

bool is_dark(const scene::Scene &scene, const scene::Material &material) {
    return scene::mean_color(scene, material[shared::PARAMETER_subsurface_color]).maxCoeff() < 0.05;
}

Vec3 diffusion_length(const scene::Scene &scene, const scene::Material &material) {
    const Vec3 radius = scene::mean_color(scene, material[shared::PARAMETER_subsurface_radius]);
    const Vec3 scale = scene::mean_color(scene, material[shared::PARAMETER_subsurface_radius_scale]);
    const Vec3 g = scene::mean_color(scene, material[shared::PARAMETER_subsurface_scatter_anisotropy]);
    const Vec3 color = scene::mean_color(scene, material[shared::PARAMETER_subsurface_color]);
    Vec3 length;
    for (int c = 0; c < 3; ++c) {
        const double A = color[c];
        const double fit = 4.09712 + 4.20863 * A - std::sqrt(9.59217 + 41.6808 * A + 17.7126 * A * A);
        const double s = material.inversion == shared::INVERSION_NONE ? std::sqrt((1 - A) / (1 - A * g[c]))
                                                                      : std::max(0., fit); // -5e-6 in white
        length[c] = radius[c] * scale[c] * (1 - g[c] * s * s) / ((1 - g[c]) * std::sqrt(3.) * s);
    }
    return length;
}

} // namespace nacre::render
