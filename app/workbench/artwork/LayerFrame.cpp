#include "workbench/artwork/LayerFrame.h"

#include "artwork/EditArtwork.h"

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

constexpr double stalk = 1.25;  // position of the turn handle, in half heights
constexpr int pieces = 16;      // of each side of the outline, so that it follows the surface
constexpr double square = 0.06; // half a handle's side, in layer diagonals

Eigen::Vector3d vectorOf(const std::array<Millimetres, 3>& place) {
    return {place[0].value(), place[1].value(), place[2].value()};
}

double roundedTo(double value, double step) {
    return std::round(value / step) * step + 0.0;
}

} // namespace

LayerFrame::LayerFrame(const ArtworkLayer& layer, const DipScene& scene)
    : layer_(layer), scene_(scene), place_(vectorOf(layer.place)),
      frame_(uprightFrame(Eigen::Vector3d::UnitZ())) {
    const TriangleMesh& mesh = scene.model()->mesh;
    const SurfacePoint middle = scene.nearestSurface(place_.cast<float>());
    place_ = position(mesh, middle).cast<double>();
    const Eigen::Vector3d outward = triangleNormal(mesh, middle.triangle).cast<double>();
    const SurfaceFrame upright =
        uprightFrame(outward.isZero() ? Eigen::Vector3d::UnitZ() : outward.normalized());
    const double angle = radians(layer.turn);
    frame_.right = std::cos(angle) * upright.right + std::sin(angle) * upright.up;
    frame_.up = -std::sin(angle) * upright.right + std::cos(angle) * upright.up;
    frame_.outward = upright.outward;
    const auto size = shownSize(layer);
    half_ = {size[0].value() / 2, size[1].value() / 2};
}

Eigen::Vector3f LayerFrame::onBody(const Eigen::Vector2d& place) const {
    const Eigen::Vector3d flat = place_ + place.x() * frame_.right + place.y() * frame_.up;
    return position(scene_.model()->mesh, scene_.nearestSurface(flat.cast<float>()));
}

std::vector<ViewLine> LayerFrame::lines(const QColor& colour) const {
    std::vector<ViewLine> lines;
    const auto draw = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to, int parts) {
        for (int part = 0; part < parts; ++part) {
            const auto at = [&](int k) { return onBody(from + double(k) / parts * (to - from)); };
            lines.push_back({{at(part), at(part + 1)}, colour});
        }
    };
    const auto drawBox = [&](const Eigen::Vector2d& middle, const Eigen::Vector2d& half,
                             int parts) {
        const Eigen::Vector2d across(half.x(), -half.y());
        draw(middle - half, middle + across, parts);
        draw(middle + across, middle + half, parts);
        draw(middle + half, middle - across, parts);
        draw(middle - across, middle - half, parts);
    };
    drawBox({0, 0}, half_, pieces);
    const Eigen::Vector2d handle = Eigen::Vector2d::Constant(square * half_.norm());
    drawBox(half_, handle, 1);
    draw({0, half_.y()}, {0, stalk * half_.y()}, 4);
    drawBox({0, stalk * half_.y()}, handle, 1);
    return lines;
}

std::optional<Eigen::Vector2d> LayerFrame::flat(const ViewRay& ray) const {
    const Eigen::Vector3d origin = scene_.toModel(ray.origin).cast<double>();
    const Eigen::Vector3d direction =
        scene_.toModel(ray.origin + ray.direction).cast<double>() - origin;
    const double slope = direction.dot(frame_.outward);
    if (std::abs(slope) < 1e-3) {
        return std::nullopt;
    }
    const Eigen::Vector3d away =
        origin + frame_.outward.dot(place_ - origin) / slope * direction - place_;
    return Eigen::Vector2d(frame_.right.dot(away), frame_.up.dot(away));
}

std::optional<FrameHandle> LayerFrame::handleAt(const ViewRay& ray, double reach) const {
    const Eigen::Vector3d origin = scene_.toModel(ray.origin).cast<double>();
    const Eigen::Vector3d direction =
        (scene_.toModel(ray.origin + ray.direction).cast<double>() - origin).normalized();
    const auto isAt = [&](const Eigen::Vector2d& handle) {
        const Eigen::Vector3d away = onBody(handle).cast<double>() - origin;
        return (away - direction.dot(away) * direction).norm() <
               std::max(reach, 1.5 * square * half_.norm());
    };
    if (isAt(half_)) {
        return FrameHandle::Size;
    }
    if (isAt({0, stalk * half_.y()})) {
        return FrameHandle::Turn;
    }
    const auto met = scene_.modelPoint(ray);
    const auto at = met ? flat(ray) : std::nullopt;
    const bool isInside = at && std::abs(at->x()) <= half_.x() && std::abs(at->y()) <= half_.y() &&
                          (met->cast<double>() - place_).norm() <= half_.norm();
    return isInside ? std::optional(FrameHandle::Move) : std::nullopt;
}

ArtworkLayer LayerFrame::dragged(FrameHandle handle, const ViewRay& from, const ViewRay& to) const {
    ArtworkLayer layer = layer_;
    if (handle == FrameHandle::Move) {
        const auto begin = scene_.modelPoint(from), end = scene_.modelPoint(to);
        if (begin && end) {
            const Eigen::Vector3f there = position(
                scene_.model()->mesh,
                scene_.nearestSurface((place_ + (*end - *begin).cast<double>()).cast<float>()));
            for (int axis = 0; axis < 3; ++axis) {
                layer.place[std::size_t(axis)] = Millimetres(roundedTo(double(there[axis]), 0.01));
            }
        }
        return layer;
    }
    const auto begin = flat(from), end = flat(to);
    if (!begin || !end || !(begin->norm() > 0) || !(end->norm() > 0)) {
        return layer;
    }
    if (handle == FrameHandle::Turn) {
        const double turn =
            layer_.turn.value() +
            (std::atan2(end->y(), end->x()) - std::atan2(begin->y(), begin->x())) * 180 / pi;
        layer.turn = Degrees(roundedTo(std::remainder(turn, 360.0), 0.5));
        return layer;
    }
    const double factor = end->norm() / begin->norm();
    for (std::size_t side = 0; side < 2; ++side) {
        layer.size[side] = Millimetres(std::clamp(
            roundedTo(layer_.size[side].value() * factor, 0.1), smallestLayer, largestLayer));
    }
    return layer;
}

} // namespace dipwright
