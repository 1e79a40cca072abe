// Tables of what a half-space returns of light that scatters at a depth below its surface: the logarithm of the share, by the
// medium's similarity s = sqrt((1 - albedo) / (1 - g albedo)), the depth and the cosine with which the light came, towards the
// surface. Between nodes kernels interpolate linearly: nodes are shifted a little so that errors (1e-4) have no mean.
#ifndef NACRE_SHARED_RETURNED_H
#define NACRE_SHARED_RETURNED_H

#include "shared/types.h"

#define RETURNED_SIMILARITIES 64 // 0 .. 1; a table has those that its material needs
#define RETURNED_DEPTHS 48       // RETURNED_DEEPEST (i / (RETURNED_DEPTHS - 1))^4; farther down the share falls exponentially
#define RETURNED_DEEPEST 60.0f   // transport mean free paths
#define RETURNED_COSINES 33      // -1 .. 1; one where all media scatter isotropically, for which the cosine does not matter

// The same of a slab, of what leaves through one side, by the depth below that side over the thickness: .5 (2 x)^2 in the upper half,
// as many nodes in the lower one. Two rows more hold what of light that enters on that side comes back, and what gets through.
#define RETURNED_SLAB_DEPTHS 32
#define RETURNED_SLAB_ROWS (RETURNED_SLAB_DEPTHS + 2)

SHARED_BEGIN

// One that twins may take an object for.
struct Slab {
    float thickness;
    float through; // what gets through over what comes back
    int first[3];  // of its tables, per channel, as if from similarity 0 on
    int pad[3];
};

SHARED_END

#ifdef __OPENCL_C_VERSION__
typedef struct Slab Slab;
#endif

#endif
