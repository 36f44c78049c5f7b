#include "dip/BodyPath.h"

#include "base/Error.h"
#include "base/NumberText.h"
#include "dip/PathMoves.h"
#include "dip/Pose.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(BodyPath)
};

constexpr double farthestTravel = 10'000; // mm, sideways

std::vector<solver::PathPose> posesOf(const std::vector<Move>& moves, double radius) {
    std::vector<solver::PathPose> poses;
    for (const Move& move : moves) {
        solver::PathPose& pose = poses.emplace_back();
        pose.seconds = move.seconds;
        pose.rotation = {move.turn.w(), move.turn.x(), move.turn.y(), move.turn.z()};
        Eigen::Map<Eigen::Vector3d>(pose.pivot.data()) = move.middle;
    }
    measureTravel(poses, radius);
    return poses;
}

// Returns the index of the pose that ends the part of the path at `travelled`, and the share of
// this part that has been travelled.
std::pair<std::size_t, double> partAt(const solver::BodyPath& path, double travelled) {
    const auto after = std::lower_bound(
        path.poses.begin() + 1, path.poses.end() - 1, travelled,
        [](const solver::PathPose& pose, double way) { return pose.travelled < way; });
    const double begin = (after - 1)->travelled;
    return {std::size_t(after - path.poses.begin()),
            std::clamp((travelled - begin) / (after->travelled - begin), 0.0, 1.0)};
}

Eigen::Vector3d vectorOf(const std::array<double, 3>& values) {
    return Eigen::Map<const Eigen::Vector3d>(values.data());
}

} // namespace

Eigen::Quaterniond rotationOf(const solver::PathPose& pose) {
    return {pose.rotation[0], pose.rotation[1], pose.rotation[2], pose.rotation[3]};
}

void measureTravel(std::vector<solver::PathPose>& poses, double radius) {
    const auto moveOf = [](const solver::PathPose& pose) {
        return Move{pose.seconds, rotationOf(pose), vectorOf(pose.pivot)};
    };
    poses.front().travelled = 0;
    for (std::size_t i = 1; i < poses.size(); ++i) {
        poses[i].travelled =
            poses[i - 1].travelled + wayBetween(moveOf(poses[i - 1]), moveOf(poses[i]), radius);
    }
}

double lowestPoint(const TriangleMesh& body, const Eigen::Isometry3d& toWorld) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3f& place : body.positions) {
        lowest = std::min(lowest, toWorld.linear().row(1).dot(place.cast<double>()));
    }
    return lowest + toWorld.translation().y();
}

Degrees travellableAngle(PathKind kind, Degrees angle) {
    switch (kind) {
    case PathKind::Slanted:
        return std::clamp(angle, Degrees(10), Degrees(170));
    case PathKind::Tilt:
        return std::clamp(angle, Degrees(-85), Degrees(85));
    case PathKind::Roll: // farther, the part would lay film on its own film
        return std::clamp(angle, Degrees(-360), Degrees(360));
    case PathKind::Straight:
    case PathKind::Poses:
        break;
    }
    return angle;
}

Eigen::Isometry3d placeOnPath(const solver::BodyPath& path, double travelled) {
    const auto [after, share] = partAt(path, travelled);
    const solver::PathPose &from = path.poses[after - 1], &to = path.poses[after];
    const Eigen::Vector3d pivot =
        vectorOf(from.pivot) + share * (vectorOf(to.pivot) - vectorOf(from.pivot));
    return Eigen::Translation3d(pivot) * rotationOf(from).slerp(share, rotationOf(to)) *
           Eigen::Translation3d(-vectorOf(path.pivot));
}

double secondsOnPath(const solver::BodyPath& path, double travelled) {
    const auto [after, share] = partAt(path, travelled);
    const double begin = path.poses[after - 1].seconds;
    return begin + share * (path.poses[after].seconds - begin);
}

double travelledAfter(const solver::BodyPath& path, double seconds) {
    const auto after =
        std::lower_bound(path.poses.begin() + 1, path.poses.end() - 1, seconds,
                         [](const solver::PathPose& pose, double at) { return pose.seconds < at; });
    const solver::PathPose &from = *(after - 1), &to = *after;
    const double share =
        std::clamp((seconds - from.seconds) / (to.seconds - from.seconds), 0.0, 1.0);
    return from.travelled + share * (to.travelled - from.travelled);
}

