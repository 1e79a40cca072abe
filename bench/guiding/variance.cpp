#include "guiding/variance.h"
#include "measure.h"
#include "render/session.h"
#include "render/statistics.h"
#include <numeric>

namespace nacre::bench {
namespace {

using namespace shared;

scene::Scene with(scene::Scene scene, const Estimator &estimator, std::uint32_t seed) {
    scene.render.guiding = estimator.guiding;
    scene.render.channel_sampling = estimator.sampling;
    scene.render.control = estimator.control;
    scene.render.seed = seed;
    return scene;
}

/// As on most screens (Rec. 709).
std::vector<double> luminance(const io::Picture &picture) {
    const std::size_t channels = picture.channels.size();
    std::vector<double> values;
    for (std::size_t i = 0; i < picture.pixels.size(); i += channels) {
        const float *p = picture.pixels.data() + i;
        values.push_back(.2126 * double(p[0]) + .7152 * double(p[1]) + .0722 * double(p[2]));
    }
    return values;
}

/// Per pixel.
struct Variance {
    double plain = 0, relative = 0;
};

double mean_of(const std::vector<double> &values) {
    return std::accumulate(values.begin(), values.end(), 0.) / double(values.size());
}

/// Of pixels that all show the same.
Variance patch_variance(const std::vector<double> &values) {
    const double mean = mean_of(values);
    double squares = 0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    squares /= double(values.size() - 1);
    return {squares, squares / (mean * mean)};
}

/// Of pixels of which there are two pictures with different seeds; relative as relMSE is.
Variance pair_variance(const std::vector<double> &a, const std::vector<double> &b) {
    const double least = .01 * mean_of(a) * mean_of(b);
    Variance sum;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double square = (a[i] - b[i]) * (a[i] - b[i]) / 2;
        sum.plain += square / double(a.size());
        sum.relative += square / (a[i] * b[i] + least) / double(a.size());
    }
    return sum;
}

/// One estimator's pictures of a scene: one of a flat patch, else two, to see how far they lie apart.
class Pictures {
  public:
    Pictures(const device::Device &device, const Scenario &scenario, const Estimator &estimator, std::uint32_t samples,
             const render::Options &options = {})
        : samples(samples) {
        for (std::uint32_t seed = 0; seed < (scenario.flat ? 1u : 2u); ++seed)
            sessions.push_back(
                std::make_unique<render::Session>(device, with(scenario.scene, estimator, seed), options));
    }

    /// Takes the samples and returns the kernels' seconds per sample. Again and again the same ones: the mean stays.
    /// Runs of some ten milliseconds lie a fifth apart.
    double render() {
        constexpr double enough = 0.1;
        double seconds = 0, count = 0;
        while (seconds < enough)
            for (const auto &session : sessions) {
                const render::Statistics before = session->statistics();
                session->render(samples);
                const render::Statistics after = session->statistics();
                seconds += after.sampling - before.sampling;
                count += double(after.samples - before.samples);
            }
        return seconds / count;
    }

    /// Of a sample.
    Variance variance() const {
        const std::vector<double> first = luminance(sessions[0]->picture());
        const Variance found =
            sessions.size() == 1 ? patch_variance(first) : pair_variance(first, luminance(sessions[1]->picture()));
        return {found.plain * samples, found.relative * samples};
    }

    double flights() const {
        const render::Statistics statistics = sessions[0]->statistics();
        return render::ratio(double(statistics[COUNTER_steps]), double(statistics[COUNTER_walks]));
    }

  private:
    std::uint32_t samples;
    std::vector<std::unique_ptr<render::Session>> sessions;
};

/// A picture with one sample for each pixel: where a white surface would show 1, a pixel is its walk's weight.
Weights weights_of(const device::Device &device, const Scenario &scenario, const Estimator &estimator) {
    scene::Scene scene = with(scenario.scene, estimator, 0);
    scene.image = {512, 512};
    render::Session session(device, scene, {});
    session.render(1);
    const io::Picture picture = session.picture();
    std::vector<float> weights;
    for (std::size_t i = 0; i < picture.pixels.size(); i += picture.channels.size())
        weights.push_back(std::max({picture.pixels[i], picture.pixels[i + 1], picture.pixels[i + 2]}));
    std::sort(weights.begin(), weights.end());
    return {double(weights.back()), double(weights[std::size_t(.9999 * double(weights.size()))])};
}

} // namespace

std::string name_of(const Estimator &estimator) {
    static const char *const guidings[] = {"none", "dwivedi", "eigen"};
    static const char *const samplings[] = {"single", "albedo", "throughput", "hero"};
    return std::string(guidings[estimator.guiding]) + "_" + samplings[estimator.sampling] +
           (estimator.control ? "_control" : "");
}

std::vector<Figures> measure(const device::Device &device, const Scenario &scenario,
                             std::span<const Estimator> estimators, std::uint32_t samples, int runs) {
    std::vector<Pictures> pictures;
    for (const Estimator &estimator : estimators) {
        pictures.emplace_back(device, scenario, estimator, samples);
        pictures.back().render(); // PoCL generates code, launches find their size
    }
    std::vector<std::vector<double>> seconds(pictures.size());
    for (int run = 0; run < runs; ++run)
        for (std::size_t i = 0; i < pictures.size(); ++i) seconds[i].push_back(pictures[i].render());
    std::vector<Figures> all;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const Variance variance = pictures[i].variance();
        Figures figures{estimators[i],     median(seconds[i]),    variance.plain,
                        variance.relative, pictures[i].flights(), {}};
        if (scenario.flat) figures.weights = weights_of(device, scenario, estimators[i]);
        all.push_back(figures);
    }
    return all;
}

double variance_of(const device::Device &device, const Scenario &scenario, const Estimator &estimator,
                   std::uint32_t samples) {
    render::Options options;
    options.definitions = "-DCAMERA_RAY_SAMPLES=1u"; // as beside control variates
    Pictures pictures(device, scenario, estimator, samples, options);
    pictures.render();
    return pictures.variance().plain;
}

} // namespace nacre::bench
