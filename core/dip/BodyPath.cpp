#include "dip/BodyPath.h"

#include "base/Error.h"
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

// The most by which the body turns between two poses. Between them the pivot moves on a straight
// line, so the lowest point of a tilting body is off by less than 1/1000 of its distance.
constexpr double turnOfAPose = 5 * pi / 180;
constexpr double farthestTravel = 10'000; // mm, sideways

// A pose: the body's rotation relative to its final one, and the pivot's place relative to the
// offset.
struct Move {
    double seconds = 0;
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
};

// The shape of the body that a path needs.
class Shape {
public:
    explicit Shape(const TriangleMesh& posed) {
        const BoundingBox box = boundingBox(posed);
        height_ = double(box.sizes().y());
        middle_ = {0, double(box.min().y()) + height_ / 2, 0};
        places_.reserve(posed.positions.size());
        for (const Eigen::Vector3f& place : posed.positions) {
            places_.push_back(place.cast<double>() - middle_);
        }
    }
    const Eigen::Vector3d& middle() const { return middle_; }
    double height() const { return height_; }
    // Returns how far the lowest point of the turned body lies under its pivot.
    double below(const Eigen::Quaterniond& turn) const {
        const Eigen::RowVector3d up = turn.toRotationMatrix().row(1);
        double lowest = std::numeric_limits<double>::infinity();
        for (const Eigen::Vector3d& place : places_) {
            lowest = std::min(lowest, up.dot(place));
        }
        return -lowest;
    }
    double radius() const {
        double most = 0;
        for (const Eigen::Vector3d& place : places_) {
            most = std::max(most, place.norm());
        }
        return most;
    }

    // Returns the distance of the farthest point from the horizontal axis across `heading`.
    double reachAcross(const Eigen::Vector3d& heading) const {
        double most = 0;
        for (const Eigen::Vector3d& place : places_) {
            most = std::max(most, std::hypot(place.dot(heading), place.y()));
        }
        return most;
    }

private:
    Eigen::Vector3d middle_;
    double height_ = 0;
    std::vector<Eigen::Vector3d> places_; // from the pivot
};

Eigen::Vector3d directionOf(Degrees heading) {
    return {std::cos(radians(heading)), 0, std::sin(radians(heading))};
}

// A turn about this axis by a positive angle lowers the side of the heading, like a wheel that
// rolls in that direction.
Eigen::Quaterniond forwards(Degrees heading, double angle) {
    return Eigen::Quaterniond(
        Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY().cross(directionOf(heading))));
}

int partsOf(double angle) {
    return std::max(1, int(std::ceil(std::abs(angle) / turnOfAPose)));
}

class Planner {
public:
    Planner(const Shape& shape, const DipPath& path, const ProcessSettings& process, double depth)
        : shape_(shape), path_(path), process_(process), depth_(depth) {}

    std::vector<Move> moves() {
        switch (path_.kind) {
        case PathKind::Straight:
            goDown(noTilt, notBeside, {});
            break;
        case PathKind::Slanted: {
            const double steepness = std::tan(radians(path_.angle));
            goDown(noTilt,
                   [&](double deep) -> Eigen::Vector3d {
                       return (deep + startHeight) / steepness * directionOf(path_.heading);
                   },
                   {});
            break;
        }
        case PathKind::Tilt:
            tilt();
            break;
        case PathKind::Roll:
            roll();
            break;
        }
        flow();
        return std::move(moves_);
    }

private:
    static double noTilt(double) { return 0; }
    static Eigen::Vector3d notBeside(double) { return Eigen::Vector3d::Zero(); }

    // Speed of the dip at a depth of the lowest point.
    double speedAt(double deep) const {
        const double slow = path_.slowWay.value();
        const bool isSlow = path_.slowSpeed && slow > 0 && (deep < slow || deep > depth_ - slow);
        return isSlow ? path_.slowSpeed->value() : process_.dipSpeed.value();
    }

