#include "inspection/JointFit.h"

#include "base/Error.h"
#include "inspection/LeastSquares.h"
#include "inspection/MovedCamera.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::FilmFit)
};

// Weak springs keep the unknowns near 0. A spring's residual is one pixel if the unknown differs
// from 0 by this multiple of its widestKnownInterval.
constexpr double springLength = 10;
constexpr double cameraSpring = 1; // spring length of the camera's unknowns

// Returns the two-sided 95 % quantile of Student's distribution (M. Abramowitz and I. Stegun,
// "Handbook of Mathematical Functions", 26.7.5).
double sure95(double freedom) {
    constexpr double z = deviationsFor95; // the quantile for infinite freedom
    const double z3 = z * z * z, z5 = z3 * z * z;
    return z + (z3 + z) / (4 * freedom) + (5 * z5 + 16 * z3 + 3 * z) / (96 * freedom * freedom);
}

// Parameters: the free unknowns, then the camera's. Residuals: in pixels, two per printed place and
// two per place on the body itself; then the springs.
class Joint {
public:
    Joint(const PlacesNear& near, const SeenPlaces& seen, const PartView& start,
          const std::vector<bool>& isFree, CameraFit camera)
        : near_(near), seen_(seen),
          camera_(start,
                  camera == CameraFit::Whole
                      ? fittableDistortions(seen.printed.size() + seen.body.size())
                      : 0,
                  camera == CameraFit::Held) {
        for (std::size_t i = 0; i < isFree.size(); ++i) {
            if (isFree[i]) {
                free_.push_back(Eigen::Index(i));
            }
        }
        for (std::size_t i = 0; i < near.places.size(); ++i) {
            if (near.places[i]) {
                laid_.push_back(i);
            }
        }
    }

    Eigen::Index freeCount() const { return Eigen::Index(free_.size()); }
    Eigen::Index count() const { return freeCount() + camera_.count(); }
    int points() const { return int(laid_.size() + seen_.body.size()); }
    int residualCount() const { return 2 * points() + int(count()); }

    Eigen::VectorXd start() const {
        Eigen::VectorXd start = Eigen::VectorXd::Zero(count());
        for (std::size_t i = 0; i < free_.size(); ++i) {
            start[Eigen::Index(i)] = near_.centre[free_[i]];
        }
        return start;
    }

    Eigen::VectorXd unknowns(const Eigen::VectorXd& numbers) const {
        Eigen::VectorXd unknowns = near_.centre;
        for (std::size_t i = 0; i < free_.size(); ++i) {
            unknowns[free_[i]] = numbers[Eigen::Index(i)];
        }
        return unknowns;
    }

    PartView view(const Eigen::VectorXd& numbers) const {
        return camera_.view(numbers.tail(camera_.count()));
    }

    Eigen::Vector2d off(const PrintedPlace& place, std::size_t index, const Eigen::VectorXd& moved,
                        const PartView& view) const {
        const Eigen::Vector3d lies = *near_.places[index] + near_.slopes[index] * moved;
        return place.pixel - seenAt(view, place.photo, seen_.picture, lies);
    }

    void residuals(const Eigen::VectorXd& numbers, Eigen::VectorXd& values) const {
        const PartView view = this->view(numbers);
        const Eigen::VectorXd moved = unknowns(numbers) - near_.centre;
        Eigen::Index at = 0;
        for (const std::size_t index : laid_) {
            values.segment<2>(at) = off(seen_.printed[index], index, moved, view);
            at += 2;
        }
        for (const PlacePair& pair : seen_.body) {
            values.segment<2>(at) =
                pair.pixel - seenAt(view, pair.photo, seen_.picture, pair.model);
            at += 2;
        }
        for (Eigen::Index i = 0; i < count(); ++i) {
            values[at++] = numbers[i] / spring(i);
        }
    }

    std::vector<Eigen::Vector2d> seenDistances(const Eigen::VectorXd& numbers) const {
        const PartView view = this->view(numbers);
        const Eigen::VectorXd moved = unknowns(numbers) - near_.centre;
        std::vector<Eigen::Vector2d> off(seen_.printed.size(), Eigen::Vector2d::Zero());
        for (const std::size_t index : laid_) {
            off[index] = this->off(seen_.printed[index], index, moved, view);
        }
        return off;
    }

    Eigen::Index freeAt(Eigen::Index i) const { return free_[std::size_t(i)]; }

private:
    double spring(Eigen::Index number) const {
        return number < freeCount()
                   ? springLength * fitScale(near_.unknowns[std::size_t(freeAt(number))].quantity)
                                        .widestKnownInterval
                   : cameraSpring;
    }

    const PlacesNear& near_;
    const SeenPlaces& seen_;
    MovedCamera camera_;
    std::vector<Eigen::Index> free_;
    std::vector<std::size_t> laid_;
};

void fillIntervals(JointSolution& solution, const Joint& joint, const Eigen::MatrixXd& covariance,
                   double freedom) {
    const Eigen::Index count = joint.freeCount();
    const Eigen::VectorXd deviations = covariance.diagonal().cwiseSqrt().cwiseMax(1e-300);
    const Eigen::MatrixXd all = deviations.cwiseInverse().asDiagonal() * covariance *
                                deviations.cwiseInverse().asDiagonal();
    solution.correlation = all.topLeftCorner(count, count);
    solution.cameraCorrelation = Eigen::VectorXd::Zero(count);
    solution.off = Eigen::VectorXd::Zero(solution.unknowns.size());
    for (Eigen::Index i = 0; i < count; ++i) {
        solution.off[joint.freeAt(i)] = sure95(freedom) * solution.pixels * deviations[i];
        if (all.cols() > count) {
            solution.cameraCorrelation[i] =
                all.row(i).tail(all.cols() - count).cwiseAbs().maxCoeff();
        }
    }
}

} // namespace

JointSolution fitJointly(const PlacesNear& near, const SeenPlaces& seen, const PartView& start,
                         const std::vector<bool>& isFree, CameraFit camera, const QString& where) {
    const Joint joint(near, seen, start, isFree, camera);
    const double freedom = 2.0 * joint.points() - double(joint.count());
    if (freedom < 1) {
        throw Error(Text::tr("There are too few pairs on the part to determine the %1 unknowns of "
                             "film and camera; give more pairs, or fit fewer quantities")
                        .arg(joint.count()),
                    where);
    }
    JointSolution solution;
    Eigen::VectorXd numbers = joint.start();
    Eigen::VectorXd values(joint.residualCount());
    if (joint.count() > 0) {
        const LeastSquaresFit fit = robustLeastSquares(
            [&](const Eigen::VectorXd& at, Eigen::VectorXd& out) { joint.residuals(at, out); },
            joint.residualCount(), numbers, joint.points());
        if (!fit.converged || !fit.determined) {
            throw Error(Text::tr("The fit found no film and camera that explain the pairs; check "
                                 "whether a pair names the wrong place"),
                        where);
        }
        numbers = fit.parameters;
        solution.unknowns = joint.unknowns(numbers);
        solution.pixels = std::sqrt(fit.residuals.head(2 * joint.points()).squaredNorm() / freedom);
        fillIntervals(solution, joint, fit.covariance, freedom);
    } else {
        joint.residuals(numbers, values);
        solution.unknowns = near.centre;
        solution.off = Eigen::VectorXd::Zero(near.centre.size());
        solution.pixels = std::sqrt(values.head(2 * joint.points()).squaredNorm() / freedom);
    }
    solution.view = joint.view(numbers);
    solution.seenDistances = joint.seenDistances(numbers);
    return solution;
}

} // namespace dipwright
