#include "cli/bench/Measurements.h"
#include "film/FilmGrid.h"
#include "model/TexturedMesh.h"
#include "project/Project.h"

#include "base/Error.h"
#include "dip/Dip.h"
#include "geometry/Shapes.h"
#include "project/NewProject.h"
#include "project/ProjectStore.h"
#include "project/Samples.h"

#include <QJsonArray>

#include <array>
#include <limits>

namespace dipwright::cli {
namespace {

// A row of Table I in the paper "Real-Time 3D Position-Based Dynamics Simulation for Hydrographic
// Printing".
struct TableRow {
    int columns, rows;
    // Steps/s on a GeForce 940MX; empty if the paper does not state them.
    std::optional<double> paper;
};
const std::array<TableRow, 8> tableOne{{{8, 12, 326},
                                        {40, 60, {}},
                                        {80, 120, {}},
                                        {120, 180, {}},
                                        {160, 240, {}},
                                        {200, 300, {}},
                                        {240, 360, {}},
                                        {280, 420, 33}}};
constexpr TableRow figureSeven{120, 180, {}};

constexpr double sphereRadius = 35;
constexpr int sphereRings = 163;
constexpr int sphereSegments = 160; // gives 25,922 positions with these rings
constexpr double tetrahedronEdge = 80;
constexpr int tableFieldSamples = 128;

// Floating point operations for one constraint. Solving it: difference 4, square 5, root and
// quotient 2, excess 2, pull 3, adding the pull at both ends 6. Moving a point takes 6, and there
// are two constraints per point, so 3 for each constraint.
constexpr double flopsPerSolve = 25;

std::shared_ptr<const TexturedMesh> plainModel(const TriangleMesh& mesh) {
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    auto model = std::make_shared<TexturedMesh>();
    model->mesh = mesh;
    const Eigen::Vector2f noCoordinate(none, none);
    model->textureCoordinates.resize(mesh.triangles.size(),
                                     {noCoordinate, noCoordinate, noCoordinate});
    model->material.resize(mesh.triangles.size(), 0);
    model->materials.resize(1);
    model->chart = findCharts(*model);
    return model;
}

BenchBodies::Body made(const QString& name) {
    if (name == QLatin1String("sphere")) {
        return {plainModel(sphereMesh(sphereRadius, sphereRings, sphereSegments)), {}};
    }
    if (name == QLatin1String("tetrahedron")) {
        Immersion tipDown;
        tipDown.rotation[0] = Degrees(180);
        return {plainModel(tetrahedronMesh(tetrahedronEdge)), tipDown};
    }
    const Project turtle = BenchBodies::turtle();
    return {turtle.model, turtle.immersions.front()};
}

// Simulates the whole dip of one body `runs` times with the same field.
std::vector<DippedFilm> dips(const BenchSolver& solver, const BenchBodies::Body& body,
                             const DistanceField& field, const Project& project,
                             const Progress& progress) {
    const PosedBody posed = posedBody(body.model->mesh, body.immersion);
    const solver::SolverModule& module = solver.registry.module(solver.id);
    std::vector<DippedFilm> films;
    films.reserve(std::size_t(solver.runs));
    for (int run = 0; run < solver.runs; ++run) {
        films.push_back(simulateDip(
            posed, field, body.immersion, project.film, project.process, module,
            progress.part(double(run) / solver.runs, double(run + 1) / solver.runs), nullptr));
    }
    return films;
}

Project projectOf(const QString& preset, int columns, int rows) {
    Project project;
    applyPreset(project, preset);
    project.process.contactTravel = newProjectContactTravel;
    project.film.columns = columns;
    project.film.rows = rows;
    return project;
}

StepRow measureRow(const BenchSolver& solver, const BenchBodies::Body& body,
                   const DistanceField& field, const TableRow& row, const Progress& progress) {
    const Project project = projectOf(QStringLiteral("paper-2020"), row.columns, row.rows);
    std::vector<double> rates;
    for (const DippedFilm& film : dips(solver, body, field, project, progress)) {
        rates.push_back(double(film.steps) / film.wallSeconds);
    }
    const solver::FilmGrid grid = filmGrid(project.film);
    StepRow result;
    result.fieldSamples = field.size[0];
    result.points = qint64(grid.pointCount());
    result.constraints = qint64(constraintCount(grid, false));
    result.iterations = project.process.iterations;
    result.stepsPerSecond = statistics(std::move(rates));
    result.paper = row.paper;
    return result;
}

} // namespace

double StepRow::flopsPerSecond() const {
    return flopsPerSolve * solvesPerSecond();
}

const BenchBodies::Body& BenchBodies::body(const QString& name) {
    const auto known = bodies_.find(name);
    return known != bodies_.end() ? known->second : bodies_.emplace(name, made(name)).first->second;
}

QString BenchBodies::turtleFile() {
    for (const QString& path : sampleProjects()) {
        if (path.endsWith(QLatin1String("/turtle.dipw"))) {
            return path;
        }
    }
    throw Error(QStringLiteral("The sample projects are missing. Install them beside the program, "
                               "or measure only steps, dips and field"),
                QStringLiteral("turtle.dipw"));
}

Project BenchBodies::turtle() {
    Project project = loadProject(turtleFile());
    // Fixed at A4 with 120 × 170 points, so that results of different versions can be compared.
    project.film = {};
    return project;
}

std::vector<StepRow> measureTableOne(const BenchSolver& solver, BenchBodies& bodies, int rows,
                                     const Progress& progress) {
    const QString name = QStringLiteral("sphere");
    const BenchBodies::Body& sphere = bodies.body(name);
    const DistanceField field =
        buildDistanceField(sphere.model->mesh, tableFieldSamples, progress.part(0, 0.1));
    std::vector<StepRow> results;
    for (int row = 0; row < rows; ++row) {
        const double begin = 0.1 + 0.9 * row / rows;
        results.push_back(measureRow(solver, sphere, field, tableOne[std::size_t(row)],
                                     progress.part(begin, begin + 0.9 / rows)));
        results.back().body = name;
    }
    return results;
}

std::vector<StepRow> measureFieldSweep(const BenchSolver& solver, BenchBodies& bodies, int finest,
                                       const Progress& progress) {
    constexpr int coarsest = 32;
    std::vector<StepRow> results;
    double done = 0;
    for (const char* name : {"sphere", "tetrahedron", "turtle"}) {
        const BenchBodies::Body& body = bodies.body(QLatin1String(name));
        for (int samples = coarsest; samples <= finest; samples *= 2) {
            const double share = double(samples) / (2 * finest - coarsest) / 3;
            const Progress part = progress.part(done, done + share);
            const DistanceField field =
                buildDistanceField(body.model->mesh, samples, part.part(0, 0.5));
            results.push_back(measureRow(solver, body, field, figureSeven, part.part(0.5, 1)));
            results.back().body = QLatin1String(name);
            done += share;
        }
    }
    return results;
}

std::vector<TimedRow> measureDips(const BenchSolver& solver, BenchBodies& bodies, int columns,
                                  int rows, const Progress& progress) {
    const BenchBodies::Body& sphere = bodies.body(QStringLiteral("sphere"));
    const DistanceField field =
        buildDistanceField(sphere.model->mesh, tableFieldSamples, progress.part(0, 0.1));
    std::vector<TimedRow> results;
    double begin = 0.1;
    for (const QString& preset : {QStringLiteral("paper-2020"), QStringLiteral("production")}) {
        const double end = begin == 0.1 ? 0.2 : 1;
        const std::vector<DippedFilm> films = dips(
            solver, sphere, field, projectOf(preset, columns, rows), progress.part(begin, end));
        std::vector<double> seconds;
        seconds.reserve(films.size());
        for (const DippedFilm& film : films) {
            seconds.push_back(film.wallSeconds);
        }
        const auto steps = qint64(films.front().steps);
        results.push_back(
            {QStringLiteral("%1, %2 × %3 points, %4 steps")
                 .arg(preset)
                 .arg(columns)
                 .arg(rows)
                 .arg(steps),
             {{"preset", preset}, {"points", QJsonArray{columns, rows}}, {"steps", steps}},
             statistics(std::move(seconds))});
        begin = end;
    }
    return results;
}

} // namespace dipwright::cli
