#pragma once
#include "io/image.h"
#include "render/upload.h"
#include <cstdint>
#include <string>
#include <vector>

namespace nacre::render {

/// Which layers a picture has beside RGBA.
struct Layers {
    bool albedo = false, normal = false, depth = false, variance = false, samples = false;
    bool zero = false, single = false, multiple = false; // light of paths by how often their first walk scattered
    bool steps = false;                                  // mean number of scatters of these walks
    bool surface() const { return albedo || normal || depth; }
    bool scatter() const { return zero || single || multiple || steps; }

    /// float4 that a pixel has in the film, and that a path keeps until the film takes them: shared/path.h.
    std::uint32_t planes() const;
    std::uint32_t kept() const;
};

/// A sum and what it has lost by rounding (FILM_REST). An infinite one leaves NaN, which says nothing.
double whole_sum(double sum, double rest);

/// Sums over all samples of every pixel, in double, in units of the device's film. Pixels are in tile order
/// (shared/path.h). An adaptive render's film has two halves of samples, and its picture is the mean of both halves'
/// means, however many samples each has: allocation.h says why.
class Film {
  public:
    Film(const Crop &crop, std::uint32_t planes, std::uint32_t halves = 1);

    /// Tile-ordered pixels, those of the last tiles that are beyond the crop's edge included.
    std::uint32_t pixels() const { return count; }

    /// Adds a block's sums (planes x float4 per pixel) as they come from the device.
    void add(const std::vector<shared::float4> &block);

    /// The same for one tile of the first or second half (0, 1), whose pixels have `more` samples each.
    void add_tile(std::uint32_t tile, std::uint32_t half, const shared::float4 *block, const std::uint32_t *more);

    /// Says that pixels [first, first + count) have `samples` more.
    void count_samples(std::uint32_t first, std::uint32_t count, std::uint32_t samples);

    /// The mean of every pixel, with its layers; `unit` and `length` bring radiance and depth back to the scene's
    /// units.
    io::Picture picture(const Layers &layers, double unit, double length) const;

    std::uint64_t total_samples() const;

    /// The root of the relMSE (compare/metrics.h) that its variances say it has. 0: it is not known.
    double relative_error() const;

  private:
    Crop crop;
    std::uint32_t planes, columns, count, halves;
    std::vector<double> sums;           // by half and pixel, planes * 4 each
    std::vector<std::uint32_t> samples; // by half and pixel

    std::uint32_t tile_index(std::uint32_t x, std::uint32_t y) const;
    std::uint32_t samples_of(std::uint32_t pixel) const;
    /// Of value `value` of the planes; a half that has no samples has no say.
    double mean(std::uint32_t pixel, std::uint32_t value) const;
    /// Of two means; 0 where there is nothing of `below`.
    double ratio(std::uint32_t pixel, std::uint32_t above, std::uint32_t below) const;
    /// Of the mean, from the samples' own spread; 0 where it cannot be known.
    double variance(std::uint32_t pixel, std::uint32_t channel) const;
};

} // namespace nacre::render