PathSpeed speedOnPath(const solver::BodyPath& path) {
    const auto between = [](const solver::PathPose& from, const solver::PathPose& to) {
        return (to.travelled - from.travelled) / (to.seconds - from.seconds);
    };
    PathSpeed speed{between(path.poses.front(), path.poses.back())};
    for (std::size_t i = 1; i < path.poses.size(); ++i) {
        speed.most = std::max(speed.most, between(path.poses[i - 1], path.poses[i]));
    }
    return speed;
}

std::optional<double> firstUnderWater(const solver::BodyPath& path, const Eigen::Vector3d& at) {
    constexpr int halvings = 12;
    const auto heightAt = [&](double way) { return (placeOnPath(path, way) * at).y(); };
    const Eigen::Vector3d arm = at - vectorOf(path.pivot);
    double above = 0;
    for (const solver::PathPose& pose : path.poses) {
        if ((rotationOf(pose) * arm).y() + pose.pivot[1] > 0) {
            above = pose.travelled;
            continue;
        }
        double under = pose.travelled;
        for (int i = 0; i < halvings; ++i) {
            const double middle = (above + under) / 2;
            (heightAt(middle) > 0 ? above : under) = middle;
        }
        return under;
    }
    return std::nullopt;
}

solver::BodyPath bodyPath(const TriangleMesh& posed, const Immersion& immersion,
                          const ProcessSettings& process) {
    if (immersion.path.isStraightDown()) {
        return {};
    }
    const PathShape shape(posed);
    const double depth = dipDepth(process, shape.height());
    solver::BodyPath path;
    Eigen::Map<Eigen::Vector3d>(path.pivot.data()) = shape.middle();
    const std::vector<Move> moves = plannedMoves(shape, immersion, process, depth);
    for (const Move& move : moves) {
        if (!(move.middle.norm() < farthestTravel)) {
            throw Error(Text::tr("On its path the part travels more than %1 m; choose a smaller "
                                 "angle or water speed, or a faster dip")
                            .arg(farthestTravel / 1000),
                        immersion.name);
        }
    }
    path.poses = posesOf(moves, shape.radius());
    if (path.poses.back().travelled > 2 * farthestTravel) {
        throw Error(Text::tr("On its path the part travels and turns more than %1 m in all; use "
                             "fewer poses or smaller turns")
                        .arg(2 * farthestTravel / 1000),
                    immersion.name);
    }
    return path;
}

solver::BodyPath pathOfModel(const solver::BodyPath& path, const Eigen::Isometry3d& toPose,
                             const Immersion& immersion) {
    solver::BodyPath result = path;
    const Eigen::Quaterniond body(toPose.linear());
    const Eigen::Vector3d pivot = toPose.inverse() * vectorOf(path.pivot);
    Eigen::Map<Eigen::Vector3d>(result.pivot.data()) = pivot;
    for (solver::PathPose& pose : result.poses) {
        const Eigen::Quaterniond turn = (rotationOf(pose) * body).normalized();
        pose.rotation = {turn.w(), turn.x(), turn.y(), turn.z()};
        pose.pivot[0] += immersion.offset[0].value();
        pose.pivot[2] += immersion.offset[1].value();
    }
    return result;
}

Eigen::Vector3d waterVelocity(const DipPath& path) {
    return path.waterSpeed.value() * directionOf(path.heading);
}

