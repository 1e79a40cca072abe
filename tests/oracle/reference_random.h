#pragma once
#include <cstdint>
#include <random>

namespace nacre::reference {

/// Numbers in (0, 1), 53 bits each. One stream per pixel.
class Random {
  public:
    Random(std::uint64_t seed, std::uint64_t stream) {
        std::seed_seq words{std::uint32_t(seed), std::uint32_t(seed >> 32), std::uint32_t(stream),
                            std::uint32_t(stream >> 32)};
        engine.seed(words);
    }
    double operator()() { return (double(engine() >> 11) + 0.5) * 0x1p-53; }

  private:
    std::mt19937_64 engine;
};

/// Russian roulette: below a quarter every other weight ends and the others double. Returns whether this one goes on.
inline bool survives(double &weight, Random &random) {
    if (weight >= 0.25) return true;
    if (!(weight > 0) || random() < 0.5) return false;
    weight *= 2;
    return true;
}

} // namespace nacre::reference
