#include "albedo/ordinates.h"
#include <Eigen/Dense>
#include <fmt/format.h>
#include <stdexcept>

// A flight that enters in state j leaves in state i with probability w_i r_ij / v_j (w weights, v mean depths), r
// symmetric. That one layer more changes nothing means
//     (1 / v_i + 1 / v_j) r_ij = (albedo / 2) [p_opposite + t p_same + (t p_same)^T + t p_opposite t^T]_ij,
// where t sums r w / v over extinctions: all that the right side needs of r.
namespace nacre::albedo {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

class Imbedding {
  public:
    Imbedding(const Ordinates &ordinates, double albedo)
        : ordinates(ordinates), albedo(albedo), n(ordinates.cosines()), rate(ordinates.depth.cwiseInverse()),
          collisions(ordinates.weight.cwiseProduct(rate)) {}

    /// Calls f(a, b, r) with the block of r between the states of extinctions a and b, for all a <= b.
    template <typename F> void for_blocks(const MatrixXd &t, const F &f) const {
        const MatrixXd same = t * ordinates.phase.same, opposite = t * ordinates.phase.opposite;
        MatrixXd r(n, n);
        for (Index a = 0; a < t.rows(); a += n)
            for (Index b = a; b < t.rows(); b += n) {
                r = ordinates.phase.opposite + same.middleRows(a, n) + same.middleRows(b, n).transpose();
                r.noalias() += opposite.middleRows(a, n) * t.middleRows(b, n).transpose();
                for (Index j = 0; j < n; ++j)
                    r.col(j).array() *= 0.5 * albedo / (rate.segment(a, n).array() + rate[b + j]);
                f(a, b, r);
            }
    }

    MatrixXd next(const MatrixXd &t) const {
        MatrixXd sum = MatrixXd::Zero(t.rows(), n);
        for_blocks(t, [&](Index a, Index b, const MatrixXd &r) {
            sum.middleRows(a, n) += r * collisions.segment(b, n).asDiagonal();
            if (a != b) sum.middleRows(b, n) += r.transpose() * collisions.segment(a, n).asDiagonal();
        });
        return sum;
    }

    Reflectance reflectance(const MatrixXd &t) const {
        VectorXd left = VectorXd::Zero(t.rows()); // sum over i of w_i r_ij
        for_blocks(t, [&](Index a, Index b, const MatrixXd &r) {
            left.segment(b, n) += r.transpose() * ordinates.weight.segment(a, n);
            if (a != b) left.segment(a, n) += r * ordinates.weight.segment(b, n);
        });
        left = left.cwiseProduct(rate);
        return {ordinates.lambert.dot(left), ordinates.uniform.dot(left)};
    }

  private:
    const Ordinates &ordinates;
    double albedo;
    Index n;
    VectorXd rate, collisions;
};

} // namespace

Reflectance reflectance_by_imbedding(const Ordinates &ordinates, double albedo, MatrixXd &moments) {
    constexpr int memory = 20, limit = 2000;
    constexpr double tolerance = 1e-10;
    const Imbedding imbedding(ordinates, albedo);
    if (moments.size() == 0) moments = MatrixXd::Zero(ordinates.size(), ordinates.cosines());
    const Index size = moments.size();
    // Fixed-point iteration with Anderson's acceleration (1965): the next point from the last ones and their residuals,
    // weighted with how often a state occurs.
    const VectorXd importance = ordinates.weight.cwiseSqrt().replicate(ordinates.cosines(), 1);
    MatrixXd steps(size, memory), changes(size, memory);
    VectorXd last, last_residual;
    for (int i = 0;; ++i) {
        if (i == limit) throw std::runtime_error(fmt::format("imbedding: no convergence at albedo {}", albedo));
        const MatrixXd image = imbedding.next(moments);
        const VectorXd point = moments.reshaped(), residual = image.reshaped() - point;
        if (residual.cwiseAbs().maxCoeff() < tolerance) break;
        VectorXd next = image.reshaped();
        if (i > 0) {
            const Index column = (i - 1) % memory, known = std::min(i, memory);
            steps.col(column) = point - last;
            changes.col(column) = residual - last_residual;
            const MatrixXd weighted = importance.asDiagonal() * changes.leftCols(known);
            const VectorXd factors = weighted.householderQr().solve(importance.cwiseProduct(residual));
            next -= (steps.leftCols(known) + changes.leftCols(known)) * factors;
        }
        last = point;
        last_residual = residual;
        moments = next.reshaped(moments.rows(), moments.cols());
    }
    return imbedding.reflectance(moments);
}

} // namespace nacre::albedo
