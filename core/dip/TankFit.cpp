#include "dip/TankFit.h"

#include "base/NumberText.h"
#include "dip/Pose.h"
#include "film/FilmGrid.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(TankFit)
};

// What a dip requires of the tank and its machine.
struct Demand {
    Eigen::AlignedBox2d outline; // that the body covers from above, x and z from the tank's middle
    double depth = 0;            // of the lowest place below the water, mm
    double reach = 0; // farthest sideways distance of the part's centre from the tank's middle, mm
    double speed = 0; // mm/s
    double turnSpeed = 0; // °/s
};

Demand straightDemand(const TriangleMesh& posed, const Immersion& immersion,
                      const ProcessSettings& process) {
    const BoundingBox box = boundingBox(posed);
    const Eigen::Vector3d offset = pathOriginInTank(immersion, Seconds(0));
    Demand demand;
    for (const Eigen::Vector3f& corner : {box.min(), box.max()}) {
        const Eigen::Vector3d place = corner.cast<double>() + offset;
        demand.outline.extend(Eigen::Vector2d(place.x(), place.z()));
    }
    demand.depth = dipDepth(process, box.sizes().y());
    demand.reach = offset.norm();
    demand.speed = process.dipSpeed.value();
    return demand;
}

Demand demandOnPath(const solver::BodyPath& path, const TriangleMesh& posed,
                    const Immersion& immersion, const ProcessSettings& process) {
    Demand demand;
    demand.speed = process.dipSpeed.value(); // of lifting the part out
    for (const PathMoment& moment : momentsOf(path, shadowStep(posed))) {
        const Eigen::Vector3d origin =
            pathOriginInTank(immersion, Seconds(secondsOnPath(path, moment.travelled)));
        for (const Eigen::Vector3f& position : posed.positions) {
            const Eigen::Vector3d place = moment.poseToWorld * position.cast<double>() + origin;
            demand.outline.extend(Eigen::Vector2d(place.x(), place.z()));
            demand.depth = std::max(demand.depth, -place.y());
        }
    }
    const auto centreAt = [&](const solver::PathPose& pose) -> Eigen::Vector3d {
        return Eigen::Map<const Eigen::Vector3d>(pose.pivot.data()) +
               pathOriginInTank(immersion, Seconds(pose.seconds));
    };
    const solver::PathPose* before = nullptr;
    for (const solver::PathPose& pose : path.poses) {
        const Eigen::Vector3d centre = centreAt(pose);
        demand.reach = std::max(demand.reach, std::hypot(centre.x(), centre.z()));
        if (before && pose.seconds > before->seconds) {
            const double seconds = pose.seconds - before->seconds;
            const double turn = rotationOf(*before).angularDistance(rotationOf(pose));
            demand.speed = std::max(demand.speed, (centre - centreAt(*before)).norm() / seconds);
            demand.turnSpeed = std::max(demand.turnSpeed, turn * 180 / pi / seconds);
        }
        before = &pose;
    }
    return demand;
}

// Returns the bounding box of the places that go under water, on the floating film.
Eigen::AlignedBox2d shadowOnFilm(const TriangleMesh& posed, const Immersion& immersion,
                                 const ProcessSettings& process, const solver::BodyPath& path) {
    const Eigen::Vector2d offset(immersion.offset[0].value(), immersion.offset[1].value());
    if (!path.isStraightDown()) {
        return shadowOnPath(path, posed, ShadowOf::UnderWater).translated(offset);
    }
    const BoundingBox box = boundingBox(posed);
    const double water = double(box.min().y()) + dipDepth(process, box.sizes().y());
    const Eigen::Isometry3d toWorld(Eigen::Translation3d(offset.x(), -water, offset.y()));
    return shadowAt(posed, toWorld, ShadowOf::UnderWater);
}

// Returns a fault for each barrier at the film's edge that the part would push away.
std::vector<TankFault> barrierFaults(const FilmSettings& film, const TriangleMesh& posed,
                                     const Immersion& immersion, const ProcessSettings& process,
                                     const solver::BodyPath& path) {
    const FilmEdges& edges = film.edges;
    if (edges == FilmEdges()) {
        return {};
    }
    const Eigen::AlignedBox2d part = shadowOnFilm(posed, immersion, process, path);
    const solver::FilmGrid floating = filmGrid(film);
    const double halfWidth = floating.width / 2, halfDepth = floating.depth / 2;
    std::vector<TankFault> faults;
    const auto check = [&](bool isHeld, double reach, double half, const QString& side) {
        if (isHeld && reach > half) {
            faults.push_back(
                {Text::tr("The part reaches past the barrier at the film's %1 edge; move or turn "
                          "the part, change its path, or use a larger film")
                     .arg(side),
                 reach, half});
        }
    };
    check(edges.leftPinned, -part.min().x(), halfWidth, Text::tr("left", "edge of the film"));
    check(edges.rightPinned, part.max().x(), halfWidth, Text::tr("right", "edge of the film"));
    check(edges.topPinned, -part.min().y(), halfDepth, Text::tr("top", "edge of the film"));
    check(edges.bottomPinned, part.max().y(), halfDepth, Text::tr("bottom", "edge of the film"));
    return faults;
}

QString number(double value) {
    return numberText(value, 1);
}

