#include "patch/fit.h"
#include "albedo/half_space.h"
#include "base/parallel.h"
#include <ceres/ceres.h>
#include <cmath>
#include <map>
#include <memory>

namespace nacre::patch {
namespace {

using albedo::MemoFit, albedo::Polynomial, albedo::ExponentialOfPolynomial;
using Six = std::array<double, 6>; // A .. F of eq 6

/// Eq 6.
template <typename T> T curve(double x, const T &a, const T &b, const T &c, const T &d, const T &e, const T &f) {
    using std::atan, std::pow;
    const double blend = std::pow(x, 0.25);
    return (1 - blend) * a * pow(atan(b * x), c) + blend * d * pow(atan(e * x), f);
}

/// Eq 7 of 8 coefficients.
template <typename T> T polynomial(const T *p, double g) {
    T sum(0);
    for (int i = 7; i >= 0; --i) sum = sum * g + p[i];
    return sum;
}

/// Eq 8 of 9: offset, factor, and 7 of the exponent.
template <typename T> T exponential(const T *p, double g) {
    using std::exp;
    T sum(0);
    for (int i = 8; i >= 2; --i) sum = (sum + p[i]) * g;
    return p[0] + p[1] * exp(sum);
}

/// Eq 6 less the albedo, in colour: times the slope of colour by albedo.
struct CurveResidual {
    double x, albedo, slope;
    template <typename T> bool operator()(const T *p, T *residual) const {
        residual[0] = slope * (curve(x, p[0], p[1], p[2], p[3], p[4], p[5]) - albedo);
        return true;
    }
};

/// Keeps a parameter near that of the last g: curves of six parameters have many fits alike, and polynomials of g are
/// to go through them. Of .003, .01, .03 and .1 this one leaves the least error after the second stage.
struct SmoothResidual {
    int parameter;
    double last;
    template <typename T> bool operator()(const T *p, T *residual) const {
        residual[0] = smoothness * (p[parameter] / last - 1.0);
        return true;
    }
    static constexpr double smoothness = 0.03;
};

/// What the first stage finds for one g, and a triangle R: parameters that differ by d change the colours of all points
/// by |R d|, root of the sum of squares.
struct Tuple {
    Six value;
    Eigen::Matrix<double, 6, 6> sensitivity;
};

/// Eqs 7 and 8 less the parameters of one g, in colour.
struct TupleResidual {
    double g;
    Tuple tuple;
    template <typename T>
    bool operator()(const T *a, const T *b, const T *c, const T *d, const T *e, const T *f, T *residual) const {
        const T off[] = {polynomial(a, g) - tuple.value[0],  exponential(b, g) - tuple.value[1],
                         polynomial(c, g) - tuple.value[2],  polynomial(d, g) - tuple.value[3],
                         exponential(e, g) - tuple.value[4], polynomial(f, g) - tuple.value[5]};
        for (int i = 0; i < 6; ++i) {
            residual[i] = T(0);
            for (int k = i; k < 6; ++k) residual[i] += tuple.sensitivity(i, k) * off[k];
        }
        return true;
    }
};

struct ExponentialResidual {
    double g, value;
    template <typename T> bool operator()(const T *p, T *residual) const {
        residual[0] = exponential(p, g) / value - 1.0;
        return true;
    }
};

/// Eq 9 less the albedo, in colour: times the slope of colour by albedo.
struct ColorResidual {
    double x, g, albedo, slope;
    template <typename T>
    bool operator()(const T *a, const T *b, const T *c, const T *d, const T *e, const T *f, T *residual) const {
        residual[0] = slope * (curve(x, polynomial(a, g), exponential(b, g), polynomial(c, g), polynomial(d, g),
                                     exponential(e, g), polynomial(f, g)) -
                               albedo);
        return true;
    }
};

void solve(ceres::Problem &problem) {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.max_num_iterations = 2000;
    options.function_tolerance = 1e-12;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
}

using Column = std::vector<Survey::Point>; // of one g, by albedo
std::vector<Column> columns_of(const Survey &survey) {
    std::map<double, Column> columns;
    for (const Survey::Point &point : survey.points)
        if (point.color > 2 * point.error) columns[point.g].push_back(point); // darker ones are noise
    std::vector<Column> sorted;
    for (auto &[g, column] : columns) sorted.push_back(std::move(column));
    return sorted;
}

/// Of colour by albedo, at a column's i-th point.
double slope_at(const Column &column, std::size_t i) {
    const Survey::Point &before = column[i > 0 ? i - 1 : 0], &after = column[std::min(i + 1, column.size() - 1)];
    return (after.color - before.color) / (after.albedo - before.albedo);
}

Tuple fit_curve(const Column &column, const Six &last) {
    Tuple tuple{last, {}};
    std::vector<std::unique_ptr<ceres::CostFunction>> costs;
    for (std::size_t i = 0; i < column.size(); ++i)
        costs.push_back(std::make_unique<ceres::AutoDiffCostFunction<CurveResidual, 1, 6>>(
            new CurveResidual{column[i].color, column[i].albedo, slope_at(column, i)}));
    ceres::Problem::Options borrow;
    borrow.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem problem(borrow);
    for (const auto &cost : costs) problem.AddResidualBlock(cost.get(), nullptr, tuple.value.data());
    std::vector<std::unique_ptr<ceres::CostFunction>> ties;
    for (int i = 0; i < 6; ++i) {
        ties.push_back(std::make_unique<ceres::AutoDiffCostFunction<SmoothResidual, 1, 6>>(
            new SmoothResidual{i, last[std::size_t(i)]}));
        problem.AddResidualBlock(ties.back().get(), nullptr, tuple.value.data());
        problem.SetParameterLowerBound(tuple.value.data(), i, 1e-3);
    }
    solve(problem);
    Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor> slopes(Eigen::Index(costs.size()), 6);
    for (std::size_t i = 0; i < costs.size(); ++i) {
        const double *at = tuple.value.data();
        double residual = 0, *row = slopes.row(Eigen::Index(i)).data();
        costs[i]->Evaluate(&at, &residual, &row);
    }
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr{Eigen::MatrixXd(slopes)};
    tuple.sensitivity = qr.matrixQR().topRows<6>().triangularView<Eigen::Upper>();
    return tuple;
}

Polynomial fit_polynomial(const std::vector<double> &g, const std::vector<double> &values) {
    Eigen::MatrixXd powers(Eigen::Index(g.size()), 8);
    for (Eigen::Index i = 0; i < powers.rows(); ++i)
        for (int k = 0; k < 8; ++k) powers(i, k) = std::pow(g[std::size_t(i)], k);
    const Eigen::VectorXd found =
        powers.colPivHouseholderQr().solve(Eigen::Map<const Eigen::VectorXd>(values.data(), powers.rows()));
    Polynomial p;
    std::copy(found.begin(), found.end(), p.begin());
    return p;
}

std::array<double, 9> flat(const ExponentialOfPolynomial &p) {
    std::array<double, 9> all{p.offset, p.factor};
    std::copy(p.power.begin(), p.power.end(), all.begin() + 2);
    return all;
}

ExponentialOfPolynomial exponential_of(const std::array<double, 9> &all) {
    ExponentialOfPolynomial p{all[0], all[1], {}};
    std::copy(all.begin() + 2, all.end(), p.power.begin());
    return p;
}

ExponentialOfPolynomial fit_exponential(const std::vector<double> &g, const std::vector<double> &values,
                                        const ExponentialOfPolynomial &start) {
    std::array<double, 9> p = flat(start);
    ceres::Problem problem;
    for (std::size_t i = 0; i < g.size(); ++i)
        problem.AddResidualBlock(
            new ceres::AutoDiffCostFunction<ExponentialResidual, 1, 9>(new ExponentialResidual{g[i], values[i]}),
            nullptr, p.data());
    solve(problem);
    return exponential_of(p);
}

/// Minimises what `add` makes of the coefficients of eq 9: it is given the problem and the six sets of them.
template <typename F> MemoFit fit_coefficients(MemoFit fit, const F &add) {
    std::array<double, 9> b = flat(fit.b), e = flat(fit.e);
    ceres::Problem problem;
    add(problem, fit.a.data(), b.data(), fit.c.data(), fit.d.data(), e.data(), fit.f.data());
    solve(problem);
    fit.b = exponential_of(b);
    fit.e = exponential_of(e);
    return fit;
}

} // namespace

FitError fit_error(const MemoFit &fit) {
    constexpr int anisotropies = 20, colors = 100;
    std::array<double, anisotropies> largest{}, sum{};
    parallel_for(anisotropies, [&](std::size_t i) {
        const double g = 0.95 * double(i) / (anisotropies - 1);
        const albedo::HalfSpace medium(g, 0, shared::FLIGHT_RENEWAL);
        for (int j = 0; j < colors; ++j) {
            const double x = 0.002 + 0.997 * j / (colors - 1);
            const double a = std::clamp(albedo::memo_albedo(fit, x, g), 0.0, 1.0);
            const double error = std::abs(medium.color(std::sqrt((1 - a) / (1 - g * a)), shared::ENTRY_LAMBERT) - x);
            largest[i] = std::max(largest[i], error);
            sum[i] += error;
        }
    });
    FitError error{};
    for (int i = 0; i < anisotropies; ++i) {
        error.largest = std::max(error.largest, largest[std::size_t(i)]);
        error.mean += sum[std::size_t(i)] / (anisotropies * colors);
    }
    return error;
}

MemoFit fit_in_two_stages(const Survey &survey, const MemoFit &start) {
    const std::array<double, 9> b = flat(start.b), e = flat(start.e);
    Six last = {start.a[0], exponential(b.data(), 0), start.c[0], start.d[0], exponential(e.data(), 0), start.f[0]};
    std::vector<double> g;
    std::vector<Tuple> tuples;
    std::array<std::vector<double>, 6> values;
    for (const Column &column : columns_of(survey)) {
        g.push_back(column[0].g);
        tuples.push_back(fit_curve(column, last));
        last = tuples.back().value;
        for (std::size_t i = 0; i < 6; ++i) values[i].push_back(last[i]);
    }
    // Each parameter by itself is where the second stage begins: from elsewhere it ends in another minimum.
    const MemoFit alone = {fit_polynomial(g, values[0]),           fit_exponential(g, values[1], start.b),
                           fit_polynomial(g, values[2]),           fit_polynomial(g, values[3]),
                           fit_exponential(g, values[4], start.e), fit_polynomial(g, values[5])};
    return fit_coefficients(alone, [&](ceres::Problem &problem, auto... sets) {
        for (std::size_t i = 0; i < g.size(); ++i)
            problem.AddResidualBlock(
                new ceres::AutoDiffCostFunction<TupleResidual, 6, 8, 9, 8, 8, 9, 8>(new TupleResidual{g[i], tuples[i]}),
                nullptr, sets...);
    });
}

MemoFit fit_jointly(const Survey &survey, const MemoFit &start) {
    return fit_coefficients(start, [&](ceres::Problem &problem, auto... sets) {
        for (Column column : columns_of(survey)) {
            column.push_back({column[0].g, 1, 1, 0}); // what scatters all is white, without a render
            for (std::size_t i = 0; i < column.size(); ++i)
                problem.AddResidualBlock(
                    new ceres::AutoDiffCostFunction<ColorResidual, 1, 8, 9, 8, 8, 9, 8>(
                        new ColorResidual{column[i].color, column[i].g, column[i].albedo, slope_at(column, i)}),
                    nullptr, sets...);
        }
    });
}

} // namespace nacre::patch
