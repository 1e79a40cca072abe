// Walks side by side, each on its own way, LANES to a group, and their turns: one flight each.
#ifndef NACRE_WALK_TURN_H
#define NACRE_WALK_TURN_H

#include "geometry/stream.h"
#include "path/count.h"
#include "random/sampler.h"
#include "walk/boundary.h"
#include "walk/clearance.h"
#include "walk/twin.h"

// Groups of lanes in a turn, 64 walks together: that many have rays enough to hide each other's waiting for memory. 32 walks
// are 2 to 7 % slower.
#ifndef LANE_GROUPS
#if LANES == 1
#define LANE_GROUPS 1
#else
#define LANE_GROUPS (64 / LANES)
#endif
#endif

// A set of walks, as bits, and a loop over it.
#if LANE_GROUPS == 1
typedef uint Walks;
#define WALKS_ALL LANES_ALL
#define FOR_WALKS FOR_BITS
#else
typedef ulong Walks;
#define WALKS_ALL first_bits(LANES * LANE_GROUPS)
#define FOR_WALKS(w, set)                                                                                              \
    for (ulong rest_##w = (set), w = lowest_bit64(rest_##w); rest_##w != 0ul;                                          \
         rest_##w &= rest_##w - 1ul, w = lowest_bit64(rest_##w))
#endif

// Group g. Of one group without arithmetic on the pointer: Mesa 22.3 crashes on it.
#if LANE_GROUPS == 1
#define GROUP(groups, g) (groups)
#else
#define GROUP(groups, g) ((groups) + (g))
#endif

uint group_bits(Walks walks, uint group) { return (uint)(walks >> (group * LANES)) & LANES_ALL; }

// A loop over the groups that have walks of a set: few do when the last and longest ones are left.
#define FOR_GROUPS(g, walks)                                                                                           \
    for (uint g = 0u; g < LANE_GROUPS; g++)                                                                            \
        if (group_bits(walks, g) != 0u)

typedef struct {
    Walk walk;
    ClearanceLanes field;         // of each walk's object
    real clear;                   // lower bound on the distance from its position to the surface
    LaneSampler sampler;
    GuideLanes guide;
    TwinLanes twin;
    natural root;                 // of its object's tree
    natural depth;                // shells it is inside of
    natural max_depth;            // scatters it may have, 0: no cap
    natural path;                 // where the rest of its path is kept
    // Of this turn's flight:
    Natural4 words;               // its random numbers: DRAW_WALK
    real rounding;                // of its start
    real clear_end;               // `clear` at its end
    real distance;                // to its end, or to where it leaves
} WalkLanes;

// Walks that are no longer under way after a turn, or lanes of a group.
typedef struct {
    Walks left;    // at the surface; the stream holds ray and hit
    Walks slipped; // out of the scene without meeting the surface; they are as they were before the flight
    Walks ended;   // by roulette, or not finite
    Walks capped;  // by max_depth
    Walks parted;  // of these: the twin has not left
    Walks twins;   // not of these: their twins left
} TurnEnds;

Walks turn_ended(TurnEnds ends) { return ends.left | ends.slipped | ends.ended | ends.capped; }

real clearance_along(const Scene *scene, const WalkLanes *lanes, real t) {
    const Walk *walk = &lanes->walk;
    return clearance_at(scene->clearance, &lanes->field, fma(walk->direction.x, t, walk->position.x),
                        fma(walk->direction.y, t, walk->position.y), fma(walk->direction.z, t, walk->position.z));
}

// Longer than any way through the scene.
float turn_beyond(const Scene *scene) { return 4.0f * scene->frame->scene_radius; }

// Draws the flights of a group's lanes. Returns the lanes of `active` that wait for a direction: they have no flight in this turn.
uint turn_draw(const Scene *scene, WalkLanes *lanes, uint active) {
    Walk *walk = &lanes->walk;
    lanes->words = lane_draw(lanes->sampler, DRAW_WALK, walk->steps);
    DirectionNumbers numbers;
    numbers.cosine = lane_unit(lanes->words.y);
    numbers.azimuth = lane_unit(lanes->words.z);
    real xi_technique = numbers.cosine, xi_length = numbers.cosine;
    if (walk_chooses(scene) || HAS(GUIDE_DWIVEDI)) {
        const Natural4 choice = lane_draw(lanes->sampler, DRAW_WALK_CHOICE, walk->steps);
        if (walk_chooses(scene)) walk_choose(scene, walk, lane_unit(choice.x));
        xi_technique = lane_unit(choice.y);
        xi_length = lane_unit(choice.z);
    }
    const uint waiting =
        walk_direct(scene, walk, &lanes->guide, xi_technique, xi_length, numbers, lanes->sampler, active);
    const real number = pick(walk->steps == 0u, walk->first_number, lane_unit(lanes->words.x));
    const real drawn = walk_distance(scene, walk, &lanes->guide, number);
    lanes->distance = min(drawn, (real)(turn_beyond(scene)));
    if (HAS(CONTROL)) lanes->twin.drawn = drawn;
    lanes->rounding =
        POSITION_ROUNDING * max(fabs(walk->position.x), max(fabs(walk->position.y), fabs(walk->position.z)));
    return waiting;
}

// Writes the rays of a group's flights into the stream from `row` on: from a little before the start of a flight to a little
// beyond its end, so that neither a scatter nor the next flight is outside by rounding; of that only what may meet the surface.
// Returns the lanes of `active` that have a ray.
uint turn_rays(const Scene *scene, WalkLanes *lanes, uint active, RayStream *stream, uint row) {
    const Walk *walk = &lanes->walk;
    uint flying = active;
    real near = (real)(0.0f), far = lanes->distance;
    if (HAS(CLEARANCE)) { // what a ball about either end reaches is clear
        lanes->clear_end = clearance_along(scene, lanes, lanes->distance);
        near = lanes->clear;
        far -= lanes->clear_end;
        flying &= bits(near < far);
    }
    if (flying == 0u) return 0u;
    STREAM_LANES(stream->origin_x, row) = walk->position.x - lanes->rounding * walk->direction.x;
    STREAM_LANES(stream->origin_y, row) = walk->position.y - lanes->rounding * walk->direction.y;
    STREAM_LANES(stream->origin_z, row) = walk->position.z - lanes->rounding * walk->direction.z;
    STREAM_LANES(stream->direction_x, row) = walk->direction.x;
    STREAM_LANES(stream->direction_y, row) = walk->direction.y;
    STREAM_LANES(stream->direction_z, row) = walk->direction.z;
    STREAM_LANES(stream->t_min, row) = near;
    STREAM_LANES(stream->t, row) = far + 2.0f * lanes->rounding;
    STREAM_LANES_UINT(stream->root, row) = lanes->root;
    return flying;
}

// Traces the flights in `flying` and returns those that leave their object.
Walks turn_trace(const Scene *scene, WalkLanes *groups, RayStream *stream, Walks flying, Counts *counts) {
    Walks left = 0u;
    while (flying != 0u) {
        counts->value[COUNTER_walk_rays] += popcount(flying);
        trace_stream(stream, flying, scene->nodes, scene->blocks, MEET_FLIGHT AND_PROFILED(counts->profile + PROFILE_walk_nodes));
        Walks onward = 0u;
        FOR_WALKS(w, flying) {
            WalkLanes *lanes = GROUP(groups, w / LANES);
            const uint l = w % LANES;
            const Hit hit = stream_hit(stream, scene->blocks, w);
            if (hit.block == BVH_NO_PRIMITIVE) continue;
            const float3 direction = (float3)(stream->direction_x[w], stream->direction_y[w], stream->direction_z[w]);
            const float rounding = LANE_FLOAT(lanes->rounding, l), distance = LANE_FLOAT(lanes->distance, l);
            if (boundary_leaves(scene, hit, direction, &LANE_UINT(lanes->depth, l))) {
                left |= (Walks)1 << w;
                LANE_FLOAT(lanes->distance, l) = max(0.0f, hit.t - rounding);
            } else { // on, beyond the shell
                onward |= (Walks)1 << w;
                stream->t_min[w] = hit.t;
                stream->t[w] = distance + 2.0f * rounding;
            }
        }
        flying = onward;
    }
    return left;
}

// Ends the flights of the lanes `flown` of a group, whose first walk has bit `first` in `all`: at the surface those that
// `left`, else in a scatter. Others stay as they were.
void turn_arrive(const Scene *scene, WalkLanes *lanes, uint flown, uint left_bits, uint first, TurnEnds *all) {
    Walk *walk = &lanes->walk;
    const float outside2 = 1.01f * scene->frame->scene_radius * scene->frame->scene_radius; // no object reaches there
    const uint slipped = bits((lanes->distance >= turn_beyond(scene)) | (dot3(walk->position, walk->position) > outside2)) &
                         flown & ~left_bits;
    if (HAS(CONTROL)) {
        all->twins |= (Walks)twins_leave(scene, &lanes->twin, walk, &lanes->guide, flown) << first;
        all->parted |= (Walks)twins_part(scene, &lanes->twin, walk, &lanes->guide, left_bits | slipped) << first;
    }
    const mask left = mask_of(left_bits), moves = mask_of(flown & ~slipped);
    const real3 position = walk->position, weight = walk->weight, share = walk->share;
    const natural steps = walk->steps;
    walk_arrive(scene, walk, &lanes->guide, lanes->distance, left);
    walk->position = pick3(moves, walk->position, position);
    walk->weight = pick3(moves, walk->weight, weight);
    walk->share = pick3(moves, walk->share, share);
    walk->steps = pick(moves, walk->steps, steps);
    if (HAS(CLEARANCE)) lanes->clear = pick(moves, lanes->clear_end, lanes->clear);
    const mask survives = walk_roulette(scene, walk, lane_unit(lanes->words.w), left | (moves == 0));
    const uint ended = flown & ~bits(survives);
    const uint capped = flown & ~left_bits & ~slipped & ~ended &
                        bits((lanes->max_depth != 0u) & (walk->steps >= lanes->max_depth));
    all->left |= (Walks)left_bits << first;
    all->slipped |= (Walks)slipped << first;
    all->ended |= (Walks)ended << first;
    all->capped |= (Walks)capped << first;
}

// One flight of every walk in `active`, bit g LANES + l for lane l of group g, that gets a direction for it; the other lanes
// compute along, unheeded. The groups take each part of the turn one after the other, so that their rays and look-ups wait for
// memory together.
TurnEnds walk_turn(const Scene *scene, WalkLanes *groups, RayStream *stream, Walks active, Counts *counts) {
    Walks waiting = 0u, flying = 0u;
    FOR_GROUPS(g, active) {
        waiting |= (Walks)turn_draw(scene, GROUP(groups, g), group_bits(active, g)) << (g * LANES);
        COUNT_PROFILE(counts, lane_turns, 1u)
    }
    const Walks flown = active & ~waiting;
    FOR_GROUPS(g, flown)
        flying |= (Walks)turn_rays(scene, GROUP(groups, g), group_bits(flown, g), stream, g * LANES) << (g * LANES);
    COUNT_PROFILE(counts, clear_steps, popcount(flown & ~flying))
    COUNT_PROFILE(counts, lane_active, popcount(active))
    const Walks left = turn_trace(scene, groups, stream, flying, counts);
    TurnEnds all = {0u, 0u, 0u, 0u, 0u, 0u};
    FOR_GROUPS(g, flown)
        turn_arrive(scene, GROUP(groups, g), group_bits(flown, g), group_bits(left, g), g * LANES, &all);
    counts->value[COUNTER_steps] += popcount(flown);
    return all;
}

#endif
