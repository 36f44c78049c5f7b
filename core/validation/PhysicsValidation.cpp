#include "validation/PhysicsValidation.h"

#include "base/Error.h"
#include "base/Units.h"
#include "film/DippedFilm.h"
#include "film/Growth.h"
#include "geometry/DistanceField.h"
#include "geometry/Shapes.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QStringList>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>

namespace dipwright {

namespace {

constexpr double contactRadius = 35; // mm: the comparison ends here on every body
constexpr double ringRadius = 90;    // mm, where the film is held
// Film points from the ring on are held. So the film's edge is jagged and lies outside the ring. It
// acts like a circle that is wider than the ring by this share of a cell. Linear elastic discs with
// 12 to 60 cells in the contact radius gave 0.37 to 0.46.
constexpr double jaggedEdge = 0.43;
constexpr double freeWidth = 300; // mm, side of the square free film
constexpr double gap = 0.5;       // mm between body and water before the dip
constexpr int fieldResolution = 256;

struct Text {
    Q_DECLARE_TR_FUNCTIONS(PhysicsValidation)
};

struct Body {
    TriangleMesh mesh;
    DistanceField field;
    double lowest = 0;
};

Body makeBody(TriangleMesh mesh, int resolution, const Progress& progress) {
    Body body;
    body.field = buildDistanceField(mesh, resolution, progress);
    body.lowest = double(boundingBox(mesh).min().y());
    body.mesh = std::move(mesh);
    return body;
}

// One dip of a film with square cells, and the solver's result.
struct DipRun {
    solver::DipSetup setup;
    std::vector<float> positions; // in the world frame
    std::vector<solver::PointState> states;
    solver::DipState progress;
    double seconds = 0;

