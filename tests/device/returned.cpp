// Tables of what half-spaces return (src/render/returned.cpp), as kernels read them.
#include "albedo/returned.h"
#include "albedo/half_space.h"
#include "base/legendre.h"
#include "device/buffer.h"
#include "device/program.h"
#include "device/recorder.h"
#include "render/convert.h"
#include "render/returned.h"
#include "shared/features.h"
#include <gtest/gtest.h>
#include <random>

namespace nacre::test {
namespace {

using namespace shared;

struct Error {
    double mean = 0, square = 0, largest = 0;
};

/// Of the shares that the kernel finds at random points in media of these colours.
Error error_of(double g, double bleed, const Vec3 &albedo, bool textured) {
    static const auto *const device = new device::Device(device::open_device());
    scene::Scene scene;
    scene::Material &source = scene.materials.emplace_back();
    source[PARAMETER_subsurface_scatter_anisotropy].value.setConstant(g);
    source[PARAMETER_subsurface_bleed].value.setConstant(bleed);
    render::Geometry geometry;
    geometry.objects.emplace_back(Object{});
    std::vector<Material> materials(1);
    materials[0].albedo = render::to_float4(albedo);
    materials[0].albedo_source = textured ? ALBEDO_TABLE : ALBEDO_FIXED;
    std::vector<float> tables;
    render::add_returned(scene, geometry, g == 0, materials, tables);

    constexpr cl_uint count = 20000;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0, 1);
    std::vector<float4> points(count);
    for (float4 &p : points) {
        const float a = float(albedo[0]);
        const float depth = 40 * std::pow(unit(random), 3.f) / float(1 - g), cosine = 2 * unit(random) - 1;
        p = {a, float(g), depth, cosine};
    }
    device::Variant variant;
    variant.entry = "probe_guide.cl";
    variant.features = FEATURE_SUBSURFACE | FEATURE_GUIDE_EIGEN | FEATURE_CONTROL | (g != 0 ? FEATURE_ANISOTROPY : 0);
    Frame frame{};
    frame.features = variant.features;
    const cl::Buffer frames = device::constant_buffer(*device, &frame, sizeof frame);
    const cl::Buffer table = device::constant_buffer(*device, tables.data(), tables.size() * sizeof(float));
    const cl::Buffer at = device::constant_buffer(*device, points.data(), points.size() * sizeof(float4));
    const cl::Buffer out(device->context, CL_MEM_WRITE_ONLY, count * sizeof(float));
    cl::Kernel kernel(device::build(*device, variant).program, "probe_returned");
    kernel.setArg(0, frames);
    kernel.setArg(1, table);
    kernel.setArg(2, materials[0].returned_first[0]);
    kernel.setArg(3, at);
    kernel.setArg(4, count);
    kernel.setArg(5, out);
    device::Recorder(nullptr).run(*device, kernel, count);
    std::vector<float> found(count);
    device->queue.enqueueReadBuffer(out, true, 0, count * sizeof(float), found.data());

    const albedo::Returned exact(albedo::Ordinates(g, bleed, FLIGHT_RENEWAL, bleed > 0 ? 8 : 32, 1e-6), g,
                                 double(float(albedo[0])));
    Error error;
    for (cl_uint i = 0; i < count; ++i) {
        const Eigen::VectorXd moments = exact.moments(double(points[i].z));
        const double e = double(found[i]) - moments.dot(legendre(double(points[i].w), moments.size()));
        error.mean += e / count;
        error.square += e * e / count;
        error.largest = std::max(error.largest, std::abs(e));
    }
    return error;
}

// Errors of single shares are some 1e-4, near the surface some 1e-3, twice that at g = .9, and have no mean.
TEST(ReturnedTables, AreWhatReturns) {
    for (const double g : {0., .5, .8, -.5, .9})
        for (const double similarity : {.02, .13, .36, .8, 1.})
            for (const bool textured : {false, true}) {
                const Vec3 albedo = Vec3::Constant(std::max(1e-6, albedo::albedo_of(similarity, g)));
                const Error error = error_of(g, 0, albedo, textured);
                SCOPED_TRACE(testing::Message() << "g " << g << ", similarity " << similarity);
                EXPECT_LT(std::abs(error.mean), 5e-5);
                EXPECT_LT(std::sqrt(error.square), g < .9 ? 3e-4 : 6e-4);
                EXPECT_LT(error.largest, g < .9 ? 5e-3 : 1e-2);
            }
}

TEST(ReturnedTables, HoldBleed) {
    for (const double g : {0., .8})
        for (const double similarity : {.05, .5}) {
            const Error error = error_of(g, .5, Vec3::Constant(albedo::albedo_of(similarity, g)), false);
            SCOPED_TRACE(testing::Message() << "g " << g << ", similarity " << similarity);
            EXPECT_LT(std::abs(error.mean), 5e-5);
            EXPECT_LT(std::sqrt(error.square), 3e-4);
        }
}

} // namespace
} // namespace nacre::test
