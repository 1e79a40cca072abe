#pragma once
#include "compare/estimate.h"
#include <cstdint>

// Whether two pictures may show the same. Null hypothesis: the expected value of every pixel is the same in both. Three
// families of differences are tested, each at a third of `alpha` with Sidak's correction: every channel of every pixel,
// of every tile of 16 x 16 pixels, and of the whole picture.
//
// Samples of a path tracer have heavy tails: a pixel that has not met its bright paths yet shows too small a variance,
// and a normal (or Student's) z finds differences where there are none. What is done about it:
//  - The variance of a difference is at least what both pictures' samples together say of it ("pooled": under the null
//    hypothesis both may have the same), so that one that missed its bright paths is not trusted.
//  - A pixel's difference is itself part of its variance, by 1 / (2n - 1) of its square, n the fewer of the samples.
//  That
//    is the variance that n + n samples have if it is by chance who got which, and makes z the statistic of a
//    permutation test: whatever the samples are, z^2 < 2n - 1. Few samples cannot tell single pixels apart, and no
//    longer seem to.
//  - Of tiles and the picture, the sum of differences is held against the sum of variances or that of squared
//  differences,
//    whichever is more. Where both pictures were rendered alike it is by chance which is A and which is B, in every
//    pixel: a sum of random signs, whose tail is bounded by sign_tail for any distribution of the samples and any
//    number of pixels. So the rate of false alarms of these is not only about, but at most what was asked for.
// Pixels are taken to be independent (each has its own scrambling) and the pictures too (other seeds). Sobol samples
// are more even than the variance layer says, which makes false alarms rarer still.
namespace nacre::compare {

constexpr int tile_size = 16; // pixels, each way

/// A difference (A - B) and the standard error to measure it by. Roundings of both pictures are taken off the
/// difference.
struct Difference {
    double value = 0, error = 0;
    double z() const { return value != 0 ? value / error : 0; }
};

/// What one family of tests found. The worst difference has the largest |z|.
struct Family {
    std::uint64_t tested = 0, beyond = 0; // differences; those beyond `limit`
    double limit = 0;                     // of |z|
    double z = 0;                         // of the worst difference, > 0: A is brighter
    int x = 0, y = 0, channel = 0;        // of it; of a tile its first pixel
    double p = 1;                         // of the family: that its worst comes so far by chance, at most
};

/// A channel over all tested pixels.
struct Channel {
    double mean_a = 0, mean_b = 0, error = 0; // error: of the difference of the means
    double z = 0;
};

struct Verdict {
    double alpha = 0;
    Family pixels, tiles, picture;
    Channel channels[3];
    std::uint64_t not_finite = 0; // pixels with a number in them that is none, or is infinite, or a variance below 0
    int not_finite_x = 0, not_finite_y = 0; // the first of them
    std::uint64_t untested = 0;             // pixels without samples in one of the pictures
    double p = 1;                           // of all: that a family goes so far by chance, at most
    bool different() const { return p < alpha || not_finite > 0; }
};

/// The difference of a pixel.
Difference pixel_difference(const Measured &a, const Measured &b);

/// The mean difference of pixels [x0, x1) x [y0, y1) that have samples and are finite.
Difference mean_difference(const Estimate &a, const Estimate &b, int channel, int x0, int y0, int x1, int y1);

/// Tests two pictures of the same size, which both have noise (Estimate::has_noise). 0 < alpha < 1.
Verdict test(const Estimate &a, const Estimate &b, double alpha);

/// Whether all numbers of the pixel are finite in both pictures and no variance is negative.
bool finite(const Estimate &a, const Estimate &b, std::size_t pixel);

/// Whether it has samples in both, too, and so is tested.
bool tested(const Estimate &a, const Estimate &b, std::size_t pixel);

} // namespace nacre::compare