    bool adhered(std::size_t point) const { return states[point] == solver::PointState::Adhered; }
    Eigen::Vector2d rest(std::size_t point) const {
        const solver::FilmGrid& film = setup.film;
        const std::size_t columns = std::size_t(film.columns);
        return {film.restX(int(point % columns)), film.restZ(int(point / columns))};
    }
    // Returns the position relative to the body's pole.
    Eigen::Vector3d onBody(std::size_t point) const {
        return {double(positions[3 * point]),
                double(positions[3 * point + 1]) - gap + progress.descent,
                double(positions[3 * point + 2])};
    }
};

// The kind of film that a body dips into.
struct FilmKind {
    FilmLaw law = FilmLaw::Elastic;
    FilmEdge edge = FilmEdge::Held;
    bool grows = false;
};

QString nameOf(const FilmKind& film) {
    QStringList words(film.law == FilmLaw::Viscous ? Text::tr("viscous") : Text::tr("elastic"));
    if (film.edge == FilmEdge::Free) {
        words << Text::tr("free");
    }
    if (film.grows) {
        words << Text::tr("growing");
    }
    return words.join(QStringLiteral(", "));
}

// Makes the film grow by 9 % during the dip of the sphere, which is more than real films grow.
void letGrow(solver::Settings& settings) {
    settings.growthRate = 0.02;
    settings.growthLimit = 0.2;
}

FloatingFilm floatingFilm(const FilmKind& film, const solver::DipSetup& setup) {
    // The closed form is for a round film. The centre of a square film is as soft as the centre of
    // a round film of equal area.
    const double radius = film.edge == FilmEdge::Held
                              ? ringRadius + jaggedEdge * setup.film.leastSpacing()
                              : setup.film.width / std::sqrt(pi);
    return {film.law, film.edge, radius,
            [settings = setup.settings, speed = setup.motion.speed](double depth) {
                return grownLength((gap + depth) / speed, settings);
            }};
}

solver::DipSetup setupFor(const Body& body, double width, double depth, double spacing,
                          double travel, const FilmKind& film, const PhysicsOptions& options) {
    solver::DipSetup setup;
    // An odd number of columns, so that one point lies under the pole.
    setup.film.columns = 2 * int(std::ceil(width / 2 / spacing)) + 1;
    setup.film.rows = 2 * int(std::ceil(depth / 2 / spacing)) + 1;
    setup.film.width = spacing * (setup.film.columns - 1);
    setup.film.depth = spacing * (setup.film.rows - 1);
    setup.field.distance = body.field.distance.data();
    setup.field.size = body.field.size;
    setup.field.origin = {body.field.origin.x(), body.field.origin.y(), body.field.origin.z()};
    setup.field.spacing = body.field.spacing;
    setup.motion.start = {0, gap - body.lowest, 0};
    setup.motion.travel = gap + travel;
    setup.settings.relaxationTime =
        film.law == FilmLaw::Viscous ? 0 : std::numeric_limits<double>::infinity();
    if (film.grows) {
        letGrow(setup.settings);
    }
    setup.settings.threads = options.threads;
    if (options.contactTravel > 0) {
        setup.settings.contactTravel = options.contactTravel;
    }
    return setup;
}

// Returns the places of grid lines over `width`. The lines are `spacing` apart under the body;
// farther out, their distance increases.
std::vector<double> linesOf(double spacing, double width) {
    const int fine = int(std::ceil(1.6 * contactRadius / spacing));
    std::vector<double> places;
    double place = 0, step = spacing;
    for (int line = 1; place < width / 2; ++line) {
        step = line <= fine ? spacing : std::min(step * 1.05, width / 20);
        place += step;
        places.push_back(place);
    }
    places.back() = width / 2;
    std::vector<double> lines;
    for (auto far = places.rbegin(); far != places.rend(); ++far) {
        lines.push_back(-*far);
    }
    lines.push_back(0);
    lines.insert(lines.end(), places.begin(), places.end());
    return lines;
}

// Sets a square film with free edges around the body.
void setFree(solver::DipSetup& setup, double spacing) {
    solver::FilmGrid& film = setup.film;
    film.width = film.depth = freeWidth;
    film.columnPlaces = film.rowPlaces = linesOf(spacing, freeWidth);
    film.columns = film.rows = int(film.columnPlaces.size());
}

void pinRing(solver::DipSetup& setup) {
    const solver::FilmGrid& film = setup.film;
    setup.pinned.assign(film.pointCount(), 0);
    for (int j = 0; j < film.rows; ++j) {
        for (int i = 0; i < film.columns; ++i) {
            const double x = film.restX(i);
            const double z = film.restZ(j);
            setup.pinned[std::size_t(j) * std::size_t(film.columns) + std::size_t(i)] =
                x * x + z * z >= ringRadius * ringRadius;
        }
    }
}

void pinSides(solver::DipSetup& setup) {
    const int columns = setup.film.columns, rows = setup.film.rows;
    setup.pinned.assign(setup.film.pointCount(), 0);
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            setup.pinned[std::size_t(j) * std::size_t(columns) + std::size_t(i)] =
                i == 0 || i == columns - 1 || j == 0 || j == rows - 1;
        }
    }
}

DipRun simulate(const solver::SolverModule& module, solver::DipSetup setup,
                const Progress& progress) {
    DipRun run;
    run.setup = std::move(setup);
    QElapsedTimer timer;
    timer.start();
    try {
        const std::unique_ptr<solver::FilmSolver> film = module.create();
        film->begin(run.setup);
        while (!run.progress.finished) {
            run.progress = film->advance(4);
            progress(run.progress.descent / run.setup.motion.travel, Text::tr("Dipping"));
        }
        run.positions.resize(3 * run.setup.film.pointCount());
        run.states.resize(run.setup.film.pointCount());
        film->read(run.positions, run.states);
    } catch (const Cancelled&) {
        throw;
    } catch (const std::exception& error) {
        throw Error(Text::tr("The solver failed: %1").arg(QString::fromUtf8(error.what())),
                    Text::tr("physics validation"));
    }
    run.seconds = double(timer.nsecsElapsed()) * 1e-9;
    return run;
}

