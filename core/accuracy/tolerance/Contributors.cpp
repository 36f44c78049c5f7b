#include "accuracy/tolerance/Contributors.h"

#include "accuracy/tolerance/ChangedPath.h"
#include "dip/BodyPath.h"
#include "dip/Pose.h"
#include "film/Growth.h"
#include "geometry/FieldGrid.h"

#include <QCoreApplication>

#include <Eigen/Geometry>

#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Tolerance)
};

constexpr double percent = 0.01;

// Returns the angles of the rotation `angles` followed by the rotation `by` about fixed axes.
std::array<Degrees, 3> turned(const std::array<Degrees, 3>& angles, const Eigen::Matrix3d& by) {
    const Eigen::Vector3d zyx = (by * rotationMatrix(angles)).eulerAngles(2, 1, 0);
    const auto degrees = [](double angle) { return Degrees(angle * 180 / pi); };
    return {degrees(zyx[2]), degrees(zyx[1]), degrees(zyx[0])};
}

void scale(solver::FilmGrid& grid, double factor) {
    grid.width *= factor;
    grid.depth *= factor;
    for (std::vector<double>* places : {&grid.columnPlaces, &grid.rowPlaces}) {
        for (double& place : *places) {
            place *= factor;
        }
    }
}

// Moves the body that goes straight down, or lies at the end of its path, to the immersion's pose.
// Returns its bodyTransform().
Eigen::Isometry3d placeBody(ChangedDip& dip, const TriangleMesh& model) {
    const Eigen::Isometry3d toPose = bodyTransform(model, dip.immersion);
    using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    Eigen::Map<RowMajor>(dip.setup.motion.rotation.data()) = toPose.linear();
    Eigen::Map<Eigen::Vector3d>(dip.setup.motion.start.data()) =
        toPose.translation() + poseToWorld(dip.immersion, 0);
    return toPose;
}

// Returns the centre of the model's bounding box, in body coordinates.
Eigen::Vector3d centreOf(const TriangleMesh& model) {
    const BoundingBox box = boundingBox(model);
    return (box.min().cast<double>() + box.max().cast<double>()) / 2 - bodyOrigin(model);
}

// Turns the body about the centre of its bounding box. The centre keeps its path. The dip therefore
// begins earlier if the turn lowers the body's lowest point, and later if the turn raises it.
void turn(ChangedDip& dip, const TriangleMesh& model, const Eigen::Vector3d& degrees) {
    const double angle = degrees.norm() * pi / 180;
    if (angle == 0) {
        return;
    }
    const Eigen::Vector3d centre = centreOf(model);
    const double before = (bodyTransform(model, dip.immersion) * centre).y();
    const Eigen::AngleAxisd by(angle, degrees.normalized());
    dip.immersion.rotation = turned(dip.immersion.rotation, by.toRotationMatrix());
    dip.setup.motion.travel += (placeBody(dip, model) * centre).y() - before;
}

// Returns the rotation of a dip that the turned film sees.
Eigen::Quaterniond turnSeen(const DipChange& change) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(-radians(Degrees(of(change, Freedom::FilmTurn))),
                                                Eigen::Vector3d::UnitY()));
}

// Turns a place on the water, X and Z.
template <typename Length>
std::array<Length, 2> turned(const std::array<Length, 2>& place, const Eigen::Quaterniond& by) {
    const Eigen::Vector3d there = by * Eigen::Vector3d(place[0].value(), 0, place[1].value());
    return {Length(there.x()), Length(there.z())};
}

// Turns the immersion with its whole path, as the turned film sees it.
void turnFilm(ChangedDip& dip, const TriangleMesh& model, const DipChange& change) {
    const double degrees = of(change, Freedom::FilmTurn);
    if (degrees == 0) {
        return;
    }
    const Eigen::Quaterniond by = turnSeen(change);
    const Eigen::Matrix3d turn = by.toRotationMatrix();
    Immersion& immersion = dip.immersion;
    immersion.rotation = turned(immersion.rotation, turn);
    immersion.offset = turned(immersion.offset, by);
    // The turn by −degrees about Y leads from X to Z.
    immersion.path.heading = immersion.path.heading + Degrees(degrees);
    for (PathKey& key : immersion.path.keys) {
        key.beside = turned(key.beside, by);
        const Eigen::Vector3d was(radians(key.turn[0]), radians(key.turn[1]), radians(key.turn[2]));
        const Eigen::Vector3d angles =
            anglesNear(turn * rotationMatrix(key.turn) * turn.transpose(), was) * 180 / pi;
        key.turn = {Degrees(angles.x()), Degrees(angles.y()), Degrees(angles.z())};
    }
    placeBody(dip, model);
}

Eigen::Vector3d turnOf(const DipChange& change) {
    return {of(change, Freedom::TurnX), of(change, Freedom::TurnY), of(change, Freedom::TurnZ)};
}