    // Divides the depths from `first` to `last` into `parts` equal parts and adds the beginning of
    // each.
    static void split(double first, double last, int parts, std::vector<double>& stops) {
        for (int part = 0; part < parts; ++part) {
            stops.push_back(first + (last - first) * part / parts);
        }
    }

    // Goes down until the lowest point is at the depth of the dip. tiltAt(depth) is the tilt
    // towards the heading, beside(depth) the sideways travel; `stops` are further depths that need
    // a pose.
    template <typename TiltAt, typename Beside>
    void goDown(const TiltAt& tiltAt, const Beside& beside, std::vector<double> stops) {
        constexpr double close = 1e-6; // mm; if two stops are closer, one is left out
        split(-startHeight, depth_, partsOf(radians(path_.turn)), stops);
        if (path_.slowSpeed) {
            stops.push_back(path_.slowWay.value());
            stops.push_back(depth_ - path_.slowWay.value());
        }
        std::erase_if(stops, [&](double deep) {
            return deep <= -startHeight + close || deep >= depth_ - close;
        });
        stops.push_back(-startHeight);
        stops.push_back(depth_);
        std::sort(stops.begin(), stops.end());
        double before = -startHeight;
        for (const double deep : stops) {
            if (!moves_.empty() && deep - before < close) {
                continue;
            }
            const double left = 1 - (deep + startHeight) / (depth_ + startHeight);
            const Eigen::Quaterniond turn =
                forwards(path_.heading, tiltAt(deep)) *
                Eigen::Quaterniond(
                    Eigen::AngleAxisd(-left * radians(path_.turn), Eigen::Vector3d::UnitY()));
            // The lowest point moves at the speed of the dip; the pivot's speed may differ.
            const double seconds = (deep - before) / speedAt((deep + before) / 2);
            moves_.push_back(
                {moves_.empty() ? 0 : moves_.back().seconds + seconds, turn,
                 beside(deep) + (shape_.below(turn) - deep) * Eigen::Vector3d::UnitY()});
            before = deep;
        }
    }

    void tilt() {
        const double level =
            std::min(path_.levelDepth ? path_.levelDepth->value() : depth_, depth_);
        const double entry = radians(path_.angle);
        std::vector<double> stops{level};
        split(-startHeight, level, partsOf(entry), stops);
        goDown(
            [&](double deep) {
                return deep >= level ? 0.0 : entry * (level - deep) / (level + startHeight);
            },
            notBeside, std::move(stops));
    }

    // The lowest point stays at the depth of the dip. The pivot's travel, or the arc of the point
    // farthest from the axis if that is longer, is covered at the speed of the dip.
    void roll() {
        const double angle = radians(path_.angle);
        const double radius = path_.rollRadius ? path_.rollRadius->value() : shape_.height() / 2;
        goDown([&](double) { return -angle; }, notBeside, {});
        const Move down = moves_.back();
        const double reach = shape_.reachAcross(directionOf(path_.heading));
        const int parts = angle == 0 ? 0 : partsOf(angle);
        for (int part = 1; part <= parts; ++part) {
            const double rolled = angle * part / parts;
            const Eigen::Quaterniond turn = forwards(path_.heading, rolled - angle);
            Eigen::Vector3d middle = down.middle + rolled * radius * directionOf(path_.heading);
            middle.y() = shape_.below(turn) - depth_;
            const Move& last = moves_.back();
            const double way =
                std::max((middle - last.middle).norm(), last.turn.angularDistance(turn) * reach);
            moves_.push_back({last.seconds + way / process_.dipSpeed.value(), turn, middle});
        }
    }

    // The film moves with the water, so the part travels against it.
    void flow() {
        for (Move& move : moves_) {
            move.middle -= move.seconds * waterVelocity(path_);
        }
    }

    const Shape& shape_;
    const DipPath& path_;
    const ProcessSettings& process_;
    double depth_; // of the lowest point at the end of the way down, mm
    std::vector<Move> moves_;
};