// Accumulates the errors of one result.
class ErrorSum {
public:
    void add(double error) {
        ++count_;
        sum_ += error;
        squares_ += error * error;
        maximum_ = std::max(maximum_, std::abs(error));
    }
    // Adds an error to the sum near the grid's axes or to the sum near its diagonals, for the
    // anisotropy.
    void addDirection(const Eigen::Vector2d& place, double error) {
        const double angle = std::atan2(std::abs(place.y()), std::abs(place.x())) * 180 / pi;
        if (angle < 5 || angle > 85) {
            axis_ += error;
            ++axisCount_;
        } else if (angle > 40 && angle < 50) {
            diagonal_ += error;
            ++diagonalCount_;
        }
    }
    void writeTo(PhysicsResult& result) const {
        if (count_ == 0) {
            throw Error(Text::tr("The film never touched the body; do not use this solver"),
                        result.body);
        }
        result.rms = std::sqrt(squares_ / count_);
        result.mean = sum_ / count_;
        result.maximum = maximum_;
        if (axisCount_ > 0 && diagonalCount_ > 0) {
            result.anisotropy = axis_ / axisCount_ - diagonal_ / diagonalCount_;
        }
    }

private:
    double sum_ = 0, squares_ = 0, maximum_ = 0, axis_ = 0, diagonal_ = 0;
    int count_ = 0, axisCount_ = 0, diagonalCount_ = 0;
};

struct Expected {
    double arc, filmRadius; // mm
};
// Returns the expected film at a place relative to the body's lowest point; none if the place is
// not compared.
using Comparison = std::function<std::optional<Expected>(const Eigen::Vector3d&)>;

struct Revolution {
    QString name;
    TriangleMesh mesh;
    double fullDepth;
    double firstCell; // the comparison begins this many cells off the axis
    bool isCone;
    bool isPlotted;
    std::function<Comparison(const FloatingFilm&)> comparison;
    std::vector<FilmKind> films;
};

// Returns a body whose pole touches the film first.
Revolution solid(const QString& name, const Meridian& profile, TriangleMesh mesh, double firstCell,
                 bool isCone) {
    const auto comparison = [profile](const FloatingFilm& film) -> Comparison {
        return [profile, exact = ClosedForm(profile, film)](const Eigen::Vector3d& p) {
            const double arc = profile.arc(std::hypot(p.x(), p.z()), p.y());
            return std::optional<Expected>({arc, exact.filmRadius(arc)});
        };
    };
    return {name,
            std::move(mesh),
            profile.fullDepth,
            firstCell,
            isCone,
            true,
            comparison,
            {{FilmLaw::Elastic}, {FilmLaw::Viscous}}};
}

// Returns the inner side of a torus with a vertical axis. Its contact line closes towards the axis.
Revolution insideOfTorus() {
    constexpr double circle = contactRadius, tube = 15; // mm, radii
    const auto expected = [](const Eigen::Vector3d& place) -> std::optional<Expected> {
        const double inwards = circle - std::hypot(place.x(), place.z());
        if (inwards <= 0) {
            return std::nullopt;
        }
        const double angle = std::atan2(inwards, tube - place.y());
        return Expected{tube * angle, insideTorusFilmRadius(circle, tube, angle)};
    };
    return {Text::tr("Inner side of a torus, up to 80° from its lowest circle"),
            torusMesh(circle, tube, 360, 720),
            tube * (1 - std::cos(radians(Degrees(80)))),
            0,
            false,
            false,
            [expected](const FloatingFilm&) { return Comparison(expected); },
            {{FilmLaw::Elastic}, {FilmLaw::Viscous}}};
}

// Held film is left out: when it grows it is compressed, and it lies as if it had not grown.
void addGrowingFilms(Revolution& revolution) {
    for (const FilmEdge edge : {FilmEdge::Free, FilmEdge::Held}) {
        for (const FilmLaw law : {FilmLaw::Elastic, FilmLaw::Viscous}) {
            revolution.films.push_back({law, edge, true});
        }
    }
}

