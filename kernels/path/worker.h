// Many paths per work-item, for devices with few and wide cores. A worker keeps POOL_PATHS of them under way: rays go through
// the BVH in streams, surfaces are shaded one by one, and walks run LANES side by side, the next one in a lane as soon as the
// last has left it. Nothing here changes what a path does, only when.
#ifndef NACRE_PATH_WORKER_H
#define NACRE_PATH_WORKER_H

#include "path/source.h"

// Paths that a worker takes from the launch at a time: neighbours, and few, so that all workers end together.
#define WORKER_CHUNK 64u

// With fewer lanes than this in use, and no walk waiting, a worker looks for more walks before it goes on.
#define WORKER_FEW_LANES (3u * LANES * LANE_GROUPS / 4u)

typedef struct {
    global Path *pool;
    ushort vacant[POOL_PATHS], rays[POOL_PATHS], walks[POOL_PATHS]; // places in the pool: free, with a ray to trace, about to walk
    uint vacant_count, ray_count, walk_count;
    bool shares[POOL_PATHS];   // by place: its ray, not yet traced, is that of the path before it in `rays`
    ushort probes[POOL_PATHS]; // places of paths below a surface with a diffusion model
    uint probe_count;
    uint next, end;            // paths of the launch that it took and has not begun
    bool exhausted;            // the launch has no more
    uint turns;                // of its lanes since then
    WalkLanes lanes[LANE_GROUPS];
    Walks walking;             // lanes in use
    RayStream stream;
    RayStream shadows;         // rays to lights
    float4 light[STREAM_RAYS]; // what they bring; w: the path's place in the pool
    float4 foreseen[STREAM_RAYS]; // w: across
    uint shadow_count;
} Worker;

// Traces the shadow rays that wait. Has to be done before their paths go on, so that a path's light is added in one order.
void worker_light(const Scene *scene, Worker *worker, Counts *counts) {
    if (worker->shadow_count == 0u) return;
    counts->value[COUNTER_shadow_rays] += worker->shadow_count;
    trace_stream(&worker->shadows, first_bits(worker->shadow_count), scene->nodes, scene->blocks,
                 MEET_ANY AND_PROFILED(counts->profile + PROFILE_shadow_nodes));
    for (uint i = 0; i < worker->shadow_count; i++)
        if (worker->shadows.block[i] == BVH_NO_PRIMITIVE)
            shadow_light(scene, worker->pool + as_uint(worker->light[i].w), worker->light[i].xyz, worker->foreseen[i].xyz,
                         worker->foreseen[i].w != 0.0f);
    worker->shadow_count = 0u;
}

void worker_ask_light(const Scene *scene, Worker *worker, uint at, const Shadow *shadow, Counts *counts) {
    if (!shadow_asked(scene, shadow)) return;
    worker->light[worker->shadow_count] = (float4)(shadow->light, as_float(at));
    if (HAS(CONTROL)) worker->foreseen[worker->shadow_count] = (float4)(shadow->foreseen, shadow->across ? 1.0f : 0.0f);
    stream_put(&worker->shadows, worker->shadow_count, shadow->ray, scene->frame->bvh_root);
    worker->shadow_count++;
    if (worker->shadow_count == STREAM_RAYS) worker_light(scene, worker, counts);
}

// Puts a path where its state says.
void worker_file(const Scene *scene, Worker *worker, const Launch *launch, uint at, Counts *counts) {
    const uint state = worker->pool[at].state;
    if (state == PATH_RAY) {
        worker->rays[worker->ray_count++] = (ushort)at;
    } else if (state == PATH_WALK) {
        worker->walks[worker->walk_count++] = (ushort)at;
    } else if (HAS(DIFFUSION_MODEL) && state == PATH_PROBE) {
        worker->probes[worker->probe_count++] = (ushort)at;
    } else {
        launch_take(scene, launch, worker->pool + at, counts);
        worker->vacant[worker->vacant_count++] = (ushort)at;
    }
}

