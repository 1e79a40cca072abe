#include "io/polygon.h"

namespace nacre::io {

namespace {

// Newell's normal: twice the area of the polygon as a vector, right for concave ones too.
Vec3 newell(const scene::Mesh &mesh, std::span<const std::uint32_t> corners) {
    Vec3 sum = Vec3::Zero();
    const Vec3 &origin = mesh.positions[corners[0]]; // a far offset would cost digits
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 a = mesh.positions[corners[i]] - origin;
        const Vec3 b = mesh.positions[corners[(i + 1) % corners.size()]] - origin;
        sum += a.cross(b);
    }
    return sum;
}

bool sees_all(const scene::Mesh &mesh, std::span<const std::uint32_t> corners, std::size_t apex, const Vec3 &normal) {
    const std::size_t count = corners.size();
    const auto position = [&](std::size_t i) -> const Vec3 & { return mesh.positions[corners[(apex + i) % count]]; };
    for (std::size_t i = 1; i + 1 < count; ++i)
        if ((position(i) - position(0)).cross(position(i + 1) - position(0)).dot(normal) < 0) return false;
    return true;
}

} // namespace

void add_polygon(scene::Mesh &mesh, std::span<const std::uint32_t> corners) {
    const std::size_t count = corners.size();
    std::size_t apex = 0;
    constexpr std::size_t largest = 256; // the search is quadratic
    if (count > 3 && count <= largest) {
        const Vec3 normal = newell(mesh, corners);
        while (apex < count && !sees_all(mesh, corners, apex, normal)) ++apex;
        if (apex == count) apex = 0;
    }
    for (std::size_t i = 1; i + 1 < count; ++i)
        mesh.triangles.push_back({corners[apex], corners[(apex + i) % count], corners[(apex + i + 1) % count]});
}

} // namespace nacre::io
