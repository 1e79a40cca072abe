#include "patch/survey.h"
#include "albedo/half_space.h"
#include "base/error.h"
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

namespace nacre::patch {
namespace {

using namespace shared;

constexpr int anisotropies = 40, albedos = 40;
constexpr double largest_anisotropy = 0.95;
constexpr double error = 1e-3;
constexpr const char *title = "g,albedo,color,standard_error";

double anisotropy_at(int i) { return largest_anisotropy * i / (anisotropies - 1); }

/// From dark to bright; the brightest colour is above .95 at any g. Brighter ones take minutes a patch where g > .9.
double albedo_at(int j, double g) { return albedo::albedo_of(std::lerp(0.98, 0.02, j / (albedos - 1.0)), g); }

using Known = std::map<std::pair<int, int>, Survey::Point>; // by the indices of g and albedo

Known read_known(const std::filesystem::path &file) {
    Known known;
    std::ifstream in(file);
    std::string line;
    if (!in || !std::getline(in, line)) return known;
    if (line != title) input_error(file.string(), "is no survey of albedos; name another file, or remove it");
    while (std::getline(in, line)) {
        std::istringstream fields(line);
        Survey::Point point{};
        char comma = 0;
        int i = 0, j = 0;
        if (fields >> point.g >> comma >> point.albedo >> comma >> point.color >> comma >> point.error)
            for (i = 0; i < anisotropies; ++i)
                for (j = 0; j < albedos; ++j)
                    if (std::abs(anisotropy_at(i) - point.g) < 1e-9 &&
                        std::abs(albedo_at(j, anisotropy_at(i)) - point.albedo) < 1e-9)
                        known[{i, j}] = point;
    }
    return known;
}

} // namespace

Survey survey_albedos(const device::Device &device, const std::filesystem::path &file,
                      const std::function<void(double)> &report) {
    Known known = read_known(file);
    std::ofstream out(file, std::ios::app);
    if (!out) throw Error(Exit::output, file.string(), "cannot be written; name another file");
    if (out.tellp() == 0) out << title << '\n';
    for (int i = 0; i < anisotropies; ++i)
        for (int j = 0; j < albedos; j += 3) { // a picture has three channels
            report(double(i * albedos + j) / (anisotropies * albedos));
            const double g = anisotropy_at(i);
            std::array<int, 3> index;
            scene::Material material;
            material.inversion = INVERSION_NONE;
            material[PARAMETER_subsurface_scatter_anisotropy].value = Vec3::Constant(g);
            for (int c = 0; c < 3; ++c) {
                index[std::size_t(c)] = std::min(j + c, albedos - 1);
                material[PARAMETER_subsurface_color].value[c] = albedo_at(index[std::size_t(c)], g);
            }
            if (known.contains({i, index[0]}) && known.contains({i, index[1]}) && known.contains({i, index[2]}))
                continue;
            const Color color = measure(device, material, error);
            for (std::size_t c = 0; c < 3; ++c) {
                const Survey::Point point{g, albedo_at(index[c], g), color.value[c], color.error[c]};
                if (!known.try_emplace({i, index[c]}, point).second) continue;
                out << fmt::format("{:.12g},{:.12g},{:.7f},{:.2e}\n", point.g, point.albedo, point.color, point.error);
            }
            if (!out.flush()) throw Error(Exit::output, file.string(), "cannot be written; is the disk full?");
        }
    Survey survey;
    for (const auto &[place, point] : known) survey.points.push_back(point);
    return survey;
}

} // namespace nacre::patch
