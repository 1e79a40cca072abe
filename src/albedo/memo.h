#pragma once
#include <array>

namespace nacre::albedo {

/// A parameter of eq 6 as a function of g: a polynomial of degree 7 (memo, eq 7), or a constant plus the exponential of
/// one without constant term (eq 8: offset + factor exp(power[0] g + ... + power[6] g^7)).
using Polynomial = std::array<double, 8>;
struct ExponentialOfPolynomial {
    double offset, factor;
    std::array<double, 7> power;
};

/// Coefficients of the memo's eq 9,
///     albedo(x, g) = (1 - x^(1/4)) A atan(B x)^C + x^(1/4) D atan(E x)^F.
struct MemoFit {
    Polynomial a;
    ExponentialOfPolynomial b;
    Polynomial c, d;
    ExponentialOfPolynomial e;
    Polynomial f;
};

/// Single-scattering albedo for the colour x in [0, 1] and g, as the fit has it: may be above 1.
double memo_albedo(const MemoFit &fit, double x, double g);

/// For walks without a cap on scatters, g in [0, .95]: the joint fit of `nacre albedo fit`, to colours of 1,600
/// rendered patches and white.
extern const MemoFit uncapped_fit;

/// As published with Blender Cycles by one of the memo's authors: for walks that end at 256 scatters.
extern const MemoFit published_fit;

} // namespace nacre::albedo
