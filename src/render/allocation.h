#pragma once
#include "render/upload.h"
#include "shared/path.h"
#include <array>
#include <cstdint>
#include <vector>

// Which tiles of an adaptive render get how many samples.
//
// A pixel has two halves of samples with independent scramblings, and its value is the mean of both halves' means. A
// sample count that depends on the samples themselves biases a mean (Kirk & Arvo 1991, "Unbiased Sampling Techniques
// for Image Synthesis"): whoever has not met the rare bright paths yet stops, and stays too dark. So the first half
// decides how many samples the second half gets, and the reverse: given the other half, a half's count is a fixed
// number, and its mean is unbiased, and so is the mean of both. Kirk and Arvo throw their pilot samples away; here each
// half is the other's pilot, and what is lost is only what a half needed to decide beyond what it was told to give.
//
// Tiles get samples in proportion to the root of their relative variance over what a sample costs: of all ways to one
// relMSE of the picture that takes the least time (Neyman 1934; Cochran 1977, "Sampling Techniques" 5.5). The same
// noise everywhere would ask for the variance itself in place of its root, and for as many samples in all as a picture
// takes that gives every pixel the same number. Cost is counted in rays and scatters, not in seconds: so pictures are
// the same whatever the device does besides.
//
// Decisions are for whole tiles, whose 64 pixels together know their variance, after FIRST_LOOK samples of a half (is
// it enough?) and at every doubling: a final number if the next decision would come too late, else to go on. A tile
// that met none of the bright paths that its neighbours met is not trusted: it needs at least what the 3 x 3 tiles
// around it need together by their first look (not a later one: how far they come depends on both halves).
namespace nacre::render {

/// Samples of a half before the first decision.
constexpr std::uint32_t FIRST_LOOK = 16;

class Allocation {
  public:
    /// `target`: the root of the relMSE that the picture is to have. `most`: samples of a half, at least 1.
    Allocation(const Crop &crop, std::uint32_t planes, double target, std::uint32_t most);

    /// What gets samples [first(), end()) next, as the kernels take it: tiles, those of the second half with
    /// SECOND_HALF. Empty: all have theirs.
    const std::vector<std::uint32_t> &list() const { return entries; }
    std::uint32_t first() const { return taken; }
    std::uint32_t end() const;

    /// Whether these samples of an entry are the picture's. False: they only help to decide.
    bool shown(std::uint32_t entry) const;

    /// Takes the film's sums of what was asked for (in the list's order) and decides what comes next.
    void add(const std::vector<shared::float4> &sums);

    /// Samples that there will be in all, as far as it can be known; pixels beyond the crop's edge count.
    std::uint64_t expected() const;

    /// Share of all tiles that get what they need, or are expected to, with at most `most` samples of each half.
    double converged() const;

  private:
    struct Half {                // of a tile
        std::uint32_t final = 0; // number of samples that the other half's say it is to have; 0: not decided yet
        double need = 0;         // the same before it is cut off or rounded
        double noise = 0;        // relative variance of one sample, by its own when they last decided something
        double around = 0;       // the same of the tiles around it, by their first look
        double cost = 1;         // of a sample, as `noise`
        double worth() const;    // samples go by it
    };
    std::uint32_t planes, most, width, height, columns, rows, taken = 0;
    double target;
    std::vector<Half> halves;                // 2 per tile
    std::vector<std::array<double, 7>> sums; // by half and pixel: r, g, b, their squares, and what they cost
    std::vector<std::uint32_t> entries;
    std::array<double, 2> floor{}; // noise_floor by the first look of each half

    void begin();
    double inside(std::size_t tile) const;
    double noise_of(std::size_t half) const;
    double cost_of(std::size_t half) const;
    void first_look(std::uint32_t deciding);
    void look(std::uint32_t deciding);
    double samples_per_worth(std::uint32_t deciding) const;
};

} // namespace nacre::render
