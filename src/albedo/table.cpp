#include "albedo/table.h"
#include "albedo/table_axes.h"
#include <array>

namespace nacre::albedo {

extern "C" const char nacre_albedo_table_begin[], nacre_albedo_table_end[]; // table_data.cpp

namespace {

/// The nodes around a place on an axis and the weights of the polynomial through them (Lagrange's). The more there are,
/// the better for analytic functions: of bleed, similarities near white are not quite.
template <int count> struct Neighbours {
    int first;
    std::array<double, count> weight;
};

template <int count> Neighbours<count> neighbours(double at, int nodes) {
    Neighbours<count> found{std::clamp(int(at) - (count / 2 - 1), 0, nodes - count), {}};
    const double x = at - found.first;
    for (int i = 0; i < count; ++i) {
        double &weight = found.weight[std::size_t(i)] = 1;
        for (int j = 0; j < count; ++j)
            if (j != i) weight *= (x - j) / (i - j);
    }
    return found;
}

/// Slope at node i of the cubics through neighbours, made as flat as a monotone interpolant needs (Fritsch & Carlson
/// 1980, "Monotone Piecewise Cubic Interpolation": at most three times the lesser slope beside it).
double slope(const std::array<double, table_colors> &y, int i) {
    constexpr int last = table_colors - 1;
    double slope;
    if (i >= 2 && i <= last - 2)
        slope = (8 * (y[i + 1] - y[i - 1]) - (y[i + 2] - y[i - 2])) / 12;
    else if (i == 0)
        slope = (-11 * y[0] + 18 * y[1] - 9 * y[2] + 2 * y[3]) / 6;
    else if (i == 1)
        slope = (-2 * y[0] - 3 * y[1] + 6 * y[2] - y[3]) / 6;
    else if (i == last) // color is even about its last node, and white has a similarity of 0 that is not passed
        slope = 0;
    else
        slope = (2 * y[last] + 3 * y[last - 1] - 6 * y[last - 2] + y[last - 3]) / 6;
    const double before = i > 0 ? y[i] - y[i - 1] : y[1] - y[0], after = i < last ? y[i + 1] - y[i] : before;
    return std::clamp(slope, 3 * std::min(std::max(before, after), 0.0), 0.0);
}

} // namespace

std::span<const float> built_in_table() {
    static const std::vector<float> table =
        read_table({nacre_albedo_table_begin, std::size_t(nacre_albedo_table_end - nacre_albedo_table_begin)});
    return table;
}

double table_similarity(std::span<const float> table, double color, double g, double bleed, shared::FlightLaw law,
                        shared::Entry entry) {
    if (color <= 0) return 1;
    if (color >= 1) return 0;
    bleed = std::clamp(bleed, 0.0, largest_bleed);
    const auto across_g = neighbours<8>(node_of_anisotropy(g), table_anisotropies);
    const auto across_bleed = neighbours<6>(node_of_bleed(bleed), table_bleeds);
    std::array<double, table_colors> column{};
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 6; ++j) {
            const float *known = table.data() + table_index(law, entry, across_g.first + i, across_bleed.first + j);
            const double weight = across_g.weight[std::size_t(i)] * across_bleed.weight[std::size_t(j)];
            for (std::size_t c = 0; c < table_colors; ++c) column[c] += weight * known[c];
        }
    const double at = node_of_color(color);
    const int i = std::min(int(at), table_colors - 2);
    const double x = at - i, x2 = x * x, x3 = x2 * x; // Hermite's cubic
    const double value = (1 - 3 * x2 + 2 * x3) * column[std::size_t(i)] + (x - 2 * x2 + x3) * slope(column, i) +
                         (3 * x2 - 2 * x3) * column[std::size_t(i) + 1] + (x3 - x2) * slope(column, i + 1);
    return std::pow(std::clamp(value, 0.0, 1.0), table_power(bleed, law));
}

} // namespace nacre::albedo
