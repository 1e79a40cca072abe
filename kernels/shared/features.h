// What a scene may need. `scene::features` turns a scene into a mask of these, the mask becomes one -D, and rooms ask
// HAS(x). Few on purpose: every bit doubles the programs that may have to be compiled.
#ifndef NACRE_SHARED_FEATURES_H
#define NACRE_SHARED_FEATURES_H

#include "shared/types.h"

#define FEATURE_LIST(X)                                                                                                \
    X(SUBSURFACE)        /* a material with subsurface_weight > 0 */                                                   \
    X(DIFFUSE)           /* a material with subsurface_weight < 1 and metalness < 1 */                                 \
    X(SPECULAR)          /* a material with specular_weight > 0 or metalness > 0 */                                    \
    X(EMISSION)          /* a mesh that emits */                                                                       \
    X(BLEED)             /* Davis-Xu flights: bleed > 0 somewhere */                                                   \
    X(ANISOTROPY)        /* Henyey-Greenstein with g != 0 somewhere */                                                 \
    X(ANISOTROPY_RGB)    /* g differs between the channels somewhere */                                                \
    X(GUIDE_EIGEN)       /* walks follow their medium's slowest mode */                                                \
    X(GUIDE_DWIVEDI)     /* walks are guided as in the memo */                                                         \
    X(SMOOTH)            /* vertex normals */                                                                          \
    X(TEXTURES)          /* a material parameter is an image; brings texture coordinates */                            \
    X(NORMAL_MAP)        /* a material has geometry_normal */                                                          \
    X(ENVIRONMENT)       /* environment of constant radiance */                                                        \
    X(ENVIRONMENT_IMAGE) /* environment image */                                                                       \
    X(RECT)              /* rect lights */                                                                             \
    X(DELTA_LIGHT)       /* point or directional lights */                                                             \
    X(LENS)              /* camera aperture > 0 */                                                                     \
    X(SURFACE_AOV)       /* layers albedo, N, depth */                                                                  \
    X(CLEARANCE)         /* an object has a clearance field */                                                         \
    X(SCATTER_AOV)       /* layers of scattering orders, walk.steps */                                                 \
    X(INTERFACE)         /* refracted entry, or reflection inside, somewhere */                                              \
    X(DIFFUSION_MODEL)   /* a material with a subsurface_model other than random_walk */                               \
    X(ALBEDO_TABLE)      /* a material whose albedo follows a texture of colours, g or bleed */                        \
    X(CONTROL)           /* walks in some object have a control variate */                                             \
    X(SLABS)             /* in some a plate's, of both its sides; brings CONTROL */

SHARED_BEGIN

enum FeatureIndex {
#define FEATURE_INDEX(name) FEATURE_INDEX_##name,
    FEATURE_LIST(FEATURE_INDEX)
#undef FEATURE_INDEX
    FEATURE_COUNT
};

enum Feature {
#define FEATURE_BIT(name) FEATURE_##name = 1 << FEATURE_INDEX_##name,
    FEATURE_LIST(FEATURE_BIT)
#undef FEATURE_BIT
    FEATURE_ALL = (1 << FEATURE_COUNT) - 1
};

SHARED_END

#endif
