// Tables of similarities s = sqrt((1 - albedo) / (1 - g albedo)) by colour, for materials whose albedo differs from point to
// point. Between nodes kernels interpolate linearly: 1e-5 in colour. g and bleed are axes only where they are textures.
#ifndef NACRE_SHARED_INVERSION_H
#define NACRE_SHARED_INVERSION_H

#define INVERSION_COLORS 256       // colours 0 .. 1
#define INVERSION_ANISOTROPIES 64  // from the least to the largest g; beyond them similarities stay
#define INVERSION_BLEEDS 32        // bleed = largest (i / (INVERSION_BLEEDS - 1))^2
#define INVERSION_LEAST_ANISOTROPY -0.95f
#define INVERSION_LARGEST_ANISOTROPY 0.98f
#define INVERSION_LARGEST_BLEED 4.0f

#endif
