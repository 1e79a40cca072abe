// Lane types: LANES walks side by side in one work-item. phase, flight and walk are written over them; with LANES = 1
// they are plain scalars. Never a bare ?:, any() or select(): a vector's true is -1, a scalar's is 1.
#ifndef NACRE_LANES_LANES_H
#define NACRE_LANES_LANES_H

#ifndef LANES
#define LANES 1
#endif

#define LANES_JOIN_(a, b) a##b
#define LANES_JOIN(a, b) LANES_JOIN_(a, b)

#if LANES == 1
typedef float real;
typedef int whole;
typedef uint natural;
typedef int mask;
#define pick(m, a, b) ((m) ? (a) : (b))
#define to_whole(x) convert_int_rtz(x)
#define to_real(x) convert_float(x)
#define as_natural(x) as_uint(x)
#define as_whole(x) as_int(x)
#define as_real(x) as_float(x)
uint bits(mask m) { return m != 0 ? 1u : 0u; }
#else
typedef LANES_JOIN(float, LANES) real;
typedef LANES_JOIN(int, LANES) whole;
typedef LANES_JOIN(uint, LANES) natural;
typedef LANES_JOIN(int, LANES) mask;
#define pick(m, a, b) select((b), (a), (m))
#define to_whole(x) LANES_JOIN(LANES_JOIN(convert_int, LANES), _rtz)(x)
#define to_real(x) LANES_JOIN(convert_float, LANES)(x)
#define as_natural(x) LANES_JOIN(as_uint, LANES)(x)
#define as_whole(x) LANES_JOIN(as_int, LANES)(x)
#define as_real(x) LANES_JOIN(as_float, LANES)(x)
#if LANES == 4
uint bits(mask m) {
    const int4 b = m & (int4)(1, 2, 4, 8);
    return (uint)(b.x | b.y | b.z | b.w);
}
#elif LANES == 8
uint bits(mask m) {
    const int8 b = m & (int8)(1, 2, 4, 8, 16, 32, 64, 128);
    const int4 h = b.lo | b.hi;
    return (uint)(h.x | h.y | h.z | h.w);
}
#else
uint bits(mask m) {
    const int16 b = m & (int16)(1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768);
    const int8 h = b.lo | b.hi;
    const int4 q = h.lo | h.hi;
    return (uint)(q.x | q.y | q.z | q.w);
}
#endif
#endif

typedef struct {
    real x, y, z;
} real3;

#endif
