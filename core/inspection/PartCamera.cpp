#include "inspection/PartCamera.h"

#include "base/Error.h"
#include "inspection/LeastSquares.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::PartCamera)
};

constexpr double sure95 = 1.959964;
constexpr double leastDepth = 1e-3;  // of the pairs' extent over their thickness
constexpr double mostFocalOff = 0.6; // of the focal length, at 95 %

struct Start {
    PartPose pose;
    double focalLength = 1;
};

[[noreturn]] void refuse(const QString& sentence, const QString& where) {
    throw Error(sentence, where);
}

// How thick the pairs' places are, over how far they reach.
double thickness(const std::vector<PlacePair>& pairs) {
    Eigen::MatrixXd places(Eigen::Index(pairs.size()), 3);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        places.row(Eigen::Index(i)) = pairs[i].model.transpose();
    }
    const Eigen::RowVector3d mean = places.colwise().mean();
    places.rowwise() -= mean;
    const Eigen::Vector3d sizes = Eigen::JacobiSVD<Eigen::MatrixXd>(places).singularValues();
    return sizes[0] > 0 ? sizes[2] / sizes[0] : 0;
}

// The matrix that takes places to the picture, by the linear method (R. Hartley and A. Zisserman,
// "Multiple View Geometry", 7.1), from places moved and scaled to the order of 1.
Eigen::Matrix<double, 3, 4> linearCamera(const std::vector<PlacePair>& pairs,
                                         const LensPlane& plane) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const PlacePair& pair : pairs) {
        mean += pair.model / double(pairs.size());
    }
    double reach = 0;
    for (const PlacePair& pair : pairs) {
        reach += (pair.model - mean).norm() / double(pairs.size());
    }
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(Eigen::Index(2 * pairs.size()), 12);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Eigen::RowVector4d place =
            ((pairs[i].model - mean) / reach).homogeneous().transpose();
        const Eigen::Vector2d seen = plane.inUnits(pairs[i].pixel);
        const auto row = Eigen::Index(2 * i);
        rows.block<1, 4>(row, 0) = place;
        rows.block<1, 4>(row, 8) = -seen.x() * place;
        rows.block<1, 4>(row + 1, 4) = place;
        rows.block<1, 4>(row + 1, 8) = -seen.y() * place;
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeFullV);
    const Eigen::VectorXd least = svd.matrixV().col(11);
    Eigen::Matrix<double, 3, 4> camera;
    camera << least.segment<4>(0).transpose(), least.segment<4>(4).transpose(),
        least.segment<4>(8).transpose();
    Eigen::Matrix4d scaling = Eigen::Matrix4d::Identity();
    scaling.topLeftCorner<3, 3>() /= reach;
    scaling.topRightCorner<3, 1>() = -mean / reach;
    camera = camera * scaling;
    // Of unit length, and with the places before the camera.
    camera /= camera.block<1, 3>(2, 0).norm();
    return camera.row(2) * mean.homogeneous() < 0 ? Eigen::Matrix<double, 3, 4>(-camera) : camera;
}

// A pinhole camera with its middle in the picture's that is near it.
Start pinhole(const Eigen::Matrix<double, 3, 4>& camera) {
    const Eigen::Vector3d x = camera.block<1, 3>(0, 0), y = camera.block<1, 3>(1, 0),
                          forward = camera.block<1, 3>(2, 0);
    Start start;
    const double across = (x - x.dot(forward) * forward).norm();
    const double down = (y - y.dot(forward) * forward).norm();
    start.focalLength = std::sqrt(across * down);
    Eigen::Matrix3d axes;
    axes << ((x - x.dot(forward) * forward) / across).transpose(),
        ((y - y.dot(forward) * forward) / down).transpose(), forward.transpose();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(axes, Eigen::ComputeFullU | Eigen::ComputeFullV);
    start.pose.turn = svd.matrixU() * svd.matrixV().transpose();
    start.pose.shift = {camera(0, 3) / across, camera(1, 3) / down, camera(2, 3)};
    return start;
}

