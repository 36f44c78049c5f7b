// Fits of a few parameters to many residuals, by Levenberg and Marquardt's method. Private to this
// folder.
#pragma once

#include <Eigen/Core>

#include <functional>

namespace dipwright {

// Fills `residuals`, which has its length already, for the parameters given.
using Residuals =
    std::function<void(const Eigen::VectorXd& parameters, Eigen::VectorXd& residuals)>;

struct LeastSquaresFit {
    Eigen::VectorXd parameters, residuals;
    // Of the parameters, for residuals of standard deviation 1 that are independent.
    Eigen::MatrixXd covariance;
    bool converged = false;
    // False where the residuals do not tell the parameters apart; `covariance` is then of no use.
    bool determined = false;
};

// Derivatives are taken by central differences: parameters should be of the order of 1.
LeastSquaresFit leastSquares(const Residuals& residuals, int count, Eigen::VectorXd start);

// The same for points: residuals 2 i and 2 i + 1 are a point's, and one that lies out more than 2.5
// times as far as most counts the less, by Huber's weights. `points`: how many there are; residuals
// past theirs count as they are. The covariance is that of the weighted residuals.
LeastSquaresFit robustLeastSquares(const Residuals& residuals, int count, Eigen::VectorXd start,
                                   int points);
LeastSquaresFit robustLeastSquares(const Residuals& residuals, int count, Eigen::VectorXd start);

// The median of how far out the first `points` of them lie.
double medianLength(const Eigen::VectorXd& residuals, Eigen::Index points);

// Derivatives of `residuals` by the parameters, by central differences.
Eigen::MatrixXd derivatives(const Residuals& residuals, int count, const Eigen::VectorXd& at);

} // namespace dipwright
