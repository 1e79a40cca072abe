#include "device/diffusion_probe.h"
#include "device/program.h"
#include "shared/features.h"
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace nacre::test {
namespace {

using namespace shared;

static_assert(sizeof(DiffusionProbe) == 64, "as in probe_diffusion.cl");

// Never released, as in probe.cpp.
const device::Device &the_device() {
    static const auto *const device = new device::Device(device::open_device());
    return *device;
}

const cl::Program &the_program() {
    static const auto *const program = [] {
        device::Variant variant;
        variant.entry = "probe_diffusion.cl";
        variant.features = FEATURE_SUBSURFACE | FEATURE_DIFFUSION_MODEL | FEATURE_ANISOTROPY;
        return new cl::Program(device::build(the_device(), variant).program);
    }();
    return *program;
}

constexpr double pi = std::numbers::pi;

} // namespace

std::vector<float> run_diffusion(const char *name, const DiffusionProbe &probe, std::size_t width,
                                 const std::vector<float> &initial) {
    const device::Device &device = the_device();
    const cl::Buffer out(device.context, CL_MEM_READ_WRITE, probe.count * width * sizeof(float));
    if (!initial.empty()) device.queue.enqueueWriteBuffer(out, true, 0, initial.size() * sizeof(float), initial.data());
    cl::Kernel kernel(the_program(), name);
    kernel.setArg(0, sizeof probe, &probe);
    kernel.setArg(1, out);
    const std::size_t group = std::size_t(device.quirks.work_group);
    device.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange((probe.count + group - 1) / group * group),
                                      cl::NDRange(group));
    std::vector<float> values(probe.count * width);
    device.queue.enqueueReadBuffer(out, true, 0, values.size() * sizeof(float), values.data());
    return values;
}

// D: Jensen et al. 2001 below eq 2; d'Eon 2012 with Grosjean's (2 sigma_a + sigma_s') / (3 sigma_t'^2).
double ExactProfile::diffusion() const { return model == MODEL_DIPOLE ? 1.0 / 3 : (2 - reduced_albedo) / 3; }
double ExactProfile::decay() const { return std::sqrt((1 - reduced_albedo) / diffusion()); }
double ExactProfile::depth() const { return 1 + 4 * diffusion(); }

double ExactProfile::reflectance(double r) const {
    if (model == MODEL_BURLEY) {
        const double s = 1.9 - color + 3.5 * std::pow(color - .8, 2);
        return color * s * (std::exp(-s * r) + std::exp(-s * r / 3)) / (8 * pi * r);
    }
    const double k = decay(), dr = std::hypot(r, 1), dv = std::hypot(r, depth());
    const double flux = (1 + k * dr) * std::exp(-k * dr) / std::pow(dr, 3) +
                        depth() * (1 + k * dv) * std::exp(-k * dv) / std::pow(dv, 3);
    if (model == MODEL_DIPOLE) return reduced_albedo / (4 * pi) * flux;
    const double fluence = (std::exp(-k * dr) / dr - std::exp(-k * dv) / dv) / diffusion();
    return std::pow(reduced_albedo, 2) / (4 * pi) * (flux / 2 + fluence / 4);
}

double ExactProfile::within(double r) const {
    if (model == MODEL_BURLEY) return color * drawn_within(r);
    const double k = decay(), dr = std::hypot(r, 1), dv = std::hypot(r, depth());
    const auto up_to = [&](double z, double d) { return std::exp(-k * z) - z * std::exp(-k * d) / d; };
    const double flux = up_to(1, dr) + up_to(depth(), dv);
    if (model == MODEL_DIPOLE) return reduced_albedo / 2 * flux;
    const auto primitive = [&](double z, double d) {
        return k > 0 ? (std::exp(-k * z) - std::exp(-k * d)) / k : d - z;
    };
    const double fluence = (primitive(1, dr) - primitive(depth(), dv)) / diffusion();
    return std::pow(reduced_albedo, 2) / 2 * (flux / 2 + fluence / 4);
}

double ExactProfile::total() const { return within(1e8); }

double ExactProfile::drawn_within(double r) const {
    if (model == MODEL_BURLEY) {
        const double s = 1.9 - color + 3.5 * std::pow(color - .8, 2);
        return 1 - std::exp(-s * r) / 4 - 3 * std::exp(-s * r / 3) / 4;
    }
    const double k = decay(), dr = std::hypot(r, 1), dv = std::hypot(r, depth());
    return 1 - (std::exp(-k * dr) / dr + depth() * std::exp(-k * dv) / dv) / (std::exp(-k) + std::exp(-k * depth()));
}

std::string ExactProfile::name() const {
    return fmt::format("model {}, reduced albedo {}, color {}", model, reduced_albedo, color);
}

// Integral of 2 mu p(mu, -mu') mu' / (mu + mu') over both cosines, midpoints after mu = t^2 (3 - 2t), which is kind to
// the ends.
double exact_single_scattering(double g) {
    constexpr int n = 100, around = 256;
    double sum = 0;
    const auto mu_of = [](double t) { return t * t * (3 - 2 * t); };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double t = (i + .5) / n, u = (j + .5) / n, mu = mu_of(t), out = mu_of(u);
            double phase = 0; // per cosine
            for (int k = 0; k < around; ++k) {
                const double azimuth = (k + .5) / around * pi;
                const double cosine = -mu * out + std::sqrt((1 - mu * mu) * (1 - out * out)) * std::cos(azimuth);
                phase += (1 - g * g) / std::pow(1 + g * g - 2 * g * cosine, 1.5) / (2 * around);
            }
            sum += 2 * mu * phase * out / (mu + out) * 36 * t * (1 - t) * u * (1 - u) / (n * n);
        }
    return sum;
}

} // namespace nacre::test
