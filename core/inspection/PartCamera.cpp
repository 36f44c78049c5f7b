#include "inspection/PartCamera.h"

#include "base/Error.h"
#include "inspection/LeastSquares.h"
#include "inspection/LinearProjection.h"
#include "inspection/MovedCamera.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::PartCamera)
};

constexpr double leastDepth = 1e-3;  // least thickness of the pairs, as a share of their extent
constexpr double mostFocalOff = 0.6; // largest 95 % interval, as a share of the focal length

[[noreturn]] void refuse(const QString& sentence, const QString& where) {
    throw Error(sentence, where);
}

// A photo's pairs, one per column.
struct PhotoPairs {
    Eigen::Matrix3Xd model; // mm
    Eigen::Matrix2Xd seen;  // in units of half the picture's diagonal
};

PhotoPairs ownPairs(const std::vector<PlacePair>& pairs, int photo, QSize picture) {
    const auto isOwn = [photo](const PlacePair& pair) { return pair.photo == photo; };
    const auto count = Eigen::Index(std::count_if(pairs.begin(), pairs.end(), isOwn));
    PhotoPairs own{Eigen::Matrix3Xd(3, count), Eigen::Matrix2Xd(2, count)};
    Eigen::Index at = 0;
    for (const PlacePair& pair : pairs) {
        if (isOwn(pair)) {
            own.model.col(at) = pair.model;
            own.seen.col(at++) = LensPlane(picture).inUnits(pair.pixel);
        }
    }
    return own;
}

// Returns the places' smallest extent over their largest.
double thickness(const Eigen::Matrix3Xd& places) {
    const Eigen::Vector3d mean = places.rowwise().mean();
    const Eigen::Vector3d sizes =
        Eigen::JacobiSVD<Eigen::MatrixXd>(places.colwise() - mean).singularValues();
    return sizes[0] > 0 ? sizes[2] / sizes[0] : 0;
}

struct Start {
    PartPose pose;
    double focalLength = 1;
};

// Returns a pinhole camera near the linear method's result, with its principal point in the
// picture's middle (R. Hartley and A. Zisserman, "Multiple View Geometry", 7.1).
Start pinhole(const PhotoPairs& pairs) {
    Eigen::Matrix<double, 3, 4> camera = linearProjection(pairs.model, pairs.seen);
    // The matrix is scaled to a viewing axis of unit length; the sign puts the places in front of
    // the camera.
    const Eigen::Vector3d mean = pairs.model.rowwise().mean();
    camera /= std::copysign(camera.block<1, 3>(2, 0).norm(), camera.row(2) * mean.homogeneous());
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

PartView firstCamera(const std::vector<PlacePair>& pairs, int photos, QSize picture,
                     const QString& where) {
    PartView first;
    first.focalLength.value = 1;
    for (int photo = 0; photo < photos; ++photo) {
        const PhotoPairs own = ownPairs(pairs, photo, picture);
        if (own.model.cols() < leastPairs) {
            refuse(Text::tr(
                       "Photo %1 has %2 pairs of places, but its camera needs %3; give more pairs")
                       .arg(photo + 1)
                       .arg(own.model.cols())
                       .arg(leastPairs),
                   where);
        }
        if (thickness(own.model) < leastDepth) {
            refuse(Text::tr("All places of photo %1 lie in one plane, which does not determine the "
                            "camera's distance; give some places on other faces")
                       .arg(photo + 1),
                   where);
        }
        const Start start = pinhole(own);
        if (start.pose.turn.determinant() < 0) {
            refuse(Text::tr("The places marked in photo %1 are a mirror image of the places on "
                            "the model; use the photo unflipped, and give the places in the "
                            "model's own coordinates")
                       .arg(photo + 1),
                   where);
        }
        first.photos.push_back(start.pose);
        first.focalLength.value *= std::pow(start.focalLength, 1.0 / photos);
    }
    return first;
}

PartFigures figuresOf(const std::vector<PairDistance>& off, double diagonal) {
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
    for (const PairDistance& one : off) {
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
    PartView first = firstCamera(pairs, photos, picture, where);
    first.lens = lens.value_or(Lens());
    const MovedCamera camera(first, lens ? 0 : fittableDistortions(pairs.size()));
    const LeastSquaresFit fit = robustLeastSquares(
        [&](const Eigen::VectorXd& by, Eigen::VectorXd& values) {
            const PartView view = camera.view(by);
            for (std::size_t i = 0; i < pairs.size(); ++i) {
                values.segment<2>(Eigen::Index(2 * i)) =
                    pairs[i].pixel - seenAt(view, pairs[i].photo, picture, pairs[i].model);
            }
        },
        int(2 * pairs.size()), Eigen::VectorXd::Zero(camera.count()));
    const double freedom = double(fit.residuals.size() - camera.count());
    if (!fit.converged || !fit.determined || freedom <= 0) {
        refuse(Text::tr("The pairs do not determine the camera; give more pairs, farther apart"),
               where);
    }
    PartView view = camera.view(fit.parameters);
    const double sigma = std::sqrt(fit.residuals.squaredNorm() / freedom);
    view.focalLength.off =
        deviationsFor95 * sigma * view.focalLength.value * std::sqrt(fit.covariance(0, 0));
    if (view.focalLength.off > mostFocalOff * view.focalLength.value) {
        refuse(
            Text::tr("The pairs do not determine the camera's distance; add pairs at places nearer "
                     "to the camera and farther from it, or take the photo from a shorter "
                     "distance"),
            where);
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
    std::vector<PairDistance> off;
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