// Parameters: logarithm of the focal length, k1 and k2 (0 to 2 of them), and for each photo a turn,
// as a vector along its axis, on top of the start's, and a shift over the distance.
class PartFit {
public:
    PartFit(const std::vector<PlacePair>& pairs, std::vector<Start> starts, QSize picture,
            const std::optional<Lens>& lens)
        : pairs_(pairs), starts_(std::move(starts)), plane_(picture), lens_(lens.value_or(Lens{})),
          distortions_(lens ? 0 : std::min(2, int(pairs.size()) / pairsForDistortion)) {}

    Eigen::VectorXd start() const {
        Eigen::VectorXd start =
            Eigen::VectorXd::Zero(firstPose() + 6 * Eigen::Index(starts_.size()));
        for (const Start& photo : starts_) {
            start[0] += std::log(photo.focalLength) / double(starts_.size());
        }
        for (std::size_t i = 0; i < starts_.size(); ++i) {
            start.segment<3>(firstPose() + 6 * Eigen::Index(i) + 3) =
                starts_[i].pose.shift / distance(i);
        }
        return start;
    }

    void residuals(const Eigen::VectorXd& p, Eigen::VectorXd& values) const {
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            values.segment<2>(Eigen::Index(2 * i)) =
                plane_.inUnits(pairs_[i].pixel) -
                seen(p, std::size_t(pairs_[i].photo), pairs_[i].model);
        }
    }

    Eigen::Vector2d seen(const Eigen::VectorXd& p, std::size_t photo,
                         const Eigen::Vector3d& model) const {
        const PartPose at = pose(p, photo);
        const Eigen::Vector3d from = at.turn * model + at.shift;
        return distorted(std::exp(p[0]) * from.head<2>() / from.z(), lens(p));
    }

    PartPose pose(const Eigen::VectorXd& p, std::size_t photo) const {
        const Eigen::Index at = firstPose() + 6 * Eigen::Index(photo);
        const Eigen::Vector3d turn = p.segment<3>(at);
        const double angle = turn.norm();
        const Eigen::Matrix3d more = angle > 0
                                         ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix()
                                         : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
        return {more * starts_[photo].pose.turn, p.segment<3>(at + 3) * distance(photo)};
    }

    Lens lens(const Eigen::VectorXd& p) const {
        return {distortions_ > 0 ? p[1] : lens_.k1, distortions_ > 1 ? p[2] : lens_.k2};
    }
    int count() const { return int(2 * pairs_.size()); }

private:
    Eigen::Index firstPose() const { return 1 + distortions_; }
    double distance(std::size_t photo) const { return starts_[photo].pose.shift.norm(); }

    const std::vector<PlacePair>& pairs_;
    std::vector<Start> starts_;
    LensPlane plane_;
    Lens lens_;
    int distortions_;
};

std::vector<Start> firstCameras(const std::vector<PlacePair>& pairs, int photos, QSize picture,
                                const QString& where) {
    std::vector<Start> starts;
    for (int photo = 0; photo < photos; ++photo) {
        std::vector<PlacePair> own;
        std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(own),
                     [photo](const PlacePair& pair) { return pair.photo == photo; });
        if (int(own.size()) < leastPairs) {
            refuse(Text::tr("Photo %1 has %2 pairs of places and takes %3 to tell its camera; give "
                            "more")
                       .arg(photo + 1)
                       .arg(own.size())
                       .arg(leastPairs),
                   where);
        }
        if (thickness(own) < leastDepth) {
            refuse(Text::tr("All places of photo %1 lie in one plane, which does not tell how far "
                            "the camera was; give some on other faces")
                       .arg(photo + 1),
                   where);
        }
        starts.push_back(pinhole(linearCamera(own, LensPlane(picture))));
        if (starts.back().pose.turn.determinant() < 0) {
            refuse(Text::tr("Photo %1 shows its places as in a mirror; give the photo as the "
                            "camera made it, and the places with the model's own signs")
                       .arg(photo + 1),
                   where);
        }
    }
    return starts;
}

