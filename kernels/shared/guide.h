// What guides walks towards the surface: the slowest decaying mode of light deep in a medium, psi = phi(mu) exp(-depth / nu), for
// a table of media. mu is the cosine towards the surface, lengths are in mean free paths.
#ifndef NACRE_SHARED_GUIDE_H
#define NACRE_SHARED_GUIDE_H

#include "shared/types.h"

// phi as a sum of Legendre polynomials. A phase function takes P_l to g^l P_l, so that the mean of phi over the directions
// after a scatter is a sum of as many: techniques are normalised exactly, whatever the sum leaves out of the true phi.
#define GUIDE_TERMS 8

// Media of one phase function, by quarter powers of (1 - albedo) / (1 - albedo g): fine where media are bright.
#define GUIDE_ALBEDOS 64
// Media of any phase function, for textures of the anisotropy: this many of each side of 0.
#define GUIDE_ANISOTROPIES 8
#define GUIDE_LARGEST_ANISOTROPY 0.98f

// Share of the guided techniques; the rest is classical, which bounds a step's weight by 1 / (1 - share). Measured in half-spaces
// and slabs: .95 is no better, .8 worse by 5 to 8 % in variance, .7 by 20. Where a surface bends within a few hundred light
// paths some walks leave where their slab has none, with weights that multiply: the memo's head in matte skin (g .8) has 20 %
// less variance at .75, balls 5 % less (g .8) to 10 % more (g 0).
#ifndef GUIDE_SHARE
#define GUIDE_SHARE 0.9f
#endif
#define GUIDE_SHARE_CURVED 0.75f

SHARED_BEGIN

enum Guiding { GUIDING_NONE, GUIDING_DWIVEDI, GUIDING_EIGEN };

struct GuideMode {
    float phi[GUIDE_TERMS]; // factors of P_0, P_1, ...
    float peak;             // largest phi
    float inverse_nu;
    float spread;           // log((nu + 1) / (nu - 1))
    float pad[5];           // to a cache line
};

// Light on the surfaces of one object that face +x, +y, +z and -x, -y, -z, relative to each other.
struct LightSides {
    float4 upper, lower;
    uint first_slab, slab_count; // those its twins may be in (shared/returned.h), by thickness
    uint lit_in_sight; // whether the camera sees enough of its light for control variates of its near side
    uint pad;
};

SHARED_END

// Rays that measure an object begin so far off its surface; one whose far side they do not find is this thick.
#define GUIDE_PROBE_START 1e-5f
#define GUIDE_THICK 1e9f

// A side is never taken to have less than this of the other one's light: the estimate is a coarse one.
#define GUIDE_LEAST_LIGHT 0.05f

// What comes from one side over what comes from the other from which on a control variate takes it for all.
#define CONTROL_MOST_LIGHT 10.0f

#ifdef __OPENCL_C_VERSION__
typedef struct GuideMode GuideMode;
typedef struct LightSides LightSides;
#endif

#endif
