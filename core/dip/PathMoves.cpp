#include "dip/PathMoves.h"

#include "base/Error.h"
#include "dip/BodyPath.h"
#include "dip/Pose.h"

#include <QCoreApplication>
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
// A turn about this axis by a positive angle lowers the side of the heading, like a wheel that
// rolls in that direction.
Eigen::Quaterniond forwards(Degrees heading, double angle) {
    return Eigen::Quaterniond(
        Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY().cross(directionOf(heading))));
}

int partsOf(double angle) {
    return std::max(1, int(std::ceil(std::abs(angle) / turnOfAPose)));
}

// The values of a PathKey between which a part moves smoothly: depth of the lowest point, mm, place
// beside the offset along X and Z, mm, and rotation about X, Y and Z, degrees.
using KeyValues = Eigen::Matrix<double, 6, 1>;

KeyValues valuesOf(const PathKey& key, double depth) {
    KeyValues values;
    values << (key.depth ? key.depth->value() : depth), key.beside[0].value(),
        key.beside[1].value(), key.turn[0].value(), key.turn[1].value(), key.turn[2].value();
    return values;
}

// Returns the rates of change at the keys for a curve that rests at both ends and never passes the
// values of its keys: zero where the change turns round, otherwise the harmonic mean of the rates
// before and after (Fritsch and Carlson 1980, Brodlie's weights for equal parts).
std::vector<KeyValues> smoothRates(const std::vector<PathKey>& keys,
                                   const std::vector<KeyValues>& values) {
    std::vector<KeyValues> rates(keys.size(), KeyValues::Zero());
    for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
        const KeyValues before =
            (values[i] - values[i - 1]) / (keys[i].time - keys[i - 1].time).value();
        const KeyValues after =
            (values[i + 1] - values[i]) / (keys[i + 1].time - keys[i].time).value();
        for (int part = 0; part < 6; ++part) {
            if (before[part] * after[part] > 0) {
                rates[i][part] = 2 / (1 / before[part] + 1 / after[part]);
            }
        }
    }
    return rates;
}

// Cubic Hermite interpolation; `share` of the part of length `seconds` has passed.
KeyValues between(const KeyValues& from, const KeyValues& fromRate, const KeyValues& to,
                  const KeyValues& toRate, double seconds, double share) {
    const double square = share * share, cube = square * share;
    return from + (3 * square - 2 * cube) * (to - from) +
           seconds * ((cube - 2 * square + share) * fromRate + (cube - square) * toRate);
}

// Returns into how many parts, between which the part moves evenly, the way between two poses is
// divided.
int partsBetween(const PathKey& from, const PathKey& to) {
    constexpr int least = 12;
    double turned = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        turned += std::abs(radians(to.turn[axis] - from.turn[axis]));
    }
    return std::max(least, 2 * partsOf(turned));
}

// The moves through the poses that the user set.
std::vector<Move> keyedMoves(const PathShape& shape, const DipPath& path, double depth) {
    std::vector<KeyValues> values;
    for (const PathKey& key : path.keys) {
        values.push_back(valuesOf(key, depth));
    }
    values.front()[0] = -startHeight;
    const std::vector<KeyValues> rates = smoothRates(path.keys, values);
    std::vector<Move> moves;
    const auto add = [&](double seconds, const KeyValues& at) {
        const Eigen::Quaterniond turn(
            rotationMatrix({Degrees(at[3]), Degrees(at[4]), Degrees(at[5])}));
        moves.push_back({seconds, turn, Eigen::Vector3d(at[1], shape.below(turn) - at[0], at[2])});
    };
    add(0, values.front());
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double begin = path.keys[i - 1].time.value();
        const double seconds = path.keys[i].time.value() - begin;
        const int parts = partsBetween(path.keys[i - 1], path.keys[i]);
        for (int part = 1; part <= parts; ++part) {
            const double share = double(part) / parts;
            add(begin + share * seconds,
                between(values[i - 1], rates[i - 1], values[i], rates[i], seconds, share));
        }
    }
    return moves;
}

