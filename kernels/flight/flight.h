// Free flights. One law serves them all: with the depth u(tau) = log(1 + b tau) / b (tau itself where the bleed b is 0),
//     transmittance  T = exp(-k u)            pdf per optical depth  p = k exp(-(k + b) u)
// k = 1 is the memo's law (eq 10 and its table, with a = 1/b; the table's "cdf" is T): exponential at b = 0, Davis & Xu 2014
// otherwise. k = 1 + b is the flight from a scatter of the reciprocal model (d'Eon 2018; Bitterli et al. 2018), whose
// mean is 1 for every b: p = (1 + b)(1 + b tau)^-(1/b + 2). So the four functions of a law (start at surface or scatter,
// end at surface or scatter) are T and p at the two values of k. tau = sigma s >= 0, b >= 0.
// log1p and expm1 keep the digits that (1 + tau/a)^-a loses for large a (relative error of T below 6e-6).
#ifndef NACRE_FLIGHT_FLIGHT_H
#define NACRE_FLIGHT_FLIGHT_H

#include "lanes/math.h"
#include "shared/view.h"

typedef struct {
    real bleed; // b
    real rate;  // k
} Flight;

Flight flight_of(real bleed, mask reciprocal, mask from_scatter) {
    Flight flight;
    flight.bleed = bleed;
    flight.rate = pick(reciprocal && from_scatter, 1.0f + bleed, (real)(1.0f));
    return flight;
}

real flight_depth(const Scene *scene, Flight flight, real tau) {
    if (!HAS(BLEED)) return tau;
    return pick(flight.bleed > 0.0f, lane_log1p(flight.bleed * tau) / flight.bleed, tau);
}

// Optical depth of a flight from a number xi in (0, 1). Infinite where float cannot hold it (large bleed).
real flight_sample(const Scene *scene, Flight flight, real xi) {
    if (!HAS(BLEED)) return -lane_log(xi);
    const real depth = -lane_log(xi) / flight.rate;
    return pick(flight.bleed > 0.0f, lane_expm1(flight.bleed * depth) / flight.bleed, depth);
}

real flight_transmittance(const Scene *scene, Flight flight, real tau) {
    if (!HAS(BLEED)) return lane_exp(-tau);
    return lane_exp(-flight.rate * flight_depth(scene, flight, tau));
}

// Per unit of tau: a density per length is sigma times this.
real flight_pdf(const Scene *scene, Flight flight, real tau) {
    if (!HAS(BLEED)) return lane_exp(-tau);
    return flight.rate * lane_exp(-(flight.rate + flight.bleed) * flight_depth(scene, flight, tau));
}

// Density of what ended the flight, per unit of tau: the transmittance in lanes that reached the surface (`left`), the pdf in
// those that scattered. Both at the price of one.
real flight_density(const Scene *scene, Flight flight, real tau, mask left) {
    if (!HAS(BLEED)) return lane_exp(-tau);
    const real decay = pick(left, flight.rate, flight.rate + flight.bleed);
    return pick(left, (real)(1.0f), flight.rate) * lane_exp(-decay * flight_depth(scene, flight, tau));
}

#endif
