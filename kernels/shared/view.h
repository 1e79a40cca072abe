// A scene as kernels see it: the pointers of the kernel's arguments in one private struct. Host code does not include this.
#ifndef NACRE_SHARED_VIEW_H
#define NACRE_SHARED_VIEW_H

#include "shared/bvh.h"
#include "shared/counters.h"
#include "shared/features.h"
#include "shared/guide.h"
#include "shared/path.h"
#include "shared/returned.h"
#include "shared/scene.h"

// No contraction: the compiler may not fuse a * b + c as it likes, so every variant does the same arithmetic.
#pragma OPENCL FP_CONTRACT OFF

#ifndef FEATURES
#define FEATURES 0xffffffffu
#endif
#ifndef WORK_GROUP
#define WORK_GROUP 1
#endif

typedef struct {
    global const Frame *frame;
    global const float *nodes;          // BVH, shared/bvh.h
    global const float *blocks;
    global const Object *objects;
    global const uint *triangles;       // 3 vertices per primitive, where they have normals or uvs
    global const float *normals;        // 3 per vertex
    global const float *uvs;            // 2 per vertex
    global const Material *materials;
    global const Texture *textures;
    global const half *texels;
    global const Light *lights;
    global const AliasEntry *light_table;
    global const AliasEntry *environment_table;
    global const float4 *environment;   // rgb and share of the light, per texel
    global const uint *clearance;       // fields of the objects, four cells per word: shared/clearance.h
    global const GuideMode *modes;      // of the materials
    global const float *similarities;   // of the materials: shared/inversion.h
    global const float *returned;       // of the materials: shared/returned.h
    global const LightSides *sides;     // of the objects
    global const float *thickness;      // below each primitive
    global const Slab *slabs;           // of the objects that are plates
    global const float *transmitted;    // of the slabs: shared/returned.h
} Scene;

#define SCENE_PARAMETERS                                                                                               \
    global const Frame *frame, global const float *nodes, global const float *blocks, global const Object *objects,   \
        global const uint *triangles, global const float *normals, global const float *uvs,                          \
        global const Material *materials, global const Texture *textures, global const half *texels,                  \
        global const Light *lights, global const AliasEntry *light_table, global const AliasEntry *environment_table, \
        global const float4 *environment, global const uint *clearance, global const GuideMode *modes, \
        global const float *similarities, global const float *returned, global const LightSides *sides, global const float *thickness, \
        global const Slab *slabs, global const float *transmitted

#define SCENE_ARGUMENTS                                                                                                \
    frame, nodes, blocks, objects, triangles, normals, uvs, materials, textures, texels, lights, light_table,         \
        environment_table, environment, clearance, modes, similarities, returned, sides, thickness, slabs, transmitted

// HAS(x): does this scene need x? Known at compile time, or with --generic asked of the scene at run time.
#ifdef GENERIC
#define HAS(feature) ((scene->frame->features & FEATURE_##feature) != 0u)
#else
#define HAS(feature) (((FEATURES) & FEATURE_##feature) != 0u)
#endif

#define PI 3.14159265358979f
#define INV_PI 0.318309886183791f

#endif