// Returns the texts of a value and its limit, with enough decimals to show that they differ.
std::array<QString, 2> apart(double value, double limit) {
    int decimals = 1;
    while (decimals < 6 && numberText(value, decimals) == numberText(limit, decimals)) {
        ++decimals;
    }
    return {numberText(value, decimals), numberText(limit, decimals)};
}

} // namespace

Eigen::Vector3d pathOriginInTank(const Immersion& immersion, Seconds time) {
    return Eigen::Vector3d(immersion.offset[0].value(), 0, immersion.offset[1].value()) +
           time.value() * waterVelocity(immersion.path);
}

std::vector<TankFault> tankFaults(const std::optional<TankProfile>& profile,
                                  const FilmSettings& film, const ProcessSettings& process,
                                  const Immersion& immersion, const TriangleMesh& posed,
                                  const solver::BodyPath& path) {
    std::vector<TankFault> faults = barrierFaults(film, posed, immersion, process, path);
    if (!profile) {
        return faults;
    }
    const TankProfile& tank = *profile;
    const Demand demand = path.isStraightDown() ? straightDemand(posed, immersion, process)
                                                : demandOnPath(path, posed, immersion, process);
    constexpr double rounding = 1e-6; // relative
    const auto add = [&](double value, double limit, const QString& sentence) {
        faults.push_back({sentence, value, limit});
    };
    // Compares two lengths with their limits. Returns the number of the length that is larger than
    // its limit; if both are, that of the one with the larger ratio.
    const auto tooLarge = [&](const Eigen::Array2d& sizes,
                              const Eigen::Array2d& limits) -> std::optional<Eigen::Index> {
        Eigen::Index worst = 0;
        return (sizes / limits).maxCoeff(&worst) > 1 + rounding ? std::optional(worst)
                                                                : std::nullopt;
    };
    const Eigen::Array2d sides(tank.width.value(), tank.length.value());
    const solver::FilmGrid floating = filmGrid(film);
    const Eigen::Array2d filmSides(floating.width, floating.depth);
    if (const auto side = tooLarge(filmSides, sides)) {
        add(filmSides[*side], sides[*side],
            Text::tr("The film measures %1 × %2 mm on the water, but the tank “%3” only %4 × "
                     "%5 mm; use a smaller film")
                .arg(number(floating.width), number(floating.depth), tank.name,
                     number(tank.width.value()), number(tank.length.value())));
    }
    if (!path.isStraightDown()) {
        const Eigen::Vector3d drift = path.poses.back().seconds * waterVelocity(immersion.path);
        const Eigen::Array2d needed = filmSides + 2 * Eigen::Array2d(drift.x(), drift.z()).abs();
        if (!tooLarge(filmSides, sides) && tooLarge(needed, sides)) {
            add(drift.norm(), (sides - filmSides).minCoeff() / 2,
                Text::tr("The water carries the film %1 mm during the dip, past the edge of the "
                         "tank “%2”; reduce the speed of the water, or use a smaller film")
                    .arg(number(drift.norm()), tank.name));
        }
    }
    // The largest distances of the part from the tank's middle.
    const Eigen::Array2d farthest = demand.outline.max().array().max(-demand.outline.min().array());
    const Eigen::Array2d half = sides / 2;
    if (const auto side = tooLarge(farthest, half)) {
        add(farthest[*side], half[*side],
            Text::tr("The part reaches past the edge of the tank “%1”; move or turn the part")
                .arg(tank.name));
    }
    const auto exceeds = [](double value, const auto& limit) {
        return limit && value > limit->value() * (1 + rounding);
    };
    if (exceeds(demand.depth, tank.waterDepth)) {
        const auto [needed, most] = apart(demand.depth, tank.waterDepth->value());
        add(demand.depth, tank.waterDepth->value(),
            Text::tr("The part goes %1 mm under water, but the water in the tank “%2” is only "
                     "%3 mm deep; reduce the depth of the dip, or turn the part")
                .arg(needed, tank.name, most));
    }
    if (exceeds(demand.reach, tank.reach)) {
        const auto [needed, most] = apart(demand.reach, tank.reach->value());
        add(demand.reach, tank.reach->value(),
            Text::tr("The centre of the part moves %1 mm sideways from the middle of the tank "
                     "“%2”, but its machine reaches only %3 mm; move the part or change its "
                     "path")
                .arg(needed, tank.name, most));
    }
    if (exceeds(demand.speed, tank.speed)) {
        const auto [needed, most] = apart(demand.speed, tank.speed->value());
        add(demand.speed, tank.speed->value(),
            Text::tr("The part moves at up to %1 mm/s, but the machine of the tank “%2” "
                     "reaches only %3 mm/s; reduce the speed of the dip")
                .arg(needed, tank.name, most));
    }
    if (exceeds(demand.turnSpeed, tank.turnSpeed)) {
        const auto [needed, most] = apart(demand.turnSpeed, tank.turnSpeed->value());
        add(demand.turnSpeed, tank.turnSpeed->value(),
            Text::tr("The part turns at up to %1°/s, but the machine of the tank “%2” reaches "
                     "only %3°/s; use a slower dip or a smaller turn")
                .arg(needed, tank.name, most));
    }
    return faults;
}

QString textOf(const std::vector<TankFault>& faults) {
    QStringList sentences;
    for (const TankFault& fault : faults) {
        sentences << fault.sentence;
    }
    return sentences.join(QStringLiteral(". "));
}

} // namespace dipwright
