#include "oracle/reference_sky.h"
#include "oracle/reference_bilinear.h"
#include <algorithm>
#include <numbers>

namespace nacre::reference {

using std::numbers::pi;

// Weight of a texel: its solid angle times the brightest of what its bilinear interpolation reaches.
Sky::Sky(const scene::Light &light) : source(&light), turn(light.rotate * pi / 180) {
    double sum = 0;
    for (std::int64_t y = 0; y < light.height; ++y)
        for (std::int64_t x = 0; x < light.width; ++x) {
            double brightest = 0;
            for (int i = -1; i <= 1; ++i)
                for (int j = -1; j <= 1; ++j) brightest = std::max(brightest, texel(x + i, y + j).maxCoeff());
            sum += brightest * (top_of(y) - top_of(y + 1));
            cumulative.push_back(sum);
        }
}

Vec3 Sky::texel(std::int64_t x, std::int64_t y) const {
    const std::int64_t row = std::clamp<std::int64_t>(y, 0, source->height - 1);
    const float *rgb = &source->pixels[std::size_t(3 * (row * source->width + repeated(x, source->width)))];
    return {rgb[0], rgb[1], rgb[2]};
}

double Sky::top_of(std::int64_t row) const { return std::cos(pi * double(row) / source->height); }

Vec3 Sky::radiance(const Vec3 &direction) const {
    const double azimuth = std::atan2(direction.z(), direction.x()) + turn;
    const double u = 0.5 + azimuth / (2 * pi), v = std::acos(std::clamp(direction.y(), -1.0, 1.0)) / pi;
    const Vec3 found =
        bilinear(u * source->width, v * source->height, [this](std::int64_t x, std::int64_t y) { return texel(x, y); });
    return source->radiance.cwiseProduct(found);
}

std::pair<Vec3, double> Sky::draw(Random &random) const {
    const double total = cumulative.back();
    const auto found = std::upper_bound(cumulative.begin(), cumulative.end(), random() * total);
    const std::int64_t texel = found - cumulative.begin(), x = texel % source->width, row = texel / source->width;
    const double weight = *found - (texel > 0 ? *std::prev(found) : 0);
    const double height = top_of(row) - top_of(row + 1), y = top_of(row) - random() * height; // evenly on the sphere
    const double azimuth = ((double(x) + random()) / source->width - 0.5) * 2 * pi - turn, sine = std::sqrt(1 - y * y);
    const double solid_angle = height * 2 * pi / source->width;
    return {Vec3(sine * std::cos(azimuth), y, sine * std::sin(azimuth)), weight / total / solid_angle};
}

} // namespace nacre::reference
