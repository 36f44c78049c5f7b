#include "artwork/LayerPlane.h"

#include "geometry/BuriedSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace dipwright {
namespace {

// Least cosine between a projection and a surface's normal. More oblique surfaces are not painted.
constexpr double facing = 0.05;
// A surface is an end of the tube if the cosine between its normal and the tube's axis is larger.
constexpr double endOfTube = 0.94;
constexpr double blendRange = 0.15; // range of cosines over which two sides of a box blend

Eigen::Vector3d placeOf(const ArtworkLayer& layer) {
    return {layer.place[0].value(), layer.place[1].value(), layer.place[2].value()};
}

Eigen::Vector3d axisOf(LayerAxis axis) {
    const auto number = int(axis);
    return (number < 3 ? 1 : -1) * Eigen::Vector3d::Unit(number % 3);
}

double distanceFromAxis(const Eigen::Vector3d& place, const Eigen::Vector3d& axis) {
    return (place - axis.dot(place) * axis).norm();
}

// Returns the area-weighted mean radius of the surface that looks away from the axis, without the
// tube's ends; none if there is no such surface. So the inside of a cup does not count.
std::optional<double> meanRadius(const TriangleMesh& mesh, const Eigen::Vector3d& place,
                                 const Eigen::Vector3d& axis) {
    double sum = 0, area = 0;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const Eigen::Vector3d outward = triangleNormal(mesh, triangle).cast<double>();
        const auto corners = cornersOf(mesh, triangle);
        const Eigen::Vector3d middle = (corners[0] + corners[1] + corners[2]).cast<double>() / 3;
        const Eigen::Vector3d across = middle - place - axis.dot(middle - place) * axis;
        if (std::abs(outward.dot(axis)) < endOfTube && outward.dot(across) > 0) {
            const double own = triangleArea(mesh, triangle);
            for (const Eigen::Vector3f& corner : corners) {
                sum += own / 3 * distanceFromAxis(corner.cast<double>() - place, axis);
            }
            area += own;
        }
    }
    return area > 0 ? std::optional(std::max(sum / area, 1e-3)) : std::nullopt;
}

} // namespace

double lengthAround(const ArtworkLayer& layer, const TriangleMesh& mesh) {
    return 2 * pi * meanRadius(mesh, placeOf(layer), axisOf(layer.axis)).value_or(1);
}

LayerPlane::LayerPlane(const ArtworkLayer& layer, const TriangleMesh& mesh,
                       const SurfaceQuery& query, const Eigen::Vector2d& size)
    : mesh_(mesh), placement_(layer.placement), place_(placeOf(layer)), axis_(axisOf(layer.axis)),
      turned_(radians(layer.turn)) {
    turn_ = Eigen::Rotation2Dd(-turned_).toRotationMatrix();
    if (placement_ == LayerPlacement::Decal) {
        const SurfacePoint middle = query.closest(place_.cast<float>()).point;
        const bool repeats = layer.repeat.value() > 0;
        const Eigen::Vector2d area =
            repeats ? Eigen::Vector2d(layer.size[0].value(), layer.size[1].value()) : size;
        reach_ = area.norm() / 2 * 1.02 + 1e-3;
        place_ = position(mesh, middle).cast<double>();
        unfolded_ = std::make_unique<const UnfoldedSurface>(mesh, middle, reach_);
    } else if (placement_ == LayerPlacement::Box) {
        normals_ = cornerNormals(mesh);
    } else if (placement_ == LayerPlacement::Cylinder) {
        lengthOfTurn_ = lengthAround(layer, mesh);
        if (layer.repeat.value() > 0) { // fit a whole number of repeats
            lengthOfTurn_ = std::max(1.0, std::round(lengthOfTurn_ / size.x())) * size.x();
        }
    }
}

Eigen::Vector2d LayerPlane::projected(const Eigen::Vector3d& place,
                                      const SurfaceFrame& frame) const {
    return turn_ * Eigen::Vector2d(frame.right.dot(place), frame.up.dot(place));
}

