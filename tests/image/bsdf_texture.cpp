// Textures where a camera sees them: exact colours at the texels' centres, between them, and under scale and offset.
#include "image/light_scene.h"
#include <Imath/half.h>
#include <gtest/gtest.h>

namespace nacre {
namespace {

using namespace shared;

/// Colours of a 4 x 4 picture, row 0 its top. Exact in half floats.
Vec3 texel(int x, int y) { return {(x + 1) / 8., (y + 1) / 8., ((x * 3 + y * 5) % 7 + 1) / 16.}; }

/// A quad that is a picture of 4 x 4 texels, seen from above, u to the right and v up, in white light.
scene::Scene textured(Parameter parameter, Vec3 color(int x, int y)) {
    scene::Scene scene = floor_scene();
    scene.objects[0].mesh = quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
    scene::Image image{"picture", 4, 4, 4, {}};
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) {
            for (int c = 0; c < 3; ++c) image.halves.push_back(Imath::half(float(color(x, y)[c])).bits());
            image.halves.push_back(Imath::half(1.0f).bits());
        }
    scene.images = {image};
    scene.textures = {{0, -1, {1, 1}, {0, 0}}};
    scene.materials[0][parameter].texture = 0;
    scene.lights = {constant_sky({1, 1, 1})};
    scene.camera.up = {0, 0, -1};
    return scene;
}

/// What is seen straight down at texture coordinates u, v.
Vec3 seen(scene::Scene scene, double u, double v) {
    scene.camera.target = {2 * u - 1, 0, 1 - 2 * v};
    scene.camera.position = scene.camera.target + Vec3(0, 2, 0);
    return shoot(scene, 1).mean;
}

TEST(BsdfTexture, CentresOfTexels) {
    const scene::Scene scene = textured(PARAMETER_base_color, texel);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            EXPECT_LE((seen(scene, (x + .5) / 4, 1 - (y + .5) / 4) - texel(x, y)).norm(), 1e-5) << x << " " << y;
}

TEST(BsdfTexture, BilinearBetweenThemAndRoundTheEdge) {
    const scene::Scene scene = textured(PARAMETER_base_color, texel);
    const Vec3 middle = (texel(1, 1) + texel(2, 1) + texel(1, 2) + texel(2, 2)) / 4;
    EXPECT_LE((seen(scene, .5, .5) - middle).norm(), 1e-5);
    const Vec3 quarter = .75 * texel(1, 3) + .25 * texel(2, 3);
    EXPECT_LE((seen(scene, 1.75 / 4, .125) - quarter).norm(), 1e-5);
    const Vec3 edge = .75 * texel(3, 0) + .25 * texel(0, 0); // repeated: texel 0 is to the right of 3
    EXPECT_LE((seen(scene, 3.75 / 4, .875) - edge).norm(), 1e-5);
}

TEST(BsdfTexture, ScaleAndOffset) {
    scene::Scene scene = textured(PARAMETER_base_color, texel);
    scene.textures[0].scale = {2, 4};
    scene.textures[0].offset = {.25, -.5};
    for (const Vec2 &uv : {Vec2(.0625, .28125), Vec2(.6875, .90625), Vec2(.3125, .03125)}) {
        const double u = uv.x() * 2 + .25, v = uv.y() * 4 - .5;
        const int x = int((u - std::floor(u)) * 4), y = int((1 - v - std::floor(1 - v)) * 4);
        EXPECT_LE((seen(scene, uv.x(), uv.y()) - texel(x, y)).norm(), 1e-5) << uv.transpose();
    }
}

// One channel of a picture as a number: a checkerboard of metal and white.
TEST(BsdfTexture, ChannelAsANumber) {
    scene::Scene scene = textured(PARAMETER_base_metalness, [](int x, int y) -> Vec3 {
        return {0, (x + y) % 2 * 1., .5};
    });
    scene.textures[0].channel = 1;
    scene.materials[0][PARAMETER_base_color].value = {1, .5, .25};
    scene.materials[0][PARAMETER_specular_roughness].value = Vec3::Zero();
    scene.lights = {directional_light({0, -1, 0.5}, {3.14159265, 3.14159265, 3.14159265})};
    // A polished metal does not scatter a single direction to the camera, a diffuse base does.
    const double cosine = 1 / std::sqrt(1.25);
    EXPECT_LE(seen(scene, .375, .875).norm(), 1e-3) << "metal";
    EXPECT_LE((seen(scene, .125, .875) - Vec3(1, .5, .25) * cosine).norm(), 1e-3) << "diffuse";
}

/// Bends light: a floor whose normal map holds `n`, in light from one direction.
Shot bent(const Vec3 &n, const Vec3 &light, bool mapped = true) {
    static Vec3 encoded;
    encoded = (n.normalized() + Vec3(1, 1, 1)) / 2;
    scene::Scene scene = textured(PARAMETER_geometry_normal, [](int, int) -> Vec3 { return encoded; });
    if (!mapped) scene.materials[0][PARAMETER_geometry_normal].texture = -1;
    scene.lights = {directional_light(-light, Vec3::Constant(3.14159265))};
    scene.camera.position = {0, 3, 0};
    return shoot(scene, 4);
}

TEST(BsdfNormalMap, FlatIsNone) {
    const Vec3 light(.3, 1, .2);
    expect_shot(bent({0, 0, 1}, light), bent({0, 0, 1}, light, false).mean, 1e-6, 1e-6, "flat");
}

// x of the map is along u (+x here), y along v (-z here), z along the normal (+y).
TEST(BsdfNormalMap, TangentFrameFollowsTheTextureCoordinates) {
    for (const Vec3 &n : {Vec3(.5, 0, 1), Vec3(0, .5, 1), Vec3(-.3, -.4, 1)}) {
        const Vec3 world = Vec3(n.x(), n.z(), -n.y()).normalized(), light = Vec3(.2, 1, -.1).normalized();
        // Directions that the lobe about this normal has below the floor are mirrored at it, and come in from below.
        const Vec3 mirrored(light.x(), -light.y(), light.z());
        const double cosine = std::max(0., world.dot(light)) + std::max(0., world.dot(mirrored));
        // A normal of halves is good to 3 digits.
        expect_shot(bent(n, light), Vec3::Constant(cosine), 1e-5, 1e-3, "normal");
    }
}

} // namespace
} // namespace nacre