// Begins paths until the pool is full or the launch has no more.
void worker_begin(const Scene *scene, Worker *worker, const Launch *launch, Counts *counts) {
    const uint total = launch_paths(launch);
    global const Path *before = 0;
    while (worker->vacant_count > 0u && !worker->exhausted) {
        if (worker->next == worker->end) {
            worker->next = atomic_add(launch->counters + COUNTER_NEXT, WORKER_CHUNK);
            worker->end = min(worker->next + WORKER_CHUNK, total);
            if (worker->next >= total) {
                worker->exhausted = true;
                return;
            }
        }
        const uint at = worker->vacant[worker->vacant_count - 1u];
        global Path *path = worker->pool + at;
        if (!launch_path(scene, launch, worker->next++, path, before, counts)) continue;
        worker->vacant_count--;
        worker->shares[at] = before != 0 && path_shares_ray(scene, path, before);
        before = launch->batch.resumed == 0u ? path : 0; // those have left their camera rays behind
        worker_file(scene, worker, launch, at, counts);
    }
}

// Puts the rays of `count` paths at `places` into the stream while it has room, a shared one once. `ray`: which is whose.
// Returns how many paths it took, and how many rays they have.
uint worker_put_rays(const Scene *scene, Worker *worker, const ushort *places, uint count, uchar *ray, uint *rays) {
    *rays = 0u;
    for (uint i = 0; i < count; i++) {
        global const Path *path = worker->pool + places[i];
        if (i == 0u || !worker->shares[places[i]]) {
            if (*rays == STREAM_RAYS) return i;
            stream_put(&worker->stream, *rays, path_ray(path->position.xyz, path->direction.xyz), scene->frame->bvh_root);
            *rays += 1u;
        }
        ray[i] = (uchar)(*rays - 1u);
    }
    return count;
}

// Traces every ray that waits, and shades what it meets.
void worker_trace(const Scene *scene, Worker *worker, const Launch *launch, Counts *counts) {
    const uint count = worker->ray_count;
    worker->ray_count = 0u; // paths that go on with a ray are put back behind those that were read
    for (uint first = 0, part; first < count; first += part) {
        const ushort *places = worker->rays + first;
        uchar ray[POOL_PATHS];
        uint rays;
        part = worker_put_rays(scene, worker, places, count - first, ray, &rays);
        trace_stream(&worker->stream, first_bits(rays), scene->nodes, scene->blocks,
                     MEET_CLOSEST AND_PROFILED(counts->profile + PROFILE_ray_nodes));
        Surface surface;
        for (uint i = 0; i < part; i++) {
            const uint at = places[i];
            global Path *path = worker->pool + at;
            const bool shares = i > 0u && ray[i] == ray[i - 1u];
            worker->shares[at] = false;
            const Shadow shadow = path_meet(scene, path, stream_hit(&worker->stream, scene->blocks, ray[i]), &surface, shares,
                                            counts, launch_layers(scene, launch, path->slot));
            worker_ask_light(scene, worker, at, &shadow, counts);
            if (HAS(CONTROL) && path->state == PATH_WALK && path->twin != TWIN_NONE) {
                Shadow more[CONTROL_SHADOWS];
                const uint count = control_foresee(scene, path, &surface, more);
                for (uint k = 0; k < count; k++) worker_ask_light(scene, worker, at, more + k, counts);
            }
        }
        worker_light(scene, worker, counts);
        for (uint i = 0; i < part; i++) worker_file(scene, worker, launch, places[i], counts);
    }
}

// Takes paths that are below a diffusion model's surface out of it, one by one.
void worker_probe(const Scene *scene, Worker *worker, const Launch *launch, Counts *counts) {
    const uint count = worker->probe_count;
    worker->probe_count = 0u;
    for (uint i = 0; i < count; i++) {
        const uint at = worker->probes[i];
        const Shadow shadow = diffusion_leave(scene, worker->pool + at, counts);
        worker_ask_light(scene, worker, at, &shadow, counts);
    }
    worker_light(scene, worker, counts);
    for (uint i = 0; i < count; i++) worker_file(scene, worker, launch, worker->probes[i], counts);
}

