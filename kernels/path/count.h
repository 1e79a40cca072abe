// What a work-item counts, kept in registers and added to its group's slice at the end.
#ifndef NACRE_PATH_COUNT_H
#define NACRE_PATH_COUNT_H

#include "shared/view.h"

typedef struct {
    uint value[COUNTER_COUNT];
#ifdef PROFILE
    uint profile[PROFILE_USED];
#endif
} Counts;

// COUNT_PROFILE(counts, name, n) adds n to a counter of PROFILE_LIST; COUNT_WALK(counts, steps) notes a walk that has ended.
// No semicolon after them: see PROFILED.
#define COUNT_PROFILE(counts, name, n) PROFILED((counts)->profile[PROFILE_##name] += (n);)
#define COUNT_WALK(counts, steps) PROFILED(count_walk(counts, steps);)

Counts no_counts(void) {
    Counts counts;
    for (int i = 0; i < COUNTER_COUNT; ++i) counts.value[i] = 0u;
#ifdef PROFILE
    for (int i = 0; i < PROFILE_USED; ++i) counts.profile[i] = 0u;
#endif
    return counts;
}

#ifdef PROFILE
// Bin of the histogram: 0 to 7 their own, then the octave and the two bits below the leading one.
uint profile_bin(uint steps) {
    if (steps < 4u) return steps;
    const uint octave = 31u - clz(steps);
    return min(4u * (octave - 1u) + ((steps >> (octave - 2u)) & 3u), PROFILE_BINS - 1u);
}

void count_walk(Counts *counts, uint steps) {
    counts->profile[PROFILE_HISTOGRAM + profile_bin(steps)] += 1u;
    counts->profile[PROFILE_MOST_STEPS] = max(counts->profile[PROFILE_MOST_STEPS], steps);
}
#endif

void add_counts(const Counts *counts, volatile global uint *counters) {
    volatile global uint *slice = counters + (get_group_id(0) % COUNTER_SLICES) * COUNTER_STRIDE;
    for (int i = 0; i < COUNTER_COUNT; ++i)
        if (counts->value[i] != 0u) atomic_add(slice + i, counts->value[i]);
#ifdef PROFILE
    slice = counters + PROFILE_TAIL + (get_group_id(0) % COUNTER_SLICES) * PROFILE_STRIDE;
    for (int i = 0; i < PROFILE_MOST_STEPS; ++i)
        if (counts->profile[i] != 0u) atomic_add(slice + i, counts->profile[i]);
    atomic_max(slice + PROFILE_MOST_STEPS, counts->profile[PROFILE_MOST_STEPS]);
#endif
}

#endif
