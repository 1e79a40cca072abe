// How far from where it entered light leaves a surface: profiles of the diffusion models, normalised over the plane. One switch
// over the models. Densities are per area, in the kernels' units of length.
//     burley  normalised diffusion, Burley 2015, "Extending the Disney BRDF to a BSDF with Integrated Subsurface Scattering":
//             R(r) = A s (e^(-sr/d) + e^(-sr/3d)) / (8 pi d r). Fitted to whole walks, so single scattering is in it. d is the mean
//             free path, s that of diffuse illumination: s = 1.9 - A + 3.5 (A - .8)^2, Christensen & Burley 2015, "Approximate
//             Reflectance Profiles for Efficient Subsurface Scattering". The total is A, the colour, on a half-space
//     dipole, better_dipole  see dipole.h
// Anisotropy enters by similarity alone: 1 / d = sigma_t' = sigma_t (1 - albedo g).
#ifndef NACRE_DIFFUSION_PROFILE_H
#define NACRE_DIFFUSION_PROFILE_H

#include "diffusion/dipole.h"

typedef struct {
    int model;
    float scale; // 1 / length: of burley s / d, of the dipoles sigma_t'
    Dipole dipole;
    float mass;  // of the dipole: dipole_mass
} Profile;

// `color` in [0, 1] is of burley alone.
Profile profile_of(int model, float sigma, float albedo, float g, float color) {
    Profile profile;
    profile.model = model;
    profile.scale = sigma * (1.0f - albedo * g);
    profile.dipole = dipole_of(model, dipole_similarity(albedo, g));
    profile.mass = dipole_mass(profile.dipole);
    if (model == MODEL_BURLEY) profile.scale *= 1.9f - color + 3.5f * (color - 0.8f) * (color - 0.8f);
    return profile;
}

// x = 0 would be 1/0 in burley: nearer than this lies a share of 1e-6 of the light.
float burley_density(float x) {
    const float y = max(1e-6f, x);
    return (exp_scalar(-y) + exp_scalar(-y * (1.0f / 3.0f))) * (0.125f * INV_PI) / y;
}

// xi in (0, 1).
float profile_sample(const Profile *profile, float xi) {
    if (profile->model == MODEL_BURLEY) // a quarter of the light is in the short exponential
        return (xi < 0.25f ? -log_scalar(4.0f * xi) : -3.0f * log_scalar((1.0f - xi) * (4.0f / 3.0f))) / profile->scale;
    const float k = profile->dipole.decay, near = dipole_flux(k, 1.0f), far = dipole_flux(k, profile->dipole.image);
    const float share = near / (near + far);
    const bool real_source = xi < share;
    const float rest = real_source ? xi / share : (1.0f - xi) / (1.0f - share);
    return dipole_radius(k, real_source ? 1.0f : profile->dipole.image, clamp(rest, 0x1p-24f, 1.0f)) / profile->scale;
}

float profile_pdf(const Profile *profile, float r) {
    const float x = r * profile->scale, unit = profile->scale * profile->scale;
    if (profile->model == MODEL_BURLEY) return unit * burley_density(x);
    const Dipole dipole = profile->dipole;
    return unit * 0.5f * INV_PI * dipole_sources(dipole, sqrt(fma(x, x, 1.0f)), sqrt(fma(x, x, dipole.image * dipole.image))) /
           (dipole_flux(dipole.decay, 1.0f) + dipole_flux(dipole.decay, dipole.image));
}

// R(r) / total.
float profile_eval(const Profile *profile, float r) {
    if (profile->model != MODEL_BETTER_DIPOLE) return profile_pdf(profile, r);
    const Dipole dipole = profile->dipole;
    const float x = r * profile->scale;
    const float near = sqrt(fma(x, x, 1.0f)), far = sqrt(fma(x, x, dipole.image * dipole.image));
    return profile->scale * profile->scale * 0.5f * INV_PI / profile->mass *
           fma(dipole.fluence, dipole_fluence(dipole, near, far), dipole_sources(dipole, near, far));
}

#endif