// Puts walks that wait into idle lanes.
void worker_fill_lanes(const Scene *scene, Worker *worker) {
    for (Walks idle = ~worker->walking & WALKS_ALL; idle != 0u && worker->walk_count > 0u; idle &= idle - 1u) {
        const uint l = lowest_bit64(idle), at = worker->walks[--worker->walk_count];
        lane_load(scene, worker->lanes + l / LANES, l % LANES, worker->pool + at, at);
        worker->walking |= (Walks)1 << l;
    }
}

// Walks until no walk is left, or few and there are others to be found.
void worker_walk(const Scene *scene, Worker *worker, const Launch *launch, Counts *counts) {
    for (;;) {
        worker_fill_lanes(scene, worker);
        const bool more = worker->ray_count > 0u || !worker->exhausted;
        if (worker->walking == 0u || (more && popcount(worker->walking) < WORKER_FEW_LANES)) break;
        if (worker->exhausted && worker->turns++ >= launch->batch.budget) break;
        const TurnEnds ends = walk_turn(scene, worker->lanes, &worker->stream, worker->walking, counts);
        if (HAS(CONTROL)) {
            FOR_WALKS(w, ends.twins)
                control_take(scene, worker->pool + LANE_UINT(worker->lanes[w / LANES].path, w % LANES),
                             &worker->lanes[w / LANES].twin, w % LANES);
        }
        const Walks ended = turn_ended(ends);
        worker->walking &= ~ended;
        FOR_WALKS(l, ended) {
            const uint at = LANE_UINT(worker->lanes[l / LANES].path, l % LANES);
            global Path *path = worker->pool + at;
            const Shadow shadow = lane_end(scene, worker->lanes, &worker->stream, l, ends, path, counts,
                                           launch_layers(scene, launch, path->slot));
            worker_ask_light(scene, worker, at, &shadow, counts);
            worker_file(scene, worker, launch, at, counts); // a walk that ends for good asks for no light
        }
    }
    worker_light(scene, worker, counts);
}

// Leaves what is under way to the next launch, which has room for every path of every pool.
void worker_suspend(Worker *worker, const Launch *launch) {
    FOR_WALKS(l, worker->walking) {
        const uint at = LANE_UINT(worker->lanes[l / LANES].path, l % LANES);
        lane_store(worker->lanes + l / LANES, l % LANES, worker->pool + at);
        launch_suspend(launch, worker->pool + at);
    }
    for (uint i = 0; i < worker->walk_count; i++) launch_suspend(launch, worker->pool + worker->walks[i]);
    for (uint i = 0; i < worker->ray_count; i++) launch_suspend(launch, worker->pool + worker->rays[i]);
}

// Takes paths from the launch until there are none, and brings them to their end or, past the budget, to the next launch.
void trace_many(const Scene *scene, const Launch *launch, global Path *pool, Counts *counts) {
    Worker worker;
    worker.pool = pool;
    worker.ray_count = worker.walk_count = worker.probe_count = worker.shadow_count = 0u;
    worker.next = worker.end = worker.turns = worker.walking = 0u;
    worker.exhausted = false;
    worker.vacant_count = POOL_PATHS;
    // Lanes without a walk compute along; what they hold must not lead them out of a buffer.
    uint *words = (uint *)worker.lanes;
    for (uint i = 0; i < LANE_GROUPS * (sizeof(WalkLanes) / sizeof(uint)); i++) words[i] = 0u;
    for (uint i = 0; i < POOL_PATHS; i++) worker.vacant[i] = (ushort)(POOL_PATHS - 1u - i);
    for (;;) {
        worker_begin(scene, &worker, launch, counts);
        if (worker.ray_count + worker.walk_count + worker.walking == 0u) return;
        worker_trace(scene, &worker, launch, counts);
        if (HAS(DIFFUSION_MODEL)) worker_probe(scene, &worker, launch, counts);
        worker_walk(scene, &worker, launch, counts);
        if (worker.turns > launch->batch.budget) break;
    }
    worker_suspend(&worker, launch);
}

#endif