// Returns the motion of the body in its own coordinates by which it is held wrong: a turn about the
// centre of its bounding box, by a vector in degrees about the axes of the pose frame.
Eigen::Isometry3d heldWrong(const NominalDip& dip, const Eigen::Vector3d& degrees) {
    const double angle = degrees.norm() * pi / 180;
    if (angle == 0) {
        return Eigen::Isometry3d::Identity();
    }
    const Eigen::Vector3d centre = centreOf(dip.model.mesh);
    const Eigen::Matrix3d toPose = rotationMatrix(dip.immersion.rotation);
    const Eigen::Vector3d axis = toPose.transpose() * degrees.normalized();
    return Eigen::Translation3d(centre) * Eigen::AngleAxisd(angle, axis) *
           Eigen::Translation3d(-centre);
}

// Returns the path with its angle changed by `degrees`, in body coordinates.
solver::BodyPath withAngle(const NominalDip& dip, double degrees) {
    if (degrees == 0) {
        return dip.setup.path;
    }
    Immersion immersion = dip.immersion;
    immersion.path.angle = changedAngle(immersion.path, degrees);
    const TriangleMesh& mesh = dip.model.mesh;
    const TriangleMesh posed = transformed(mesh, poseTransform(mesh, immersion));
    return pathOfModel(bodyPath(posed, immersion, dip.process), bodyTransform(mesh, immersion),
                       immersion);
}

solver::BodyPath changedPath(const NominalDip& dip, const DipChange& change) {
    const TriangleMesh body = inBodyCoordinates(dip.model.mesh);
    ChangedPath path(withAngle(dip, of(change, Freedom::PathAngle)), body);
    path.speedUp(1 + of(change, Freedom::Speed), waterVelocity(dip.immersion.path));
    path.holdDifferently(heldWrong(dip, turnOf(change)));
    path.move(of(change, Freedom::X), of(change, Freedom::Z));
    path.turn(turnSeen(change));
    path.raiseWater(of(change, Freedom::WaterLevel));
    return path.path();
}

// Lets the film grow for `seconds` more before the dip. It then has less left to grow. If the dip
// begins early, the film is shorter by as much as it would be longer if the dip began late.
void growBefore(ChangedDip& dip, double seconds) {
    solver::Settings& settings = dip.setup.settings;
    if (seconds == 0 || !grows(settings)) {
        return;
    }
    const double late = grownLength(std::abs(seconds), settings);
    const double length = seconds > 0 ? late : 1 / late;
    const double limit = std::max(0.0, (1 + settings.growthLimit) / length - 1);
    settings.growthRate *= limit / settings.growthLimit; // with the same time constant
    settings.growthLimit = limit;
    dip.filmLength *= length;
}

} // namespace

double toleranceOf(const ToleranceSettings& settings, Contributor contributor) {
    switch (contributor) {
    case Contributor::PositionX:
        return settings.position[0].value();
    case Contributor::PositionZ:
        return settings.position[1].value();
    case Contributor::TurnX:
        return settings.turn[0].value();
    case Contributor::TurnY:
        return settings.turn[1].value();
    case Contributor::TurnZ:
        return settings.turn[2].value();
    case Contributor::FilmPositionX:
        return settings.filmPosition[0].value();
    case Contributor::FilmPositionZ:
        return settings.filmPosition[1].value();
    case Contributor::FilmTurn:
        return settings.filmTurn.value();
    case Contributor::Swell:
        return settings.swell / percent;
    case Contributor::WaterLevel:
        return settings.waterLevel.value();
    case Contributor::Speed:
        return settings.speed / percent;
    case Contributor::Relaxation:
        return settings.relaxation / percent;
    case Contributor::PathAngle:
        return settings.pathAngle.value();
    case Contributor::Timing:
        break;
    }
    return settings.timing.value();
}

QString contributorText(Contributor contributor) {
    switch (contributor) {
    case Contributor::PositionX:
        return Text::tr("Position of the part along X");
    case Contributor::PositionZ:
        return Text::tr("Position of the part along Z");
    case Contributor::TurnX:
        return Text::tr("Rotation of the part about X");
    case Contributor::TurnY:
        return Text::tr("Rotation of the part about Y");
    case Contributor::TurnZ:
        return Text::tr("Rotation of the part about Z");
    case Contributor::FilmPositionX:
        return Text::tr("Position of the film along X");
    case Contributor::FilmPositionZ:
        return Text::tr("Position of the film along Z");
    case Contributor::FilmTurn:
        return Text::tr("Rotation of the film about Y");
    case Contributor::Swell:
        return Text::tr("Swell");
    case Contributor::WaterLevel:
        return Text::tr("Water level");
    case Contributor::Speed:
        return Text::tr("Speed");
    case Contributor::Relaxation:
        return Text::tr("Relaxation");
    case Contributor::PathAngle:
        return Text::tr("Angle of the path");
    case Contributor::Timing:
        break;
    }
    return Text::tr("Start of the dip");
}

QString contributorUnit(Contributor contributor) {
    switch (contributor) {
    case Contributor::TurnX:
    case Contributor::TurnY:
    case Contributor::TurnZ:
    case Contributor::FilmTurn:
    case Contributor::PathAngle:
        return QStringLiteral("°");
    case Contributor::Swell:
    case Contributor::Speed:
    case Contributor::Relaxation:
        return QStringLiteral("%");
    case Contributor::Timing:
        return QStringLiteral("s");
    default:
        return QStringLiteral("mm");
    }
}

