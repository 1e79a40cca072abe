// Reflectance of smooth interfaces.
#ifndef NACRE_BSDF_FRESNEL_H
#define NACRE_BSDF_FRESNEL_H

// Unpolarised Fresnel reflectance of a dielectric, relative index eta >= 1, from outside. cosine in [0, 1].
float fresnel_dielectric(float cosine, float eta) {
    const float sine2 = (1.0f - cosine) * (1.0f + cosine) / (eta * eta);
    const float inner = sqrt(max(0.0f, 1.0f - sine2));
    const float parallel = (eta * cosine - inner) / (eta * cosine + inner);
    const float perpendicular = (cosine - eta * inner) / (cosine + eta * inner);
    return 0.5f * (parallel * parallel + perpendicular * perpendicular);
}

// Schlick 1994: a metal whose reflectance at normal incidence is `f0`.
float3 fresnel_schlick(float cosine, float3 f0) {
    const float m = 1.0f - cosine, m2 = m * m;
    return f0 + (1.0f - f0) * (m2 * m2 * m);
}

// OpenPBR: specular_weight scales the reflectance at normal incidence, so it changes the index.
float weighted_ior(float ior, float weight) {
    const float r = sqrt(min(1.0f, weight)) * (ior - 1.0f) / (ior + 1.0f);
    return (1.0f + r) / (1.0f - r);
}

#endif