QString pathText(const DipPath& path) {
    const QLocale locale;
    const auto degrees = [&](Degrees angle) {
        return withMinusSign(locale.toString(angle.value(), 'g', 4));
    };
    QStringList words;
    switch (path.kind) {
    case PathKind::Straight:
        break;
    case PathKind::Slanted:
        words << Text::tr("slanted by %1°, heading %2°")
                     .arg(degrees(path.angle), degrees(path.heading));
        break;
    case PathKind::Tilt:
        words << Text::tr("tilted by %1°, heading %2°")
                     .arg(degrees(path.angle), degrees(path.heading));
        break;
    case PathKind::Roll:
        words << Text::tr("rolled by %1°, heading %2°")
                     .arg(degrees(path.angle), degrees(path.heading));
        break;
    case PathKind::Poses:
        words << Text::tr("through %1 poses").arg(path.keys.size());
        break;
    }
    if (path.kind != PathKind::Poses && path.turn != Degrees(0)) {
        words << Text::tr("turned by %1° on the way down").arg(degrees(path.turn));
    }
    if (path.waterSpeed != MillimetresPerSecond(0)) {
        words << Text::tr("water at %1 mm/s, heading %2°")
                     .arg(withMinusSign(locale.toString(path.waterSpeed.value(), 'g', 4)),
                          degrees(path.heading));
    }
    if (path.isSlowed()) {
        words << Text::tr("slow at the beginning and the end");
    }
    if (path.acceleration) {
        words << Text::tr("acceleration at most %1 mm/s²")
                     .arg(locale.toString(path.acceleration->value(), 'g', 4));
    }
    return words.join(QStringLiteral(", "));
}

std::vector<PathMoment> momentsOf(const solver::BodyPath& path, double most) {
    std::vector<PathMoment> moments{{0, placeOnPath(path, 0)}};
    for (std::size_t i = 1; i < path.poses.size(); ++i) {
        const double begin = path.poses[i - 1].travelled, end = path.poses[i].travelled;
        const int parts = std::max(2, int(std::ceil((end - begin) / most)));
        for (int part = 1; part <= parts; ++part) {
            const double way = begin + (end - begin) * part / parts;
            moments.push_back({way, placeOnPath(path, way)});
        }
    }
    return moments;
}

double shadowStep(const TriangleMesh& posed) {
    return std::max(double(boundingBox(posed).diagonal().norm()) / 12, 0.5);
}

double riseOnPath(const solver::BodyPath& path, const TriangleMesh& posed) {
    if (path.isStraightDown()) {
        return 0;
    }
    double deepest = 0, rise = 0;
    for (const PathMoment& moment : momentsOf(path, shadowStep(posed))) {
        const double depth = -lowestPoint(posed, moment.poseToWorld);
        deepest = std::max(deepest, depth);
        rise = deepest > 0 ? std::max(rise, (deepest - depth) / deepest) : 0;
    }
    return rise;
}

Eigen::AlignedBox2d shadowAt(const TriangleMesh& body, const Eigen::Isometry3d& toWorld,
                             ShadowOf part) {
    const auto shadowOf = [](const Eigen::Vector3d& at) { return Eigen::Vector2d(at.x(), at.z()); };
    Eigen::AlignedBox2d shadow;
    std::vector<Eigen::Vector3d> places;
    for (const Eigen::Vector3f& place : body.positions) {
        const Eigen::Vector3d& at = places.emplace_back(toWorld * place.cast<double>());
        if (part == ShadowOf::Whole || at.y() <= 0) {
            shadow.extend(shadowOf(at));
        }
    }
    if (part == ShadowOf::Whole) {
        return shadow;
    }
    for (const auto& corners : body.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Eigen::Vector3d &from = places[corners[k]], &to = places[corners[(k + 1) % 3]];
            if (from.y() * to.y() < 0) {
                shadow.extend(shadowOf(from + from.y() / (from.y() - to.y()) * (to - from)));
            }
        }
    }
    return shadow;
}

Eigen::AlignedBox2d shadowOnPath(const solver::BodyPath& path, const TriangleMesh& posed,
                                 ShadowOf part) {
    Eigen::AlignedBox2d shadow;
    for (const PathMoment& moment : momentsOf(path, shadowStep(posed))) {
        shadow.extend(shadowAt(posed, moment.poseToWorld, part));
    }
    return shadow;
}

Eigen::Vector3d upAtWater(const solver::BodyPath& path, const Eigen::Vector3d& at) {
    if (path.isStraightDown()) {
        return Eigen::Vector3d::UnitY();
    }
    const double way = firstUnderWater(path, at).value_or(path.poses.back().travelled);
    return placeOnPath(path, way).linear().row(1);
}

bool isTilting(const solver::BodyPath& path) {
    constexpr double alike = 0.9998; // cosine of about 1°
    return std::any_of(path.poses.begin(), path.poses.end(), [](const solver::PathPose& pose) {
        return rotationOf(pose).toRotationMatrix()(1, 1) < alike;
    });
}

} // namespace dipwright
