// LANES walks side by side, each on its own way, and their turns: one flight each.
#ifndef NACRE_WALK_TURN_H
#define NACRE_WALK_TURN_H

#include "geometry/stream.h"
#include "path/count.h"
#include "random/sampler.h"
#include "walk/boundary.h"
#include "walk/clearance.h"
#include "walk/walk.h"

// How often the part of a flight that must be traced is narrowed.
#ifndef CLEARANCE_ROUNDS
#define CLEARANCE_ROUNDS 2u
#endif

typedef struct {
    Walk walk;
    ClearanceLanes field;         // of each walk's object
    real clear;                   // lower bound on the distance from its position to the surface
    natural key, sample, vertex;  // its Sampler
    natural root;                 // of its object's tree
    natural depth;                // shells it is inside of
    natural max_depth;            // scatters it may have, 0: no cap
    natural path;                 // where the rest of its path is kept
} WalkLanes;

// Lanes, as bits, that are no longer under way after a turn.
typedef struct {
    uint left;    // at the surface; the stream holds ray and hit
    uint slipped; // out of the scene without meeting the surface; they are as they were before the flight
    uint ended;   // by roulette, or not finite
    uint capped;  // by max_depth
} TurnEnds;

real clearance_along(const Scene *scene, const WalkLanes *lanes, real t) {
    const Walk *walk = &lanes->walk;
    return clearance_at(scene->clearance, &lanes->field, fma(walk->direction.x, t, walk->position.x),
                        fma(walk->direction.y, t, walk->position.y), fma(walk->direction.z, t, walk->position.z));
}

// Narrows [*near, *far], the part of a flight that is not known to be clear, from both ends: what a ball about an end reaches
// is clear, and so is what one about the new end reaches. Returns the lanes of `flying` that have a part left.
uint turn_narrow(const Scene *scene, const WalkLanes *lanes, uint flying, real *near, real *far) {
    for (uint k = 0u; k < CLEARANCE_ROUNDS; k++) {
        flying &= bits(*near < *far);
        if (flying == 0u) return 0u;
        *near += clearance_along(scene, lanes, *near);
        *far -= clearance_along(scene, lanes, *far);
    }
    return flying & bits(*near < *far);
}

// The rays of a turn: from a little before the start of a flight to a little beyond its end, so that neither a scatter nor the
// next flight is outside by rounding; of that what lies between `near` and `far`.
void turn_rays(const WalkLanes *lanes, real near, real far, real rounding, RayStream *stream) {
    const Walk *walk = &lanes->walk;
    STREAM_ROW(stream->origin_x) = walk->position.x - rounding * walk->direction.x;
    STREAM_ROW(stream->origin_y) = walk->position.y - rounding * walk->direction.y;
    STREAM_ROW(stream->origin_z) = walk->position.z - rounding * walk->direction.z;
    STREAM_ROW(stream->direction_x) = walk->direction.x;
    STREAM_ROW(stream->direction_y) = walk->direction.y;
    STREAM_ROW(stream->direction_z) = walk->direction.z;
    STREAM_ROW(stream->t_min) = near;
    STREAM_ROW(stream->t) = far + 2.0f * rounding;
    STREAM_ROW_UINT(stream->root) = lanes->root;
}

// Traces the flights of the lanes in `flying`. Returns those that leave; `*distance` is then how far they came.
uint turn_trace(const Scene *scene, WalkLanes *lanes, real rounding, RayStream *stream, uint flying, real *distance,
                Counts *counts) {
    const real t_max = STREAM_ROW(stream->t);
    uint left = 0u;
    while (flying != 0u) {
        counts->value[COUNTER_walk_rays] += popcount(flying);
        trace_stream(stream, flying, scene->nodes, scene->blocks, false);
        uint onward = 0u;
        FOR_LANES(l, flying) {
            const Hit hit = stream_hit(stream, scene->blocks, l);
            if (hit.block == BVH_NO_PRIMITIVE) continue;
            const float3 direction = (float3)(stream->direction_x[l], stream->direction_y[l], stream->direction_z[l]);
            uint depth = LANE_UINT(lanes->depth, l);
            if (boundary_leaves(scene, hit, direction, LANE_FLOAT(rounding, l), &depth)) {
                left |= 1u << l;
                LANE_FLOAT(*distance, l) = fmax(0.0f, hit.t - LANE_FLOAT(rounding, l));
            } else { // on, beyond the shell
                onward |= 1u << l;
                stream->t_min[l] = hit.t;
                stream->t[l] = LANE_FLOAT(t_max, l);
            }
            LANE_UINT(lanes->depth, l) = depth;
        }
        flying = onward;
    }
    return left;
}

// One flight of every lane in `active`; the others may hold anything.
TurnEnds walk_turn(const Scene *scene, WalkLanes *lanes, RayStream *stream, uint active, Counts *counts) {
    Walk *walk = &lanes->walk;
    const float radius = scene->frame->scene_radius;
    const float beyond = 4.0f * radius;             // longer than any way through the scene
    const float outside2 = 1.01f * radius * radius; // no object reaches there
    const Natural4 words = lane_draw(lanes->key, lanes->sample, lanes->vertex, DRAW_WALK, walk->steps);
    if (walk_chooses(scene))
        walk_choose(scene, walk, lane_unit(lane_draw(lanes->key, lanes->sample, lanes->vertex, DRAW_WALK_CHANNEL, walk->steps).x));
    const real number = pick(walk->steps == 0u, walk->first_number, lane_unit(words.x));
    const real length = min(walk_distance(scene, walk, number), (real)(beyond));
    const real rounding =
        POSITION_ROUNDING * max(fabs(walk->position.x), max(fabs(walk->position.y), fabs(walk->position.z)));

    uint flying = active;
    real near = (real)(0.0f), far = length, clear_end = near;
    if (HAS(CLEARANCE)) {
        clear_end = clearance_along(scene, lanes, length);
        near = lanes->clear;
        far = length - clear_end;
        flying = turn_narrow(scene, lanes, flying, &near, &far);
    }
    real distance = length;
    TurnEnds ends;
    ends.left = 0u;
    if (flying != 0u) {
        turn_rays(lanes, near, far, rounding, stream);
        ends.left = turn_trace(scene, lanes, rounding, stream, flying, &distance, counts);
    }
    const real from_centre2 = fma(walk->position.x, walk->position.x,
                                  fma(walk->position.y, walk->position.y, walk->position.z * walk->position.z));
    ends.slipped = bits((length >= beyond) | (from_centre2 > outside2)) & active & ~ends.left;
    Walk before;
    if (ends.slipped != 0u) before = *walk;

    const mask left = mask_of(ends.left);
    walk_arrive(scene, walk, distance, left, lane_unit(words.y), lane_unit(words.z));
    lanes->clear = clear_end;
    const mask survives = walk_roulette(walk, lane_unit(words.w), left);
    const mask capped = (lanes->max_depth != 0u) & (walk->steps >= lanes->max_depth);
    const uint under_way = active & ~ends.left & ~ends.slipped;
    ends.ended = under_way & ~bits(survives);
    ends.capped = under_way & ~ends.ended & bits(capped);
    if (ends.slipped != 0u) {
        const mask slipped = mask_of(ends.slipped);
        walk->position = pick3(slipped, before.position, walk->position);
        walk->direction = pick3(slipped, before.direction, walk->direction);
        walk->weight = pick3(slipped, before.weight, walk->weight);
    }
    counts->value[COUNTER_steps] += popcount(active);
    return ends;
}

#endif