void requireTravellable(const DipPath& path, const Immersion& immersion) {
    constexpr double flattest = 10;
    const double angle = path.angle.value();
    if (path.kind == PathKind::Slanted && (angle < flattest || angle > 180 - flattest)) {
        throw Error(Text::tr("A slanted dip needs an angle to the water between %1° and %2°")
                        .arg(flattest)
                        .arg(180 - flattest),
                    immersion.name);
    }
    if (path.kind == PathKind::Tilt && std::abs(angle) > 85) {
        throw Error(Text::tr("The part can enter tilted by at most 85°"), immersion.name);
    }
}

// Returns the poses of the path. Between two of them, no point of the body moves farther than
// `travelled` grows.
std::vector<solver::PathPose> posesOf(const std::vector<Move>& moves, double radius) {
    std::vector<solver::PathPose> poses;
    for (const Move& move : moves) {
        solver::PathPose pose;
        pose.seconds = move.seconds;
        pose.rotation = {move.turn.w(), move.turn.x(), move.turn.y(), move.turn.z()};
        Eigen::Map<Eigen::Vector3d>(pose.pivot.data()) = move.middle;
        if (!poses.empty()) {
            const Move& last = moves[poses.size() - 1];
            pose.travelled = poses.back().travelled + (move.middle - last.middle).norm() +
                             radius * last.turn.angularDistance(move.turn);
        }
        poses.push_back(pose);
    }
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
    requireTravellable(immersion.path, immersion);
    const Shape shape(posed);
    const double depth = dipDepth(process, shape.height());
    solver::BodyPath path;
    Eigen::Map<Eigen::Vector3d>(path.pivot.data()) = shape.middle();
    const std::vector<Move> moves = Planner(shape, immersion.path, process, depth).moves();
    for (const Move& move : moves) {
        if (!(move.middle.norm() < farthestTravel)) {
            throw Error(Text::tr("On its path the part travels more than %1 m; choose a smaller "
                                 "angle or water speed, or a faster dip")
                            .arg(farthestTravel / 1000),
                        immersion.name);
        }
    }
    path.poses = posesOf(moves, shape.radius());
    return path;
}

solver::BodyPath pathOfModel(const solver::BodyPath& path, const Eigen::Isometry3d& modelToPose,
                             const Immersion& immersion) {
    solver::BodyPath result = path;
    const Eigen::Quaterniond model(modelToPose.linear());
    const Eigen::Vector3d pivot = modelToPose.inverse() * vectorOf(path.pivot);
    Eigen::Map<Eigen::Vector3d>(result.pivot.data()) = pivot;
    for (solver::PathPose& pose : result.poses) {
        const Eigen::Quaterniond turn = (rotationOf(pose) * model).normalized();
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
    const auto degrees = [&](Degrees angle) { return locale.toString(angle.value(), 'g', 4); };
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
    }
    if (path.turn != Degrees(0)) {
        words << Text::tr("turned by %1° on the way down").arg(degrees(path.turn));
    }
    if (path.waterSpeed != MillimetresPerSecond(0)) {
        words << Text::tr("water at %1 mm/s, heading %2°")
                     .arg(locale.toString(path.waterSpeed.value(), 'g', 4), degrees(path.heading));
    }
    if (path.slowSpeed) {
        words << Text::tr("slow at the beginning and the end");
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

Eigen::AlignedBox2d shadowOnPath(const solver::BodyPath& path, const TriangleMesh& posed,
                                 ShadowOf part) {
    Eigen::AlignedBox2d shadow;
    for (const PathMoment& moment : momentsOf(path, shadowStep(posed))) {
        for (const Eigen::Vector3f& place : posed.positions) {
            const Eigen::Vector3d at = moment.poseToWorld * place.cast<double>();
            if (part == ShadowOf::Whole || at.y() <= 0) {
                shadow.extend(Eigen::Vector2d(at.x(), at.z()));
            }
        }
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
