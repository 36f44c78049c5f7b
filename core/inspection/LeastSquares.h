// Fits a few parameters to many residuals by the Levenberg–Marquardt method. Private to this
// folder.
#pragma once

#include <Eigen/Core>

#include <functional>

namespace dipwright {

// Computes the residuals for the parameters. The caller has set the length of `residuals`.
using Residuals =
    std::function<void(const Eigen::VectorXd& parameters, Eigen::VectorXd& residuals)>;

struct LeastSquaresFit {
    Eigen::VectorXd parameters, residuals;
    // Covariance of the parameters, for independent residuals of standard deviation 1.
    Eigen::MatrixXd covariance;
    bool converged = false;
    // False if the residuals do not determine every parameter; `covariance` is then useless.
    bool determined = false;
};

// Fits the parameters. Derivatives are central differences: parameters should be of the order of 1.
LeastSquaresFit leastSquares(const Residuals& residuals, int count, Eigen::VectorXd start);

// Fits robustly. Residuals 2 i and 2 i + 1 belong to point i. Points whose residual is more than
// 2.5 times the median get Huber's smaller weights. `points` is the number of points; the residuals
// after them have full weight. The covariance belongs to the weighted residuals.
LeastSquaresFit robustLeastSquares(const Residuals& residuals, int count, Eigen::VectorXd start,
                                   int points);
LeastSquaresFit robustLeastSquares(const Residuals& residuals, int count, Eigen::VectorXd start);

// Returns the median length of the first `points` pairs of residuals.
double medianLength(const Eigen::VectorXd& residuals, Eigen::Index points);

// Returns the derivatives of `residuals` with respect to the parameters, as central differences.
Eigen::MatrixXd derivatives(const Residuals& residuals, int count, const Eigen::VectorXd& at);

} // namespace dipwright
