// A path on its way, as it is kept between launches, and what a launch is asked to do.
#ifndef NACRE_SHARED_PATH_H
#define NACRE_SHARED_PATH_H

#include "shared/types.h"

SHARED_BEGIN

// probe: below a surface with a diffusion model.
enum PathState { PATH_RAY, PATH_WALK, PATH_PROBE, PATH_DONE };

// The control variate of a path's first walk (walk/twin.h): none, out, in its half-space, and, TWIN_SLAB + i, in slab i.
enum Twin { TWIN_NONE, TWIN_OUT, TWIN_INSIDE, TWIN_SLAB };

struct Path {
    float4 position;   // start of the next ray or flight
    float4 direction;  // of it; w: density with which the BSDF chose it, < 0: lights were not sampled for it
    float4 throughput;
    float4 radiance;   // so far; w: alpha
    float4 weight;     // walk: W_c, throughput of each channel over `throughput`, which is then the largest at the entry
    float4 share;      // walk: P_c, probability of each channel as the one that draws the flight
    float4 sigma;      // walk: extinction per channel
    float4 albedo;     // walk: single-scattering albedo per channel
    float4 anisotropy; // walk: g per channel
    float4 outward;    // ray: geometric normal where it starts; walk: the near side's normal, as its guide sees it; w: dot(normal, entry)
    float4 foreseen;   // direct light about the entry, as far as it arrives, times `throughput`
    float4 surplus;    // what a half-space returns in the mean less what the twin brought back: to add so much of `foreseen`
    float4 foreseen_across, surplus_across; // the same of a slab's other side
    float bleed;
    float first_number; // walk: the random number of its first flight
    uint slot;         // of the batch: where its radiance goes
    uint pixel, sample;
    uint vertex;       // events so far that draw numbers: hits, entries, exits
    uint state;        // PathState
    uint object, flight, max_depth, channel; // walk
    uint steps, depth; // walk: scatters so far; shells it is inside of
    uint hits;         // surfaces its rays have met
    float thickness;   // walk: from the near to the far side
    float far_light;   // walk: light on the far side over that on the near side
    uint tries;        // walk: directions that its guide has tried
    uint scatters;     // walk: those before it was last turned back at the surface
    uint key;          // of its random numbers: from seed, pixel and half
    uint twin;         // Twin
};

// One launch: `pixel_count` pixels from `first_pixel` on (in tile order), samples [first_sample, first_sample + sample_count) each.
struct Batch {
    uint first_pixel, pixel_count, first_sample, sample_count;
    uint resumed;  // paths to go on with instead of new ones
    uint capacity; // paths that can be suspended
    uint budget;   // steps that paths may take before they are suspended: each of its own, or a worker's after the last new path
    uint pad;
};

SHARED_END

#ifdef __OPENCL_C_VERSION__
typedef struct Path Path;
typedef struct Batch Batch;

// Where a path is while it is on its way: in its worker's pool, or in its work-item's own memory. It is changed in place: to copy
// it out and back took 3 to 7 % of a walk's time.
#if defined(LANES) && LANES > 1
#define PATH_SPACE global
#else
#define PATH_SPACE private
#endif
#endif

// Pixels are visited in tiles of TILE x TILE, so that neighbouring work-items see neighbouring geometry.
#define TILE 8

// Paths that a worker (a work-item of LANES > 1) has under way at a time. They stay in its second-level cache.
#define POOL_PATHS 256

// What a path keeps for the layers of its first surface and of its first walk, in float4: film/layers.h.
#define LAYERS_SURFACE 2u
#define LAYERS_SCATTER 1u

// Planes of the film: sums over the samples of one block, float4 each. Behind those that are always there come, where they are
// asked for, those of the first surface (albedo and depth, normal), then those of the first walk (light that scattered never
// and the number of walks, once and the number of scatters, more often).
#define FILM_RADIANCE 0 // rgb, alpha
#define FILM_SQUARE 1   // squares of rgb; with -DTILE_LIST, about how long the samples took
#define FILM_REST 2     // what the sums of rgb and alpha have lost by rounding
#define FILM_PLANES 3
#define FILM_SURFACE_PLANES 2
#define FILM_SCATTER_PLANES 3

// Samples are added up in float within aligned blocks of this many, keeping what is rounded off, the blocks in double on the
// host.
#define FILM_BLOCK 64

// A program with -DTILE_LIST (adaptive renders) takes its pixels from a list of tiles, TILE x TILE for each entry; its film is in
// the list's order. This bit of an entry says that its samples are of the second half: that is samples SECOND_HALF and on, whose
// numbers are independent of those of samples 0 and on. Its film has what the samples cost beside their squares: FILM_SQUARE.
#define SECOND_HALF 0x80000000u
#define LIST_COST 2.0f            // the unit in a path's alpha
#define LIST_EVENT_COST 4u        // a surface's, with its rays, against one flight of a walk
#define LIST_MOST_COST (1u << 20) // floats hold it and alpha

// Only with -DTILE_LIST; as PROFILED, shared/counters.h.
#ifdef TILE_LIST
#define LISTED(tokens) tokens
#define AND_LISTED(argument) , argument
#else
#define LISTED(tokens)
#define AND_LISTED(argument)
#endif

#endif