// Returns the same way, begun and ended at rest and travelled with at most this acceleration along
// it, mm/s²; no part of it is travelled faster than before.
std::vector<Move> ramped(const std::vector<Move>& moves, double acceleration, double radius) {
    std::vector<double> ways{0}, speeds{0}; // of the part that ends at each move
    for (std::size_t i = 1; i < moves.size(); ++i) {
        ways.push_back(wayBetween(moves[i - 1], moves[i], radius));
        speeds.push_back(ways[i] / (moves[i].seconds - moves[i - 1].seconds));
    }
    // The highest speed at each move from which the next ones can be reached.
    std::vector<double> passing(moves.size(), 0);
    const auto reachable = [&](double speed, double way) {
        return std::sqrt(speed * speed + 2 * acceleration * way);
    };
    for (std::size_t i = 1; i + 1 < moves.size(); ++i) {
        passing[i] = std::min({speeds[i], speeds[i + 1], reachable(passing[i - 1], ways[i])});
    }
    for (std::size_t i = moves.size() - 1; i > 0; --i) {
        passing[i - 1] = std::min(passing[i - 1], reachable(passing[i], ways[i]));
    }
    std::vector<Move> result{moves.front()};
    for (std::size_t i = 1; i < moves.size(); ++i) {
        const Move &from = moves[i - 1], &to = moves[i];
        const double way = ways[i], first = passing[i - 1], last = passing[i];
        const double top =
            std::min(speeds[i], std::sqrt((first * first + last * last) / 2 + acceleration * way));
        const double rise = (top * top - first * first) / (2 * acceleration);
        const double fall = (top * top - last * last) / (2 * acceleration);
        const double begin = result.back().seconds;
        const double even = top > 0 ? std::max(0.0, way - rise - fall) / top : 0;
        const double riseTime = (top - first) / acceleration,
                     fallTime = (top - last) / acceleration;
        const auto add = [&](double seconds, double along) {
            const double share = std::min(along / way, 1.0);
            constexpr double apart = 1e-9; // s
            const bool isBetween = begin + seconds > result.back().seconds + apart &&
                                   seconds < riseTime + even + fallTime - apart && share < 1;
            if (isBetween) {
                result.push_back({begin + seconds, from.turn.slerp(share, to.turn),
                                  from.middle + share * (to.middle - from.middle)});
            }
        };
        constexpr int parts = 6; // of a ramp
        for (int part = 1; part <= parts && rise > 0; ++part) {
            const double time = riseTime * part / parts;
            add(time, first * time + acceleration * time * time / 2);
        }
        for (int part = 0; part < parts && fall > 0; ++part) {
            const double time = fallTime * part / parts;
            add(riseTime + even + time, way - fall + top * time - acceleration * time * time / 2);
        }
        result.push_back({begin + riseTime + even + fallTime, to.turn, to.middle});
    }
    return result;
}

class Planner {
public:
    Planner(const PathShape& shape, const DipPath& path, const ProcessSettings& process,
            double depth)
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
        case PathKind::Poses:
            moves_ = keyedMoves(shape_, path_, depth_);
            break;
        }
        if (path_.acceleration) {
            moves_ = ramped(moves_, path_.acceleration->value(), shape_.radius());
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
        const bool isSlow = path_.isSlowed() && (deep < slow || deep > depth_ - slow);
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

    const PathShape& shape_;
    const DipPath& path_;
    const ProcessSettings& process_;
    double depth_; // of the lowest point at the end of the way down, mm
    std::vector<Move> moves_;
};

