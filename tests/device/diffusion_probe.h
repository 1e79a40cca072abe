#pragma once
#include "shared/scene.h"
#include "shared/types.h"
#include <string>
#include <vector>

namespace nacre::test {

/// The argument `DiffusionProbe` of kernels/probe_diffusion.cl, field by field.
struct DiffusionProbe {
    shared::float4 sigma{1, 1, 1, 0}, chance{1, 0, 0, 0};
    int model = shared::MODEL_BURLEY;
    float albedo = 0, g = 0, color = 0;
    float ball = 1;
    std::uint32_t direct = 0, seed = 1, count = 1;
};

/// Runs a kernel of probe_diffusion.cl over probe.count items of `width` floats. `initial`: what it finds there.
std::vector<float> run_diffusion(const char *kernel, const DiffusionProbe &probe, std::size_t width,
                                 const std::vector<float> &initial = {});

/// A model at a reduced albedo, in float64, by the textbooks' formulas; sigma_t' = 1.
struct ExactProfile {
    int model;
    double reduced_albedo; // of dipoles
    double color;          // of burley

    /// R(r), a dipole's with its albedo: the total is not 1.
    double reflectance(double r) const;
    /// Integral of R over the plane, or over a disk.
    double total() const;
    double within(double r) const;
    /// Share of the light that the sampler of radii puts within r.
    double drawn_within(double r) const;
    std::string name() const;

  private:
    double decay() const; // sigma_tr
    double depth() const; // of the virtual source
    double diffusion() const;
};

/// Share of cosine-weighted light that leaves a half-space after one scatter, per unit of albedo; |g| <= .95.
double exact_single_scattering(double g);

} // namespace nacre::test
