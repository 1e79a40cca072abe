// Tables of what a half-space returns of light that scatters at a depth below its surface: the logarithm of the share, by the
// medium's similarity s = sqrt((1 - albedo) / (1 - g albedo)), the depth and the cosine with which the light came, towards the
// surface. Between nodes kernels interpolate linearly: nodes are shifted a little so that errors (1e-4) have no mean.
#ifndef NACRE_SHARED_RETURNED_H
#define NACRE_SHARED_RETURNED_H

#define RETURNED_SIMILARITIES 64 // 0 .. 1; a table has those that its material needs
#define RETURNED_DEPTHS 48       // RETURNED_DEEPEST (i / (RETURNED_DEPTHS - 1))^4; farther down the share falls exponentially
#define RETURNED_DEEPEST 60.0f   // transport mean free paths
#define RETURNED_COSINES 33      // -1 .. 1; one where all media scatter isotropically, for which the cosine does not matter

#endif
