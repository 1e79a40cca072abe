#pragma once
#include "albedo/ordinates.h"
#include <vector>

namespace nacre::albedo {

/// Diffuse reflectance of a half-space, in float64 and without random numbers. albedo in [0, 1], g in [-.99, .99],
/// bleed in [0, 4]. For the lambert entry within 1e-8 at g = 0 and at bleed 0 (|g| <= .95), else within 5e-6; for the
/// uniform one within 1e-8 at g = 0, else 5e-5: most of it at |g| > .9. About a fifth of a second where bleed > 0.
/// Throws std::runtime_error where imbedding does not converge: renewal flights of bleed > 1.1, similarities below .1.
Reflectance reflectance(double albedo, double g, double bleed, shared::FlightLaw law);

/// The colours of a half-space for all albedos, from some reflectances between which it interpolates: to 2e-5 for the
/// lambert entry, to 2e-4 for the uniform one at g = .98. Albedos are given by their similarity
/// s = sqrt((1 - albedo) / (1 - g albedo)) (van de Hulst 1980), in which colour is smooth but for white and reciprocal
/// flights. There it is 1 - c s^(2 / (1 + bleed)) for bleed > 1: walks go (1 - albedo)^(-bleed / (1 + bleed)) mean free
/// paths deep (Levy flights), and what enters further is lost. Up to a second each.
class HalfSpace {
  public:
    HalfSpace(double g, double bleed, shared::FlightLaw law);

    /// Colour for a similarity in [0, 1]: 1 for 0, 0 for 1.
    double color(double similarity, shared::Entry entry) const;

    /// Similarity for a colour in [0, 1]. Entries other than uniform are taken for lambert.
    double similarity(double color, shared::Entry entry) const;

  private:
    double power;                     // similarity = node ^ power
    double white = 1;                 // 1 - color goes like node ^ white below the first node
    std::vector<double> node, factor; // ascending, to 1; barycentric
    std::vector<Reflectance> known;
};

double albedo_of(double similarity, double g);

} // namespace nacre::albedo
