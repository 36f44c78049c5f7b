#include "accuracy/tolerance/Draws.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace dipwright {
namespace {

// Returns a normally distributed number, computed by the method of Box and Muller from two uniform
// numbers in (0, 1]. Does not use the standard library's distributions, because they differ between
// systems.
double normal(std::mt19937_64& random) {
    const auto even = [&] { return (double(random() >> 11) + 1) / 9007199254740992.0; };
    const double radius = std::sqrt(-2 * std::log(even()));
    return radius * std::cos(2 * std::numbers::pi * even());
}

} // namespace

Eigen::MatrixXd evenDraws(int dips, int quantities, int seed) {
    const int pairs = std::max((dips + 1) / 2, quantities);
    std::mt19937_64 random{std::uint64_t(seed)};
    Eigen::MatrixXd half(pairs, quantities);
    for (int row = 0; row < pairs; ++row) {
        for (int column = 0; column < quantities; ++column) {
            half(row, column) = normal(random);
        }
    }
    const Eigen::MatrixXd covariance = half.transpose() * half / pairs;
    const Eigen::MatrixXd factor = covariance.llt().matrixL();
    // Makes the covariance the identity matrix.
    half = factor.triangularView<Eigen::Lower>().solve(half.transpose()).transpose().eval();
    Eigen::MatrixXd draws(2 * pairs, quantities);
    draws << half, -half;
    return draws;
}

} // namespace dipwright
