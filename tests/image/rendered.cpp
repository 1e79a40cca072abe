#include "image/rendered.h"
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace nacre {
namespace {

const device::Device &the_device() {
    static const device::Device device = device::open_device();
    return device;
}

} // namespace

float Rendered::at(int x, int y, std::size_t channel) const {
    return picture
        .pixels[(std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) * picture.channels.size() + channel];
}

scene::Scene scene_of(const std::string &json) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("nacre-scene-" + std::to_string(getpid()) + ".json");
    std::ofstream(file) << json;
    scene::Scene scene = io::load_scene(file);
    std::filesystem::remove(file);
    return scene;
}

std::vector<int> lane_counts() {
    if (the_device().quirks.work_group > 1) return {1};
    return {1, 4, 8, 16};
}

Rendered rendered(const scene::Scene &scene, const render::Options &options) {
    render::Session session(the_device(), scene, options);
    session.render(scene.render.spp);
    return {session.picture(), session.statistics()};
}

std::array<Mean, 3> covered_mean(const io::Picture &picture) {
    const std::size_t channels = picture.channels.size();
    std::array<Mean, 3> means;
    for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0, squares = 0, count = 0;
        for (std::size_t i = 0; i < picture.pixels.size(); i += channels) {
            if (picture.pixels[i + 3] != 1) continue;
            const double value = picture.pixels[i + c];
            sum += value;
            squares += value * value;
            count += 1;
        }
        means[c].value = sum / count;
        means[c].error = std::sqrt(std::max(0.0, squares / count - means[c].value * means[c].value) / (count - 1));
    }
    return means;
}

std::array<Mean, 3> rendered_to(scene::Scene scene, const std::array<double, 3> &largest_error) {
    std::array<Mean, 3> sum{};
    for (int rounds = 0;; ++scene.render.seed) {
        const std::array<Mean, 3> found = covered_mean(rendered(scene).picture);
        bool enough = true;
        for (std::size_t c = 0; c < 3; ++c) {
            sum[c].value += (found[c].value - sum[c].value) / (rounds + 1);
            sum[c].error = std::hypot(sum[c].error * rounds, found[c].error) / (rounds + 1);
            enough = enough && sum[c].error <= largest_error[c];
        }
        ++rounds;
        if (enough) return sum;
    }
}

void expect_same_pixels(const io::Picture &first, const io::Picture &second) {
    const auto &a = first.pixels, &b = second.pixels;
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(float)), 0)
        << std::count_if(a.begin(), a.end(), [&, i = std::size_t(0)](float v) mutable { return v != b[i++]; }) << " of "
        << a.size() << " numbers differ";
    EXPECT_GT(*std::max_element(a.begin(), a.end()), 0) << "a black picture shows nothing";
}

} // namespace nacre
