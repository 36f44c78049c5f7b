#include "inspection/LeastSquares.h"

#include <Eigen/QR>
#include <unsupported/Eigen/NonLinearOptimization>

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

// Step of the derivatives, relative to the parameter's size, or to 1 if that is larger.
constexpr double step = 1e-6;
constexpr int mostEvaluations = 200;
constexpr double leastCondition = 1e-11; // smallest over largest diagonal entry of the R factor

struct Functor {
    using Scalar = double;
    using InputType = Eigen::VectorXd;
    using ValueType = Eigen::VectorXd;
    using JacobianType = Eigen::MatrixXd;

    const Residuals& residuals;
    int count, parameters;

    int inputs() const { return parameters; }
    int values() const { return count; }
    int operator()(const InputType& at, ValueType& values) const {
        residuals(at, values);
        return values.allFinite() ? 0 : -1;
    }
    int df(const InputType& at, JacobianType& jacobian) const {
        jacobian = derivatives(residuals, count, at);
        return jacobian.allFinite() ? 0 : -1;
    }
};

void judge(LeastSquaresFit& fit, const Eigen::MatrixXd& jacobian) {
    const auto parameters = jacobian.cols();
    // Gives all columns the same length, so that the choice of units does not affect the rank test.
    const Eigen::VectorXd scale = jacobian.colwise().norm().cwiseMax(1e-300);
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(jacobian *
                                                         scale.cwiseInverse().asDiagonal());
    const Eigen::VectorXd diagonal = qr.matrixQR().diagonal().cwiseAbs();
    fit.determined = jacobian.allFinite() && jacobian.rows() > parameters &&
                     diagonal.minCoeff() > leastCondition * diagonal.maxCoeff();
    if (!fit.determined) {
        return;
    }
    const Eigen::MatrixXd upper = qr.matrixQR().topRows(parameters).triangularView<Eigen::Upper>();
    const Eigen::MatrixXd inverse =
        qr.colsPermutation() * upper.triangularView<Eigen::Upper>().solve(
                                   Eigen::MatrixXd::Identity(parameters, parameters));
    const Eigen::MatrixXd rows = scale.cwiseInverse().asDiagonal() * inverse;
    fit.covariance = rows * rows.transpose();
}

Eigen::VectorXd lengthsOf(const Eigen::VectorXd& residuals, Eigen::Index points) {
    return Eigen::Map<const Eigen::Matrix2Xd>(residuals.data(), 2, points).colwise().norm();
}

// Returns the square root of each residual's weight: Huber's weight for the points, 1 for the
// others.
Eigen::VectorXd huberRoots(const Eigen::VectorXd& residuals, Eigen::Index points) {
    const Eigen::VectorXd lengths = lengthsOf(residuals, points);
    const double far = 2.5 * std::max(medianLength(residuals, points), 1e-12);
    Eigen::VectorXd roots = Eigen::VectorXd::Ones(residuals.size());
    for (Eigen::Index point = 0; point < points; ++point) {
        if (lengths[point] > far) {
            roots.segment<2>(2 * point).setConstant(std::sqrt(far / lengths[point]));
        }
    }
    return roots;
}

} // namespace

Eigen::MatrixXd derivatives(const Residuals& residuals, int count, const Eigen::VectorXd& at) {
    Eigen::MatrixXd jacobian(count, at.size());
    Eigen::VectorXd place = at, before(count), after(count);
    for (Eigen::Index i = 0; i < at.size(); ++i) {
        const double h = step * std::max(1.0, std::abs(at[i]));
        place[i] = at[i] - h;
        residuals(place, before);
        place[i] = at[i] + h;
        residuals(place, after);
        place[i] = at[i];
        jacobian.col(i) = (after - before) / (2 * h);
    }
    return jacobian;
}

double medianLength(const Eigen::VectorXd& residuals, Eigen::Index points) {
    Eigen::VectorXd lengths = lengthsOf(residuals, points);
    const auto middle = lengths.begin() + points / 2;
    std::nth_element(lengths.begin(), middle, lengths.end());
    return *middle;
}

LeastSquaresFit leastSquares(const Residuals& residuals, int count, Eigen::VectorXd start) {
    LeastSquaresFit fit;
    fit.parameters = std::move(start);
    fit.residuals.setZero(count);
    const int parameters = int(fit.parameters.size());
    if (count >= parameters) {
        Functor functor{residuals, count, parameters};
        Eigen::LevenbergMarquardt<Functor> search(functor);
        search.parameters.maxfev = mostEvaluations;
        search.parameters.xtol = 1e-12;
        search.parameters.ftol = 1e-14;
        const auto status = search.minimize(fit.parameters);
        fit.converged =
            status > 0 && status != Eigen::LevenbergMarquardtSpace::TooManyFunctionEvaluation;
    }
    residuals(fit.parameters, fit.residuals);
    fit.converged = fit.converged && fit.residuals.allFinite();
    judge(fit, derivatives(residuals, count, fit.parameters));
    return fit;
}

LeastSquaresFit robustLeastSquares(const Residuals& residuals, int count, Eigen::VectorXd start) {
    return robustLeastSquares(residuals, count, std::move(start), count / 2);
}

LeastSquaresFit robustLeastSquares(const Residuals& residuals, int count, Eigen::VectorXd start,
                                   int points) {
    constexpr int rounds = 4;
    LeastSquaresFit fit = leastSquares(residuals, count, std::move(start));
    for (int round = 0; round < rounds && fit.converged; ++round) {
        const Eigen::VectorXd roots = huberRoots(fit.residuals, points);
        if (roots.minCoeff() == 1) {
            break;
        }
        const Residuals weighted = [&](const Eigen::VectorXd& at, Eigen::VectorXd& values) {
            residuals(at, values);
            values = values.cwiseProduct(roots);
        };
        fit = leastSquares(weighted, count, fit.parameters);
        residuals(fit.parameters, fit.residuals);
    }
    return fit;
}

} // namespace dipwright
