#pragma once
#include <algorithm>
#include <array>
#include <cmath>

// Colour spaces of FLIP (Andersson et al. 2020, section 4): three floats each, linear sRGB within 0..1.
namespace nacre::compare {

using Color = std::array<float, 3>;

// Linear sRGB to CIE XYZ over the XYZ of white, which is (1, 1, 1): IEC 61966-2-1's primaries, the rows of its matrix
// divided by the sums of the rows.
inline Color white_xyz(const Color &rgb) {
    const auto row = [&](float r, float g, float b) { return (r * rgb[0] + g * rgb[1] + b * rgb[2]) / (r + g + b); };
    return {row(0.4124564f, 0.3575761f, 0.1804375f), row(0.2126729f, 0.7151522f, 0.0721750f),
            row(0.0193339f, 0.1191920f, 0.9503041f)};
}

// The inverse; colours outside of the cube are clipped to it, as the paper says.
inline Color clipped_rgb(const Color &xyz) {
    const float x = 0.9504700f * xyz[0], y = xyz[1], z = 1.0888300f * xyz[2];
    return {std::clamp(3.2404542f * x - 1.5371385f * y - 0.4985314f * z, 0.0f, 1.0f),
            std::clamp(-0.9692660f * x + 1.8760108f * y + 0.0415560f * z, 0.0f, 1.0f),
            std::clamp(0.0556434f * x - 0.2040259f * y + 1.0572252f * z, 0.0f, 1.0f)};
}

// YCxCz, opponent colours that are linear in light (Flohr et al. 1993).
inline Color opponent(const Color &rgb) {
    const auto [x, y, z] = white_xyz(rgb);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

inline Color rgb_of_opponent(const Color &color) {
    const float y = (color[0] + 16) / 116;
    return clipped_rgb({y + color[1] / 500, y, y - color[2] / 200});
}

// CIELAB with Hunt's effect: chroma is seen more where it is light.
inline Color hunt_lab(const Color &rgb) {
    const auto curve = [](float t) {
        constexpr float edge = 6.0f / 29;
        return t > edge * edge * edge ? std::cbrt(t) : t / (3 * edge * edge) + 4.0f / 29;
    };
    const auto [x, y, z] = white_xyz(rgb);
    const float lightness = 116 * curve(y) - 16, hunt = 0.01f * lightness;
    return {lightness, hunt * 500 * (curve(x) - curve(y)), hunt * 200 * (curve(y) - curve(z))};
}

// Distance of large colour differences: city blocks in lightness, Euclid in chroma (Abasi et al. 2020).
inline float hyab(const Color &a, const Color &b) {
    return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

} // namespace nacre::compare