QString contributorKey(Contributor contributor) {
    static const std::array<const char*, contributorCount> keys{
        "position_x",      "position_z",      "turn_x",     "turn_y", "turn_z",
        "film_position_x", "film_position_z", "film_turn",  "swell",  "water_level",
        "speed",           "relaxation",      "path_angle", "timing"};
    return QString::fromLatin1(keys.at(std::size_t(contributor)));
}

DipChange changeBy(Contributor contributor, const Immersion& immersion) {
    DipChange change = DipChange::Zero();
    switch (contributor) {
    case Contributor::PositionX:
        of(change, Freedom::X) = 1;
        break;
    case Contributor::PositionZ:
        of(change, Freedom::Z) = 1;
        break;
    case Contributor::TurnX:
        of(change, Freedom::TurnX) = 1;
        break;
    case Contributor::TurnY:
        of(change, Freedom::TurnY) = 1;
        break;
    case Contributor::TurnZ:
        of(change, Freedom::TurnZ) = 1;
        break;
    case Contributor::FilmPositionX:
        of(change, Freedom::X) = -1;
        break;
    case Contributor::FilmPositionZ:
        of(change, Freedom::Z) = -1;
        break;
    case Contributor::FilmTurn:
        if (!immersion.path.isStraightDown()) {
            of(change, Freedom::FilmTurn) = 1;
            break;
        }
        of(change, Freedom::TurnY) = -1;
        of(change, Freedom::X) = -radians(Degrees(1)) * immersion.offset[1].value();
        of(change, Freedom::Z) = radians(Degrees(1)) * immersion.offset[0].value();
        break;
    case Contributor::Swell:
        of(change, Freedom::Swell) = percent;
        break;
    case Contributor::WaterLevel:
        of(change, Freedom::WaterLevel) = 1;
        break;
    case Contributor::Speed:
        of(change, Freedom::Speed) = percent;
        break;
    case Contributor::Relaxation:
        of(change, Freedom::Relaxation) = percent;
        break;
    case Contributor::PathAngle:
        of(change, Freedom::PathAngle) = 1;
        break;
    case Contributor::Timing: {
        const Eigen::Vector3d water = waterVelocity(immersion.path);
        of(change, Freedom::X) = -water.x();
        of(change, Freedom::Z) = -water.z();
        of(change, Freedom::Growth) = 1;
        break;
    }
    }
    return change;
}

ChangedDip changed(const NominalDip& dip, const DipChange& change) {
    ChangedDip result{dip.immersion, dip.setup};
    solver::DipSetup& setup = result.setup;
    const double x = of(change, Freedom::X), z = of(change, Freedom::Z);
    result.immersion.offset[0] = result.immersion.offset[0] + Millimetres(x);
    result.immersion.offset[1] = result.immersion.offset[1] + Millimetres(z);
    setup.motion.start[0] += x;
    setup.motion.start[2] += z;
    result.immersion.path.angle =
        changedAngle(result.immersion.path, of(change, Freedom::PathAngle));
    turn(result, dip.model.mesh, turnOf(change));
    turnFilm(result, dip.model.mesh, change);
    if (dip.setup.path.isStraightDown()) {
        // The body must at least reach the water.
        setup.motion.travel =
            std::max(setup.motion.travel + of(change, Freedom::WaterLevel), startHeight);
    } else {
        setup.path = changedPath(dip, change);
        setup.motion.travel = setup.path.poses.back().travelled;
    }
    result.filmLength = 1 + of(change, Freedom::Swell);
    growBefore(result, of(change, Freedom::Growth));
    scale(setup.film, result.filmLength);
    setup.motion.speed *= 1 + of(change, Freedom::Speed);
    setup.settings.relaxationTime *= 1 + of(change, Freedom::Relaxation);
    return result;
}

bool matters(Freedom freedom, const solver::Settings& settings, const DipPath& path) {
    const bool isProduction = solver::isProductionFilm(settings.lattice, settings.support);
    const bool relaxes =
        isProduction && settings.relaxationTime > 0 && std::isfinite(settings.relaxationTime);
    switch (freedom) {
    case Freedom::Relaxation:
        return relaxes;
    case Freedom::Speed:
        return !isProduction || relaxes || grows(settings) ||
               path.waterSpeed != MillimetresPerSecond(0);
    case Freedom::PathAngle:
        return path.kind != PathKind::Straight && path.kind != PathKind::Poses;
    case Freedom::Growth:
        return grows(settings);
    case Freedom::FilmTurn:
        return !path.isStraightDown();
    default:
        return true;
    }
}

bool isListed(Contributor contributor, const solver::Settings& settings, const DipPath& path) {
    switch (contributor) {
    case Contributor::PathAngle:
        return matters(Freedom::PathAngle, settings, path);
    case Contributor::Timing:
        return path.waterSpeed != MillimetresPerSecond(0) ||
               matters(Freedom::Growth, settings, path);
    default:
        return true;
    }
}

} // namespace dipwright
