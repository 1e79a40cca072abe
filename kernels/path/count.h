// What a work-item counts, kept in registers and added to its group's slice at the end.
#ifndef NACRE_PATH_COUNT_H
#define NACRE_PATH_COUNT_H

#include "shared/view.h"

typedef struct {
    uint value[COUNTER_COUNT];
} Counts;

Counts no_counts(void) {
    Counts counts;
    for (int i = 0; i < COUNTER_COUNT; ++i) counts.value[i] = 0u;
    return counts;
}

void add_counts(const Counts *counts, volatile global uint *counters) {
    volatile global uint *slice = counters + (get_group_id(0) % COUNTER_SLICES) * COUNTER_STRIDE;
    for (int i = 0; i < COUNTER_COUNT; ++i)
        if (counts->value[i] != 0u) atomic_add(slice + i, counts->value[i]);
}

#endif
