// How far a point surely is from the surface of its object. A step from p to q of length s cannot touch the surface if
// s <= clearance(p) + clearance(q): the two balls cover it. Else only what lies between the balls must be traced.
#ifndef NACRE_WALK_CLEARANCE_H
#define NACRE_WALK_CLEARANCE_H

#include "lanes/gather.h"
#include "shared/clearance.h"

#pragma OPENCL FP_CONTRACT OFF

// The fields that the lanes' walks are in.
typedef struct {
    real corner_x, corner_y, corner_z;
    real edge, inverse_edge, unit, rounding;
    real last_x, last_y, last_z; // index of the last cell
    whole bricks_x, bricks_y;
    whole first;                 // in words
} ClearanceLanes;

// From now on `lane` walks in the object with field `c`. By address: where the struct is copied, NVIDIA's compiler (580.159) comes
// to no end.
void clearance_set(ClearanceLanes *lanes, uint lane, global const Clearance *c) {
    LANE_FLOAT(lanes->corner_x, lane) = c->corner.x;
    LANE_FLOAT(lanes->corner_y, lane) = c->corner.y;
    LANE_FLOAT(lanes->corner_z, lane) = c->corner.z;
    LANE_FLOAT(lanes->edge, lane) = c->corner.w;
    LANE_FLOAT(lanes->inverse_edge, lane) = c->inverse_edge;
    LANE_FLOAT(lanes->unit, lane) = c->unit;
    LANE_FLOAT(lanes->rounding, lane) = c->rounding;
    // Without a field every look-up reads the buffer's first byte, and a unit of 0 makes nothing of it.
    LANE_FLOAT(lanes->last_x, lane) = convert_float(max(CLEARANCE_BRICK * c->bricks_x, 1u) - 1u);
    LANE_FLOAT(lanes->last_y, lane) = convert_float(max(CLEARANCE_BRICK * c->bricks_y, 1u) - 1u);
    LANE_FLOAT(lanes->last_z, lane) = convert_float(max(CLEARANCE_BRICK * c->bricks_z, 1u) - 1u);
    LANE_INT(lanes->bricks_x, lane) = (int)c->bricks_x;
    LANE_INT(lanes->bricks_y, lane) = (int)c->bricks_y;
    LANE_INT(lanes->first, lane) = (int)(c->first / 4u);
}

// Cell of a coordinate; beyond the grid its nearest one. NaN gives 0.
whole clearance_cell(real x, real corner, real inverse_edge, real last) {
    const real cell = (x - corner) * inverse_edge;
    const real above = pick(cell > 0.0f, cell, (real)(0.0f));
    return to_whole(pick(above < last, above, last));
}

// A lower bound, >= 0, on the distance of any point to the surface. It holds beyond the grid as well (triangle
// inequality about the centre of the nearest cell), and is 0 for points that are not finite and lanes without a field.
real clearance_at(global const uint *field, const ClearanceLanes *c, real x, real y, real z) {
    const whole i = clearance_cell(x, c->corner_x, c->inverse_edge, c->last_x);
    const whole j = clearance_cell(y, c->corner_y, c->inverse_edge, c->last_y);
    const whole k = clearance_cell(z, c->corner_z, c->inverse_edge, c->last_z);
    // A row of four cells along x is one word, sixteen words are a brick.
    const whole brick = ((k >> 2) * c->bricks_y + (j >> 2)) * c->bricks_x + (i >> 2);
    const whole word = gather(field, c->first + brick * 16 + (k & 3) * 4 + (j & 3));
    const real code = to_real((word >> ((i & 3) * 8)) & 255);

    const real from_x = fma(to_real(i) + 0.5f, c->edge, c->corner_x - x);
    const real from_y = fma(to_real(j) + 0.5f, c->edge, c->corner_y - y);
    const real from_z = fma(to_real(k) + 0.5f, c->edge, c->corner_z - z);
    const real off_centre = sqrt(fma(from_x, from_x, fma(from_y, from_y, from_z * from_z)));
    // Sum, root and the distances from far away round by a few ulp of the result.
    const real bound = fma(code * code, c->unit, -c->rounding) - off_centre * 1.000001f;
    return pick(bound > 0.0f, bound, (real)(0.0f));
}

#endif
