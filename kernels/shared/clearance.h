// Clearance field of one object: per cell of a grid one byte, a lower bound on the distance from the cell's centre to
// the object's surface. Lengths are in the kernels' units.
//
// Cells lie in bricks of 4 x 4 x 4, 64 bytes each and so one cache line; bricks and the cells in them count x first,
// then y, then z. The byte c of a cell says: distance >= unit * c * c, finer near the surface, where steps are short.
#ifndef NACRE_SHARED_CLEARANCE_H
#define NACRE_SHARED_CLEARANCE_H

#include "shared/types.h"

#define CLEARANCE_BRICK 4        // cells along an edge of a brick
#define CLEARANCE_BRICK_BYTES 64

SHARED_BEGIN

#ifdef __OPENCL_C_VERSION__
typedef struct Clearance Clearance;
#endif

struct Clearance {
    float4 corner;      // lower corner of cell 0, 0, 0; w: edge of a cell
    float inverse_edge;
    float unit;         // of the codes
    float rounding;     // what rounding may cost one look-up, or a point that lies this close to the true one
    uint bricks_x, bricks_y, bricks_z; // 0: no field, nothing is known to be clear
    uint first;         // byte of its first brick in the buffer that all objects share, a multiple of 64
    uint pad;
};

SHARED_END

#endif
