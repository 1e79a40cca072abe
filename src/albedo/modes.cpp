#include "albedo/modes.h"
#include <Eigen/Dense>

// Collision densities per ordinate, c+ inwards and c- outwards, obey v dc+/dz + c+ = (albedo / 2) sum w (p_same c+ +
// p_opposite c-), with v the mean depth, and the same with -z outwards. Their sum e and difference o, times sqrt(w),
// obey
//     v do/dz = -S_e e,  v de/dz = -S_o o,  S = 1 - (albedo / 2) sqrt(w) (p_same +- p_opposite) sqrt(w).
// With S = C C^T, e = C_e^-T x, o = C_o^-T y a decay exp(-rate z) is  rate y = B x,  rate x = B^T y,
// B = C_o^T v^-1 C_e: a singular value of B with its vectors.
namespace nacre::albedo {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

MatrixXd factor(const Ordinates &ordinates, const MatrixXd &phase, double albedo) {
    const Index n = ordinates.cosines();
    const VectorXd root = ordinates.weight.cwiseSqrt();
    MatrixXd s(ordinates.size(), ordinates.size());
    for (Index a = 0; a < s.rows(); a += n)
        for (Index b = 0; b < s.cols(); b += n)
            s.block(a, b, n, n) =
                -0.5 * albedo * (root.segment(a, n).asDiagonal() * phase * root.segment(b, n).asDiagonal());
    s.diagonal().array() += 1;
    return s.llt().matrixL();
}

struct SingularVectors {
    MatrixXd left, right;
    VectorXd values;
};

/// Eigen's divide and conquer gives wrong vectors for one matrix in some thousands, which put a colour off by .009.
/// They do not give the matrix back: slower rotations then find the right ones.
SingularVectors singular_vectors(const MatrixXd &b) {
    const Eigen::BDCSVD<MatrixXd> fast(b, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const MatrixXd residual = b * fast.matrixV() - fast.matrixU() * fast.singularValues().asDiagonal();
    if (residual.norm() < 1e-10 * b.norm()) return {fast.matrixU(), fast.matrixV(), fast.singularValues()};
    const Eigen::JacobiSVD<MatrixXd> slow(b, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return {slow.matrixU(), slow.matrixV(), slow.singularValues()};
}

} // namespace

Modes modes_of(const Ordinates &ordinates, double albedo) {
    const MatrixXd even = factor(ordinates, ordinates.phase.same + ordinates.phase.opposite, albedo);
    const MatrixXd odd = factor(ordinates, ordinates.phase.same - ordinates.phase.opposite, albedo);
    const SingularVectors found =
        singular_vectors(odd.transpose() * (ordinates.depth.cwiseInverse().asDiagonal() * even));
    return {found.values, even.transpose().triangularView<Eigen::Upper>().solve(found.right),
            odd.transpose().triangularView<Eigen::Upper>().solve(found.left)};
}

Reflectance reflectance_by_modes(const Ordinates &ordinates, double albedo) {
    const Modes modes = modes_of(ordinates, albedo);
    const MatrixXd &e = modes.even, &o = modes.odd;
    // What leaves for what enters: (e - o) (e + o)^-1 in sqrt(w) c, and a current is w v c.
    const VectorXd current = ordinates.weight.cwiseSqrt().cwiseProduct(ordinates.depth);
    const VectorXd out = (e + o).transpose().partialPivLu().solve((e - o).transpose() * current);
    const VectorXd reflected = out.cwiseQuotient(current);
    return {ordinates.lambert.dot(reflected), ordinates.uniform.dot(reflected)};
}

} // namespace nacre::albedo