std::optional<Eigen::Vector2d> LayerPlane::round(const Eigen::Vector3d& place,
                                                 const Eigen::Vector3d& outward) const {
    if (std::abs(outward.dot(axis_)) > endOfTube) {
        return std::nullopt;
    }
    // Seen with the axis pointing up, the picture's middle is in front and its sides meet at the
    // back.
    const Eigen::Vector3d front =
        std::abs(axis_.z()) > 0.5 ? Eigen::Vector3d(0, -axis_.z(), 0) : Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d side = axis_.cross(front);
    double angle = std::atan2(side.dot(place), front.dot(place)) - turned_;
    angle = std::remainder(angle, 2 * pi);
    return Eigen::Vector2d(angle / (2 * pi) * lengthOfTurn_, axis_.dot(place));
}

// If a place faces several sides of the box about equally, blends them, so that no line shows.
PlanePlaces LayerPlane::boxed(const SurfacePoint& point) const {
    const Eigen::Vector3d place = position(mesh_, point).cast<double>() - place_;
    const Eigen::Vector3d normal = normalAt(normals_, point).cast<double>();
    const Eigen::Vector3d absNormal = normal.cwiseAbs();
    const Eigen::Vector3d weights =
        (absNormal.array() - absNormal.maxCoeff() + blendRange).max(0).square();
    PlanePlaces places;
    for (Eigen::Index side = 0; side < 3; ++side) {
        if (weights[side] > 0) {
            const double sign = normal[side] < 0 ? -1 : 1;
            places[std::size_t(side)] = {
                projected(place, uprightFrame(sign * Eigen::Vector3d::Unit(side))),
                float(weights[side] / weights.sum())};
        }
    }
    return places;
}

PlanePlaces LayerPlane::at(const SurfacePoint& point, const Eigen::Vector3d& outward) const {
    if (placement_ == LayerPlacement::Box) {
        return boxed(point);
    }
    const std::optional<Eigen::Vector2d> place = single(point, outward);
    return place ? PlanePlaces{PlanePlace{*place, 1}} : PlanePlaces{};
}

std::optional<Eigen::Vector2d> LayerPlane::single(const SurfacePoint& point,
                                                  const Eigen::Vector3d& outward) const {
    const Eigen::Vector3d place = position(mesh_, point).cast<double>() - place_;
    if (placement_ == LayerPlacement::Decal) {
        if (place.norm() > reach_) {
            return std::nullopt;
        }
        const auto flat = unfolded_->at(point);
        return flat ? std::optional<Eigen::Vector2d>(turn_ * *flat) : std::nullopt;
    }
    if (placement_ == LayerPlacement::Cylinder) {
        return round(place, outward);
    }
    return outward.dot(axis_) > facing ? std::optional(projected(place, uprightFrame(axis_)))
                                       : std::nullopt;
}

double LayerPlane::coveredShare(const Eigen::Vector2d& size) const {
    constexpr std::size_t directions = 90;
    if (!unfolded_) {
        return 0;
    }
    std::vector<FlatPiece> pieces = unfolded_->pieces();
    std::erase_if(pieces, [&](const FlatPiece& piece) {
        const Eigen::Vector2d inPicture = turn_ * piece.flat;
        return (inPicture.cwiseAbs() - size / 2).maxCoeff() > 0;
    });
    std::vector<SurfacePoint> places;
    for (const FlatPiece& piece : pieces) {
        places.push_back(piece.place);
    }
    const std::vector<std::uint8_t> buried = buriedPlaces(mesh_, places);
    std::array<double, directions> end{}; // where the decal ends in each direction, mm
    end.fill(std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const Eigen::Vector2d& flat = pieces[k].flat;
        const double turn = (std::atan2(flat.y(), flat.x()) + pi) / (2 * pi);
        double& own = end[std::min(std::size_t(turn * double(directions)), directions - 1)];
        own = buried[k] != 0 ? std::min(own, flat.norm()) : own;
    }
    double lost = 0, all = 0; // areas in the picture, relative to each other
    for (std::size_t k = 0; k < directions; ++k) {
        const double angle = (double(k) + 0.5) / double(directions) * 2 * pi - pi;
        const Eigen::Vector2d way = turn_ * Eigen::Vector2d(std::cos(angle), std::sin(angle));
        const double border = (size / 2).cwiseQuotient(way.cwiseAbs()).minCoeff();
        all += border * border;
        lost += std::max(border * border - end[k] * end[k], 0.0);
    }
    return lost / all;
}

} // namespace dipwright
