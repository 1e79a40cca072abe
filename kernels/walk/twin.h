// A control variate for walks. What a half-space of a medium returns is known: the colour that its albedo was found for. So a
// walk has a twin, which makes the same flights in the half-space below the plane of the entry, where no mesh is. With the direct
// light L about both points, whose numbers are not the walk's,
//     W L(exit) + (R - C) L(entry)
// has the mean of W L(exit): W and C are the weights with which walk and twin leave (0: roulette), R is the mean of C. Of a plate
// the twin is in a slab, and has a weight, its mean and light for either side. One whose walk leaves before it does scatters at the
// end of that flight, and of what it brings back from there C takes the mean, which is known, too (walk/returned.h). Where the
// surface is flat to the walk W and C are one, L takes the same numbers at both points, and what is left is the noise of a surface
// that scatters light where it arrives. (Control variates: Hammersley & Handscomb 1964, Monte Carlo Methods, 5.5.) The light that
// exits see of other surfaces has no part in it.
#ifndef NACRE_WALK_TWIN_H
#define NACRE_WALK_TWIN_H

#include "walk/walk.h"

typedef struct {
    mask inside;    // the walk has a twin, still in its half-space or slab
    real thickness; // of its slab; GUIDE_THICK: a half-space
    real drawn;     // length of the flight if nothing is in its way
    // Of this turn:
    real3 left;            // weight with which a twin left
    mask across;           // through the far side
    real3 position;        // where one scatters that is left behind,
    real3 weight;          // and with which weight
} TwinLanes;

// Lets the twins of the lanes `flown` out that reach their plane, or the far one, before their walks arrive. Returns those that
// leave.
uint twins_leave(const Scene *scene, TwinLanes *twin, const Walk *walk, const GuideLanes *guide, uint flown) {
    const real rise = dot3(guide->outward, walk->direction), depth = guide->offset - dot3(guide->outward, walk->position);
    const mask outwards = rise > 0.0f;
    const real speed = HAS(SLABS) ? fabs(rise) : rise, ahead = HAS(SLABS) ? pick(outwards, depth, twin->thickness - depth) : depth;
    const mask leaves = twin->inside & (speed > 0.0f) & (ahead < twin->drawn * speed) & mask_of(flown);
    const uint left = bits(leaves);
    if (left == 0u) return 0u;
    Walk out = *walk;
    walk_arrive(scene, &out, guide, max(ahead, (real)(0.0f)) / pick(leaves, speed, (real)(1.0f)), leaves);
    twin->left = out.weight;
    twin->across = outwards == 0;
    twin->inside = pick(leaves, (mask)(0), twin->inside);
    return left;
}

// Returns those of the walks that leave their object in this turn whose twin does not: it scatters where the flight was to end.
uint twins_part(const Scene *scene, TwinLanes *twin, const Walk *walk, const GuideLanes *guide, uint leaving) {
    const uint parted = leaving & bits(twin->inside);
    if (parted == 0u) return 0u;
    Walk on = *walk;
    walk_arrive(scene, &on, guide, twin->drawn, (mask)(0));
    twin->position = on.position;
    twin->weight = on.weight;
    return parted;
}

#endif
