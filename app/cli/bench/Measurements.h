// What `dipwright-cli bench` measures.
#pragma once

#include "base/Progress.h"
#include "cli/bench/Statistics.h"
#include "settings/Immersion.h"
#include "solver/SolverRegistry.h"

#include <QJsonObject>

#include <map>
#include <optional>

namespace dipwright {

struct Project;
struct TexturedMesh;

} // namespace dipwright

namespace dipwright::cli {

// A whole dip of the paper's film: the rate of its steps.
struct StepRow {
    QString body;
    int fieldSamples = 0; // along an edge of the field's cube
    qint64 points = 0, constraints = 0;
    int iterations = 0; // in which a step solves each constraint once
    Statistics stepsPerSecond;
    std::optional<double> paper; // steps/s, where the paper states them

    double solvesPerSecond() const {
        return stepsPerSecond.median * double(constraints) * iterations;
    }
    double flopsPerSecond() const;
};

// A piece of work by the seconds it takes.
struct TimedRow {
    QString what;      // for people
    QJsonObject facts; // for programs
    Statistics seconds;
};

// The bodies that are dipped, by "sphere", "tetrahedron" and "turtle", each made or read when first
// asked for. The sphere is Table I's: 70 mm, about 26,000 vertices.
class BenchBodies {
public:
    struct Body {
        std::shared_ptr<const TexturedMesh> model;
        Immersion immersion;
    };
    const Body& body(const QString& name);
    // The sample turtle's project on an A4 film of 120 × 170 points, and its file. Throws Error
    // where the samples are not installed.
    static QString turtleFile();
    static Project turtle();

private:
    std::map<QString, Body> bodies_;
};

// n³, for people. (QString::arg takes a ³ that follows a place's number for a part of it.)
inline QString cubed(int n) {
    return QString::number(n) + QChar(u'³');
}

// How a measurement is made: the solver, and how often.
struct BenchSolver {
    const SolverRegistry& registry;
    QString id;
    int runs = 1;
};

// The first `rows` rows of the paper's Table I: films of 96 to 117,600 points under the sphere.
std::vector<StepRow> measureTableOne(const BenchSolver& solver, BenchBodies& bodies, int rows,
                                     const Progress& progress);
// The paper's Figure 7: a film of 21,600 points under three bodies, each with fields of 32 samples
// a side and twice as many again and again, up to `finest`.
std::vector<StepRow> measureFieldSweep(const BenchSolver& solver, BenchBodies& bodies, int finest,
                                       const Progress& progress);
// Whole dips of the sphere in both presets on films of columns × rows points.
std::vector<TimedRow> measureDips(const BenchSolver& solver, BenchBodies& bodies, int columns,
                                  int rows, const Progress& progress);
// Fields of 64³ to `finest`³ samples round a sphere of 50,000 triangles.
std::vector<TimedRow> measureFields(int runs, int finest, const Progress& progress);
// The turtle's first immersion once dipped: its reverse texture and the sheet as PNG and PDF.
std::vector<TimedRow> measureSheets(const BenchSolver& solver, const std::vector<int>& resolutions,
                                    const Progress& progress);
// What `run` does with the turtle beside the dip, piece by piece: what depends on an immersion for
// the first one.
std::vector<TimedRow> measureParts(const BenchSolver& solver, const Progress& progress);
// The command `run` on the turtle from the project to the files, the field built each time.
std::vector<TimedRow> measureRun(const BenchSolver& solver, const Progress& progress);

} // namespace dipwright::cli