PartFigures figuresOf(const std::vector<PairOff>& off, double diagonal) {
    PartFigures figures;
    figures.count = int(off.size());
    if (off.empty()) {
        return figures;
    }
    std::vector<double> lengths;
    for (std::size_t i = 0; i < off.size(); ++i) {
        figures.meanPixels += off[i].pixels.norm() / double(off.size());
        lengths.push_back(off[i].millimetres);
        if (off[i].millimetres > figures.worst) {
            figures.worst = off[i].millimetres;
            figures.worstPair = i;
        }
    }
    for (const PairOff& one : off) {
        figures.deviationPixels += std::pow(one.pixels.norm() - figures.meanPixels, 2);
    }
    figures.deviationPixels =
        std::sqrt(figures.deviationPixels / std::max(1.0, double(off.size()) - 1));
    figures.shareOfDiagonal = figures.meanPixels / diagonal;
    std::sort(lengths.begin(), lengths.end());
    figures.percentile95 = lengths[std::size_t(std::ceil(0.95 * double(lengths.size()))) - 1];
    return figures;
}

} // namespace

PartView fitPartCamera(const std::vector<PlacePair>& pairs, int photos, QSize picture,
                       const QString& where, const std::optional<Lens>& lens) {
    const PartFit problem(pairs, firstCameras(pairs, photos, picture, where), picture, lens);
    const LeastSquaresFit fit = robustLeastSquares(
        [&](const Eigen::VectorXd& p, Eigen::VectorXd& values) { problem.residuals(p, values); },
        problem.count(), problem.start());
    const double freedom = double(problem.count() - fit.parameters.size());
    if (!fit.converged || !fit.determined || freedom <= 0) {
        refuse(Text::tr("The pairs do not tell the camera; give more, farther apart"), where);
    }
    PartView view;
    const double sigma = std::sqrt(fit.residuals.squaredNorm() / freedom);
    view.focalLength.value = std::exp(fit.parameters[0]);
    view.focalLength.off =
        sure95 * sigma * view.focalLength.value * std::sqrt(fit.covariance(0, 0));
    if (view.focalLength.off > mostFocalOff * view.focalLength.value) {
        refuse(Text::tr("The pairs do not tell how far the camera was; give places that lie nearer "
                        "and farther, and photograph from less far away"),
               where);
    }
    view.lens = problem.lens(fit.parameters);
    for (int photo = 0; photo < photos; ++photo) {
        view.photos.push_back(problem.pose(fit.parameters, std::size_t(photo)));
    }
    return viewOf(view, pairs, picture);
}

PartView viewOf(const PartView& camera, const std::vector<PlacePair>& pairs, QSize picture) {
    PartView view = camera;
    view.off.clear();
    for (const PlacePair& pair : pairs) {
        const PartPose& pose = view.photos[std::size_t(pair.photo)];
        const double depth = (pose.turn * pair.model + pose.shift).z();
        const Eigen::Vector2d off = pair.pixel - seenAt(view, pair.photo, picture, pair.model);
        const double unit = LensPlane(picture).unit();
        view.off.push_back({off, off.norm() / unit * depth / view.focalLength.value});
    }
    view.figures = figuresOf(view.off, 2 * LensPlane(picture).unit());
    return view;
}

PartFigures figuresOfPhoto(const PartView& view, const std::vector<PlacePair>& pairs, int photo,
                           QSize picture) {
    std::vector<PairOff> off;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (pairs[i].photo == photo) {
            off.push_back(view.off[i]);
        }
    }
    return figuresOf(off, 2 * LensPlane(picture).unit());
}

Eigen::Vector2d seenAt(const PartView& view, int photo, QSize picture,
                       const Eigen::Vector3d& model) {
    const PartPose& pose = view.photos[std::size_t(photo)];
    const Eigen::Vector3d from = pose.turn * model + pose.shift;
    return LensPlane(picture).inPixels(
        distorted(view.focalLength.value * from.head<2>() / from.z(), view.lens));
}

} // namespace dipwright