std::vector<Revolution> bodiesOfRevolution() {
    constexpr int rings = 360, segments = 720;
    std::vector<Revolution> bodies;
    const double angle = radians(Degrees(80)), rho = contactRadius / std::sin(angle);
    bodies.push_back(solid(Text::tr("Sphere, up to 80° from its lowest point"),
                           sphereMeridian(rho, angle), sphereMesh(rho, rings, segments), 3, false));
    addGrowingFilms(bodies.back());
    for (const double along : {0.6, 1.4}) {
        bodies.push_back(
            solid(along < 1 ? Text::tr("Flat spheroid 1 : 0.6") : Text::tr("Long spheroid 1 : 1.4"),
                  spheroidMeridian(rho, along * rho, angle),
                  ellipsoidMesh({rho, along * rho, rho}, rings, segments), 3, false));
    }
    for (const int degrees : {30, 45, 60, 75}) {
        const double half = radians(Degrees(degrees));
        bodies.push_back(
            solid(Text::tr("Cone of %1°").arg(degrees), coneMeridian(half, contactRadius),
                  coneMesh(half, contactRadius * 1.05 / std::tan(half), segments), 10, true));
        if (degrees == 45) {
            addGrowingFilms(bodies.back());
        }
    }
    bodies.push_back(insideOfTorus());
    return bodies;
}

// The limits of docs/film-validation.md, "The closed forms".
double allowedError(bool isCone, int cells) {
    const double at30 = isCone ? 0.01 : 0.005;
    return cells < 30 ? 2 * at30 : cells < 60 ? at30 : at30 / 2;
}

PhysicsResult compare(const solver::SolverModule& module, const Revolution& revolution,
                      const Body& body, const FilmKind& film, int cells,
                      const PhysicsOptions& options, const Progress& progress) {
    PhysicsResult result;
    result.body = revolution.name;
    result.film = nameOf(film);
    result.cells = cells;
    result.allowed = allowedError(revolution.isCone, cells);
    const double spacing = contactRadius / cells, width = 2 * (ringRadius + 2 * spacing);
    solver::DipSetup setup =
        setupFor(body, width, width, spacing, revolution.fullDepth, film, options);
    if (film.edge == FilmEdge::Held) {
        pinRing(setup);
    } else {
        setFree(setup, spacing);
    }
    const Comparison exact = revolution.comparison(floatingFilm(film, setup));
    const DipRun run = simulate(module, std::move(setup), progress);
    result.steps = run.progress.steps;
    result.seconds = run.seconds;

    ErrorSum errors;
    for (std::size_t point = 0; point < run.states.size(); ++point) {
        const double R = run.rest(point).norm();
        if (!run.adhered(point) || R < revolution.firstCell * spacing) {
            continue;
        }
        const std::optional<Expected> expected = exact(run.onBody(point));
        if (!expected) {
            continue;
        }
        const double error = R / expected->filmRadius - 1;
        errors.add(error);
        errors.addDirection(run.rest(point), error);
        if (revolution.isPlotted && !film.grows && std::abs(run.rest(point).y()) < spacing / 4) {
            result.samples.push_back({expected->arc, R, expected->filmRadius});
        }
    }
    errors.writeTo(result);
    return result;
}

// Compares a flat face parallel to the water, on which the film must not move.
PhysicsResult compareFlatFace(const solver::SolverModule& module, const PhysicsOptions& options,
                              const Progress& progress) {
    PhysicsResult result;
    result.body = Text::tr("Flat face, 60 × 40 mm");
    result.film = Text::tr("elastic");
    result.inMillimetres = true;
    result.allowed = 0.02;
    const Body body = makeBody(boxMesh({60, 20, 40}), fieldResolution, progress.part(0, 0.2));
    const double spacing = 1;
    const DipRun run =
        simulate(module, setupFor(body, 160, 120, spacing, 15, {}, options), progress.part(0.2, 1));
    result.steps = run.progress.steps;
    result.seconds = run.seconds;
    ErrorSum errors;
    for (std::size_t point = 0; point < run.states.size(); ++point) {
        const Eigen::Vector2d rest = run.rest(point);
        if (std::abs(rest.x()) < 29 && std::abs(rest.y()) < 19) {
            const Eigen::Vector3d place = run.onBody(point);
            errors.add((place - Eigen::Vector3d(rest.x(), 0, rest.y())).norm());
        }
    }
    errors.writeTo(result);
    return result;
}

