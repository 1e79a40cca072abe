#pragma once
#include "base/vector.h"
#include "scene/mesh.h"
#include "shared/guide.h"
#include "shared/scene.h"
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace nacre::scene {

/// Pixels of a material texture, ready for upload: linear half floats, row 0 is the top of the picture.
struct Image {
    std::string name;                                  // file, for messages
    std::uint32_t width = 0, height = 0, channels = 0; // channels 1 or 4
    std::vector<std::uint16_t> halves;                 // width * height * channels
};

/// Where and how a material reads an image.
struct Texture {
    std::uint32_t image = 0; // index in Scene::images
    int channel = -1;        // the channel that is the number, -1: all (a colour, a normal)
    Vec2 scale{1, 1}, offset{0, 0};
};

/// A number or a colour (a number is repeated in all three), replaced by a texture where there is one.
/// In Scene::textures; -1: none.
struct Value {
    Vec3 value{0, 0, 0};
    int texture = -1;
};

struct Material {
    std::string name;
    std::array<Value, shared::PARAMETER_COUNT> values; // by shared::Parameter; OpenPBR's defaults
    shared::FlightLaw flight = shared::FLIGHT_RENEWAL;
    shared::Inversion inversion = shared::INVERSION_TABLE;
    shared::Entry entry = shared::ENTRY_LAMBERT;
    shared::SubsurfaceModel model = shared::MODEL_RANDOM_WALK;
    std::uint32_t max_depth = 0;      // scatters a walk may have, 0: no cap
    bool internal_reflection = false; // walks may be turned back at the surface

    Material();
    Value &operator[](shared::Parameter p) { return values[p]; }
    const Value &operator[](shared::Parameter p) const { return values[p]; }
};

/// Light may go below the surface of this material somewhere.
bool scatters_below(const Material &material);

/// It does so in random walks.
bool walks_below(const Material &material);

/// Its single-scattering albedo comes from its colour, and is not the same everywhere.
bool inverts_texture(const Material &material);

struct Object {
    std::string name; // for messages: file or shape, and its place in the scene
    Mesh mesh;        // world space
    std::uint32_t material = 0;
    std::size_t degenerate = 0; // triangles dropped at load
};

struct Light {
    shared::LightKind kind = shared::LIGHT_ENVIRONMENT;
    Vec3 radiance{1, 1, 1};      // radiance, or intensity (point), or irradiance (directional); scale of an image
    Vec3 position{0, 0, 0};      // centre of a rect, the point
    Vec3 u{1, 0, 0}, v{0, 0, 1}; // whole edges of a rect
    Vec3 direction{0, -1, 0};    // directional: where the light goes, unit
    double rotate = 0;           // environment image, degrees counter-clockwise about +y
    bool visible = false;        // the camera sees it (environments: true by default)
    std::string image_name;
    std::uint32_t width = 0, height = 0; // environment image, row 0 at +y
    std::vector<float> pixels;           // rgb, linear
};

struct Camera {
    shared::CameraKind kind = shared::CAMERA_PERSPECTIVE;
    Vec3 position{0, 0, 4}, target{0, 0, 0}, up{0, 1, 0};
    double fov = 35;           // vertical, degrees
    double height = 2;         // orthographic: scene units
    double aperture = 0;       // diameter of the lens, scene units
    double focus_distance = 0; // 0: the distance to the target
};

struct ImageSettings {
    int width = 512, height = 512;
};

struct RenderSettings {
    std::uint32_t spp = 64;
    std::uint32_t seed = 0;
    std::uint32_t max_depth = 8; // surface hits, 0: no limit but roulette
    shared::ChannelSampling channel_sampling = shared::CHANNEL_HERO;
    shared::Guiding guiding = shared::GUIDING_EIGEN;
    bool clearance = true; // build clearance fields where they pay
    bool control = true;   // walks have a control variate where that pays
    double exposure = 0;   // stops, PNG only
};

struct Scene {
    std::string file;
    Camera camera;
    ImageSettings image;
    RenderSettings render;
    std::vector<Material> materials;
    std::vector<Object> objects;
    std::vector<Light> lights;
    std::vector<Image> images;
    std::vector<Texture> textures;
    std::vector<std::string> warnings; // what was read and is not used, and why
    int lanes = 0;                     // device.lanes, 0: automatic
};

} // namespace nacre::scene
