// No combination of guiding, channel sampling, flights, phase function, entry and body is biased: z-tests against exact
// values, and where none is known against classical walks, one channel's phase function at a time.
#include "device/guided_cases.h"
#include "oracle/adding_doubling.h"
#include <cmath>
#include <map>

namespace nacre::test {
namespace {

using namespace shared;

/// Two-sided z that `count` tests together exceed by chance once in a hundred (Sidak).
double limit_of(std::size_t count) {
    const double chance = -std::expm1(std::log1p(-.01) / double(count));
    double low = 0, high = 10;
    while (high - low > 1e-6) {
        const double z = (low + high) / 2;
        (std::erfc(z / std::sqrt(2)) > chance ? low : high) = z;
    }
    return high;
}

float channel(float4 v, std::size_t c) { return c == 0 ? v.x : c == 1 ? v.y : v.z; }

/// Reflectance of channel c where it is known without Monte Carlo.
bool known(const Probe &probe, std::size_t c, Estimate &exact) {
    const double albedo = double(channel(probe.albedo, c)), g = double(channel(probe.walk_anisotropy, c));
    if (probe.thickness != 0) return false;
    if (probe.entry == ENTRY_LAMBERT && probe.bleed == 0) {
        static std::map<std::pair<double, double>, double> solved;
        const auto [entry, fresh] = solved.try_emplace({albedo, g});
        if (fresh) entry->second = half_space_reflectance(albedo, g);
        exact = {entry->second, 1e-6};
        return true;
    }
    // Universal law of Sparre Andersen: all flights, the first included, have the same distribution.
    if (probe.entry == ENTRY_UNIFORM && g == 0 && (probe.bleed == 0 || !probe.reciprocal)) {
        const double r = std::sqrt(1 - albedo);
        exact = {(1 - r) / (1 + r), 0};
        return true;
    }
    return false;
}

/// What channel c of a case leaves on both sides. `classical` keeps walks by phase function.
std::array<Estimate, 2> reference(const GuidedCase &c, std::size_t at, double error,
                                  std::map<float, Walks> &classical) {
    Estimate exact;
    if (known(c.probe, at, exact)) return {exact, {}};
    const float g = channel(c.probe.walk_anisotropy, at);
    const auto [entry, fresh] = classical.try_emplace(g);
    if (fresh) {
        Probe probe = c.probe;
        probe.walk_anisotropy = {g, g, g, 1};
        probe.anisotropy = g;
        probe.seed += 500;
        entry->second = run_walks_to(probe, error, c.sampling == CHANNEL_HERO ? CHANNEL_THROUGHPUT : CHANNEL_HERO);
    }
    return {entry->second.near[at], entry->second.far[at]};
}

/// Whoever leaves a thick body only once in a million walks is not normally distributed: a thousandth of the error
/// asked for is let pass.
void expect_agreement(const Estimate &found, const Estimate &wanted, double error, double limit,
                      const std::string &what) {
    const double deviation = std::hypot(found.error, wanted.error);
    EXPECT_LE(found.error, error) << what << ": too few walks";
    EXPECT_LE(std::abs(found.mean - wanted.mean), limit * deviation + 1e-3 * error)
        << what << ": found " << found.mean << " +- " << found.error << ", wanted " << wanted.mean << " +- "
        << wanted.error;
}

/// `limit`: of |z|.
void check(const GuidedCase &c, double error, double limit) {
    const Walks found = run_walks_to(c.probe, error, c.sampling, c.guiding);
    std::map<float, Walks> classical;
    for (std::size_t at = 0; at < 3; ++at) {
        const auto [near, far] = reference(c, at, error, classical);
        const std::string what = fmt::format("{}, channel {}, ", name_of(c), at);
        expect_agreement(found.near[at], near, error, limit, what + "near");
        expect_agreement(found.far[at], far, error, limit, what + "far");
    }
    if (c.guiding == GUIDING_EIGEN && c.sampling == CHANNEL_HERO && c.probe.bleed == 0) {
        EXPECT_LT(found.largest, 10) << name_of(c);
    }
}

TEST(GuidedAgreement, ThirtyCases) {
    for (const GuidedCase &c : guided_cases(30)) check(c, 2e-3, limit_of(30 * 6));
}

// In parts, so that one sees them pass.
constexpr int cases = 200, part = 20;

class GuidedAgreementPart : public testing::TestWithParam<int> {};

TEST_P(GuidedAgreementPart, TwentyCases) {
    const std::vector<GuidedCase> all = guided_cases(cases);
    for (int i = GetParam(); i < GetParam() + part; ++i) check(all[std::size_t(i)], 3e-4, limit_of(cases * 6));
}

INSTANTIATE_TEST_SUITE_P(Long, GuidedAgreementPart, testing::Range(0, cases, part));

} // namespace
} // namespace nacre::test