// Compares a long cylinder along Z in a film with free edges. Film that does not grow wraps the
// cylinder without stretch.
PhysicsResult compareCylinder(const solver::SolverModule& module, const FilmKind& film,
                              const PhysicsOptions& options, const Progress& progress) {
    PhysicsResult result;
    result.body = Text::tr("Horizontal cylinder, up to 80° from its lowest line");
    result.film = nameOf(film);
    result.inMillimetres = true;
    result.allowed = 0.1;
    const double radius = film.grows ? 20 : 30, angle = radians(Degrees(80));
    // A growing film is so long that its middle cannot grow along the cylinder.
    const double width = film.grows ? 64 : 150, length = film.grows ? 250 : 100;
    const Body body = makeBody(cylinderMesh(radius, film.grows ? 300 : 140, 720), fieldResolution,
                               progress.part(0, 0.2));
    const DipRun run = simulate(
        module, setupFor(body, width, length, 1, radius * (1 - std::cos(angle)), film, options),
        progress.part(0.2, 1));
    result.steps = run.progress.steps;
    result.seconds = run.seconds;
    const FloatingFilm floating = floatingFilm(film, run.setup);
    ErrorSum errors;
    for (std::size_t point = 0; point < run.states.size(); ++point) {
        const Eigen::Vector2d rest = run.rest(point);
        if (run.adhered(point) && (!film.grows || std::abs(rest.y()) < radius)) {
            const Eigen::Vector3d place = run.onBody(point);
            const double arc = radius * std::atan2(place.x(), radius - place.y());
            errors.add(std::hypot(filmOnCylinder(radius, arc, floating) - rest.x(),
                                  place.z() / floating.grown(0) - rest.y()));
        }
    }
    errors.writeTo(result);
    return result;
}

// Compares a film before a body touches it. The film grows about its centre, or does not move if
// all its sides are held.
PhysicsResult compareFloating(const solver::SolverModule& module, const FilmKind& film,
                              const PhysicsOptions& options, const Progress& progress) {
    PhysicsResult result;
    result.body = Text::tr("Film before it is touched");
    result.film = nameOf(film);
    result.inMillimetres = true;
    result.allowed = 0.02;
    const Body body = makeBody(boxMesh({60, 20, 40}), 32, progress.part(0, 0.1));
    solver::DipSetup setup = setupFor(body, 160, 120, 1, 0, film, options);
    setup.motion.start[1] += 30;
    setup.motion.travel = 29;
    if (film.edge == FilmEdge::Held) {
        pinSides(setup);
    }
    const DipRun run = simulate(module, std::move(setup), progress.part(0.1, 1));
    result.steps = run.progress.steps;
    result.seconds = run.seconds;
    const double grown = film.edge == FilmEdge::Held
                             ? 1
                             : floatingFilm(film, run.setup).grown(run.setup.motion.travel - gap);
    ErrorSum errors;
    for (std::size_t point = 0; point < run.states.size(); ++point) {
        const Eigen::Vector2d place(double(run.positions[3 * point]),
                                    double(run.positions[3 * point + 2]));
        errors.add((place - grown * run.rest(point)).norm());
    }
    errors.writeTo(result);
    return result;
}

