#pragma once

namespace nacre::compare {

// Probabilities that a test needs far out in the tail. All are two-sided.

/// Upper bound of P(|sum of e_i d_i| >= z sqrt(sum of d_i^2)) for any numbers d_i and independent random signs
/// e_i: 3.178 times that of a normal (Bentkus and Dzindzalieta 2015, "A tight Gaussian bound for weighted sums of
/// Rademacher random variables", Bernoulli 21:2, theorem 1.1; the factor 1 / (4 P(Z >= sqrt 2)) cannot be improved). At
/// most 1.
double sign_tail(double z);

/// The z > 0 from which on sign_tail is at most `p`, 0 < p < 1; infinity where that is too far out for doubles.
double sign_limit(double p);

/// p of the smallest of `count` p-values, which is `p` (Sidak 1967; holds for correlated normals too, and is exact for
/// independent ones): 1 - (1 - p)^count.
double sidak(double p, double count);

/// The inverse: how small each of `count` p-values may be before one of them is found with probability `alpha`.
double sidak_level(double alpha, double count);

} // namespace nacre::compare
