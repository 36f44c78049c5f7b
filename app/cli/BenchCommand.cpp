#include "cli/Arguments.h"

#include "geometry/Shapes.h"
#include "solver/SolverRegistry.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>
#include <array>

namespace dipwright::cli {
namespace {

const QString jsonOption = QStringLiteral("json");
const QString solverOption = QStringLiteral("solver");
const QString rowsOption = QStringLiteral("rows");
const QString runsOption = QStringLiteral("runs");

// A film of Table I in "Real-Time 3D Position-Based Dynamics Simulation for Hydrographic Printing".
struct TableRow {
    int columns, rows;
    std::optional<double> paper; // steps/s on a GeForce 940MX, where the paper states it
};
const std::array<TableRow, 8> tableOne{{{8, 12, 326},
                                        {40, 60, {}},
                                        {80, 120, {}},
                                        {120, 180, {}},
                                        {160, 240, {}},
                                        {200, 300, {}},
                                        {240, 360, {}},
                                        {280, 420, 33}}};

constexpr double sphereRadius = 35;
constexpr int sphereRings = 163;
constexpr int sphereSegments = 160; // 25,922 positions with these rings

struct Measured {
    double median = 0, minimum = 0, maximum = 0;
};

Measured measured(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    const double median =
        values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
    return {median, values.front(), values.back()};
}

TexturedMesh plainModel(const TriangleMesh& mesh) {
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    TexturedMesh model;
    model.mesh = mesh;
    const Eigen::Vector2f noCoordinate(none, none);
    model.textureCoordinates.resize(mesh.triangles.size(),
                                    {noCoordinate, noCoordinate, noCoordinate});
    model.material.resize(mesh.triangles.size(), 0);
    model.materials.resize(1);
    model.chart = findCharts(model);
    return model;
}

// The same body for all measurements, with its field.
struct Bench {
    const solver::SolverModule& module;
    int runs = 1;
    PosedBody body;
    DistanceField field;

    // Whole dips of the sphere in this project's film, one a run.
    std::vector<DippedFilm> dips(const Project& project, const Progress& progress) const {
        std::vector<DippedFilm> films;
        for (int run = 0; run < runs; ++run) {
            films.push_back(simulateDip(
                body, field, project.immersions.front(), project.film, project.process, module,
                progress.part(double(run) / runs, double(run + 1) / runs), nullptr));
        }
        return films;
    }
};

struct RowResult {
    qint64 points = 0, constraints = 0;
    Measured stepsPerSecond;
    std::optional<double> paper;
};

RowResult measureRow(const Bench& bench, const TableRow& row, const Progress& progress) {
    Project project;
    applyPreset(project, QStringLiteral("paper-2020"));
    project.film.columns = row.columns;
    project.film.rows = row.rows;
    std::vector<double> rates;
    for (const DippedFilm& film : bench.dips(project, progress)) {
        rates.push_back(double(film.steps) / film.wallSeconds);
    }
    const solver::FilmGrid grid = filmGrid(project.film);
    return {qint64(grid.pointCount()), qint64(constraintCount(grid, false)), measured(rates),
            row.paper};
}

struct DipResult {
    QString preset;
    int columns = 0, rows = 0;
    qint64 steps = 0;
    Measured seconds;
};

DipResult measureDip(const Bench& bench, const QString& preset, const Progress& progress) {
    Project project;
    applyPreset(project, preset);
    const std::vector<DippedFilm> films = bench.dips(project, progress);
    std::vector<double> seconds;
    for (const DippedFilm& film : films) {
        seconds.push_back(film.wallSeconds);
    }
    return {preset, project.film.columns, project.film.rows, films.front().steps,
            measured(seconds)};
}

QJsonObject toJson(const RowResult& row) {
    return {{"points", row.points},
            {"constraints", row.constraints},
            {"steps_per_second", row.stepsPerSecond.median},
            {"min", row.stepsPerSecond.minimum},
            {"max", row.stepsPerSecond.maximum},
            {"paper", row.paper ? QJsonValue(*row.paper) : QJsonValue()}};
}

QJsonObject toJson(const DipResult& dip) {
    return {{"preset", dip.preset},       {"points", QJsonArray{dip.columns, dip.rows}},
            {"steps", dip.steps},         {"seconds", dip.seconds.median},
            {"min", dip.seconds.minimum}, {"max", dip.seconds.maximum}};
}

template <typename Result>
QJsonArray toJson(const std::vector<Result>& results) {
    QJsonArray array;
    for (const Result& result : results) {
        array.append(toJson(result));
    }
    return array;
}

QString rate(double stepsPerSecond) {
    return QString::number(stepsPerSecond, 'f', 0);
}

void printTable(const std::vector<RowResult>& rows, QTextStream& out) {
    out << QStringLiteral("\nTable I, sphere of %1 mm, preset paper-2020, steps/s of whole dips\n")
               .arg(2 * sphereRadius)
        << QStringLiteral("%1 %2 %3 %4 %5 %6\n")
               .arg(QStringLiteral("points"), 8)
               .arg(QStringLiteral("constraints"), 12)
               .arg(QStringLiteral("median"), 9)
               .arg(QStringLiteral("min"), 9)
               .arg(QStringLiteral("max"), 9)
               .arg(QStringLiteral("paper"), 7);
    for (const RowResult& row : rows) {
        out << QStringLiteral("%1 %2 %3 %4 %5 %6\n")
                   .arg(row.points, 8)
                   .arg(row.constraints, 12)
                   .arg(rate(row.stepsPerSecond.median), 9)
                   .arg(rate(row.stepsPerSecond.minimum), 9)
                   .arg(rate(row.stepsPerSecond.maximum), 9)
                   .arg(row.paper ? rate(*row.paper) : QStringLiteral("–"), 7);
    }
}

void printDips(const std::vector<DipResult>& dips, QTextStream& out) {
    out << "\nWhole dips of the sphere\n";
    for (const DipResult& dip : dips) {
        out << QStringLiteral("%1 %2 × %3 points, %4 steps: %5 s (%6 … %7)\n")
                   .arg(dip.preset, -12)
                   .arg(dip.columns)
                   .arg(dip.rows)
                   .arg(dip.steps)
                   .arg(dip.seconds.median, 0, 'f', 3)
                   .arg(dip.seconds.minimum, 0, 'f', 3)
                   .arg(dip.seconds.maximum, 0, 'f', 3);
    }
}

class BenchCommand : public Command {
public:
    QString name() const override { return QStringLiteral("bench"); }
    QString summary() const override {
        return QStringLiteral("Measures the solver on the paper's Table I and on whole dips.");
    }

