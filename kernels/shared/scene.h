// Everything the host tells a kernel about a scene. Lengths are in units of the scene's size, around its centre
// (scene::normalise), radiance in units of Frame.light_unit: scale, offset and brightness of a scene do not matter here.
#ifndef NACRE_SHARED_SCENE_H
#define NACRE_SHARED_SCENE_H

#include "shared/clearance.h"
#include "shared/types.h"

// Parameters of a material, in OpenPBR's names. Each has a value and, where `texture` >= 0, an image that replaces it.
#define PARAMETER_LIST(X)                                                                                              \
    X(base_color)                                                                                                      \
    X(base_metalness)                                                                                                  \
    X(specular_weight)                                                                                                 \
    X(specular_roughness)                                                                                              \
    X(specular_ior)                                                                                                    \
    X(emission_luminance)                                                                                              \
    X(emission_color)                                                                                                  \
    X(subsurface_weight)                                                                                               \
    X(subsurface_color)                                                                                                \
    X(subsurface_radius)                                                                                               \
    X(subsurface_radius_scale)                                                                                         \
    X(subsurface_scatter_anisotropy)                                                                                   \
    X(subsurface_bleed)                                                                                                \
    X(geometry_normal)

SHARED_BEGIN

enum Parameter {
#define PARAMETER_ENUM(name) PARAMETER_##name,
    PARAMETER_LIST(PARAMETER_ENUM)
#undef PARAMETER_ENUM
    PARAMETER_COUNT
};

enum FlightLaw { FLIGHT_RENEWAL, FLIGHT_RECIPROCAL };
enum ChannelSampling { CHANNEL_SINGLE, CHANNEL_ALBEDO, CHANNEL_THROUGHPUT, CHANNEL_HERO };
enum Inversion { INVERSION_TABLE, INVERSION_MEMO, INVERSION_VAN_DE_HULST, INVERSION_CHIANG, INVERSION_NONE };
enum AlbedoSource { ALBEDO_GIVEN, ALBEDO_FIXED, ALBEDO_TABLE };
enum Entry { ENTRY_LAMBERT, ENTRY_UNIFORM, ENTRY_REFRACTED };
enum SubsurfaceModel { MODEL_RANDOM_WALK, MODEL_DIPOLE, MODEL_BETTER_DIPOLE, MODEL_BURLEY };
enum LightKind { LIGHT_ENVIRONMENT, LIGHT_ENVIRONMENT_IMAGE, LIGHT_RECT, LIGHT_TRIANGLE, LIGHT_POINT, LIGHT_DIRECTIONAL };
enum CameraKind { CAMERA_PERSPECTIVE, CAMERA_ORTHOGRAPHIC };

#ifdef __OPENCL_C_VERSION__
typedef struct Camera Camera;
typedef struct Material Material;
typedef struct Texture Texture;
typedef struct Object Object;
typedef struct Light Light;
typedef struct AliasEntry AliasEntry;
typedef struct Frame Frame;
#endif

struct Camera {
    float4 position;
    float4 right, up, forward; // unit vectors, right-handed: right x up = -forward
    int kind;                  // CameraKind
    float half_width, half_height; // of the image plane: at distance 1 (perspective), in scene units (orthographic)
    float lens_radius;
    float focus_distance;
    float pad[3];
};

struct Material {
    float4 value[PARAMETER_COUNT]; // rgb, or the number in x (and y, z)
    float4 albedo;                 // of single scattering, where its source is FIXED
    int texture[PARAMETER_COUNT];  // index of a Texture, or -1
    int flight;                    // FlightLaw
    int albedo_source;             // AlbedoSource; GIVEN: subsurface_color holds it; TABLE: shared/inversion.h
    int entry;                     // Entry
    uint max_depth;                // scatters a walk may have, 0: no cap
    float radius_scale;            // of a texture of radii, to the kernels' units (value[] has it already)
    uint guide_first[3];           // its first GuideMode, per channel
    uint guide_anisotropies;       // 1: made for its anisotropy; else for any, see shared/guide.h
    int internal_reflection;       // walks may be turned back at the surface
    int model;                     // SubsurfaceModel; flight, entry, max_depth and bleed are the random walk's alone
    uint similarity_first;         // its table of similarities by colour, g and bleed: INVERSION_COLORS x ...
    uint similarity_anisotropies, similarity_bleeds; // ... or 1 where they are the same everywhere
    int returned_first[3];         // where its table of what a half-space returns begins, per channel: shared/returned.h
    uint pad;
};

// RGBA or one channel, half floats, linear, row 0 at v = 1 (the top of the picture).
struct Texture {
    uint first;    // index of the first half in the texel buffer
    uint width, height;
    uint channels; // 1 or 4
    int channel;   // the one to use as a number (glTF packs roughness in green), -1: all
    float scale_u, scale_v, offset_u, offset_v;
    float pad[3];
};

struct Object {
    uint material;
    uint walk_root;   // root of the BVH that holds this object alone (for walks)
    uint first_light; // Light of its first triangle where the material emits, else NO_LIGHT
    uint first_primitive;
    uint closed; // every edge has two triangles: a walk can only leave through the surface
    float guided; // share of the guided techniques in its walks, 0: they are classical
    float control_thickness; // where it is thicker walks have a control variate
    uint plate;    // walks may have a control variate of both its sides
    Clearance clearance; // for walks
};

// One surface that emits, an environment, or a point. Sampled with `probability`, a share of the total power.
struct Light {
    float4 radiance;   // radiance (rect, triangle, environment), intensity (point), irradiance (directional)
    float4 position;   // a corner (rect, triangle) or the point; environment image: cos and sin of its rotation in x, y
    float4 u, v;       // edges of rect and triangle; u: direction towards a directional light
    float4 normal;     // unit, the side that emits; w: area
    int kind;          // LightKind
    uint primitive;    // triangle: primitive id
    int visible;       // the camera sees it
    uint first_texel;  // environment image: first entry of its alias table and of its texels (rgb, share of the light)
    uint width, height;
    float probability;
    float pad;
};

struct AliasEntry {
    float threshold; // keep this entry if the second random number is below
    uint other;      // else take this one
};

struct Frame {
    Camera camera;
    uint width, height;       // whole image
    uint crop_x, crop_y;      // first pixel of the crop
    uint crop_width, crop_height;
    uint seed;
    uint features;            // mask of Feature: what --generic asks at run time
    uint light_count;
    uint rect_first, rect_count;               // rects are consecutive in the light buffer
    uint environment_count;                    // environments come first
    uint lone_rays;           // every sample has a camera ray of its own: walks that it sees may have a control variate
    uint bvh_root;
    uint max_depth;           // surface hits, 0: no limit
    int channel_sampling;     // ChannelSampling
    float scene_radius;       // of a sphere about the origin that holds the scene
    float emission_scale;     // emission of materials -> units of the film
    uint object_count;
};

SHARED_END

#define NO_LIGHT 0xffffffffu

#endif