// Compares the dip of an ellipsoid with the dip of the same ellipsoid turned by 45° about Y. After
// turning one film back, both films must be equal.
PhysicsResult compareTurned(const solver::SolverModule& module, const PhysicsOptions& options,
                            const Progress& progress) {
    PhysicsResult result;
    result.body = Text::tr("Ellipsoid turned by 45°");
    result.film = Text::tr("elastic");
    result.inMillimetres = true;
    result.allowed = 0.15;
    const Body body =
        makeBody(ellipsoidMesh({40, 25, 24}, 240, 480), fieldResolution, progress.part(0, 0.1));
    const double spacing = 1.5, width = 2 * (ringRadius + 2 * spacing);
    solver::DipSetup setup = setupFor(body, width, width, spacing, 20, {}, options);
    pinRing(setup);
    const DipRun straight = simulate(module, setup, progress.part(0.1, 0.55));
    const double cosine = std::sqrt(0.5), sine = std::sqrt(0.5);
    setup.motion.rotation = {cosine, 0, sine, 0, 1, 0, -sine, 0, cosine};
    const DipRun turned = simulate(module, std::move(setup), progress.part(0.55, 1));
    result.steps = turned.progress.steps;
    result.seconds = straight.seconds + turned.seconds;

    const solver::FilmGrid& film = straight.setup.film;
    const std::size_t columns = std::size_t(film.columns);
    ErrorSum errors;
    for (std::size_t point = 0; point < turned.states.size(); ++point) {
        if (!turned.adhered(point)) {
            continue;
        }
        const auto back = [&](double x, double z) {
            return Eigen::Vector2d(cosine * x - sine * z, sine * x + cosine * z);
        };
        const Eigen::Vector2d rest = back(turned.rest(point).x(), turned.rest(point).y());
        const double column = columnAt(film, rest.x() / film.width + 0.5);
        const double row = rowAt(film, rest.y() / film.depth + 0.5);
        const std::size_t corner = std::size_t(row) * columns + std::size_t(column);
        if (!straight.adhered(corner) || !straight.adhered(corner + 1) ||
            !straight.adhered(corner + columns) || !straight.adhered(corner + columns + 1)) {
            continue;
        }
        const double s = column - std::floor(column), t = row - std::floor(row);
        const Eigen::Vector3d expected =
            (1 - t) * ((1 - s) * straight.onBody(corner) + s * straight.onBody(corner + 1)) +
            t * ((1 - s) * straight.onBody(corner + columns) +
                 s * straight.onBody(corner + columns + 1));
        const Eigen::Vector3d place = turned.onBody(point);
        const Eigen::Vector2d placeBack = back(place.x(), place.z());
        errors.add((Eigen::Vector3d(placeBack.x(), place.y(), placeBack.y()) - expected).norm());
    }
    errors.writeTo(result);
    return result;
}

} // namespace

std::vector<PhysicsResult> validatePhysics(const solver::SolverModule& module,
                                           const PhysicsOptions& options,
                                           const Progress& progress) {
    std::vector<PhysicsResult> results;
    const std::vector<Revolution> bodies = bodiesOfRevolution();
    // The work grows with the cube of the resolution.
    double total = 0, done = 0;
    for (const Revolution& revolution : bodies) {
        for (const int cells : options.resolutions) {
            total += double(revolution.films.size()) * std::pow(double(cells), 3);
        }
    }
    total *= 1.1;
    for (const Revolution& revolution : bodies) {
        const Body body =
            makeBody(revolution.mesh, fieldResolution, Progress{nullptr, progress.cancelToken});
        for (const FilmKind& film : revolution.films) {
            for (const int cells : options.resolutions) {
                if (options.isWanted && !options.isWanted(revolution.name, nameOf(film), cells)) {
                    continue;
                }
                const double work = std::pow(double(cells), 3);
                const Progress part = progress.part(done / total, (done + work) / total);
                part(0, Text::tr("%1, %2 cells").arg(revolution.name).arg(cells));
                results.push_back(compare(module, revolution, body, film, cells, options, part));
                done += work;
            }
        }
    }
    progress(0.92, Text::tr("Flat face"));
    results.push_back(compareFlatFace(module, options, progress.part(0.92, 0.93)));
    const std::array growing{FilmKind{FilmLaw::Elastic, FilmEdge::Free, true},
                             FilmKind{FilmLaw::Viscous, FilmEdge::Free, true}};
    results.push_back(compareCylinder(module, {}, options, progress.part(0.93, 0.95)));
    for (const FilmKind& film : growing) {
        results.push_back(compareCylinder(module, film, options, progress.part(0.95, 0.96)));
        results.push_back(compareFloating(module, film, options, progress.part(0.96, 0.965)));
    }
    const FilmKind held{FilmLaw::Elastic, FilmEdge::Held, true};
    results.push_back(compareFloating(module, held, options, progress.part(0.965, 0.97)));
    results.push_back(compareTurned(module, options, progress.part(0.97, 1)));
    return results;
}

} // namespace dipwright