    void declare(QCommandLineParser& parser) const override {
        parser.addOption({jsonOption, QStringLiteral("Prints JSON.")});
        parser.addOption({solverOption, QStringLiteral("The solver plugin."), QStringLiteral("ID"),
                          QStringLiteral("auto")});
        parser.addOption({rowsOption, QStringLiteral("Only the first N rows of Table I, 1 to 8."),
                          QStringLiteral("N"), QString::number(tableOne.size())});
        parser.addOption({runsOption, QStringLiteral("Runs of each row; the median counts."),
                          QStringLiteral("N"), QStringLiteral("3")});
        declareThreads(parser);
    }

    void run(const QCommandLineParser& parser, Console& console) const override {
        const ThreadLimit threads(parser);
        const int rowCount = wholeNumberOption(parser, rowsOption, 1, int(tableOne.size()));
        const int runs = wholeNumberOption(parser, runsOption, 1, 1000);
        requireNoPositionalArgument(parser);
        const SolverRegistry registry;
        const SolverInfo solver = registry.info(parser.value(solverOption));
        const solver::SolverModule& module = registry.module(solver.id);

        const Progress progress = console.progress();
        const TexturedMesh sphere =
            plainModel(sphereMesh(sphereRadius, sphereRings, sphereSegments));
        const Bench bench{
            module, runs, posedBody(sphere, {}),
            buildDistanceField(sphere.mesh, Project().fieldResolution, progress.part(0, 0.05))};
        std::vector<RowResult> rows;
        for (int row = 0; row < rowCount; ++row) {
            const double begin = 0.05 + 0.65 * row / rowCount;
            rows.push_back(measureRow(bench, tableOne[std::size_t(row)],
                                      progress.part(begin, begin + 0.65 / rowCount)));
        }
        const std::vector<DipResult> dips{
            measureDip(bench, QStringLiteral("paper-2020"), progress.part(0.7, 0.8)),
            measureDip(bench, QStringLiteral("production"), progress.part(0.8, 1))};
        const QString device = QString::fromUtf8(module.device());
        if (parser.isSet(jsonOption)) {
            const QJsonObject json{{"version", 1},           {"solver", solver.id},
                                   {"device", device},       {"runs", runs},
                                   {"table1", toJson(rows)}, {"dips", toJson(dips)}};
            console.out() << QJsonDocument(json).toJson();
            return;
        }
        console.out() << QStringLiteral("%1 %2 on %3\n").arg(solver.name, solver.version, device);
        printTable(rows, console.out());
        printDips(dips, console.out());
    }
};

} // namespace

std::unique_ptr<Command> benchCommand() {
    return std::make_unique<BenchCommand>();
}

} // namespace dipwright::cli
