#include "render/returned_layer.h"
#include "base/legendre.h"
#include <cmath>

namespace nacre::render {
namespace {

using Eigen::Index;

/// Lowers nodes, by row and between the first and the last, by what straight lines between the true ones lie above a
/// curve in the mean: h^2 / 12 times its second derivative on either side.
void settle(Rows &nodes, const std::vector<double> &at) {
    const Rows true_nodes = nodes;
    for (Index i = 1; i + 1 < nodes.rows(); ++i) {
        const std::size_t k = std::size_t(i);
        const double below = at[k] - at[k - 1], above = at[k + 1] - at[k];
        const auto slope =
            (true_nodes.row(i + 1) - true_nodes.row(i)) / above - (true_nodes.row(i) - true_nodes.row(i - 1)) / below;
        nodes.row(i) -= slope * ((below * below + above * above) / (12 * (below + above)));
    }
}

} // namespace

albedo::Ordinates returned_ordinates(double g, double bleed, shared::FlightLaw law) {
    const bool forward = std::abs(g) > 0.8;
    return {g, bleed, law, bleed > 0 ? (forward ? 12 : 8) : (forward ? 32 : 12), 1e-6};
}

Rows returned_layer(const albedo::Returned &returned, const std::vector<double> &depths, Index cosines) {
    constexpr double least_share = 1e-30;
    std::vector<double> cosine;
    for (Index i = 0; i < cosines; ++i) cosine.push_back(cosines > 1 ? 2.0 * double(i) / double(cosines - 1) - 1 : 0);
    const Index terms = returned.moments(0).size();
    Rows moments(Index(depths.size()), terms), polynomials(terms, cosines);
    for (Index i = 0; i < moments.rows(); ++i) moments.row(i) = returned.moments(depths[std::size_t(i)]);
    for (Index i = 0; i < cosines; ++i) polynomials.col(i) = legendre(cosine[std::size_t(i)], terms);
    Rows layer = (moments * polynomials).cwiseMax(least_share).array().log();
    settle(layer, depths);
    Rows across = layer.transpose();
    settle(across, cosine);
    return across.transpose();
}

} // namespace nacre::render