void requireKeys(const DipPath& path, const Immersion& immersion) {
    const auto refuse = [&](const QString& text) { throw Error(text, immersion.name); };
    if (path.keys.size() < 2) {
        refuse(Text::tr("A path by poses needs at least two poses"));
    }
    if (path.keys.front().time != Seconds(0) ||
        path.keys.front().depth != std::optional(Millimetres(0))) {
        refuse(Text::tr("The first pose of a path must have the time 0 s and the depth 0 mm, at "
                        "which the part touches the water"));
    }
    constexpr double leastWait = leastPathWait.value();
    // The solvers take at most 10,000 poses; a limit of the acceleration divides each part of the
    // path into up to 13.
    const int mostParts = path.acceleration ? 750 : 9000;
    int parts = 0;
    for (std::size_t i = 1; i < path.keys.size(); ++i) {
        if (!((path.keys[i].time - path.keys[i - 1].time).value() > leastWait * (1 - 1e-9))) {
            refuse(Text::tr("Pose %1 of the path must be at least %2 s later than the pose before "
                            "it")
                       .arg(i + 1)
                       .arg(leastWait));
        }
        parts += partsBetween(path.keys[i - 1], path.keys[i]);
    }
    if (parts > mostParts) {
        refuse(Text::tr("The poses of the path turn the part too far in all; use fewer poses or "
                        "smaller turns"));
    }
    if (path.keys.back().depth || path.keys.back().turn != std::array<Degrees, 3>{}) {
        refuse(Text::tr("The last pose of a path must have the depth of the dip and no turn; to "
                        "turn the part at the end of the dip, change its rotation"));
    }
}

void requireTravellable(const DipPath& path, const Immersion& immersion) {
    if (path.kind == PathKind::Poses) {
        requireKeys(path, immersion);
    }
    if (path.angle == travellableAngle(path.kind, path.angle)) {
        return;
    }
    const auto limit = [&](double wish) {
        return travellableAngle(path.kind, Degrees(wish)).value();
    };
    switch (path.kind) {
    case PathKind::Slanted:
        throw Error(Text::tr("A slanted dip needs an angle to the water between %1° and %2°")
                        .arg(limit(-720))
                        .arg(limit(720)),
                    immersion.name);
    case PathKind::Roll:
        throw Error(
            Text::tr("A part that rolls by more than 360° lays film on its own film; choose "
                     "an angle of at most 360°"),
            immersion.name);
    case PathKind::Tilt:
        throw Error(Text::tr("The part can enter tilted by at most 85°"), immersion.name);
    case PathKind::Straight:
    case PathKind::Poses:
        break;
    }
}

} // namespace

PathShape::PathShape(const TriangleMesh& posed) {
    const BoundingBox box = boundingBox(posed);
    height_ = double(box.sizes().y());
    middle_ = {0, double(box.min().y()) + height_ / 2, 0};
    places_.reserve(posed.positions.size());
    for (const Eigen::Vector3f& place : posed.positions) {
        places_.push_back(place.cast<double>() - middle_);
    }
}

double PathShape::below(const Eigen::Quaterniond& turn) const {
    const Eigen::RowVector3d up = turn.toRotationMatrix().row(1);
    double lowest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& place : places_) {
        lowest = std::min(lowest, up.dot(place));
    }
    return -lowest;
}

double PathShape::radius() const {
    double most = 0;
    for (const Eigen::Vector3d& place : places_) {
        most = std::max(most, place.norm());
    }
    return most;
}

double PathShape::reachAcross(const Eigen::Vector3d& heading) const {
    double most = 0;
    for (const Eigen::Vector3d& place : places_) {
        most = std::max(most, std::hypot(place.dot(heading), place.y()));
    }
    return most;
}

double wayBetween(const Move& from, const Move& to, double radius) {
    constexpr double least = 1e-5; // mm; a hold counts as a short way, since a way must grow
    return std::max((to.middle - from.middle).norm() + radius * from.turn.angularDistance(to.turn),
                    least);
}

Eigen::Vector3d directionOf(Degrees heading) {
    return {std::cos(radians(heading)), 0, std::sin(radians(heading))};
}

std::vector<Move> plannedMoves(const PathShape& shape, const Immersion& immersion,
                               const ProcessSettings& process, double depth) {
    requireTravellable(immersion.path, immersion);
    return Planner(shape, immersion.path, process, depth).moves();
}

} // namespace dipwright
