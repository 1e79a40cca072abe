// Which object a triangle belongs to.
#ifndef NACRE_GEOMETRY_OBJECT_H
#define NACRE_GEOMETRY_OBJECT_H

#include "shared/view.h"

// Primitives are counted from object to object: the last one that begins at or before `primitive`. Found by halving, so that
// no number per triangle has to come from memory.
uint object_of(const Scene *scene, uint primitive) {
    uint first = 0u, count = scene->frame->object_count;
    while (count > 1u) {
        const uint half_count = count / 2u;
        const bool upper = scene->objects[first + half_count].first_primitive <= primitive;
        first = upper ? first + half_count : first;
        count = upper ? count - half_count : half_count;
    }
    return first;
}

#endif
